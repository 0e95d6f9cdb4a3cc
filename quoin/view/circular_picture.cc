// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/circular_picture.h"

#include <cmath>

namespace quoin {

PicturePath PictureTraits<CircularFamily>::piece(const CircularFamily& family, BranchId branch,
                                                 const CircularPoint& left, const CircularPoint& right,
                                                 const PictureBox&) {
  const Point2 from = family.position(left);
  const Point2 to = family.position(right);
  if (family.is_line(branch)) return {from, {line_to(to)}};
  const RationalCircle circle = family.circle(CircularFamily::support(branch));
  const Point2 center{circle.x.to_double(), circle.y.to_double()};
  const double from_angle = std::atan2(from.y - center.y, from.x - center.x);
  const double to_angle = std::atan2(to.y - center.y, to.x - center.x);
  constexpr double full = 6.283185307179586;
  // From left to right the upper half runs clockwise, the lower one counterclockwise; neither turns more than half.
  double sweep = std::remainder(to_angle - from_angle, full);
  if (CircularFamily::is_upper(branch) && sweep > 0) sweep -= full;
  if (!CircularFamily::is_upper(branch) && sweep < 0) sweep += full;
  return {from, {arc_to(to, center, sweep)}};
}

}  // namespace quoin
