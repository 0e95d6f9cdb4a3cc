// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/primes.h"

#include <charconv>

#include "quoin/cli/failure.h"
#include "quoin/topology/homology.h"

namespace quoin::cli {

std::vector<std::uint32_t> primes_of(const Options& options) {
  std::vector<std::uint32_t> primes;
  for (const std::string& text : options.primes) {
    std::uint32_t prime = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), prime);
    if (error != std::errc() || end != text.data() + text.size() || prime >= std::uint32_t{1} << 31 || !is_prime(prime))
      throw UsageError("--prime '" + text + "' is not a prime number below 2^31");
    primes.push_back(prime);
  }
  return primes;
}

std::uint32_t prime_of(const Options& options) {
  const std::vector<std::uint32_t> primes = primes_of(options);
  if (primes.size() > 1) throw UsageError("--prime is given twice; persistence is over one field");
  return primes.empty() ? 2 : primes[0];
}

}  // namespace quoin::cli
