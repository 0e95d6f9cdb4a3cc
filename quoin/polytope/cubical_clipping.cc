// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/cubical_clipping.h"

#include <utility>

namespace quoin::cube {

namespace {

/// Directions between two that are less than half a turn apart.
struct Wedge {
  Direction from;
  Direction to;
  bool has_source = true;
  bool has_target = true;
};

Direction cross(const Direction& a, const Direction& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

bool is_opposite(const Direction& a, const Direction& b) {
  for (const Integer& component : cross(a, b)) {
    if (component.sign() != Sign::zero) return false;
  }
  return (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]).sign() == Sign::negative;
}

/// A direction is over a square if the coordinate across it exceeds the other two in magnitude; that makes four half
/// spaces. This is positive inside number `i`.
Integer height(const Direction& d, std::size_t square, unsigned i) {
  const Integer& across = d[axis(square)];
  const Integer& along = d[i < 2 ? x_axis(square) : y_axis(square)];
  Integer value = sign(square) > 0 ? across : -across;
  if (i % 2 == 0) {
    value += along;
  } else {
    value -= along;
  }
  return value;
}

/// Where the wedge meets the plane of a half space, as primitive integers.
Direction cut(const Wedge& wedge, const Integer& from_height, const Integer& to_height) {
  const Integer a = abs(to_height);
  const Integer b = abs(from_height);
  Direction d;
  for (std::size_t i = 0; i < 3; ++i) d[i] = wedge.from[i] * a + wedge.to[i] * b;
  return SphereDirection(d).primitive().integers();
}

/// The part over a square, unless it is one direction or none.
std::optional<Wedge> clipped(Wedge wedge, std::size_t square) {
  for (unsigned i = 0; i < 4; ++i) {
    const Integer from = height(wedge.from, square, i);
    const Integer to = height(wedge.to, square, i);
    const bool is_from_out = from.sign() == Sign::negative;
    const bool is_to_out = to.sign() == Sign::negative;
    if (!is_from_out && !is_to_out) continue;
    if ((is_from_out || from.sign() == Sign::zero) && (is_to_out || to.sign() == Sign::zero)) return std::nullopt;
    if (is_from_out) {
      wedge.from = cut(wedge, from, to);
      wedge.has_source = false;
    } else {
      wedge.to = cut(wedge, from, to);
      wedge.has_target = false;
    }
  }
  return wedge;
}

RationalPoint2 projected(const Direction& d, std::size_t square) {
  const Integer across = abs(d[axis(square)]);
  return {Rational(d[x_axis(square)], across), Rational(d[y_axis(square)], across)};
}

}  // namespace

Clipping::Clipping(const MapArcs& map) : map_(map) {
  normals_.reserve(map.normals.size());
  for (const SphereDirection& normal : map.normals) normals_.push_back(normal.primitive().integers());
}

/// Half a turn is two wedges. A square is less than half a turn wide, so that the two parts make one.
std::optional<Part> Clipping::on_square(std::size_t arc, std::size_t square) const {
  Wedge wedge{normals_[map_.arcs[arc].source], normals_[map_.arcs[arc].target]};
  std::optional<Wedge> part;
  if (is_opposite(wedge.from, wedge.to)) {
    const Direction middle = cross(map_.edges[arc].integers(), wedge.from);
    part = clipped({wedge.from, middle, true, false}, square);
    const std::optional<Wedge> second = clipped({middle, wedge.to, false, true}, square);
    if (part && second) {
      part->to = second->to;
      part->has_target = second->has_target;
    } else if (second) {
      part = second;
    }
  } else {
    part = clipped(std::move(wedge), square);
  }
  if (!part) return std::nullopt;
  return Part{projected(part->from, square), projected(part->to, square), part->has_source, part->has_target};
}

}  // namespace quoin::cube
