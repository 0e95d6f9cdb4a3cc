// SPDX-License-Identifier: Apache-2.0
#include "quoin/kernel/predicates2.h"

#include <array>

#include "quoin/kernel/call_grid.h"
#include "quoin/number/expansion.h"

namespace quoin::detail {

namespace {

template <class N>
struct LiftedRow2 {
  typename N::Linear x;
  typename N::Linear y;
  typename N::Quadratic lift;

  LiftedRow2(const CallReader<N>& difference, const Point2& p, const Point2& q)
      : x(difference(p.x, q.x)),
        y(difference(p.y, q.y)),
        lift(product<typename N::Quadratic>(x, x) + product<typename N::Quadratic>(y, y)) {}
};

template <class N>
typename N::Quartic lifted_minor(const LiftedRow2<N>& lifted, const LiftedRow2<N>& b, const LiftedRow2<N>& c) {
  return product<typename N::Quartic>(lifted.lift, cross<typename N::Quadratic>(b.x, b.y, c.x, c.y));
}

}  // namespace

Sign exact_orientation(const Point2& a, const Point2& b, const Point2& c, Tier& tier) {
  const TwoDoubles bx = two_difference(b.x, a.x);
  const TwoDoubles by = two_difference(b.y, a.y);
  const TwoDoubles cx = two_difference(c.x, a.x);
  const TwoDoubles cy = two_difference(c.y, a.y);
  if (bx.tail == 0 && by.tail == 0 && cx.tail == 0 && cy.tail == 0 && is_product_exact_range(bx.value, cy.value) &&
      is_product_exact_range(by.value, cx.value)) {
    tier = Tier::expansion;
    return (exact_product(bx.value, cy.value) - exact_product(by.value, cx.value)).sign();
  }
  const std::array<double, 6> values{a.x, a.y, b.x, b.y, c.x, c.y};
  return decide_on_grid(values, tier, [&]<class N>(const CallReader<N>& difference) {
    return cross<typename N::Quadratic>(difference(b.x, a.x), difference(b.y, a.y), difference(c.x, a.x),
                                        difference(c.y, a.y))
        .sign();
  });
}

Sign exact_in_circle(const Point2& a, const Point2& b, const Point2& c, const Point2& d, Tier& tier) {
  const std::array<double, 8> values{a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y};
  return decide_on_grid(values, tier, [&]<class N>(const CallReader<N>& difference) {
    const LiftedRow2<N> ra(difference, a, d);
    const LiftedRow2<N> rb(difference, b, d);
    const LiftedRow2<N> rc(difference, c, d);
    return (lifted_minor(ra, rb, rc) + lifted_minor(rb, rc, ra) + lifted_minor(rc, ra, rb)).sign();
  });
}

}  // namespace quoin::detail
