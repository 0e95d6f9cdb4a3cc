// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "quoin/cli/options.h"

namespace quoin::cli {

/// The numbers of --prime, in the order in which they are given. @throws UsageError  one is not a prime below 2^31
std::vector<std::uint32_t> primes_of(const Options& options);
/// The number of --prime, 2 without it. @throws UsageError  it is given twice; as above
std::uint32_t prime_of(const Options& options);

}  // namespace quoin::cli
