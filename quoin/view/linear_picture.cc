// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/picture_traits.h"

namespace quoin {

namespace {

Point2 rounded(const RationalPoint2& p) {
  return {p.x.to_double(), p.y.to_double()};
}

/// Where the half line from a point of the box leaves it.
Point2 exit_of(const Point2& from, const Vector2& direction, const PictureBox& box) {
  const auto time = [](double start, double speed, double low, double high) {
    if (speed == 0) return std::numeric_limits<double>::infinity();
    return std::max(0.0, ((speed > 0 ? high : low) - start) / speed);
  };
  const double tx = time(from.x, direction.x, box.low.x, box.high.x);
  const double ty = time(from.y, direction.y, box.low.y, box.high.y);
  if (tx <= ty) {
    const double y = direction.y == 0 ? from.y : from.y + tx * direction.y;
    return {direction.x > 0 ? box.high.x : box.low.x, std::clamp(y, box.low.y, box.high.y)};
  }
  const double x = direction.x == 0 ? from.x : from.x + ty * direction.x;
  return {std::clamp(x, box.low.x, box.high.x), direction.y > 0 ? box.high.y : box.low.y};
}

}  // namespace

PicturePath PictureTraits<LinearFamily>::piece(const LinearFamily& family, BranchId line, const LinearPoint& left,
                                               const LinearPoint& right, const PictureBox& reach) {
  if (!left.is_end() && !right.is_end()) return {family.position(left), {line_to(family.position(right))}};
  const Point2 a = rounded(family.first_support_point(line));
  const Point2 b = rounded(family.second_support_point(line));
  const double size = std::max(std::fabs(b.x - a.x), std::fabs(b.y - a.y));
  if (!(size > 0)) return {a, {}};  // two points that rounding made one
  const Vector2 forward{(b.x - a.x) / size, (b.y - a.y) / size};
  const Vector2 back{-forward.x, -forward.y};
  const Point2 from = !left.is_end() ? family.position(left) : !right.is_end() ? family.position(right) : a;
  const Point2 start = left.is_end() ? exit_of(from, back, reach) : family.position(left);
  const Point2 end = right.is_end() ? exit_of(from, forward, reach) : family.position(right);
  return {start, {line_to(end)}};
}

std::array<Point2, 2> PictureTraits<LinearFamily>::anchors(const LinearFamily& family, BranchId line) {
  return {rounded(family.first_support_point(line)), rounded(family.second_support_point(line))};
}

}  // namespace quoin
