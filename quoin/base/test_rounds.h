// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace quoin {

#ifdef QUOIN_SANITIZED
inline constexpr bool tests_take_fewer_rounds = true;
#else
inline constexpr bool tests_take_fewer_rounds = false;
#endif

/// How many rounds a random test takes: all of them, or a tenth in sanitized builds, where each takes several times as
/// long.
template <typename Count>
constexpr Count test_rounds(Count rounds) {
  return tests_take_fewer_rounds ? (rounds + Count{9}) / Count{10} : rounds;
}

/// How many cases of some kind all rounds of a random test must have seen at least. A tenth of the rounds promises
/// none.
template <typename Count>
constexpr Count test_cases(Count cases) {
  return tests_take_fewer_rounds ? Count{0} : cases;
}

}  // namespace quoin
