// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/lower_chain.h"

#include <cstddef>
#include <utility>

#include "quoin/number/rational.h"

namespace quoin {

namespace {

/// A point of a line by a coordinate along it, and its height above it, less its weight.
struct Lifted {
  std::uint32_t place;
  Rational along;
  Rational height;

  Lifted(std::uint32_t at, const Point3& p, double weight, std::size_t axis)
      : place(at), along(p[axis]), height(-Rational(weight)) {
    for (const double x : {p.x, p.y, p.z}) height += Rational(x) * Rational(x);
  }
};

bool is_above(const Lifted& b, const Lifted& a, const Lifted& c) {
  return (b.height - a.height) * (c.along - a.along) > (c.height - a.height) * (b.along - a.along);
}

}  // namespace

std::vector<std::uint32_t> lower_chain(std::span<const Point3> points, std::span<const double> weights,
                                       const Context& context) {
  std::vector<std::uint32_t> places;
  if (points.empty()) return places;
  const Point3& first = points.front();
  const Point3& last = points.back();
  const std::size_t axis = first.x != last.x ? 0 : first.y != last.y ? 1 : 2;
  std::vector<Lifted> chain;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (i % 256 == 0) context.poll();
    if (i > 0 && points[i] == points[i - 1]) continue;
    Lifted next(i, points[i], weights[i], axis);
    while (chain.size() > 1 && is_above(chain.back(), chain[chain.size() - 2], next)) chain.pop_back();
    chain.push_back(std::move(next));
  }
  for (const Lifted& lifted : chain) places.push_back(lifted.place);
  return places;
}

}  // namespace quoin
