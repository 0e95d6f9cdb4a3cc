// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/exit_triangulation.h"

#include <algorithm>
#include <utility>

#include "quoin/base/parallel.h"
#include "quoin/kernel/projection.h"
#include "quoin/triangulation/polygon.h"

namespace quoin {

namespace {

// Coordinates (u, v) of a projection in which the face's outline turns counterclockwise.
struct Projection {
  unsigned u;
  unsigned v;
};

Projection projection_of(const Constructions& table, const std::array<PointId, 3>& plane) {
  const unsigned axis = projection_axis(table, plane[0], plane[1], plane[2]);
  const unsigned u = (axis + 1) % 3;
  const unsigned v = (axis + 2) % 3;
  return table.turn(plane[0], plane[1], plane[2], axis) == Sign::positive ? Projection{u, v} : Projection{v, u};
}

class FaceTriangulator {
 public:
  FaceTriangulator(const Brep& boundary, std::span<const Point3> positions, std::span<const std::uint8_t> moved,
                   FaceTriangles& out)
      : boundary_(boundary), positions_(positions), moved_(moved), out_(out) {}

  void run(std::uint32_t face) {
    const std::uint32_t first_loop = boundary_.face_first_loop[face];
    const std::uint32_t end_loop = boundary_.face_first_loop[face + 1];
    if (end_loop - first_loop == 1 && boundary_.loop(first_loop).size() == 3 &&
        add_triangle(face, boundary_.loop(first_loop))) {
      return;
    }
    gather(face, first_loop, end_loop);
    triangles_.clear();
    const bool is_simple = triangulate_polygon(points_, loop_points_, loop_begin_, triangles_);
    if (!is_simple) {
      out_.failed_faces.push_back(face);
      add_fans(first_loop, end_loop);
    }
    for (const PolygonTriangle& t : triangles_) {
      out_.triangles.push_back({ids_[t[0]], ids_[t[1]], ids_[t[2]]});
    }
    out_.triangle_face.resize(out_.triangles.size(), face);
  }

 private:
  // A triangle needs no projection where no vertex has moved from where it is exactly: its area is not zero.
  bool add_triangle(std::uint32_t face, std::span<const PointId> loop) {
    if ((moved_[loop[0].value] | moved_[loop[1].value] | moved_[loop[2].value]) != 0) return false;
    out_.triangles.push_back({loop[0].value, loop[1].value, loop[2].value});
    out_.triangle_face.push_back(face);
    return true;
  }

  void gather(std::uint32_t face, std::uint32_t first_loop, std::uint32_t end_loop) {
    const Projection projection = projection_of(boundary_.points, boundary_.face_planes[face]);
    ids_.clear();
    for (std::uint32_t l = first_loop; l < end_loop; ++l) {
      for (const PointId p : boundary_.loop(l)) ids_.push_back(p.value);
    }
    if (ids_.size() > 4) {
      std::sort(ids_.begin(), ids_.end());
      ids_.erase(std::unique(ids_.begin(), ids_.end()), ids_.end());
    }
    points_.clear();
    for (const std::uint32_t id : ids_) points_.push_back({positions_[id][projection.u], positions_[id][projection.v]});
    loop_points_.clear();
    loop_begin_.assign(1, 0);
    for (std::uint32_t l = first_loop; l < end_loop; ++l) {
      for (const PointId p : boundary_.loop(l)) loop_points_.push_back(index_of(p.value));
      loop_begin_.push_back(static_cast<std::uint32_t>(loop_points_.size()));
    }
  }

  std::uint32_t index_of(std::uint32_t id) const {
    if (ids_.size() <= 4) return static_cast<std::uint32_t>(std::find(ids_.begin(), ids_.end(), id) - ids_.begin());
    return static_cast<std::uint32_t>(std::lower_bound(ids_.begin(), ids_.end(), id) - ids_.begin());
  }

  void add_fans(std::uint32_t first_loop, std::uint32_t end_loop) {
    for (std::uint32_t l = first_loop; l < end_loop; ++l) {
      const auto loop = boundary_.loop(l);
      for (std::size_t i = 2; i < loop.size(); ++i) {
        const PolygonTriangle t{index_of(loop[0].value), index_of(loop[i - 1].value), index_of(loop[i].value)};
        if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) triangles_.push_back(t);
      }
    }
  }

  const Brep& boundary_;
  std::span<const Point3> positions_;
  std::span<const std::uint8_t> moved_;
  FaceTriangles& out_;
  std::vector<std::uint32_t> ids_;
  std::vector<Point2> points_;
  std::vector<std::uint32_t> loop_points_;
  std::vector<std::uint32_t> loop_begin_;
  std::vector<PolygonTriangle> triangles_;
};

}  // namespace

FaceTriangles triangulate_faces(const Brep& boundary, std::span<const Point3> positions,
                                std::span<const std::uint8_t> moved, const Context& context) {
  constexpr std::size_t grain = 4096;
  std::vector<FaceTriangles> parts(chunk_count(boundary.face_count(), grain));
  for_each_chunk(context, boundary.face_count(), grain, [&](const Chunk& chunk) {
    parts[chunk.index].triangles.reserve(chunk.end - chunk.begin);
    parts[chunk.index].triangle_face.reserve(chunk.end - chunk.begin);
    FaceTriangulator triangulator(boundary, positions, moved, parts[chunk.index]);
    for (std::size_t f = chunk.begin; f < chunk.end; ++f) {
      if (f % 256 == 0) context.poll();
      triangulator.run(static_cast<std::uint32_t>(f));
    }
  });
  FaceTriangles all;
  std::vector<std::size_t> begin;
  std::size_t count = 0;
  for (const FaceTriangles& part : parts) {
    begin.push_back(count);
    count += part.triangles.size();
    all.failed_faces.insert(all.failed_faces.end(), part.failed_faces.begin(), part.failed_faces.end());
  }
  run_both(
      context, [&] { all.triangles.resize(count); }, [&] { all.triangle_face.resize(count); });
  for_each_chunk(context, parts.size(), 1, [&](const Chunk& chunk) {
    FaceTriangles& part = parts[chunk.index];
    const auto at = static_cast<std::ptrdiff_t>(begin[chunk.index]);
    std::copy(part.triangles.begin(), part.triangles.end(), all.triangles.begin() + at);
    std::copy(part.triangle_face.begin(), part.triangle_face.end(), all.triangle_face.begin() + at);
    part = {};
  });
  return all;
}

namespace {

// Over a table of its own that holds the face's vertices as rationals. Nothing where the face is no polygon.
bool triangulate_exactly(const Brep& boundary, std::uint32_t face, std::vector<Tile>& out) {
  std::vector<std::uint32_t> ids;
  for (std::uint32_t l = boundary.face_first_loop[face]; l < boundary.face_first_loop[face + 1]; ++l) {
    for (const PointId p : boundary.loop(l)) ids.push_back(p.value);
  }
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  std::vector<RationalPoint3> exact;
  std::vector<PointId> points;
  for (const std::uint32_t id : ids) {
    exact.push_back(boundary.points.exact(PointId{id}));
    points.push_back(PointId{points.size()});
  }
  std::vector<std::uint32_t> loop_points;
  std::vector<std::uint32_t> loop_begin{0};
  for (std::uint32_t l = boundary.face_first_loop[face]; l < boundary.face_first_loop[face + 1]; ++l) {
    for (const PointId p : boundary.loop(l)) {
      const auto at = std::lower_bound(ids.begin(), ids.end(), p.value);
      loop_points.push_back(static_cast<std::uint32_t>(at - ids.begin()));
    }
    loop_begin.push_back(static_cast<std::uint32_t>(loop_points.size()));
  }
  const auto& [a, b, c] = boundary.face_planes[face];
  const unsigned axis = projection_axis(boundary.points, a, b, c);
  const PolygonView view{axis, boundary.points.turn(a, b, c, axis) == Sign::positive};
  std::vector<PolygonTriangle> triangles;
  const Constructions table(std::move(exact));
  if (!triangulate_polygon(table, points, view, loop_points, loop_begin, triangles)) return false;
  for (const PolygonTriangle& t : triangles) out.push_back({ids[t[0]], ids[t[1]], ids[t[2]]});
  return true;
}

}  // namespace

bool triangulate_exactly(const Brep& boundary, std::span<const std::uint32_t> faces, std::vector<Tile>& triangles,
                         std::vector<std::uint32_t>& triangle_face, const Context& context) {
  std::vector<Tile> result;
  std::vector<std::uint32_t> result_face;
  std::size_t t = 0;
  for (const std::uint32_t face : faces) {
    context.poll();
    for (; t < triangles.size() && triangle_face[t] < face; ++t) {
      result.push_back(triangles[t]);
      result_face.push_back(triangle_face[t]);
    }
    while (t < triangles.size() && triangle_face[t] == face) ++t;
    if (!triangulate_exactly(boundary, face, result)) return false;
    result_face.resize(result.size(), face);
  }
  result.insert(result.end(), triangles.begin() + static_cast<std::ptrdiff_t>(t), triangles.end());
  result_face.insert(result_face.end(), triangle_face.begin() + static_cast<std::ptrdiff_t>(t), triangle_face.end());
  triangles = std::move(result);
  triangle_face = std::move(result_face);
  return true;
}

}  // namespace quoin
