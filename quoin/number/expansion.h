// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "quoin/base/sign.h"
#include "quoin/number/error_free.h"

namespace quoin {

namespace detail {

/// Writes the sum of the expansions e and f to h, which has room for both and overlaps neither; returns the length.
std::size_t add_expansions(std::span<const double> e, std::span<const double> f, double* h);

/// Writes the expansion e times b to h, which has room for 2 |e| and does not overlap e; returns the length.
std::size_t scale_expansion(std::span<const double> e, double b, double* h);

}  // namespace detail

/// A number as the unevaluated sum of at most N doubles, smallest first, none of which is zero and no two of which
/// overlap: the largest decides the sign.
///
/// Capacities are known at compile time, nothing is allocated. Sums are exact while no component overflows; products
/// are exact where every product of two components lies in the range of `is_product_exact_range`. Outside, results are
/// meaningless: a caller checks the range of its input first and goes on to `Integer` or `Rational` where it is left.
/// With all factors zero or of magnitude within [2^-200, 2^200], the lowest bit of a product of k of them is at least
/// 2^(-252 k), and the product below 2^(200 k): products of up to three factors are exact.
/// Source: Shewchuk 1997, sections 2.4 and 2.5, with elimination of zeros.
template <std::size_t N>
class Expansion {
 public:
  Expansion() = default;
  explicit Expansion(double value) requires(N >= 1) : size_(value != 0 ? 1 : 0) { parts_[0] = value; }
  explicit Expansion(const TwoDoubles& sum) requires(N >= 2) {
    if (sum.tail != 0) parts_[size_++] = sum.tail;
    if (sum.value != 0) parts_[size_++] = sum.value;
  }

  /// The components, smallest first; none for zero.
  std::span<const double> parts() const { return {parts_.data(), size_}; }
  Sign sign() const { return size_ == 0 ? Sign::zero : sign_of(parts_[size_ - 1]); }
  /// The sum of the components in double arithmetic, within one unit in the last place of the value.
  double estimate() const {
    double sum = 0;
    for (const double part : parts()) sum += part;
    return sum;
  }

  Expansion operator-() const {
    Expansion result = *this;
    for (double& part : result.parts_) part = -part;
    return result;
  }

 private:
  template <std::size_t K, std::size_t L>
  friend Expansion<K + L> operator+(const Expansion<K>& a, const Expansion<L>& b);
  template <std::size_t K>
  friend Expansion<2 * K> operator*(const Expansion<K>& a, double b);
  template <std::size_t K, std::size_t L>
  friend Expansion<2 * K * L> operator*(const Expansion<K>& a, const Expansion<L>& b);

  std::array<double, N> parts_{};
  std::size_t size_ = 0;
};

/// a + b and a - b of doubles, and a b in the range of `two_product`.
inline Expansion<2> exact_sum(double a, double b) {
  return Expansion<2>(two_sum(a, b));
}
inline Expansion<2> exact_difference(double a, double b) {
  return Expansion<2>(two_difference(a, b));
}
inline Expansion<2> exact_product(double a, double b) {
  return Expansion<2>(two_product(a, b));
}

/// O(K + L).
template <std::size_t K, std::size_t L>
Expansion<K + L> operator+(const Expansion<K>& a, const Expansion<L>& b) {
  Expansion<K + L> result;
  result.size_ = detail::add_expansions(a.parts(), b.parts(), result.parts_.data());
  return result;
}

template <std::size_t K, std::size_t L>
Expansion<K + L> operator-(const Expansion<K>& a, const Expansion<L>& b) {
  return a + (-b);
}

/// O(K).
template <std::size_t K>
Expansion<2 * K> operator*(const Expansion<K>& a, double b) {
  Expansion<2 * K> result;
  result.size_ = detail::scale_expansion(a.parts(), b, result.parts_.data());
  return result;
}

/// O(K L^2): a scaled by each component of b, summed. For long factors split b in the middle, as in Shewchuk 1997.
template <std::size_t K, std::size_t L>
Expansion<2 * K * L> operator*(const Expansion<K>& a, const Expansion<L>& b) {
  std::array<double, 2 * K * L> sum{};
  Expansion<2 * K * L> result;
  for (const double part : b.parts()) {
    const Expansion<2 * K> term = a * part;
    sum = result.parts_;
    result.size_ = detail::add_expansions({sum.data(), result.size_}, term.parts(), result.parts_.data());
  }
  return result;
}

}  // namespace quoin
