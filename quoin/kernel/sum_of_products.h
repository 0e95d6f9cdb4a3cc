// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "quoin/base/sign.h"
#include "quoin/kernel/tier.h"

namespace quoin::detail {

/// Two doubles to be multiplied.
struct Factors {
  double a;
  double b;
};

/// Exact sign of the sum of at most six products of finite doubles: by expansions where each product is in the range of
/// is_product_exact_range, else by rationals.
Sign exact_sign_of_sum(std::span<const Factors> products, Tier& tier);

}  // namespace quoin::detail
