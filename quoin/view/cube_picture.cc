// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/cube_picture.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "quoin/view/arrangement_picture.h"
#include "quoin/view/cell_rings.h"

namespace quoin {

namespace {

using dcel::EdgeId;
using dcel::FaceId;
using dcel::VertexId;

using Unit = std::array<int, 3>;

/// Where a square is in the picture, and which directions of space lead right and up there.
struct Leaf {
  Point2 center;
  Unit right;
  Unit up;
  const char* name;
};

constexpr std::array<Leaf, cube::square_count> leaves{{{{-2, 0}, {0, -1, 0}, {0, 0, 1}, "x = -1"},
                                                       {{0, 0}, {1, 0, 0}, {0, 0, 1}, "y = -1"},
                                                       {{0, -2}, {1, 0, 0}, {0, -1, 0}, "z = -1"},
                                                       {{2, 0}, {0, 1, 0}, {0, 0, 1}, "x = 1"},
                                                       {{4, 0}, {-1, 0, 0}, {0, 0, 1}, "y = 1"},
                                                       {{0, 2}, {1, 0, 0}, {0, 1, 0}, "z = 1"}}};

Point2 placed(std::size_t square, const Point2& p) {
  std::array<double, 3> at{};
  at[cube::axis(square)] = cube::sign(square);
  at[cube::x_axis(square)] = p.x;
  at[cube::y_axis(square)] = p.y;
  Point2 result = leaves[square].center;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    result.x += leaves[square].right[axis] * at[axis];
    result.y += leaves[square].up[axis] * at[axis];
  }
  return result;
}

/// Whether a point of a square's border is on that of an earlier one in the picture too.
bool is_seam(std::size_t square, const Point2& p) {
  for (std::size_t other = 0; other < square; ++other) {
    const Point2& center = leaves[other].center;
    if (std::fabs(p.x - center.x) <= 1 && std::fabs(p.y - center.y) <= 1) return true;
  }
  return false;
}

class CubePicture {
 public:
  CubePicture(const CubicalMap& map, const CubePictureOptions& options) : map_(map), options_(options) {
    picture_.title = options.title;
    picture_.box = PictureBox{{-3, -3}, {5, 3}}.enlarged(0.02);
    const CubicalMap::Counts counts = map.counts();
    picture_.facts = {{"Faces on all squares", std::to_string(counts.faces)},
                      {"Edges on all squares", std::to_string(counts.edges)},
                      {"Vertices on all squares", std::to_string(counts.vertices)}};
  }

  PlanarPicture take() {
    for (std::size_t s = 0; s < cube::square_count; ++s) {
      find_paths(s);
      add_faces(s);
      add_edges(s);
      add_points(s);
    }
    // Strong over faint.
    for (PictureEdge& edge : real_) picture_.edges.push_back(std::move(edge));
    for (std::size_t s = 0; s < cube::square_count; ++s) add_name(s);
    return std::move(picture_);
  }

 private:
  ViewFact square_fact(std::size_t s) const { return {"Square", leaves[s].name}; }
  std::string name_of(std::uint32_t vertex) const {
    return options_.vertex_name ? options_.vertex_name(vertex) : "vertex " + std::to_string(vertex);
  }

  void find_paths(std::size_t s) {
    const LinearArrangement& a = map_.squares[s].arrangement;
    paths_.assign(a.edge_count(), {});
    for (std::size_t i = 0; i < a.edge_count(); ++i) {
      const EdgeId edge(i);
      if (!a.cells().is_real(edge)) continue;
      paths_[i] = path_of(
          {placed(s, a.family().position(a.left_point(edge))), placed(s, a.family().position(a.right_point(edge)))});
    }
  }

  void add_faces(std::size_t s) {
    const CubicalMap::Square& square = map_.squares[s];
    for (std::size_t i = 0; i < square.vertex_of_face.size(); ++i) {
      const std::uint32_t vertex = square.vertex_of_face[i];
      if (vertex == CubicalMap::none) continue;
      PictureFace face;
      face.rings = face_rings(square.arrangement.cells(), FaceId(i), paths_, *picture_.box);
      face.fill.category = vertex;
      face.text = {name_of(vertex), options_.has_labels ? std::to_string(vertex) : std::string(), {square_fact(s)}};
      picture_.faces.push_back(std::move(face));
    }
  }

  void add_edges(std::size_t s) {
    const CubicalMap::Square& square = map_.squares[s];
    for (std::size_t i = 0; i < square.arc_of_edge.size(); ++i) {
      if (!square.arrangement.cells().is_real(EdgeId(i))) continue;
      const Point2 middle{(paths_[i].start.x + paths_[i].end().x) / 2, (paths_[i].start.y + paths_[i].end().y) / 2};
      if (is_seam(s, middle)) continue;
      if (square.arc_of_edge[i] == CubicalMap::none) {
        picture_.edges.push_back({paths_[i], EdgeStyle::faint, {}, {"side of the square", "", {square_fact(s)}}});
        continue;
      }
      const MapArc& arc = map_.arcs[square.arc_of_edge[i]];
      PictureText text{"edge " + std::to_string(arc.tail) + " - " + std::to_string(arc.head), "", {square_fact(s)}};
      real_.push_back({paths_[i], EdgeStyle::strong, {}, std::move(text)});
    }
  }

  void add_points(std::size_t s) {
    const CubicalMap::Square& square = map_.squares[s];
    for (std::size_t i = 0; i < square.vertices.size(); ++i) {
      const CubicalMap::Vertex& vertex = square.vertices[i];
      if (!vertex.is_real()) continue;
      const LinearArrangement& a = square.arrangement;
      const Point2 at = placed(s, a.family().position(a.point(VertexId(i))));
      if (vertex.location != CubicalMap::Location::interior && is_seam(s, at)) continue;
      picture_.points.push_back({at, 1, {}, {"facet " + std::to_string(vertex.facet), "", {square_fact(s)}}});
    }
  }

  /// In a corner of the square.
  void add_name(std::size_t s) {
    const Point2& center = leaves[s].center;
    picture_.points.push_back({{center.x - 0.98, center.y + 0.86}, 0, {}, {"", leaves[s].name, {}}});
  }

  const CubicalMap& map_;
  const CubePictureOptions& options_;
  PlanarPicture picture_;
  std::vector<PicturePath> paths_;  // of the square at hand, by edge
  std::vector<PictureEdge> real_;
};

}  // namespace

const char* cube_square_name(std::size_t square) {
  return leaves[square].name;
}

PlanarPicture cube_picture_of(const CubicalMap& map, const CubePictureOptions& options) {
  return CubePicture(map, options).take();
}

}  // namespace quoin
