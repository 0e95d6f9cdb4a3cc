// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/piece_bulge.h"

#include <algorithm>
#include <cmath>

namespace quoin {

/// The sine of half the angle over one and its cosine; a piece turns through half a circle at most.
double bulge_between(const CircularFamily& family, BranchId branch, const Point2& left, const Point2& right) {
  if (family.is_line(branch)) return 0;
  const CircularSupport& circle = family.rounded(CircularFamily::support(branch));
  const double half_chord = 0.5 * std::hypot(right.x - left.x, right.y - left.y);
  const double to_chord = std::hypot(0.5 * (left.x + right.x) - circle.x, 0.5 * (left.y + right.y) - circle.y);
  const double bulge = std::min(1.0, half_chord / (circle.radius + to_chord));
  return CircularFamily::is_upper(branch) ? -bulge : bulge;
}

}  // namespace quoin
