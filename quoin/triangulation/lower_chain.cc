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

/// Of b above the line through a and c, where a is before c; the opposite, where c is.
Sign side_above(const Lifted& b, const Lifted& a, const Lifted& c) {
  return ((b.height - a.height) * (c.along - a.along) - (c.height - a.height) * (b.along - a.along)).sign();
}

/// Along which two points of a line differ.
std::size_t axis_of_line(const Point3& a, const Point3& b) {
  return a.x != b.x ? 0 : a.y != b.y ? 1 : 2;
}

}  // namespace

std::vector<std::uint32_t> lower_chain(std::span<const Point3> points, std::span<const double> weights,
                                       const Context& context) {
  std::vector<std::uint32_t> places;
  if (points.empty()) return places;
  const std::size_t axis = axis_of_line(points.front(), points.back());
  std::vector<Lifted> chain;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (i % 256 == 0) context.poll();
    if (i > 0 && points[i] == points[i - 1]) continue;
    Lifted next(i, points[i], weights[i], axis);
    while (chain.size() > 1 && side_above(chain.back(), chain[chain.size() - 2], next) == Sign::positive) {
      chain.pop_back();
    }
    chain.push_back(std::move(next));
  }
  for (const Lifted& lifted : chain) places.push_back(lifted.place);
  return places;
}

Sign side_of_chord(const WeightedPoint3& p, const WeightedPoint3& a, const WeightedPoint3& b) {
  const std::size_t axis = axis_of_line(a.point, b.point);
  const Lifted from(0, a.point, a.weight, axis);
  const Lifted to(0, b.point, b.weight, axis);
  const Sign side = side_above(Lifted(0, p.point, p.weight, axis), from, to);
  return from.along < to.along ? side : -side;
}

}  // namespace quoin
