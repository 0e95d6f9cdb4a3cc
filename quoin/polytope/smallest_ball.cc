// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/smallest_ball.h"

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "quoin/base/error.h"
#include "quoin/polytope/as_doubles.h"
#include "quoin/polytope/ball_basis.h"
#include "quoin/polytope/ball_filter.h"

namespace quoin {

namespace {

void check_count(std::size_t count) {
  if (count == 0) throw InputError("there are no points that a ball could hold");
}

void check(std::span<const Point3> points, const Context& context) {
  check_count(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % 16384 == 0) context.poll();
    const Point3& p = points[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      throw InputError("point " + std::to_string(i) + " has a coordinate that is not finite");
  }
}

/// The point furthest outside of the ball, up to the rounding of heights in doubles, or BallFilter::nobody.
template <class Point>
std::uint32_t find_outside(std::span<const Point> points, const BallFilter& filter, const SmallestBall& ball,
                           const Context& context) {
  const BallFilter::Outcome filtered = filter.find_outside(ball, context);
  if (filtered.outside != BallFilter::nobody) return filtered.outside;
  const Point& on = points[ball.support[0]];
  std::uint32_t furthest = BallFilter::nobody;
  Rational most(0);
  for (std::size_t i = 0; i < filtered.open.size(); ++i) {
    if (i % 256 == 0) context.poll();
    Rational height = ball_basis::height(ball, on, points[filtered.open[i]]);
    if (height <= most) continue;
    most = std::move(height);
    furthest = filtered.open[i];
  }
  return furthest;
}

template <class Point>
SmallestBall grow(std::span<const Point> points, const Context& context) {
  const BallFilter filter(points, context);
  SmallestBall ball = ball_basis::of_point(points, 0);
  while (true) {
    const std::uint32_t outside = find_outside(points, filter, ball, context);
    if (outside == BallFilter::nobody) return ball;
    const std::size_t steps = ball.steps + 1;
    ball = ball_basis::grown(points, ball, outside);
    ball.steps = steps;
  }
}

}  // namespace

SmallestBall smallest_ball(std::span<const Point3> points, const Context& context) {
  check(points, context);
  return grow(points, context);
}

SmallestBall smallest_ball(std::span<const RationalPoint3> points, const Context& context) {
  check_count(points.size());
  if (const auto doubles = as_doubles(points, &context)) return grow(std::span<const Point3>(*doubles), context);
  return grow(points, context);
}

}  // namespace quoin
