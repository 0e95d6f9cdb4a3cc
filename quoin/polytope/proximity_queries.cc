// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/proximity_queries.h"

#include <algorithm>
#include <cmath>

#include "quoin/base/error.h"

namespace quoin {

namespace {

constexpr std::uint32_t none = ProximityHint::none;

void require_finite(const Vector3& v, const char* what) {
  if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) {
    throw InputError(std::string(what) + " is not finite");
  }
}

}  // namespace

/// The point of a facet that is closest to a translation: in the interior of a feature.
struct ProximityQueries::Closest {
  TranslationFeature feature;
  bool is_foot = false;  ///< the foot of the perpendicular
};

ProximityQueries::ProximityQueries(const Polytope& first, const Polytope& second, const Context& context)
    : body_(first, second, context), filters_(body_, context) {
  fill_table(context);
}

ProximityQueries::Query ProximityQueries::query_of(const Vector3& translation) const {
  const Point3 t{translation.x, translation.y, translation.z};
  const Query query{t, filters_.query(t)};
  if (!std::isfinite(query.rounded.size)) require_finite(translation, "the translation");
  return query;
}

int ProximityQueries::height(std::uint32_t f, const Query& t) const {
  const int sign = filters_.height(f, t.rounded);
  return sign != 0 ? sign : to_int(body_.height(f, t.exact));
}
int ProximityQueries::seen(std::uint32_t rim, const Query& t) const {
  const int sign = filters_.seen(rim, t.rounded);
  return sign != 0 ? sign : to_int(body_.seen(rim, t.exact));
}
int ProximityQueries::along(std::uint32_t rim, const Query& t) const {
  const int sign = filters_.along(body_.tail(rim), body_.head(rim), t.rounded);
  return sign != 0 ? sign : to_int(body_.along(rim, t.exact));
}
int ProximityQueries::across(std::uint32_t rim, const Query& t) const {
  const int sign = filters_.across(body_.facet_of(rim), body_.tail(rim), body_.head(rim), t.rounded);
  return sign != 0 ? sign : to_int(body_.across(rim, t.exact));
}
int ProximityQueries::seen_along(std::uint32_t rim, const Query& t, const Vector3& direction) const {
  const int sign = filters_.seen_along(body_.tail(rim), body_.head(rim), t.rounded, direction);
  return sign != 0 ? sign : to_int(body_.seen_along(rim, t.exact, direction));
}

/// Cells of the faces of a cube, by the largest component of a direction.
std::size_t ProximityQueries::cell_of(const Vector3& d) const {
  std::size_t axis = std::fabs(d.y) > std::fabs(d.x) ? 1 : 0;
  if (std::fabs(d.z) > std::fabs(d[axis])) axis = 2;
  const double size = std::fabs(d[axis]);
  const auto place = [&](double x) {
    const double cell = (x / size + 1) * 0.5 * static_cast<double>(table_size_);
    return cell > 0 ? std::min(static_cast<std::size_t>(cell), table_size_ - 1) : 0;  // 0 of a NaN
  };
  const std::size_t face = 2 * axis + (d[axis] < 0 ? 1 : 0);
  return (face * table_size_ + place(d[(axis + 1) % 3])) * table_size_ + place(d[(axis + 2) % 3]);
}

/// About twelve facets in a cell; rows of cells there and back, so that each walk is short.
void ProximityQueries::fill_table(const Context& context) {
  table_size_ = std::clamp<std::size_t>(static_cast<std::size_t>(std::sqrt(body_.facet_count() / 12.0)), 2, 48);
  table_.assign(6 * table_size_ * table_size_, 0);
  std::uint32_t last = 0;
  std::uint64_t steps = 0;
  for (std::size_t face = 0; face < 6; ++face) {
    for (std::size_t i = 0; i < table_size_; ++i) {
      context.poll();
      for (std::size_t k = 0; k < table_size_; ++k) {
        const std::size_t j = i % 2 == 0 ? k : table_size_ - 1 - k;
        const auto middle = [&](std::size_t x) {
          return (2.0 * static_cast<double>(x) + 1) / static_cast<double>(table_size_) - 1;
        };
        std::array<double, 3> d{};
        d[face / 2] = face % 2 == 0 ? 1 : -1;
        d[(face / 2 + 1) % 3] = middle(i);
        d[(face / 2 + 2) % 3] = middle(j);
        const Query t = query_of(filters_.towards({d[0], d[1], d[2]}));
        last = walk(last, last, steps, [&](std::uint32_t rim) { return seen(rim, t) < 0; });
        table_[(face * table_size_ + i) * table_size_ + j] = last;
      }
    }
  }
}

/// From facet to facet across rims beyond which it goes on; once from the other facet, if the first seems far away.
template <class Beyond>
std::uint32_t ProximityQueries::walk(std::uint32_t from, std::uint32_t other, std::uint64_t& steps,
                                     const Beyond& beyond) const {
  constexpr std::uint64_t far = 12;
  std::uint32_t f = from;
  std::uint32_t entered = none;  // the rim that the walk came in by, which it does not go out by
  for (std::uint64_t count = 0;; ++count) {
    if (count == far && other != from) {
      f = other;
      entered = none;
    }
    std::uint32_t out = none;
    for (std::uint32_t rim = body_.first_rim(f); rim < body_.end_rim(f); ++rim) {
      if (rim == entered || !beyond(rim)) continue;
      out = rim;
      break;
    }
    if (out == none) return f;
    entered = body_.twin(out);
    f = body_.facet_of(entered);
    ++steps;
  }
}

std::uint32_t ProximityQueries::hiding_facet(const Query& t, ProximityHint& hint) const {
  const std::uint32_t other = start(t);
  const std::uint32_t from = hint.facet < body_.facet_count() ? hint.facet : other;
  hint.facet = walk(from, other, hint.steps, [&](std::uint32_t rim) { return seen(rim, t) < 0; });
  return hint.facet;
}

/// Of a translation on the boundary: the rims of the facet it lies on.
TranslationFeature ProximityQueries::contact(std::uint32_t f, const Query& t) const {
  TranslationFeature feature{2, body_.first_rim(f)};
  for (std::uint32_t rim = body_.first_rim(f); rim < body_.end_rim(f); ++rim) {
    if (seen(rim, t) != 0) continue;
    --feature.dimension;
    // Of two, the second, unless they are the first and the last.
    if (feature.dimension == 1 || body_.next(rim) != feature.rim) feature.rim = rim;
  }
  return feature;
}

TranslationRelation ProximityQueries::relation_of(const Query& t, ProximityHint& hint) const {
  if (hint.facet < body_.facet_count() && height(hint.facet, t) > 0) {
    return {Proximity::apart, {2, body_.first_rim(hint.facet)}};
  }
  const std::uint32_t f = hiding_facet(t, hint);
  const int sign = height(f, t);
  if (sign == 0) return {Proximity::touching, contact(f, t)};
  return {sign > 0 ? Proximity::apart : Proximity::overlapping, {2, body_.first_rim(f)}};
}

/// The foot, if it is on the inner side of all rims. Else an edge with the foot on its outer side and between the
/// planes through its ends; or a vertex with the foot behind both its edges, one of which has it on its outer side.
ProximityQueries::Closest ProximityQueries::closest_in(std::uint32_t f, const Query& t) const {
  Closest foot{{2, body_.first_rim(f)}, true};
  bool is_inside = true;
  for (std::uint32_t rim = body_.first_rim(f); rim < body_.end_rim(f); ++rim) {
    const int sign = across(rim, t);
    if (sign > 0) continue;
    if (sign == 0) {
      --foot.feature.dimension;
      if (foot.feature.dimension == 1 || body_.next(rim) != foot.feature.rim) foot.feature.rim = rim;
      continue;
    }
    is_inside = false;
    const bool is_behind_tail = along(rim, t) <= 0;
    const bool is_behind_head = along(body_.twin(rim), t) <= 0;
    if (!is_behind_tail && !is_behind_head) return {{1, rim}};
    if (is_behind_tail) {
      const std::uint32_t last = rim > body_.first_rim(f) ? rim - 1 : body_.end_rim(f) - 1;
      if (along(body_.twin(last), t) <= 0) return {{0, rim}};
    }
    if (is_behind_head && along(body_.next(rim), t) <= 0) return {{0, body_.next(rim)}};
  }
  if (!is_inside) throw InternalError("no feature of a facet is closest");
  return foot;
}

/// A facet that is not behind the translation's back and has a point that is nearer than the closest one of the last
/// facet; none if that is the nearest of all.
std::uint32_t ProximityQueries::nearer_facet(const Closest& spot, const Query& t) const {
  if (spot.is_foot) return none;
  const std::uint32_t rim = spot.feature.rim;
  if (spot.feature.dimension == 1) {
    const std::uint32_t twin = body_.twin(rim);
    return across(twin, t) > 0 ? body_.facet_of(twin) : none;
  }
  std::uint32_t out = rim;
  do {
    if (along(out, t) > 0) {
      for (const std::uint32_t f : {body_.facet_of(out), body_.facet_of(body_.twin(out))}) {
        if (height(f, t) >= 0) return f;
      }
    }
    out = body_.next_about_tail(out);
  } while (out != rim);
  return none;
}

TranslationNearest ProximityQueries::nearest_of(const Query& t, ProximityHint& hint) const {
  const TranslationRelation found = relation_of(t, hint);
  if (found.relation != Proximity::apart) return {found.relation, found.feature, Interval(0.0)};
  std::uint32_t f = hint.facet;
  for (;;) {
    const Closest spot = closest_in(f, t);
    const std::uint32_t nearer = nearer_facet(spot, t);
    if (nearer == none) {
      hint.facet = f;
      return {Proximity::apart, spot.feature};
    }
    f = nearer;
    ++hint.steps;
  }
}

TranslationRelation ProximityQueries::relation(const Vector3& translation, ProximityHint& hint) const {
  return relation_of(query_of(translation), hint);
}

TranslationNearest ProximityQueries::nearest(const Vector3& translation, ProximityHint& hint) const {
  const Query t = query_of(translation);
  TranslationNearest result = nearest_of(t, hint);
  if (result.relation == Proximity::apart) result.squared_distance = squared_distance(result.feature, t.exact);
  return result;
}

DirectionalPenetration ProximityQueries::penetration(const Vector3& translation, const Vector3& direction,
                                                     ProximityHint& hint) const {
  require_finite(direction, "the direction");
  if (direction == Vector3{}) throw InputError("the direction is zero");
  const Query t = query_of(translation);
  if (relation_of(t, hint).relation != Proximity::overlapping) return {};
  const std::uint32_t other = table_[cell_of(direction)];
  const std::uint32_t from = hint.exit < body_.facet_count() ? hint.exit : other;
  const std::uint32_t f =
      walk(from, other, hint.steps, [&](std::uint32_t rim) { return seen_along(rim, t, direction) < 0; });
  hint.exit = f;
  const RationalPoint3 along = exact_point({direction.x, direction.y, direction.z});
  return {-exact_height(f, t.exact) / dot(body_.exact_normal(f), along), f};
}

}  // namespace quoin
