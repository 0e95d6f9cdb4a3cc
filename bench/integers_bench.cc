// SPDX-License-Identifier: Apache-2.0
//
// Backends for integers of any size on what predicates ask of them: the sign of a determinant of n rows of entries of
// the given bits, by cofactors of 2 by 2 minors (n = 3, as in orientation) and the same times lifts (n = 4, as in the
// sphere test). The fixed widths of the classes of 61 and 124 bits run beside them.
#include <benchmark/benchmark.h>
#include <gmp.h>

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "quoin/number/fixed_int.h"
#include "quoin/number/integer.h"
#ifdef QUOIN_HAS_FLINT
#include <flint/fmpz.h>
#endif

namespace {

using quoin::FixedInt;
using quoin::Integer;
using Boost = boost::multiprecision::cpp_int;

constexpr std::size_t sets = 64;

#ifdef QUOIN_HAS_FLINT
/// A value over FLINT's fmpz, as `Integer` is over mpz.
class Flint {
 public:
  Flint() { fmpz_init(value_); }
  Flint(const Flint& other) { fmpz_init_set(value_, other.value_); }
  Flint(Flint&& other) noexcept : Flint() { fmpz_swap(value_, other.value_); }
  Flint& operator=(const Flint& other) {
    fmpz_set(value_, other.value_);
    return *this;
  }
  Flint& operator=(Flint&& other) noexcept {
    fmpz_swap(value_, other.value_);
    return *this;
  }
  ~Flint() { fmpz_clear(value_); }
  explicit Flint(const Integer& value) : Flint() { fmpz_set_mpz(value_, value.raw()); }
  friend Flint operator*(Flint a, const Flint& b) {
    fmpz_mul(a.value_, a.value_, b.value_);
    return a;
  }
  friend Flint operator-(Flint a, const Flint& b) {
    fmpz_sub(a.value_, a.value_, b.value_);
    return a;
  }
  friend Flint operator+(Flint a, const Flint& b) {
    fmpz_add(a.value_, a.value_, b.value_);
    return a;
  }
  int sign() const { return fmpz_sgn(value_); }

 private:
  fmpz_t value_;
};
int sign(const Flint& a) {
  return a.sign();
}
#endif

int sign(const Integer& a) {
  return quoin::to_int(a.sign());
}
int sign(const Boost& a) {
  return a.sign();
}

template <class Number>
Number converted(const Integer& value) {
  return Number(value);
}
template <>
Boost converted<Boost>(const Integer& value) {
  return Boost(value.to_string());
}

Integer random_integer(gmp_randstate_t state, unsigned long bits) {
  Integer value;
  mpz_urandomb(value.raw(), state, bits);
  return value - (Integer(1) << (bits - 1));
}

template <class Number>
std::vector<Number> random_entries(std::size_t count, unsigned long bits) {
  gmp_randstate_t state;
  gmp_randinit_default(state);
  gmp_randseed_ui(state, 7);
  std::vector<Number> entries;
  for (std::size_t i = 0; i < count; ++i) entries.push_back(converted<Number>(random_integer(state, bits)));
  gmp_randclear(state);
  return entries;
}

template <class Number>
Number determinant(const Number* a, const Number* b, const Number* c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

template <class Number>
Number lift(const Number* a) {
  return a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
}

template <class Number>
void three_rows(benchmark::State& state) {
  const auto entries = random_entries<Number>(9 * sets, static_cast<unsigned long>(state.range(0)));
  for (auto _ : state) {
    int sum = 0;
    for (const Number* m = entries.data(); m < entries.data() + 9 * sets; m += 9) {
      sum += sign(determinant(m, m + 3, m + 6));
    }
    benchmark::DoNotOptimize(sum);
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * sets));
}

template <class Number>
void lifted_rows(benchmark::State& state) {
  const auto entries = random_entries<Number>(12 * sets, static_cast<unsigned long>(state.range(0)));
  for (auto _ : state) {
    int sum = 0;
    for (const Number* m = entries.data(); m < entries.data() + 12 * sets; m += 12) {
      const Number* b = m + 3;
      const Number* c = m + 6;
      const Number* d = m + 9;
      const Number value = lift(m) * determinant(b, c, d) - lift(b) * determinant(m, c, d) +
                           lift(c) * determinant(m, b, d) - lift(d) * determinant(m, b, c);
      sum += sign(value);
    }
    benchmark::DoNotOptimize(sum);
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * sets));
}

template <std::size_t Entry, std::size_t Minor, std::size_t Result>
void three_rows_fixed(benchmark::State& state) {
  std::vector<FixedInt<Entry>> entries(9 * sets);
  std::uint64_t seed = 7;
  for (FixedInt<Entry>& entry : entries) {
    for (std::size_t i = 0; i < Entry; ++i) {
      seed = seed * 6364136223846793005U + 1442695040888963407U;
      entry.set_limb(i, i + 1 == Entry ? seed >> 3 : seed);
    }
  }
  const auto minor = [](const auto& a, const auto& b, const auto& c, const auto& d) {
    return quoin::multiply<Minor>(a, d) - quoin::multiply<Minor>(b, c);
  };
  for (auto _ : state) {
    int sum = 0;
    for (const FixedInt<Entry>* a = entries.data(); a < entries.data() + 9 * sets; a += 9) {
      const FixedInt<Entry>* b = a + 3;
      const FixedInt<Entry>* c = a + 6;
      const auto value = quoin::multiply<Result>(minor(b[1], b[2], c[1], c[2]), a[0]) +
                         quoin::multiply<Result>(minor(b[2], b[0], c[2], c[0]), a[1]) +
                         quoin::multiply<Result>(minor(b[0], b[1], c[0], c[1]), a[2]);
      sum += quoin::to_int(value.sign());
    }
    benchmark::DoNotOptimize(sum);
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * sets));
}

#define QUOIN_SIZES Arg(62)->Arg(125)->Arg(300)->Arg(1000)->Arg(2100)
BENCHMARK(three_rows_fixed<1, 2, 3>);
BENCHMARK(three_rows_fixed<2, 4, 6>);
BENCHMARK(three_rows<Integer>)->QUOIN_SIZES;
BENCHMARK(three_rows<Boost>)->QUOIN_SIZES;
BENCHMARK(lifted_rows<Integer>)->QUOIN_SIZES;
BENCHMARK(lifted_rows<Boost>)->QUOIN_SIZES;
#ifdef QUOIN_HAS_FLINT
BENCHMARK(three_rows<Flint>)->QUOIN_SIZES;
BENCHMARK(lifted_rows<Flint>)->QUOIN_SIZES;
#endif

}  // namespace

BENCHMARK_MAIN();
