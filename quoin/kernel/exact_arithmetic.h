// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include "quoin/number/fixed_int.h"
#include "quoin/number/integer.h"
#include "quoin/number/rational.h"

/// Arithmetic that reads the same for all exact number types: the type of the result is named, widths follow.
namespace quoin::detail {

template <class R, std::size_t N, std::size_t M>
R product(const FixedInt<N>& a, const FixedInt<M>& b) {
  return multiply<R::limb_count>(a, b);
}

template <class R>
R product(const R& a, const R& b) requires std::is_same_v<R, Integer> || std::is_same_v<R, Rational> {
  return a * b;
}

/// a d - b c
template <class R, class A, class B>
R cross(const A& a, const A& b, const B& c, const B& d) {
  return product<R>(a, d) - product<R>(b, c);
}

template <class R, class A, class B>
R dot(const std::array<A, 3>& a, const std::array<B, 3>& b) {
  return product<R>(a[0], b[0]) + product<R>(a[1], b[1]) + product<R>(a[2], b[2]);
}

template <class R, class A, class B>
std::array<R, 3> cross(const std::array<A, 3>& a, const std::array<B, 3>& b) {
  return {cross<R>(a[1], a[2], b[1], b[2]), cross<R>(a[2], a[0], b[2], b[0]), cross<R>(a[0], a[1], b[0], b[1])};
}

}  // namespace quoin::detail
