// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/circular_picture.h"

namespace quoin {

PicturePath PictureTraits<CircularFamily>::piece(const CircularFamily& family, BranchId branch,
                                                 const CircularPoint& left, const CircularPoint& right,
                                                 const PictureBox& /*reach*/) {
  const Point2 from = family.position(left);
  const Point2 to = family.position(right);
  if (family.is_line(branch) || from == to) return {from, {line_to(to)}};
  const CircularSupport& circle = family.rounded(CircularFamily::support(branch));
  const Point2 center{circle.x, circle.y};
  // Angles from the x-axis within the half circle, so that rounding cannot lead around the other way.
  const auto angle = [&](const Point2& p) { return std::atan2(std::fabs(p.y - center.y), p.x - center.x); };
  const double turn = angle(from) - angle(to);
  if (turn <= 0) return {from, {line_to(to)}};  // closer than rounding
  return {from, {arc_to(to, center, CircularFamily::is_upper(branch) ? -turn : turn)}};
}

}  // namespace quoin
