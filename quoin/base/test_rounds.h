// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace quoin {

/// How many rounds a random test takes: all of them, or a tenth in sanitized builds, where each takes about ten times
/// as long.
template <typename Count>
constexpr Count test_rounds(Count rounds) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return (rounds + Count{9}) / Count{10};
#else
  return rounds;
#endif
}

}  // namespace quoin
