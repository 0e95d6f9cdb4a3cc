// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/solid_penetration.h"

#include "quoin/base/error.h"
#include "quoin/polytope/solid_sum.h"
#include "quoin/solid/nearest_tile.h"
#include "quoin/solid/placement.h"

namespace quoin {

namespace {

/// Where a ray passes the plane of a closed triangle within it.
std::optional<Rational> passage(const std::array<RationalPoint3, 3>& t, const RationalPoint3& from,
                                const RationalPoint3& direction) {
  const RationalPoint3 normal = cross(t[1] - t[0], t[2] - t[0]);
  const Rational speed = dot(normal, direction);
  if (speed.sign() == Sign::zero) return std::nullopt;
  const Rational at = dot(normal, t[0] - from) / speed;
  if (at.sign() == Sign::negative) return std::nullopt;
  const RationalPoint3 p = from + direction * at;
  for (std::size_t k = 0; k < 3; ++k) {
    if (dot(normal, cross(t[(k + 1) % 3] - t[k], p - t[k])).sign() == Sign::negative) return std::nullopt;
  }
  return at;
}

}  // namespace

SolidPenetration::SolidPenetration(const Solid& first, const Solid& second, const Context& context)
    : sum_(minkowski_sum(second, reflected(first, {}, context), context)) {
  if (sum_.is_empty()) return;
  const auto leaf = leaf_of(sum_, "the sum", context);
  points_ = leaf->exact_vertices.empty() ? Constructions(leaf->vertices) : Constructions(leaf->exact_vertices);
  for (const Tile& t : leaf->tiles)
    tiles_.push_back({PointId{std::size_t{t[0]}}, PointId{std::size_t{t[1]}}, PointId{std::size_t{t[2]}}});
  locator_ = std::make_unique<const SolidLocator>(sum_.boundary(), context);
}

bool SolidPenetration::is_inside(const RationalPoint3& translation) const {
  return locator_ != nullptr && locator_->locate(translation).place == Place::in;
}

std::optional<SolidPenetration::Shortest> SolidPenetration::shortest(const RationalPoint3& translation,
                                                                     const Context& context) const {
  if (!is_inside(translation)) return std::nullopt;
  const auto nearest = nearest_point(translation, points_, tiles_, TouchingTiles::count, context);
  return Shortest{nearest->squared_distance, nearest->point - translation};
}

Rational SolidPenetration::along(const RationalPoint3& translation, const RationalPoint3& direction,
                                 const Context& context) const {
  if (direction == RationalPoint3{}) throw InputError("the direction is zero");
  if (!is_inside(translation)) return Rational(0);
  std::optional<Rational> first;
  for (const auto& [a, b, c] : tiles_) {
    context.poll();
    const auto at = passage({points_.exact(a), points_.exact(b), points_.exact(c)}, translation, direction);
    if (at && (!first || *at < *first)) first = at;
  }
  if (!first) throw InternalError("a ray does not leave a bounded set");
  return *first;
}

}  // namespace quoin
