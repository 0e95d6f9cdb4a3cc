// SPDX-License-Identifier: Apache-2.0
#include "quoin/kernel/sum_of_products.h"

#include <algorithm>
#include <array>

#include "quoin/base/error.h"
#include "quoin/number/expansion.h"
#include "quoin/number/rational.h"

namespace quoin::detail {

namespace {

constexpr std::size_t most_products = 6;

Sign sign_by_expansion(std::span<const Factors> products) {
  std::array<double, 2 * most_products> sum{};
  std::array<double, 2 * most_products> previous{};
  std::size_t length = 0;
  for (const Factors& factors : products) {
    const Expansion<2> term = exact_product(factors.a, factors.b);
    std::swap(sum, previous);
    length = add_expansions({previous.data(), length}, term.parts(), sum.data());
  }
  return length == 0 ? Sign::zero : sign_of(sum[length - 1]);
}

}  // namespace

Sign exact_sign_of_sum(std::span<const Factors> products, Tier& tier) {
  if (products.size() > most_products) throw InternalError("a sum of more than six products");
  const auto is_in_range = [](const Factors& f) { return is_product_exact_range(f.a, f.b); };
  if (std::all_of(products.begin(), products.end(), is_in_range)) {
    tier = Tier::expansion;
    return sign_by_expansion(products);
  }
  tier = Tier::big;
  Rational sum;
  for (const Factors& f : products) sum += Rational(f.a) * Rational(f.b);
  return sum.sign();
}

}  // namespace quoin::detail
