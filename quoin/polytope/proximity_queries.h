// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/number/interval.h"
#include "quoin/polytope/proximity.h"
#include "quoin/polytope/translation_body.h"
#include "quoin/polytope/translation_filters.h"

namespace quoin {

/// Where the last query ended, so that the next one begins there; answers never depend on it.
struct ProximityHint {
  static constexpr std::uint32_t none = 0xFFFFFFFFU;
  std::uint32_t facet = none;  ///< of the body of translations, for relations and distances
  std::uint32_t exit = none;   ///< for penetrations
  std::uint64_t steps = 0;     ///< from facet to facet, of all queries so far
};

/// A facet, an edge or a vertex of the body of translations.
struct TranslationFeature {
  int dimension = 2;
  std::uint32_t rim = 0;  ///< of the facet; or the edge itself; or its tail is the vertex
};

/// How the two lie to one another.
struct TranslationRelation {
  Proximity relation = Proximity::apart;
  /// Apart: the body lies behind the plane of this facet, the translation before it. Touching: where the translation is
  /// on the boundary of the body, an edge or a vertex where they graze each other. Overlapping: a facet that hides the
  /// translation from outside.
  TranslationFeature feature{};
};

/// That, and how far they are apart. Not apart: the feature is as above.
struct TranslationNearest {
  Proximity relation = Proximity::apart;
  TranslationFeature feature{};  ///< with the nearest point in its interior
  Interval squared_distance{};   ///< holds the exact one
};

/// The same in rationals.
struct TranslationDistance {
  Proximity relation = Proximity::apart;
  TranslationFeature feature{};
  Rational squared_distance{0};
  std::array<RationalPoint3, 2> witness{};  ///< the nearest points, of the first where it is then; not if they overlap
};

/// How far the first has to go in a direction.
struct DirectionalPenetration {
  Rational depth{0};                          ///< in lengths of the direction; 0 unless they overlap
  std::uint32_t facet = ProximityHint::none;  ///< the facet through which the body is left, if they do
};

/// The shortest translation that separates the interiors.
struct ShortestPenetration {
  Rational squared_depth{0};                  ///< 0 unless they overlap
  std::uint32_t facet = ProximityHint::none;  ///< the facet through which the body is left, if they do
  RationalPoint3 separation{};                ///< that translation, of the first
  std::array<RationalPoint3, 2>
      witness{};  ///< a point of the first where it is, which that brings to one of the second
};

/// What happens while the first moves straight from one translation to another.
struct TranslationPassage {
  Proximity relation = Proximity::apart;  ///< the deepest on the way; touching where they graze or slide along
  Rational enter{0};  ///< unless apart: they have common points from this part of the way, in [0, 1]
  Rational leave{0};  ///< to this one
};

/// Answers how two convex polytopes lie to one another for any translation of the first, exactly.
///
/// Made once, of the body of all translations at which they have a common point; then each query walks over its facets
/// from a hint, or from a facet in about the right direction where there is none. The walk to the facet that hides a
/// translation ends because each step leads to a plane that the ray from the centre meets earlier; the walk to the
/// nearest one, because each step leads to a facet that is strictly nearer, and only over facets that the translation
/// is not behind. All signs are exact: doubles with bounds (translation_filters.h), then integers. A query costs the
/// length of its walk: tens to hundreds of nanoseconds where translations change little. Turned polytopes need a new
/// one. Immutable after construction; safe to share between threads, each with its hints.
/// Source: Fogel and Halperin 2007; Lin and Canny 1991 (regions of features).
/// Queries throw InputError where a number is not finite, or a direction is zero; those that may look at all facets,
/// Cancelled.
class ProximityQueries {
 public:
  /// O(n log n) for the sum's size n. @throws InputError if both are flat, Cancelled
  ProximityQueries(const Polytope& first, const Polytope& second, const Context& context);

  const TranslationBody& body() const { return body_; }

  TranslationRelation relation(const Vector3& translation, ProximityHint& hint) const;
  TranslationNearest nearest(const Vector3& translation, ProximityHint& hint) const;
  TranslationDistance distance(const Vector3& translation, ProximityHint& hint) const;

  /// The least depth >= 0 such that the interiors have no common point once the first, translated, has moved by depth
  /// times the direction. The direction is not normalised.
  DirectionalPenetration penetration(const Vector3& translation, const Vector3& direction, ProximityHint& hint) const;

  /// Of all facets those that are nearest in doubles, compared exactly: O(facets).
  ShortestPenetration shortest_penetration(const Vector3& translation, ProximityHint& hint,
                                           const Context& context) const;

  /// Exact; a plane of the body with the whole way before it tells that they stay apart, at once if it is that of the
  /// hint. Else O(facets).
  TranslationPassage passage(const Vector3& from, const Vector3& to, ProximityHint& hint, const Context& context) const;

  /// The vertices of the faces of the first and of the second that make up a feature: those in contact if they touch
  /// there, those with the nearest points if they are apart. Ascending; one for a vertex, two for an edge.
  std::array<std::vector<std::uint32_t>, 2> faces_of(const TranslationFeature& feature) const;

 private:
  struct Query {
    Point3 exact;
    TranslationFilters::Query rounded;
  };

  Query query_of(const Vector3& translation) const;
  int height(std::uint32_t f, const Query& t) const;
  int seen(std::uint32_t rim, const Query& t) const;
  int along(std::uint32_t rim, const Query& t) const;
  int across(std::uint32_t rim, const Query& t) const;
  int seen_along(std::uint32_t rim, const Query& t, const Vector3& direction) const;

  std::size_t cell_of(const Vector3& direction) const;
  void fill_table(const Context& context);
  std::uint32_t start(const Query& t) const { return table_[cell_of(t.rounded.at)]; }
  template <class Beyond>
  std::uint32_t walk(std::uint32_t from, std::uint32_t other, std::uint64_t& steps, const Beyond& beyond) const;
  std::uint32_t hiding_facet(const Query& t, ProximityHint& hint) const;
  TranslationRelation relation_of(const Query& t, ProximityHint& hint) const;
  TranslationNearest nearest_of(const Query& t, ProximityHint& hint) const;
  TranslationFeature contact(std::uint32_t f, const Query& t) const;
  struct Closest;
  Closest closest_in(std::uint32_t f, const Query& t) const;
  std::uint32_t nearer_facet(const Closest& spot, const Query& t) const;
  Interval squared_distance(const TranslationFeature& feature, const Point3& t) const;
  std::array<RationalPoint3, 2> witness_of(const TranslationFeature& feature, const Point3& t,
                                           Rational& squared_length) const;
  Rational exact_height(std::uint32_t f, const Point3& t) const;
  Rational crossing(std::uint32_t f, const Point3& from, const Point3& to) const;

  TranslationBody body_;
  TranslationFilters filters_;
  std::size_t table_size_ = 1;        // a cell's edge is this part of a cube's
  std::vector<std::uint32_t> table_;  // by cell of a cube around the centre
};

}  // namespace quoin
