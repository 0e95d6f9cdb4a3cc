// SPDX-License-Identifier: Apache-2.0
//
// What queries answer in intervals and rationals, once the facet or feature is known.
#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "quoin/kernel/closest_point.h"
#include "quoin/polytope/proximity_queries.h"

namespace quoin {

namespace {

using Enclosed = closest::Vector<Interval>;

Enclosed enclosed(const Point3& t) {
  return {Interval(t.x), Interval(t.y), Interval(t.z)};
}
Enclosed enclosed(const TranslationBody& body, std::uint32_t v) {
  return closest::difference(enclosed(body.point_of_second(v)), enclosed(body.point_of_first(v)));
}
Interval squared_length(const Enclosed& v) {
  return square(v[0]) + square(v[1]) + square(v[2]);
}

/// The plane of a facet, by a corner and a normal.
struct EnclosedPlane {
  EnclosedPlane(const TranslationBody& body, std::uint32_t f)
      : corner(enclosed(body, body.tail(body.first_rim(f)))),
        normal(closest::cross(closest::difference(enclosed(body, body.tail(body.first_rim(f) + 1)), corner),
                              closest::difference(enclosed(body, body.tail(body.first_rim(f) + 2)), corner))) {}
  Interval height(const Point3& t) const { return closest::dot(normal, closest::difference(enclosed(t), corner)); }

  Enclosed corner;
  Enclosed normal;
};

/// The greatest of exact values, of which those are looked at whose enclosures reach up to where the greatest is.
template <class Exact>
std::optional<std::pair<std::uint32_t, Rational>> greatest(
    const std::vector<std::pair<std::uint32_t, Interval>>& enclosures, const Context& context, const Exact& exact) {
  double reach = -std::numeric_limits<double>::infinity();
  for (const auto& enclosure : enclosures) reach = std::max(reach, enclosure.second.lower());
  std::optional<std::pair<std::uint32_t, Rational>> best;
  for (const auto& enclosure : enclosures) {
    if (enclosure.second.upper() < reach) continue;
    context.poll();
    Rational value = exact(enclosure.first);
    if (!best || value > best->second) best.emplace(enclosure.first, std::move(value));
  }
  return best;
}

}  // namespace

Interval ProximityQueries::squared_distance(const TranslationFeature& feature, const Point3& t) const {
  if (feature.dimension == 2) {
    const EnclosedPlane plane(body_, body_.facet_of(feature.rim));
    return square(plane.height(t)) / squared_length(plane.normal);
  }
  const Enclosed origin = enclosed(body_, body_.tail(feature.rim));
  const Enclosed to_t = closest::difference(enclosed(t), origin);
  if (feature.dimension == 0) return squared_length(to_t);
  const Enclosed edge = closest::difference(enclosed(body_, body_.head(feature.rim)), origin);
  return squared_length(closest::cross(edge, to_t)) / squared_length(edge);
}

Rational ProximityQueries::exact_height(std::uint32_t f, const Point3& t) const {
  return dot(body_.exact_normal(f), exact_point(t) - body_.exact(body_.tail(body_.first_rim(f))));
}

/// The nearest point of a feature as a mean of its corners, which are differences of points.
std::array<RationalPoint3, 2> ProximityQueries::witness_of(const TranslationFeature& feature, const Point3& t,
                                                           Rational& squared_length) const {
  const RationalPoint3 from = exact_point(t);
  std::vector<std::uint32_t> corners{body_.tail(feature.rim)};
  if (feature.dimension == 1) corners.push_back(body_.head(feature.rim));
  if (feature.dimension == 2) {
    for (std::uint32_t rim = body_.next(feature.rim); rim != feature.rim; rim = body_.next(rim)) {
      corners.push_back(body_.tail(rim));
    }
  }
  std::vector<closest::Vector<Rational>> polygon;
  for (const std::uint32_t v : corners) {
    const RationalPoint3 p = body_.exact(v) - from;
    polygon.push_back({p.x, p.y, p.z});
  }
  closest::ClosestPoint<Rational> point{polygon[0], closest::dot(polygon[0], polygon[0]), {0, 0, 0}, {1, 0, 0}};
  if (feature.dimension == 1) point = closest::on_edge<Rational>(polygon, 0);
  if (feature.dimension == 2) {
    const RationalPoint3 n = body_.exact_normal(body_.facet_of(feature.rim));
    point = closest::on_polygon<Rational>(polygon, {n.x, n.y, n.z});
  }
  squared_length = std::move(point.squared_length);
  std::array<RationalPoint3, 2> witness{from, {0, 0, 0}};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t v = corners[point.corners[i]];
    witness[0] = witness[0] + exact_point(body_.point_of_first(v)) * point.weights[i];
    witness[1] = witness[1] + exact_point(body_.point_of_second(v)) * point.weights[i];
  }
  return witness;
}

TranslationDistance ProximityQueries::distance(const Vector3& translation, ProximityHint& hint) const {
  const Query t = query_of(translation);
  const TranslationNearest nearest = nearest_of(t, hint);
  TranslationDistance result{nearest.relation, nearest.feature};
  if (nearest.relation == Proximity::overlapping) return result;
  result.witness = witness_of(nearest.feature, t.exact, result.squared_distance);
  return result;
}

/// The foot on the nearest facet plane, from inside, is in the facet.
ShortestPenetration ProximityQueries::shortest_penetration(const Vector3& translation, ProximityHint& hint,
                                                           const Context& context) const {
  const Query t = query_of(translation);
  if (relation_of(t, hint).relation != Proximity::overlapping) return {};
  std::vector<std::pair<std::uint32_t, Interval>> depths;
  for (std::uint32_t f = 0; f < body_.facet_count(); ++f) {
    if (f % 256 == 0) context.poll();
    const EnclosedPlane plane(body_, f);
    depths.emplace_back(f, -(square(plane.height(t.exact)) / squared_length(plane.normal)));
  }
  const auto best = greatest(depths, context, [&](std::uint32_t f) {
    const Rational height = exact_height(f, t.exact);
    const RationalPoint3 n = body_.exact_normal(f);
    return -(height * height / dot(n, n));
  });
  ShortestPenetration result;
  result.facet = best->first;
  result.witness = witness_of({2, body_.first_rim(best->first)}, t.exact, result.squared_depth);
  result.separation = result.witness[1] - result.witness[0];
  return result;
}

/// The part of the way at which it crosses the facet's plane.
Rational ProximityQueries::crossing(std::uint32_t f, const Point3& from, const Point3& to) const {
  const Rational start = exact_height(f, from);
  return start / (start - exact_height(f, to));
}

TranslationPassage ProximityQueries::passage(const Vector3& from, const Vector3& to, ProximityHint& hint,
                                             const Context& context) const {
  const Query a = query_of(from);
  const Query b = query_of(to);
  const auto keeps_apart = [&](std::uint32_t f) { return height(f, a) > 0 && height(f, b) > 0; };
  if (hint.facet < body_.facet_count() && keeps_apart(hint.facet)) return {};
  std::vector<std::pair<std::uint32_t, Interval>> inward;
  std::vector<std::pair<std::uint32_t, Interval>> outward;  // negated
  bool slides = false;
  for (std::uint32_t f = 0; f < body_.facet_count(); ++f) {
    if (f % 256 == 0) context.poll();
    const int start = height(f, a);
    const int end = height(f, b);
    if (start > 0 && end > 0) {
      hint.facet = f;
      return {};
    }
    slides = slides || (start == 0 && end == 0);
    if (start <= 0 && end <= 0) continue;
    const EnclosedPlane plane(body_, f);
    const Interval first = plane.height(a.exact);
    const Interval part = first / (first - plane.height(b.exact));
    if (start > 0) {
      inward.emplace_back(f, part);
    } else {
      outward.emplace_back(f, -part);
    }
  }
  TranslationPassage result{Proximity::overlapping, 0, 1};
  if (auto last = greatest(inward, context, [&](std::uint32_t f) { return crossing(f, a.exact, b.exact); })) {
    result.enter = std::move(last->second);
  }
  if (auto first = greatest(outward, context, [&](std::uint32_t f) { return -crossing(f, a.exact, b.exact); })) {
    result.leave = -first->second;
  }
  if (result.enter > result.leave) return {};
  if (slides || result.enter == result.leave) result.relation = Proximity::touching;
  return result;
}

std::array<std::vector<std::uint32_t>, 2> ProximityQueries::faces_of(const TranslationFeature& feature) const {
  std::array<std::vector<std::uint32_t>, 2> faces;
  const auto add = [&](std::uint32_t v) {
    for (std::size_t k = 0; k < 2; ++k) faces[k].push_back(body_.sources(v)[k]);
  };
  add(body_.tail(feature.rim));
  if (feature.dimension == 1) add(body_.head(feature.rim));
  if (feature.dimension == 2) {
    for (std::uint32_t rim = body_.next(feature.rim); rim != feature.rim; rim = body_.next(rim)) add(body_.tail(rim));
  }
  for (auto& face : faces) {
    std::sort(face.begin(), face.end());
    face.erase(std::unique(face.begin(), face.end()), face.end());
  }
  return faces;
}

}  // namespace quoin
