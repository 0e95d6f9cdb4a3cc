// SPDX-License-Identifier: Apache-2.0
#include "quoin/number/expansion.h"

#include <cmath>

namespace quoin::detail {

namespace {

/// Collects the components of a growing sum that are not zero.
class Writer {
 public:
  explicit Writer(double* out) : out_(out) {}
  void put(double part) {
    if (part != 0) out_[size_++] = part;
  }
  std::size_t size() const { return size_; }

 private:
  double* out_;
  std::size_t size_ = 0;
};

/// Hands out the components of two expansions in order of magnitude.
class Merge {
 public:
  Merge(std::span<const double> e, std::span<const double> f) : e_(e), f_(f) {}
  bool is_done() const { return i_ == e_.size() && j_ == f_.size(); }
  double next() {
    if (i_ == e_.size()) return f_[j_++];
    if (j_ == f_.size()) return e_[i_++];
    return std::fabs(e_[i_]) < std::fabs(f_[j_]) ? e_[i_++] : f_[j_++];
  }

 private:
  std::span<const double> e_;
  std::span<const double> f_;
  std::size_t i_ = 0;
  std::size_t j_ = 0;
};

}  // namespace

// LINEAR-EXPANSION-SUM of Shewchuk 1997: the carry is a pair of doubles, so that nonoverlapping input suffices;
// FAST-EXPANSION-SUM with one double needs strongly nonoverlapping input, which scaling does not give.
std::size_t add_expansions(std::span<const double> e, std::span<const double> f, double* h) {
  if (e.empty() || f.empty()) {
    Writer copy(h);
    for (const double part : e.empty() ? f : e) copy.put(part);
    return copy.size();
  }
  Merge parts(e, f);
  Writer out(h);
  const double first = parts.next();
  TwoDoubles carry = fast_two_sum(parts.next(), first);
  while (!parts.is_done()) {
    const TwoDoubles low = fast_two_sum(parts.next(), carry.tail);
    out.put(low.tail);
    carry = two_sum(carry.value, low.value);
  }
  out.put(carry.tail);
  out.put(carry.value);
  return out.size();
}

// SCALE-EXPANSION of Shewchuk 1997.
std::size_t scale_expansion(std::span<const double> e, double b, double* h) {
  if (e.empty() || b == 0) return 0;
  Writer out(h);
  TwoDoubles carry = two_product(e[0], b);
  out.put(carry.tail);
  for (std::size_t i = 1; i < e.size(); ++i) {
    const TwoDoubles product = two_product(e[i], b);
    const TwoDoubles low = two_sum(carry.value, product.tail);
    out.put(low.tail);
    carry = fast_two_sum(product.value, low.value);
    out.put(carry.tail);
  }
  out.put(carry.value);
  return out.size();
}

}  // namespace quoin::detail
