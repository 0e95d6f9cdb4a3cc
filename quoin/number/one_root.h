// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/base/sign.h"
#include "quoin/number/bounded_int.h"
#include "quoin/number/rational.h"

/// Numbers (a + b sqrt c) / d with one square root: coordinates of crossings of circles and lines. Signs and order are
/// found by squaring, with sums and products alone, so they work on any ring with a sign: `Rational`, `BoundedInt`
/// (which derives the width of every step), `Integer`.
namespace quoin {

/// Sign of a + b sqrt c; c >= 0.
template <class A, class B, class C>
Sign sign_of_one_root(const A& a, const B& b, const C& c) {
  const Sign rational = a.sign();
  const Sign root = c.sign() == Sign::zero ? Sign::zero : b.sign();
  if (root == Sign::zero || rational == root) return rational;
  if (rational == Sign::zero) return root;
  return rational * (a * a - b * b * c).sign();
}

/// Sign of a + b sqrt c - e sqrt f; c, f >= 0. At most two squarings, of which the second is seldom needed.
template <class A, class B, class C, class E, class F>
Sign sign_of_two_roots(const A& a, const B& b, const C& c, const E& e, const F& f) {
  const Sign left = sign_of_one_root(a, b, c);
  const Sign right = f.sign() == Sign::zero ? Sign::zero : e.sign();
  if (right == Sign::zero) return left;
  if (left != right) return left != Sign::zero ? left : -right;
  // Both sides have one sign: their squares decide.
  const auto ab = a * b;
  return left * sign_of_one_root(a * a + b * b * c - e * e * f, ab + ab, c);
}

/// (a + b root) / d, where the root is that of a number kept elsewhere (both coordinates of a point share it); d > 0.
template <class A, class B, class D>
struct OneRoot {
  A a;
  B b;
  D d;
};
template <class A, class B, class D>
OneRoot(A, B, D) -> OneRoot<A, B, D>;

/// Order of (p.a + p.b sqrt c) / p.d and (q.a + q.b sqrt f) / q.d.
template <class A, class B, class D, class C, class E, class G, class H, class F>
Sign compare_one_root(const OneRoot<A, B, D>& p, const C& c, const OneRoot<E, G, H>& q, const F& f) {
  return sign_of_two_roots(p.a * q.d - q.a * p.d, p.b * q.d, c, q.b * p.d, f);
}

}  // namespace quoin
