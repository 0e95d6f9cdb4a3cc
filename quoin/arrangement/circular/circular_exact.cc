// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/circular/circular_exact.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "quoin/arrangement/circular/circular_kernel.h"
#include "quoin/arrangement/circular/circular_readers.h"

namespace quoin {

namespace circular_exact {
namespace {

thread_local Counts thread_counts;

/// Calls `use` with the support as a circle or as a line.
template <class Reader, class Use>
auto with_support(const Reader& reader, std::uint32_t id, const Use& use) {
  return reader.grid().pools().supports[id].is_line() ? use(reader.line(id)) : use(reader.circle(id));
}

template <class Reader>
ExactPoint<typename Reader::Numbers> crossing_of(const Reader& reader, std::uint32_t a, std::uint32_t b) {
  return with_support(reader, a, [&](const auto& one) {
    return with_support(reader, b, [&](const auto& two) { return meet(one, two); });
  });
}

template <class Reader>
ExactPoint<typename Reader::Numbers> point_of(const Reader& reader, const CircularPoint& p) {
  using Numbers = typename Reader::Numbers;
  using Factor = typename Numbers::Factor;
  if (p.kind == CircularPointKind::crossing) return take_root(crossing_of(reader, p.first, p.second), p.root);
  if (p.kind == CircularPointKind::extreme) {
    const ExactCircle<Numbers> circle = reader.circle(p.first);
    return {circle.x, circle.y, Factor(p.root), Factor(0), circle.squared_radius, typename Numbers::Denominator(1)};
  }
  return reader.explicit_point(p);
}

/// Calls `use` with a reader of the narrowest arithmetic that holds the grid.
template <class Use>
auto with_reader(const Grid& grid, const Use& use) {
  if (grid.fits(25)) {
    ++thread_counts.narrow;
    return use(GridReader<25>(grid));
  }
  if (grid.fits(60)) {
    ++thread_counts.wide;
    return use(GridReader<60>(grid));
  }
  ++thread_counts.big;
  return use(BigReader(grid));
}

/// value 2^exponent, within 2u of the number it stands for.
struct Scaled {
  double value = 0;
  long exponent = 0;
};

template <std::size_t Bits>
Scaled rounded(const BoundedInt<Bits>& value) {
  return {to_double(value), 0};
}
Scaled rounded(const Integer& value) {
  Scaled result;
  result.value = mpz_get_d_2exp(&result.exponent, value.raw());
  return result;
}

Scaled product(const Scaled& a, const Scaled& b) {
  return {a.value * b.value, a.exponent + b.exponent};
}
double quotient(const Scaled& a, const Scaled& b) {
  const long exponent = std::clamp(a.exponent - b.exponent, -5000L, 5000L);
  return std::ldexp(a.value / b.value, static_cast<int>(exponent));
}
Scaled root(const Scaled& a) {
  const long odd = a.exponent & 1;
  return {std::sqrt(odd != 0 ? 2 * a.value : a.value), (a.exponent - odd) / 2};
}

/// Unit of the integers that a reader makes, and where they start.
template <std::size_t B>
Scaled scale_of(const GridReader<B>& reader) {
  return {1 / reader.unit(), 0};
}
Scaled scale_of(const BigReader& reader) {
  return rounded(reader.denominator());
}

/// Each number is rounded once, so that middle and half have a few roundings; both stay below the largest coordinate
/// plus the radius where the supports meet, and the origin is added last.
template <class Reader>
Crossing rounded_crossing(const Reader& reader, const ExactPoint<typename Reader::Numbers>& p) {
  Crossing result;
  if (p.d.sign() == Sign::zero) return result;
  result.discriminant = p.c.sign();
  if (result.discriminant == Sign::negative) return result;
  const Scaled d = product(rounded(p.d), scale_of(reader));
  const Scaled c = root(rounded(p.c));
  constexpr bool shifted = !std::is_same_v<Reader, BigReader>;
  result.middle_x = quotient(rounded(p.ax), d) + (shifted ? reader.grid().origin_x() : 0);
  result.middle_y = quotient(rounded(p.ay), d) + (shifted ? reader.grid().origin_y() : 0);
  result.half_x = quotient(product(rounded(p.bx), c), d);
  result.half_y = quotient(product(rounded(p.by), c), d);
  result.in_range = std::isfinite(result.middle_x) && std::isfinite(result.middle_y) && std::isfinite(result.half_x) &&
                    std::isfinite(result.half_y);
  return result;
}

Grid grid_of(const CircularPools& pools, const CircularPoint& p, const CircularPoint& q) {
  Grid grid(pools);
  grid.add_point(p);
  grid.add_point(q);
  return grid;
}

Grid grid_of(const CircularPools& pools, const CircularPoint& p, std::uint32_t support) {
  Grid grid(pools);
  grid.add_point(p);
  grid.add_support(support);
  return grid;
}

}  // namespace

const Counts& counts() {
  return thread_counts;
}

Sign compare_x(const CircularPools& pools, const CircularPoint& p, const CircularPoint& q) {
  return with_reader(grid_of(pools, p, q), [&](const auto& reader) {
    const auto a = point_of(reader, p);
    const auto b = point_of(reader, q);
    return compare_one_root(OneRoot{a.ax, a.bx, a.d}, a.c, OneRoot{b.ax, b.bx, b.d}, b.c);
  });
}

Sign compare_y(const CircularPools& pools, const CircularPoint& p, const CircularPoint& q) {
  return with_reader(grid_of(pools, p, q), [&](const auto& reader) {
    const auto a = point_of(reader, p);
    const auto b = point_of(reader, q);
    return compare_one_root(OneRoot{a.ay, a.by, a.d}, a.c, OneRoot{b.ay, b.by, b.d}, b.c);
  });
}

Sign compare_y_to_centre(const CircularPools& pools, const CircularPoint& p, std::uint32_t circle) {
  return with_reader(grid_of(pools, p, circle), [&](const auto& reader) {
    return compare_y_to_centre(point_of(reader, p), reader.circle(circle));
  });
}

Sign side(const CircularPools& pools, const CircularPoint& p, std::uint32_t support) {
  return with_reader(grid_of(pools, p, support), [&](const auto& reader) {
    const auto point = point_of(reader, p);
    return with_support(reader, support, [&](const auto& s) { return side(point, s); });
  });
}

Sign turn(const CircularPools& pools, const CircularPoint& p, std::uint32_t a, std::uint32_t b) {
  Grid grid = grid_of(pools, p, a);
  grid.add_support(b);
  return with_reader(grid, [&](const auto& reader) {
    const auto point = point_of(reader, p);
    return with_support(reader, a, [&](const auto& one) {
      return with_support(reader, b, [&](const auto& two) { return turn(point, one, two); });
    });
  });
}

Crossing crossing(const CircularPools& pools, std::uint32_t a, std::uint32_t b) {
  Grid grid(pools);
  grid.add_support(a);
  grid.add_support(b);
  return with_reader(grid, [&](const auto& reader) { return rounded_crossing(reader, crossing_of(reader, a, b)); });
}

bool same_support(const CircularPools& pools, std::uint32_t a, std::uint32_t b) {
  if (pools.supports[a].is_line() != pools.supports[b].is_line()) return false;
  Grid grid(pools);
  grid.add_support(a);
  grid.add_support(b);
  return with_reader(grid, [&](const auto& reader) {
    if (pools.supports[a].is_line()) {
      const auto one = reader.line(a);
      const auto two = reader.line(b);
      const auto dx = one.end_x - one.x;
      const auto dy = one.end_y - one.y;
      return (dx * (two.y - one.y) - dy * (two.x - one.x)).sign() == Sign::zero &&
             (dx * (two.end_y - one.y) - dy * (two.end_x - one.x)).sign() == Sign::zero;
    }
    const auto one = reader.circle(a);
    const auto two = reader.circle(b);
    return (one.x - two.x).sign() == Sign::zero && (one.y - two.y).sign() == Sign::zero &&
           (one.squared_radius - two.squared_radius).sign() == Sign::zero;
  });
}

IntegerPoint integers(const CircularPools& pools, const CircularPoint& p) {
  Grid grid(pools);
  grid.add_point(p);
  const BigReader reader(grid);
  ExactPoint<Integers> q = point_of(reader, p);
  return {std::move(q.ax), std::move(q.bx), std::move(q.ay),
          std::move(q.by), std::move(q.c),  q.d * reader.denominator()};
}

CircularPoint approximate(const CircularPools& pools, const CircularPoint& p) {
  Grid grid(pools);
  grid.add_point(p);
  const Crossing numbers =
      with_reader(grid, [&](const auto& reader) { return rounded_crossing(reader, point_of(reader, p)); });
  CircularPoint result = p;
  result.x = numbers.middle_x + numbers.half_x;
  result.y = numbers.middle_y + numbers.half_y;
  return result;
}

}  // namespace circular_exact
}  // namespace quoin
