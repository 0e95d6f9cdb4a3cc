// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "quoin/base/sign.h"
#include "quoin/number/integer.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace quoin {

/// Limbs of a two's complement number that holds every value of the given number of bits, the sign bit among them.
constexpr std::size_t limbs_for_bits(std::size_t bits) {
  return (bits + 63) / 64;
}

/// The 64 leading bits of a nonzero magnitude: it lies in [bits, bits + 1) 2^exponent, and is not bits 2^exponent
/// exactly if and only if `sticky`. `bits` has its highest bit set.
struct LeadingBits {
  std::uint64_t bits = 0;
  std::int64_t exponent = 0;
  bool sticky = false;
};

namespace fixed_int_detail {

__extension__ using UInt128 = unsigned __int128;
__extension__ using Int128 = __int128;

inline std::uint64_t add_with_carry(std::uint64_t a, std::uint64_t b, unsigned char& carry) {
#if defined(__x86_64__)
  unsigned long long sum;
  carry = _addcarry_u64(carry, a, b, &sum);
  return sum;
#else
  const UInt128 sum = static_cast<UInt128>(a) + b + carry;
  carry = static_cast<unsigned char>(sum >> 64);
  return static_cast<std::uint64_t>(sum);
#endif
}

inline std::uint64_t subtract_with_borrow(std::uint64_t a, std::uint64_t b, unsigned char& borrow) {
#if defined(__x86_64__)
  unsigned long long difference;
  borrow = _subborrow_u64(borrow, a, b, &difference);
  return difference;
#else
  const UInt128 difference = static_cast<UInt128>(a) - b - borrow;
  borrow = static_cast<unsigned char>((difference >> 64) & 1);
  return static_cast<std::uint64_t>(difference);
#endif
}

}  // namespace fixed_int_detail

/// An integer of N 64-bit limbs in two's complement; arithmetic is modulo 2^(64 N), so a result is exact whenever the
/// true value lies in [-2^(64 N - 1), 2^(64 N - 1)), whatever happened to partial sums on the way.
///
/// N is known at compile time; nothing is allocated and no operation but `leading_bits` branches on values.
/// The schoolbook product is the fastest at these widths (N up to about 26).
template <std::size_t N>
class FixedInt {
  static_assert(N >= 1);

 public:
  static constexpr std::size_t limb_count = N;

  constexpr FixedInt() = default;
  constexpr explicit FixedInt(std::int64_t value) {
    limbs_.fill(static_cast<std::uint64_t>(value >> 63));
    limbs_[0] = static_cast<std::uint64_t>(value);
  }
  /// Sign-extended, or truncated to the low limbs.
  template <std::size_t M>
  requires(M != N) constexpr explicit FixedInt(const FixedInt<M>& other) {
    for (std::size_t i = 0; i < N; ++i) limbs_[i] = i < M ? other.limb(i) : other.sign_mask();
  }

  /// Limb i, the lowest is 0.
  constexpr std::uint64_t limb(std::size_t i) const { return limbs_[i]; }
  constexpr void set_limb(std::size_t i, std::uint64_t value) { limbs_[i] = value; }

  constexpr bool is_negative() const { return static_cast<std::int64_t>(limbs_[N - 1]) < 0; }
  /// All ones for a negative number, else 0.
  constexpr std::uint64_t sign_mask() const {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(limbs_[N - 1]) >> 63);
  }
  constexpr bool is_zero() const {
    std::uint64_t any = 0;
    for (const std::uint64_t limb : limbs_) any |= limb;
    return any == 0;
  }

  constexpr Sign sign() const {
    return static_cast<Sign>(static_cast<int>(!is_zero()) | -static_cast<int>(is_negative()));
  }

  friend constexpr bool operator==(const FixedInt&, const FixedInt&) = default;

 private:
  std::array<std::uint64_t, N> limbs_{};
};

template <std::size_t N>
inline FixedInt<N> operator+(const FixedInt<N>& a, const FixedInt<N>& b) {
  FixedInt<N> sum;
  unsigned char carry = 0;
  for (std::size_t i = 0; i < N; ++i) sum.set_limb(i, fixed_int_detail::add_with_carry(a.limb(i), b.limb(i), carry));
  return sum;
}

template <std::size_t N>
inline FixedInt<N> operator-(const FixedInt<N>& a, const FixedInt<N>& b) {
  FixedInt<N> difference;
  unsigned char borrow = 0;
  for (std::size_t i = 0; i < N; ++i) {
    difference.set_limb(i, fixed_int_detail::subtract_with_borrow(a.limb(i), b.limb(i), borrow));
  }
  return difference;
}

template <std::size_t N>
inline FixedInt<N> operator-(const FixedInt<N>& a) {
  return FixedInt<N>() - a;
}

/// Sign of a - b, for any a and b.
template <std::size_t N>
inline Sign compare(const FixedInt<N>& a, const FixedInt<N>& b) {
  constexpr std::uint64_t flip = std::uint64_t{1} << 63;
  unsigned char borrow = 0;
  std::uint64_t any = 0;
  for (std::size_t i = 0; i < N; ++i) {
    const std::uint64_t f = i + 1 == N ? flip : 0;
    any |= fixed_int_detail::subtract_with_borrow(a.limb(i) ^ f, b.limb(i) ^ f, borrow);
  }
  return static_cast<Sign>(static_cast<int>(any != 0) | -static_cast<int>(borrow));
}

/// The low R limbs of the product a b; exact whenever the product fits in R limbs.
template <std::size_t R, std::size_t N, std::size_t M>
inline FixedInt<R> multiply(const FixedInt<N>& a, const FixedInt<M>& b) {
  using fixed_int_detail::Int128;
  using fixed_int_detail::UInt128;
  if constexpr (N < M) {
    return multiply<R>(b, a);  // long rows, few of them
  } else if constexpr (R == 1) {
    return FixedInt<1>(static_cast<std::int64_t>(a.limb(0) * b.limb(0)));
  } else if constexpr (R < N || R < M) {
    constexpr std::size_t n = R < N ? R : N;
    constexpr std::size_t m = R < M ? R : M;
    return multiply<R>(FixedInt<n>(a), FixedInt<m>(b));
  } else if constexpr (N == 1 && M == 1) {
    const Int128 product =
        static_cast<Int128>(static_cast<std::int64_t>(a.limb(0))) * static_cast<std::int64_t>(b.limb(0));
    FixedInt<2> result;
    result.set_limb(0, static_cast<std::uint64_t>(product));
    result.set_limb(1, static_cast<std::uint64_t>(product >> 64));
    if constexpr (R == 2) {
      return result;
    } else {
      return FixedInt<R>(result);
    }
  } else {
    FixedInt<R> result;
    for (std::size_t i = 0; i < M; ++i) {
      std::uint64_t carry = 0;
      for (std::size_t j = 0; j < N && i + j < R; ++j) {
        const UInt128 t = static_cast<UInt128>(a.limb(j)) * b.limb(i) + result.limb(i + j) + carry;
        result.set_limb(i + j, static_cast<std::uint64_t>(t));
        carry = static_cast<std::uint64_t>(t >> 64);
      }
      if (i + N < R) result.set_limb(i + N, carry);
    }
    // The limbs of a negative number are 2^(64 N) too much: take b 2^(64 N) away again, likewise for b.
    unsigned char borrow_a = 0;
    unsigned char borrow_b = 0;
    for (std::size_t k = N; k < R; ++k) {
      const std::uint64_t from_b = (k - N < M ? b.limb(k - N) : b.sign_mask()) & a.sign_mask();
      result.set_limb(k, fixed_int_detail::subtract_with_borrow(result.limb(k), from_b, borrow_a));
    }
    for (std::size_t k = M; k < R; ++k) {
      const std::uint64_t from_a = (k - M < N ? a.limb(k - M) : 0) & b.sign_mask();
      result.set_limb(k, fixed_int_detail::subtract_with_borrow(result.limb(k), from_a, borrow_b));
    }
    return result;
  }
}

/// |a|, as an unsigned number of the same limbs (so that -2^(64 N - 1) has a magnitude too).
template <std::size_t N>
inline std::array<std::uint64_t, N> magnitude(const FixedInt<N>& a) {
  const std::uint64_t mask = a.sign_mask();
  std::array<std::uint64_t, N> result;
  unsigned char carry = static_cast<unsigned char>(mask & 1);
  for (std::size_t i = 0; i < N; ++i) result[i] = fixed_int_detail::add_with_carry(a.limb(i) ^ mask, 0, carry);
  return result;
}

/// Of |a|; a is not zero.
template <std::size_t N>
inline LeadingBits leading_bits(const FixedInt<N>& a) {
  const std::array<std::uint64_t, N> limbs = magnitude(a);
  std::size_t top = N - 1;
  while (limbs[top] == 0 && top > 0) --top;
  const int shift = std::countl_zero(limbs[top]);
  LeadingBits result;
  result.bits = limbs[top] << shift;
  result.exponent = static_cast<std::int64_t>(64 * top) - shift;
  std::uint64_t rest = 0;
  if (top > 0) {
    const std::uint64_t next = limbs[top - 1];
    if (shift > 0) result.bits |= next >> (64 - shift);
    rest = next << shift;
    for (std::size_t i = 0; i + 1 < top; ++i) rest |= limbs[i];
  }
  result.sticky = rest != 0;
  return result;
}

/// a 2^bits, modulo 2^(64 N); bits below 64 N.
template <std::size_t N>
inline FixedInt<N> shift_left(const FixedInt<N>& a, std::size_t bits) {
  const std::size_t whole = bits / 64;
  const std::size_t part = bits % 64;
  FixedInt<N> result;
  for (std::size_t i = whole; i < N; ++i) {
    std::uint64_t limb = a.limb(i - whole) << part;
    if (part > 0 && i > whole) limb |= a.limb(i - whole - 1) >> (64 - part);
    result.set_limb(i, limb);
  }
  return result;
}

template <std::size_t N>
inline Integer to_integer(const FixedInt<N>& a) {
  const std::array<std::uint64_t, N> limbs = magnitude(a);
  Integer result;
  mpz_import(result.raw(), N, -1, sizeof(std::uint64_t), 0, 0, limbs.data());
  return a.is_negative() ? -result : result;
}

/// Of |a|; a is not zero.
inline LeadingBits leading_bits(mpz_srcptr a) {
  static_assert(GMP_NUMB_BITS == 64);
  const mp_limb_t* const limbs = mpz_limbs_read(a);
  const std::size_t top = mpz_size(a) - 1;
  const int shift = std::countl_zero(limbs[top]);
  LeadingBits result;
  result.bits = limbs[top] << shift;
  result.exponent = static_cast<std::int64_t>(64 * top) - shift;
  if (top > 0) {
    const std::uint64_t next = limbs[top - 1];
    if (shift > 0) result.bits |= next >> (64 - shift);
    result.sticky = next << shift != 0 || mpz_scan1(a, 0) < 64 * (top - 1);
  }
  return result;
}
inline LeadingBits leading_bits(const Integer& a) {
  return leading_bits(a.raw());
}

/// The nearest double, ties to even, of the leading bits alone: in [2^63, 2^64], to be multiplied by 2^exponent.
inline double nearest_mantissa(const LeadingBits& leading) {
  // Half of it fits in a signed number; the bit that is shifted out is sticky, far below the 53rd.
  const std::uint64_t half = (leading.bits >> 1) | (leading.bits & 1) | static_cast<std::uint64_t>(leading.sticky);
  return 2.0 * static_cast<double>(static_cast<std::int64_t>(half));
}

}  // namespace quoin
