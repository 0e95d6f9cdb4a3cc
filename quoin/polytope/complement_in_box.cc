// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/complement_in_box.h"

#include "quoin/base/error.h"
#include "quoin/polytope/half_space.h"

namespace quoin {

Solid complement_in_box(const Solid& solid, const ExactBox& reach, const Context& context) {
  if (solid.boundary().is_unbounded) throw InputError("the first operand is unbounded");
  const RationalPoint3 one{Rational(1), Rational(1), Rational(1)};
  const ExactBox box = exact_bounds(solid.boundary()).grown(reach.hi - reach.lo + one);
  return subtract(solid_box(box, context), {&solid, 1}, context);
}

}  // namespace quoin
