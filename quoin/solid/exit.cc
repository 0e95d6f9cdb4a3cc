// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/exit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "quoin/base/error.h"
#include "quoin/base/parallel.h"
#include "quoin/solid/exit_check.h"
#include "quoin/solid/exit_triangulation.h"
#include "quoin/solid/leaf.h"
#include "quoin/solid/overlay/overlay.h"

namespace quoin {

namespace {

struct Positions {
  std::vector<Point3> points;  // per point of the boundary
  std::vector<std::uint8_t> moved;
  std::size_t moved_count = 0;
  double displacement = 0;  // largest move of a coordinate
};

double nearest(double value, Precision precision) {
  if (precision == Precision::binary64 && std::isfinite(value)) return value;
  if (!(std::fabs(value) <= static_cast<double>(std::numeric_limits<float>::max()))) {
    throw InputError("a coordinate is too large for the numbers of the format");
  }
  return static_cast<double>(static_cast<float>(value));
}

double spacing(double value) {
  const double x = std::fabs(value);
  return std::nextafter(x, std::numeric_limits<double>::infinity()) - x;
}

// A constructed coordinate that is no double moves by at most half the spacing there.
double move_of(const Constructions& table, PointId id, const Point3& position) {
  const Point3& near = table.rounded(id);
  double move = 0;
  for (std::size_t k = 0; k < 3; ++k) move = std::max(move, std::fabs(position[k] - near[k]));
  if (!table.is_exact(id)) {
    for (std::size_t k = 0; k < 3; ++k) move = std::max(move, std::fabs(position[k] - near[k]) + spacing(near[k]) / 2);
  }
  return move;
}

Positions round_points(const Brep& boundary, Precision precision, const Context& context) {
  constexpr std::size_t grain = 16384;
  struct Part {
    std::size_t moved_count = 0;
    double displacement = 0;
  };
  const Constructions& table = boundary.points;
  Positions result;
  result.points.resize(table.point_count());
  result.moved.assign(table.point_count(), 0);
  std::vector<Part> parts(chunk_count(table.point_count(), grain));
  for_each_chunk(context, table.point_count(), grain, [&](const Chunk& chunk) {
    Part& part = parts[chunk.index];
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const Point3& near = table.rounded(PointId{i});
      for (std::size_t k = 0; k < 3; ++k) result.points[i][k] = nearest(near[k], precision);
      const double move = move_of(table, PointId{i}, result.points[i]);
      if (move == 0) continue;
      result.moved[i] = 1;
      ++part.moved_count;
      part.displacement = std::max(part.displacement, move);
    }
  });
  for (const Part& part : parts) {
    result.moved_count += part.moved_count;
    result.displacement = std::max(result.displacement, part.displacement);
  }
  return result;
}

// Per point, 1: a triangle names it.
std::vector<std::uint8_t> named_points(std::span<const Tile> triangles, std::size_t point_count) {
  std::vector<std::uint8_t> result(point_count, 0);
  for (const Tile& t : triangles) {
    for (const std::uint32_t v : t) result[v] = 1;
  }
  return result;
}

// Keeps only the named vertices, in place.
void set_vertices(Triangulated& result, std::vector<Point3> points, std::span<const std::uint8_t> is_named) {
  const bool are_all_named = std::find(is_named.begin(), is_named.end(), 0) == is_named.end();
  if (!are_all_named) {
    std::vector<std::uint32_t> number(points.size());
    std::uint32_t kept = 0;
    for (std::size_t v = 0; v < points.size(); ++v) {
      if (is_named[v] == 0) continue;
      points[kept] = points[v];
      number[v] = kept++;
    }
    points.resize(kept);
    for (Tile& t : result.triangles) {
      for (std::uint32_t& v : t) v = number[v];
    }
  }
  result.vertices = std::move(points);
}

// A uniform grid of cells whose size is a power of two.
class SnapGrid {
 public:
  SnapGrid(std::span<const Point3> points, int bits) {
    double largest = 0;
    for (const Point3& p : points) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    int exponent = 0;
    std::frexp(largest, &exponent);
    cell_ = std::ldexp(1.0, std::max(exponent - bits, -1070));
  }

  double snap(double x) const { return std::nearbyint(x / cell_) * cell_; }
  Point3 snap(const Point3& p) const { return {snap(p.x), snap(p.y), snap(p.z)}; }

 private:
  double cell_;
};

struct PointLess {
  bool operator()(const Point3& a, const Point3& b) const { return lexicographically_less(a, b); }
};

// One round of snap rounding: the vertices of crossing triangles, and all others in their cells, go to the cells'
// centres.
double snap_crossing(std::vector<Point3>& points, std::span<const Tile> triangles, std::span<const TilePair> crossings,
                     const SnapGrid& grid) {
  std::set<Point3, PointLess> cells;
  for (const TilePair& pair : crossings) {
    for (const std::uint32_t t : {pair.a, pair.b}) {
      for (const std::uint32_t v : triangles[t]) cells.insert(grid.snap(points[v]));
    }
  }
  double displacement = 0;
  for (Point3& p : points) {
    const Point3 snapped = grid.snap(p);
    if (!cells.contains(snapped)) continue;
    for (std::size_t k = 0; k < 3; ++k) displacement = std::max(displacement, std::fabs(snapped[k] - p[k]));
    p = snapped;
  }
  return displacement;
}

// The points of positive winding number of triangles that may cross each other; for an unbounded set, whose triangles
// wind about what it leaves out, the complement of those of the reversed triangles. Nothing where the triangles do not
// close.
std::optional<Brep> resolve(const std::vector<Point3>& points, std::span<const Tile> triangles, bool is_unbounded,
                            const Context& context) {
  Mesh mesh;
  std::vector<std::uint32_t> representative(points.size());
  std::vector<std::uint32_t> order(points.size());
  for (std::uint32_t v = 0; v < order.size(); ++v) order[v] = v;
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    if (points[a] != points[b]) return lexicographically_less(points[a], points[b]);
    return a < b;
  });
  for (const std::uint32_t v : order) {
    if (mesh.vertices.empty() || mesh.vertices.back() != points[v]) mesh.vertices.push_back(points[v]);
    representative[v] = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
  }
  for (const Tile& t : triangles) {
    Tile corners{representative[t[0]], representative[t[1]], representative[t[2]]};
    if (is_unbounded) std::swap(corners[1], corners[2]);
    mesh.add_face(corners);
  }
  const LeafResult leaf = make_leaf(mesh, {.max_listed = 0, .find_crossings = false}, context);
  if (!leaf.leaf) return std::nullopt;
  const std::shared_ptr<const Leaf> leaves[] = {leaf.leaf};
  const Expression inside = Expression::leaf(0);
  return overlay_boundary(leaves, is_unbounded ? Expression::complement(inside) : inside, context);
}

// After a round of snap rounding the boundary's faces stem from triangles of the round before.
void name_original_faces(Triangulated& result, const Brep& current, const std::vector<std::uint32_t>& face_before) {
  if (face_before.empty()) return;
  for (std::uint32_t& f : result.triangle_face) f = face_before[current.origins[current.face_first_origin[f]].face];
}

// A face whose outline is not simple counts as crossing itself.
void add_failed_faces(Triangulated& result, std::span<const std::uint32_t> failed_faces) {
  for (std::uint32_t t = 0; t < result.triangles.size(); ++t) {
    if (std::binary_search(failed_faces.begin(), failed_faces.end(), result.triangle_face[t])) {
      result.crossings.push_back({t, t});
    }
  }
}

}  // namespace

Triangulated triangulate_boundary(const Brep& boundary, const ExitOptions& options, const Context& context) {
  context.progress("rounding", 0);
  Triangulated result;
  const Brep* current = &boundary;
  Brep resolved;
  std::vector<std::uint32_t> face_before;  // of the boundary, per triangle of the round before
  int bits = 24;
  for (unsigned round = 0;; ++round) {
    Positions positions = round_points(*current, options.precision, context);
    FaceTriangles faces = triangulate_faces(*current, positions.points, context);
    result.triangles = std::move(faces.triangles);
    result.triangle_face = std::move(faces.triangle_face);
    result.max_displacement += positions.displacement;
    result.moved_vertices = std::max(result.moved_vertices, positions.moved_count);
    result.rounds = round;
    result.crossings.clear();
    std::vector<std::uint8_t> is_named;
    const auto find_named = [&] { is_named = named_points(result.triangles, positions.points.size()); };
    if (positions.moved_count == 0 && faces.failed_faces.empty()) {
      find_named();
      name_original_faces(result, *current, face_before);
      result.rounding = round == 0 ? Rounding::exact : Rounding::certified;
      set_vertices(result, std::move(positions.points), is_named);
      return result;
    }
    run_both(context, find_named,
             [&] { result.crossings = find_crossings(positions.points, result.triangles, positions.moved, context); });
    add_failed_faces(result, faces.failed_faces);
    name_original_faces(result, *current, face_before);
    if (result.crossings.empty()) {
      result.rounding = Rounding::certified;
      set_vertices(result, std::move(positions.points), is_named);
      return result;
    }
    std::vector<Point3> points = positions.points;
    const SnapGrid grid(points, bits);
    if (round % 2 == 1) bits -= 4;
    const double displacement = snap_crossing(points, result.triangles, result.crossings, grid);
    std::optional<Brep> next;
    if (round < options.max_rounds) next = resolve(points, result.triangles, boundary.is_unbounded, context);
    if (!next) {
      result.rounding = Rounding::failed;
      if (result.crossings.size() > options.max_listed) result.crossings.resize(options.max_listed);
      set_vertices(result, std::move(positions.points), is_named);
      return result;
    }
    result.max_displacement += displacement;
    face_before = result.triangle_face;
    resolved = std::move(*next);
    current = &resolved;
  }
}

}  // namespace quoin
