// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "quoin/arrangement/geodesic/direction_pool.h"
#include "quoin/arrangement/geodesic/geodesic_family.h"
#include "quoin/number/fixed_int.h"
#include "quoin/number/integer.h"

/// Exact arithmetic of the geodesic family, by width. A tier of N words holds normals of at most m = 64 N - 2 bits and
/// input directions of at most 2 m + 1 bits; then crossings m x n fit in 2 N words (2 m + 1 bits), scalar products with
/// normals in 3 N (3 m + 3), and 2x2 determinants of points in 4 N (4 m + 3).
namespace quoin::geodesic_exact {

template <std::size_t N>
struct FixedTier {
  using Normal = FixedInt<N>;
  using Coordinate = FixedInt<2 * N>;
};

struct AnySizeTier {
  using Normal = Integer;
  using Coordinate = Integer;
};

template <std::size_t N, std::size_t M>
FixedInt<N + M> product(const FixedInt<N>& a, const FixedInt<M>& b) {
  return multiply<N + M>(a, b);
}
inline Integer product(const Integer& a, const Integer& b) {
  return a * b;
}

/// Words of the tier for normals, and for directions of the input, of that many bits.
constexpr std::uint8_t tier_of_normal(unsigned bits) {
  return bits <= 62 ? 1 : bits <= 126 ? 2 : bits <= 254 ? 4 : GeodesicFamily::any_size;
}
constexpr std::uint8_t tier_of_direction(unsigned bits) {
  return bits <= 125 ? 1 : bits <= 253 ? 2 : bits <= 509 ? 4 : GeodesicFamily::any_size;
}

/// Calls the function with the tier.
template <class Function>
auto with_tier(std::uint8_t tier, const Function& function) {
  switch (tier) {
    case 1:
      return function(FixedTier<1>());
    case 2:
      return function(FixedTier<2>());
    case 4:
      return function(FixedTier<4>());
    default:
      return function(AnySizeTier());
  }
}

template <class Tier>
typename Tier::Normal normal_component(const DirectionPool& normals, std::uint32_t support, std::size_t axis) {
  typename Tier::Normal value{};
  normals.load(support, axis, value);
  return value;
}

/// Component of n_a x n_b.
template <class Tier>
typename Tier::Coordinate cross_component(const DirectionPool& normals, std::uint32_t a, std::uint32_t b,
                                          std::size_t axis) {
  const std::size_t j = axis == 2 ? 0 : axis + 1;
  const std::size_t k = axis == 0 ? 2 : axis - 1;
  return product(normal_component<Tier>(normals, a, j), normal_component<Tier>(normals, b, k)) -
         product(normal_component<Tier>(normals, a, k), normal_component<Tier>(normals, b, j));
}

/// Component of the direction of a point; at a pole end of the horizontal direction of its meridian.
template <class Tier>
typename Tier::Coordinate coordinate(const DirectionPool& normals, const DirectionPool& directions,
                                     const GeodesicFamily::Point& p, std::size_t axis) {
  if (p.is_crossing()) {
    return p.sign > 0 ? cross_component<Tier>(normals, p.first, p.second, axis)
                      : cross_component<Tier>(normals, p.second, p.first, axis);
  }
  typename Tier::Coordinate value{};
  directions.load(p.first, axis, value);
  return value;
}

/// Sign of p_i q_j - p_j q_i.
template <class Tier>
Sign determinant_sign(const DirectionPool& normals, const DirectionPool& directions, const GeodesicFamily::Point& p,
                      const GeodesicFamily::Point& q, std::size_t i, std::size_t j) {
  const auto difference =
      product(coordinate<Tier>(normals, directions, p, i), coordinate<Tier>(normals, directions, q, j)) -
      product(coordinate<Tier>(normals, directions, p, j), coordinate<Tier>(normals, directions, q, i));
  return difference.sign();
}

/// Sign of n . p.
template <class Tier>
Sign scalar_product_sign(const DirectionPool& normals, const DirectionPool& directions, std::uint32_t support,
                         const GeodesicFamily::Point& p) {
  const auto term = [&](std::size_t axis) {
    return product(normal_component<Tier>(normals, support, axis), coordinate<Tier>(normals, directions, p, axis));
  };
  const auto sum = term(0) + term(1) + term(2);
  return sum.sign();
}

}  // namespace quoin::geodesic_exact
