// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/base/sign.h"
#include "quoin/kernel/rational_point.h"
#include "quoin/polytope/minkowski_sum.h"
#include "quoin/polytope/polytope.h"

namespace quoin {

/// All translations of a polytope, the first, at which it has a point in common with another, the second: the second
/// plus the reflected first, { q - p }. Moved by t, the first meets the second if and only if t is in this body.
///
/// A vertex is the difference of a vertex of the second and one of the first. A rim is an edge of a facet, from one
/// corner to the next, counterclockwise seen from outside; rims are numbered through all facets, and each has a twin in
/// the facet beyond. Signs are exact for all finite doubles: in integers on the grid of the call, slow beside filters.
class TranslationBody {
 public:
  /// O(size of the sum, times its logarithm). @throws InputError if neither is a solid, or a vertex is no point of
  /// doubles; Cancelled
  TranslationBody(const Polytope& first, const Polytope& second, const Context& context);

  std::uint32_t facet_count() const { return static_cast<std::uint32_t>(sum_.facet_count()); }
  std::uint32_t vertex_count() const { return static_cast<std::uint32_t>(sum_.vertices.size()); }
  std::uint32_t rim_count() const { return static_cast<std::uint32_t>(twins_.size()); }
  std::uint32_t first_rim(std::uint32_t f) const { return static_cast<std::uint32_t>(sum_.facet_begin[f]); }
  std::uint32_t end_rim(std::uint32_t f) const { return static_cast<std::uint32_t>(sum_.facet_begin[f + 1]); }
  std::uint32_t twin(std::uint32_t rim) const { return twins_[rim]; }
  std::uint32_t facet_of(std::uint32_t rim) const { return facets_[rim]; }
  std::uint32_t tail(std::uint32_t rim) const { return sum_.corners[rim]; }
  std::uint32_t head(std::uint32_t rim) const { return tail(next(rim)); }
  std::uint32_t next(std::uint32_t rim) const {
    return rim + 1 < end_rim(facets_[rim]) ? rim + 1 : first_rim(facets_[rim]);
  }
  /// The next rim that leaves the same vertex, counterclockwise.
  std::uint32_t next_about_tail(std::uint32_t rim) const {
    return twins_[rim > first_rim(facets_[rim]) ? rim - 1 : end_rim(facets_[rim]) - 1];
  }

  /// Of the first and of the second polytope.
  std::array<std::uint32_t, 2> sources(std::uint32_t v) const { return {sum_.vertices[v][1], sum_.vertices[v][0]}; }
  const Point3& point_of_first(std::uint32_t v) const { return first_[sum_.vertices[v][1]]; }
  const Point3& point_of_second(std::uint32_t v) const { return second_[sum_.vertices[v][0]]; }
  RationalPoint3 exact(std::uint32_t v) const {
    return exact_point(point_of_second(v)) - exact_point(point_of_first(v));
  }
  /// An outward normal.
  RationalPoint3 exact_normal(std::uint32_t f) const;
  /// Four vertices whose mean, the centre, is well inside.
  const std::array<std::uint32_t, 4>& anchors() const { return anchors_; }

  /// Positive: t is outside of the facet's plane.
  Sign height(std::uint32_t f, const Point3& t) const;
  /// Negative: from the centre, t is seen beyond the rim.
  Sign seen(std::uint32_t rim, const Point3& t) const;
  /// Negative: from t, the direction goes beyond the rim, if t is inside.
  Sign seen_along(std::uint32_t rim, const Point3& t, const Vector3& direction) const;
  /// Positive: t is on the rim's head side of the plane through its tail that is normal to it.
  Sign along(std::uint32_t rim, const Point3& t) const;
  /// Positive: t is on the facet's side of the plane through the rim that is normal to the facet.
  Sign across(std::uint32_t rim, const Point3& t) const;

 private:
  void link();
  void choose_anchors();
  bool are_independent(const std::array<std::uint32_t, 4>& corners) const;

  std::vector<Point3> first_;
  std::vector<Point3> second_;
  PolytopeSum sum_;
  std::vector<std::uint32_t> twins_;
  std::vector<std::uint32_t> facets_;
  std::array<std::uint32_t, 4> anchors_{};
};

}  // namespace quoin
