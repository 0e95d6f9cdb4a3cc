// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/decomposition.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "quoin/base/error.h"
#include "quoin/polytope/convex_joining.h"
#include "quoin/polytope/half_space.h"
#include "quoin/polytope/notches.h"
#include "quoin/solid/query/shell_components.h"

namespace quoin {

namespace {

/// Signs of all vertices of loops, by point, against the plane of a face.
std::vector<Sign> sides_of_plane(const Brep& boundary, std::uint32_t face) {
  const auto& [a, b, c] = boundary.face_planes[face];
  std::vector<Sign> sides(boundary.points.point_count(), Sign::zero);
  for (const PointId v : boundary.loop_vertices) sides[v.index()] = boundary.points.orientation_any(a, b, c, v);
  return sides;
}

/// How good a plane is to cut along: notches in it, less those that it cuts in two; then the fewer edges are cut the
/// better.
struct Merit {
  long notches = 0;
  long cut_edges = 0;
  bool is_better_than(const Merit& other) const {
    return notches != other.notches ? notches > other.notches : cut_edges < other.cut_edges;
  }
};

/// Nothing where the plane does not cut the solid.
std::optional<Merit> merit_of(const Brep& boundary, const std::vector<Notch>& notches, std::uint32_t face) {
  const std::vector<Sign> sides = sides_of_plane(boundary, face);
  const auto has = [&](Sign sign) {
    return std::ranges::any_of(boundary.loop_vertices, [&](PointId v) { return sides[v.index()] == sign; });
  };
  if (!has(Sign::negative) || !has(Sign::positive)) return std::nullopt;
  Merit merit;
  for (const Notch& n : notches) {
    const Sign a = sides[n.a.index()];
    const Sign b = sides[n.b.index()];
    if (a == Sign::zero && b == Sign::zero) ++merit.notches;
    if (a * b == Sign::negative) --merit.notches;
  }
  for (std::size_t l = 0; l < boundary.loop_count(); ++l) {
    const auto loop = boundary.loop(l);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Sign next = sides[loop[(i + 1) % loop.size()].index()];
      if (sides[loop[i].index()] * next == Sign::negative) ++merit.cut_edges;
    }
  }
  return merit;
}

/// One face of each plane, as far as faces at notches go.
std::vector<std::uint32_t> candidate_faces(const std::vector<Notch>& notches) {
  std::vector<std::uint32_t> faces;
  for (const Notch& n : notches) faces.insert(faces.end(), n.faces.begin(), n.faces.end());
  std::ranges::sort(faces);
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

std::uint32_t best_face(const Brep& boundary, const std::vector<Notch>& notches, const Context& context) {
  std::optional<Merit> best;
  std::uint32_t result = 0;
  for (const std::uint32_t face : candidate_faces(notches)) {
    context.poll();
    const std::optional<Merit> merit = merit_of(boundary, notches, face);
    if (!merit || (best && !merit->is_better_than(*best))) continue;
    best = merit;
    result = face;
  }
  if (!best) throw InternalError("no plane at a notch cuts the solid");
  return result;
}

SectionPlane plane_of(const Brep& boundary, std::uint32_t face) {
  const auto& [a, b, c] = boundary.face_planes[face];
  const RationalPoint3 origin = boundary.points.exact(a);
  const RationalPoint3 normal = cross(boundary.points.exact(b) - origin, boundary.points.exact(c) - origin);
  return {normal, dot(normal, origin)};
}

/// The least k with k (k - 1) / 2 at least `planes`.
std::size_t pieces_for_planes(std::size_t planes) {
  std::size_t k = 1;
  while (k * (k - 1) / 2 < planes) ++k;
  return k;
}

/// Of one component. Where it only touches itself along an edge no two pieces need a plane in common.
std::size_t lower_bound(const Brep& boundary, const std::vector<Notch>& notches, const Context& context) {
  std::vector<const Notch*> chosen;
  for (const Notch& n : notches) {
    context.poll();
    if (!n.is_manifold) continue;
    const bool is_apart = std::ranges::all_of(chosen, [&](const Notch* other) {
      return boundary.points.orientation_any(other->a, other->b, n.a, n.b) != Sign::zero;
    });
    if (is_apart) chosen.push_back(&n);
  }
  return pieces_for_planes(chosen.size());
}

class Decomposer {
 public:
  explicit Decomposer(const Context& context) : context_(context) {}

  ConvexDecomposition run(const Solid& solid) {
    std::vector<Brep> waiting = component_boundaries(solid.boundary(), context_);
    for (const Brep& component : waiting) {
      const std::vector<Notch> notches = find_notches(component, context_);
      result_.notches += notches.size();
      result_.lower_bound += lower_bound(component, notches, context_);
    }
    std::vector<Solid> pieces;
    while (!waiting.empty()) {
      Brep piece = std::move(waiting.back());
      waiting.pop_back();
      const std::vector<Notch> notches = find_notches(piece, context_);
      if (notches.empty()) {
        pieces.push_back(Solid::from_boundary(std::move(piece), "piece", context_));
        context_.progress("pieces", 0);
      } else {
        cut(std::move(piece), notches, waiting);
      }
    }
    std::ranges::reverse(pieces);
    result_.pieces = join_convex(pieces, context_);
    return std::move(result_);
  }

 private:
  void cut(Brep piece, const std::vector<Notch>& notches, std::vector<Brep>& waiting) {
    ++result_.cuts;
    const RationalPoint3 one{Rational(1), Rational(1), Rational(1)};
    const SectionPlane plane = plane_of(piece, best_face(piece, notches, context_));
    const Solid below = half_space_in_box(exact_bounds(piece).grown(one), plane, context_);
    const Solid whole = Solid::from_boundary(std::move(piece), "piece", context_);
    for (const Solid& side : {subtract(whole, {&below, 1}, context_), intersect(std::array{whole, below}, context_)}) {
      for (Brep& part : component_boundaries(side.boundary(), context_)) waiting.push_back(std::move(part));
    }
  }

  const Context& context_;
  ConvexDecomposition result_;
};

}  // namespace

ConvexDecomposition convex_decomposition(const Solid& solid, const Context& context) {
  if (solid.boundary().is_unbounded) throw InputError("the solid is unbounded");
  return Decomposer(context).run(solid);
}

}  // namespace quoin
