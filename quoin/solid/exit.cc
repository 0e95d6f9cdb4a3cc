// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/exit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "quoin/base/error.h"
#include "quoin/base/parallel.h"
#include "quoin/solid/exit_check.h"
#include "quoin/solid/exit_polygons.h"
#include "quoin/solid/exit_sides.h"
#include "quoin/solid/exit_snapping.h"
#include "quoin/solid/exit_triangulation.h"

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

// Per point, 1: a triangle names it. Polygons name no others.
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
    for (std::uint32_t& v : result.polygons.corners) v = number[v];
  }
  result.vertices = std::move(points);
}

class Exit {
 public:
  Exit(const Brep& boundary, const ExitOptions& options, const Context& context)
      : boundary_(boundary), options_(options), context_(context), current_(&boundary) {}

  Triangulated run() {
    context_.progress("rounding", 0);
    for (unsigned round = 0;; ++round) {
      result_.rounds = round;
      round_and_triangulate();
      if (holds() || holds_triangulated_exactly()) return finish(rounding_that_holds());
      if (round == options_.max_rounds || !snap(round)) return finish(Rounding::failed);
    }
  }

 private:
  void round_and_triangulate() {
    positions_ = round_points(*current_, options_.precision, context_);
    FaceTriangles faces = triangulate_faces(*current_, positions_.points, positions_.moved, context_);
    result_.triangles = std::move(faces.triangles);
    result_.triangle_face = std::move(faces.triangle_face);
    failed_faces_ = std::move(faces.failed_faces);
    result_.max_displacement += positions_.displacement;
    result_.moved_vertices = std::max(result_.moved_vertices, positions_.moved_count);
  }

  // Whether the triangles bound what the current boundary does, but for the coordinates.
  bool holds() {
    result_.crossings.clear();
    if (positions_.moved_count == 0 && failed_faces_.empty()) {
      is_named_ = named_points(result_.triangles, positions_.points.size());
      return true;
    }
    bool is_evident = false;
    run_both(
        context_,
        [&] {
          is_named_ = named_points(result_.triangles, positions_.points.size());
          is_evident =
              are_sides_evident(*current_, positions_.points, result_.triangles, result_.triangle_face, context_);
        },
        [&] { result_.crossings = find_crossings(positions_.points, result_.triangles, positions_.moved, context_); });
    add_failed_faces();
    return result_.crossings.empty() && (is_evident || are_sides_kept(*current_, positions_.points, result_.triangles,
                                                                      result_.triangle_face, context_));
  }

  // The faces whose triangles cross once more, without triangles of vertices that lie on one line before rounding.
  bool holds_triangulated_exactly() {
    std::vector<std::uint32_t> faces;
    for (const TilePair& pair : result_.crossings) {
      faces.push_back(result_.triangle_face[pair.a]);
      faces.push_back(result_.triangle_face[pair.b]);
    }
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    const Triangulated before = result_;
    const std::vector<std::uint32_t> failed = std::exchange(failed_faces_, {});
    if (!faces.empty() && triangulate_exactly(*current_, faces, result_.triangles, result_.triangle_face, context_) &&
        holds()) {
      return true;
    }
    result_ = before;
    failed_faces_ = failed;
    return false;
  }

  // A face whose outline is not simple counts as crossing itself.
  void add_failed_faces() {
    for (std::uint32_t t = 0; t < result_.triangles.size(); ++t) {
      if (std::binary_search(failed_faces_.begin(), failed_faces_.end(), result_.triangle_face[t])) {
        result_.crossings.push_back({t, t});
      }
    }
  }

  Rounding rounding_that_holds() {
    if (result_.rounds == 0) return positions_.moved_count == 0 ? Rounding::exact : Rounding::certified;
    result_.topology_before = topology_of(boundary_);
    result_.topology_after = topology_of(*current_);
    return result_.topology_after.has_parts_of(result_.topology_before) ? Rounding::certified : Rounding::changed;
  }

  // False where the snapped triangles do not close. Without crossings some side is wrong, which needs no snapping.
  bool snap(unsigned round) {
    std::vector<Point3> points = positions_.points;
    const double displacement = snap_crossing(points, result_.triangles, result_.crossings, bits_);
    if (round % 2 == 1) bits_ -= 4;
    std::optional<Brep> next = resolve(points, result_.triangles, boundary_.is_unbounded, context_);
    if (!next) return false;
    result_.max_displacement += displacement;
    name_original_faces();
    face_before_ = result_.triangle_face;
    result_.resolved = std::make_shared<const Brep>(std::move(*next));
    current_ = result_.resolved.get();
    return true;
  }

  // After a round of snap rounding the boundary's faces stem from triangles of the round before.
  void name_original_faces() {
    if (current_ == &boundary_) return;
    for (std::uint32_t& f : result_.triangle_face)
      f = face_before_[current_->origins[current_->face_first_origin[f]].face];
  }

  Triangulated finish(Rounding rounding) {
    result_.rounding = rounding;
    if (result_.crossings.size() > options_.max_listed) result_.crossings.resize(options_.max_listed);
    if (options_.keep_polygons && rounding != Rounding::failed)
      result_.polygons = find_polygons(*current_, positions_.points, positions_.moved, result_.triangles,
                                       result_.triangle_face, context_);
    name_original_faces();
    set_vertices(result_, std::move(positions_.points), is_named_);
    return std::move(result_);
  }

  const Brep& boundary_;
  const ExitOptions& options_;
  const Context& context_;
  const Brep* current_;  // what the triangles are of: the boundary, or what the last round made of it
  Triangulated result_;
  Positions positions_;
  std::vector<std::uint8_t> is_named_;       // per point: by the triangles
  std::vector<std::uint32_t> failed_faces_;  // of the current boundary
  std::vector<std::uint32_t> face_before_;   // of the boundary, per triangle of the round before
  int bits_ = 24;
};

}  // namespace

Triangulated triangulate_boundary(const Brep& boundary, const ExitOptions& options, const Context& context) {
  return Exit(boundary, options, context).run();
}

}  // namespace quoin
