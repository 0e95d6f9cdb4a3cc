// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/constructions.h"
#include "quoin/solid/query/point_location.h"
#include "quoin/solid/solid.h"

namespace quoin {

/// How deep two solids lie in one another, for any translation of the first: by the sum of the second and the first
/// reflected, whose boundary is where they only touch.
///
/// Exact, for any two bounded solids (solid_sum.h).
class SolidPenetration {
 public:
  /// Cost of the sum. @throws InputError  a solid is unbounded; Cancelled
  SolidPenetration(const Solid& first, const Solid& second, const Context& context);

  struct Shortest {
    Rational squared_depth{0};
    RationalPoint3 separation{};  ///< of the first, until they only touch
  };
  /// Nothing where they have no points inside in common. O(faces of the sum).
  std::optional<Shortest> shortest(const RationalPoint3& translation, const Context& context) const;

  /// The least number a >= 0 such that moving the first by `a` times the direction leaves no points inside in common:
  /// 0 where they have none. O(faces of the sum). @throws InputError  the direction is zero
  Rational along(const RationalPoint3& translation, const RationalPoint3& direction, const Context& context) const;

 private:
  bool is_inside(const RationalPoint3& translation) const;

  Solid sum_;
  Constructions points_{std::vector<Point3>{}};
  std::vector<std::array<PointId, 3>> tiles_;
  std::unique_ptr<const SolidLocator> locator_;  // none of an empty sum
};

}  // namespace quoin
