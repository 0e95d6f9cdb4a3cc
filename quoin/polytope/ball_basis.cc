// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/ball_basis.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>

#include "quoin/base/error.h"

namespace quoin::ball_basis {

namespace {

constexpr std::size_t most = 3;  // points of a support besides one

RationalPoint3 exact(const Point3& p) {
  return exact_point(p);
}
const RationalPoint3& exact(const RationalPoint3& p) {
  return p;
}

/// Linear equations in as many unknowns, the last column on the right side.
using Equations = std::array<std::array<Rational, most + 1>, most>;

/// @return whether there is one solution, which the last column then holds
bool solve(Equations& m, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) {
    std::size_t pivot = i;
    while (pivot < size && m[pivot][i].sign() == Sign::zero) ++pivot;
    if (pivot == size) return false;
    std::swap(m[i], m[pivot]);
    for (std::size_t k = size + 1; k-- > i;) m[i][k] /= m[i][i];
    for (std::size_t row = 0; row < size; ++row) {
      if (row == i) continue;
      const Rational factor = m[row][i];
      for (std::size_t k = i; k <= size; ++k) m[row][k] -= factor * m[i][k];
    }
  }
  for (std::size_t i = 0; i < size; ++i) std::swap(m[i][most], m[i][size]);
  return true;
}

/// A ball with all of some points on its sphere and its center inside their simplex: there is one at most, and none if
/// they do not span one.
///
/// With the center at a + sum of t_k v_k for the vectors v_k from the first point a to the others, equal distances mean
/// 2 v_i.(sum of t_k v_k) = v_i.v_i; inside is where all t_k and what they lack to one are positive.
template <class Point>
std::optional<SmallestBall> ball_through(std::span<const Point> points, std::vector<std::uint32_t> support) {
  const RationalPoint3 a = exact(points[support[0]]);
  const std::size_t size = support.size() - 1;
  std::array<RationalPoint3, most> v;
  for (std::size_t i = 0; i < size; ++i) v[i] = exact(points[support[i + 1]]) - a;
  Equations m;
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t k = 0; k < size; ++k) m[i][k] = dot(v[i], v[k]) * Rational(2);
    m[i][size] = dot(v[i], v[i]);
  }
  if (!solve(m, size)) return std::nullopt;
  Rational rest(1);
  RationalPoint3 to_center;
  for (std::size_t i = 0; i < size; ++i) {
    if (m[i][most].sign() != Sign::positive) return std::nullopt;
    rest -= m[i][most];
    to_center = to_center + v[i] * m[i][most];
  }
  if (rest.sign() != Sign::positive) return std::nullopt;
  std::sort(support.begin(), support.end());
  return SmallestBall{a + to_center, dot(to_center, to_center), std::move(support), 0};
}

}  // namespace

template <class Point>
SmallestBall of_point(std::span<const Point> points, std::uint32_t only) {
  return {exact(points[only]), Rational(0), {only}, 0};
}

/// |p - c|^2 - |s - c|^2 = (p - s).(p + s - 2 c).
template <class Point>
Rational height(const SmallestBall& ball, const Point& support, const Point& p) {
  Rational value(0);
  if (p == support) return value;
  for (unsigned axis = 0; axis < 3; ++axis) {
    const Rational step = Rational(p[axis]) - Rational(support[axis]);
    value += step * (step + (Rational(support[axis]) - ball.center[axis]) * Rational(2));
  }
  return value;
}

/// The new point is in every support of the new ball. So of all sets of it and others of the old support one has a ball
/// with the center inside that holds the rest too: it is the smallest, since no smaller one holds the set.
template <class Point>
SmallestBall grown(std::span<const Point> points, const SmallestBall& ball, std::uint32_t outside) {
  const std::vector<std::uint32_t>& old = ball.support;
  for (unsigned subset = 1; subset < (1U << old.size()); ++subset) {
    std::vector<std::uint32_t> support{outside};
    for (std::size_t i = 0; i < old.size(); ++i) {
      if ((subset >> i & 1U) != 0) support.push_back(old[i]);
    }
    if (support.size() > most + 1) continue;
    std::optional<SmallestBall> found = ball_through(points, std::move(support));
    if (!found) continue;
    const auto is_outside = [&](std::uint32_t i) {
      return height(*found, points[outside], points[i]).sign() == Sign::positive;
    };
    if (std::none_of(old.begin(), old.end(), is_outside)) return std::move(*found);
  }
  throw InternalError("no ball through a point outside of another");
}

template SmallestBall of_point(std::span<const Point3> points, std::uint32_t only);
template SmallestBall of_point(std::span<const RationalPoint3> points, std::uint32_t only);
template SmallestBall grown(std::span<const Point3> points, const SmallestBall& ball, std::uint32_t outside);
template SmallestBall grown(std::span<const RationalPoint3> points, const SmallestBall& ball, std::uint32_t outside);
template Rational height(const SmallestBall& ball, const Point3& support, const Point3& p);
template Rational height(const SmallestBall& ball, const RationalPoint3& support, const RationalPoint3& p);

}  // namespace quoin::ball_basis
