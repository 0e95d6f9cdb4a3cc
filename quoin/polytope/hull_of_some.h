// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/base/large_vector.h"
#include "quoin/kernel/point.h"
#include "quoin/polytope/hull_builder.h"
#include "quoin/polytope/hull_order.h"
#include "quoin/polytope/hull_simplex.h"

namespace quoin {

/// The hull of some of the points and of a simplex of theirs, built in rounds, on several threads where there are many
/// points. Stays where it is.
struct HullOfSome {
  /// `chosen` without repetition. O(m log m) for m of them, as expected over the order.
  /// @throws Cancelled
  HullOfSome(std::span<const Point3> points, std::span<const std::uint32_t> chosen, const Simplex& simplex,
             const Context& context);
  HullOfSome(const HullOfSome&) = delete;
  HullOfSome& operator=(const HullOfSome&) = delete;

  std::vector<std::uint32_t> order;  ///< the simplex, then the others
  LargeVector<Point3> ordered;
  HullBuilder builder;  ///< of `ordered`

 private:
  HullOfSome(std::span<const Point3> points, const RandomOrder& rounds, const Simplex& simplex, const Context& context);
};

}  // namespace quoin
