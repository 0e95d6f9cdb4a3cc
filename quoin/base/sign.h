// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace quoin {

/// What a predicate answers. A plain enumeration over int, so that signs multiply and negate without branches.
enum class Sign : int { negative = -1, zero = 0, positive = 1 };

constexpr int to_int(Sign sign) {
  return static_cast<int>(sign);
}
constexpr Sign operator-(Sign sign) {
  return static_cast<Sign>(-to_int(sign));
}
constexpr Sign operator*(Sign a, Sign b) {
  return static_cast<Sign>(to_int(a) * to_int(b));
}

template <class Number>
constexpr Sign sign_of(const Number& value) {
  return static_cast<Sign>((value > 0) - (value < 0));
}

}  // namespace quoin
