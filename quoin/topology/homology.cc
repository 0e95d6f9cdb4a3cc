// SPDX-License-Identifier: Apache-2.0
#include "quoin/topology/homology.h"

#include <algorithm>
#include <string>

#include "quoin/base/error.h"
#include "quoin/topology/collapse.h"
#include "quoin/topology/column_reduction.h"
#include "quoin/topology/smith_form.h"

namespace quoin {

namespace {

// What is known of the boundaries of one dimension.
struct BoundaryRank {
  std::size_t rank = 0;
  std::vector<Integer> divisors;  // those above 1
};

template <class Ring>
BoundaryRank rank_of_rest(ColumnReduction<Ring, BoundaryColumns>& reduction, std::size_t pivots,
                          const Context& context) {
  BoundaryRank result;
  result.rank = pivots;
  const auto columns = reduction.put_off_columns();
  if (columns.empty()) return result;
  std::vector<std::uint32_t> rows;
  for (const auto& column : columns)
    for (const auto& entry : column) rows.push_back(entry.row);
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  IntegerMatrix matrix(columns.size(), std::vector<Integer>(rows.size()));
  for (std::size_t j = 0; j < columns.size(); ++j)
    for (const auto& entry : columns[j])
      matrix[j][static_cast<std::size_t>(std::lower_bound(rows.begin(), rows.end(), entry.row) - rows.begin())] =
          Integer(entry.value);
  for (Integer& divisor : elementary_divisors(std::move(matrix), context)) {
    ++result.rank;
    if (divisor != Integer(1)) result.divisors.push_back(std::move(divisor));
  }
  return result;
}

// From the highest dimension down. A simplex that is a pivot has a boundary that depends on others.
template <class Ring>
std::vector<BoundaryRank> boundary_ranks(const Ring& ring, const OrderedBoundaries& boundaries,
                                         const Context& context) {
  constexpr bool is_field = std::is_same_v<Ring, coefficients::Two> || std::is_same_v<Ring, coefficients::Prime>;
  std::vector<BoundaryRank> result(boundaries.dimension() + 2);
  std::vector<bool> is_pivot;
  for (int k = boundaries.dimension(); k > 0; --k) {
    context.progress("homology", 1 - static_cast<double>(k) / boundaries.dimension());
    const BoundaryColumns matrix(boundaries, k);
    ColumnReduction<Ring, BoundaryColumns> reduction(ring, matrix, context);
    std::vector<bool> is_pivot_below(boundaries.count(k - 1), false);
    std::size_t pivots = 0;
    for (std::uint32_t column = 0; column < matrix.columns(); ++column) {
      if (!is_pivot.empty() && is_pivot[column]) continue;
      const std::uint32_t pivot = reduction.reduce(column);
      if (pivot == PivotBits::none) continue;
      is_pivot_below[pivot] = true;
      ++pivots;
    }
    if constexpr (is_field) {
      result[k].rank = pivots;
    } else {
      result[k] = rank_of_rest(reduction, pivots, context);
    }
    is_pivot = std::move(is_pivot_below);
  }
  return result;
}

std::size_t betti_number(const OrderedBoundaries& boundaries, const std::vector<BoundaryRank>& ranks, int k) {
  return boundaries.count(k) - ranks[k].rank - ranks[k + 1].rank;
}

void require_prime(std::uint32_t p) {
  if (p >= std::uint32_t{1} << 31 || !is_prime(p))
    throw InputError(std::to_string(p) + " is not a prime number below 2^31");
}

}  // namespace

OrderedBoundaries collapsed(const SimplicialComplex& complex, const Context& context) {
  return {complex, collapse_order(complex, context).simplices, context};
}

std::vector<std::size_t> betti_numbers(const SimplicialComplex& complex, std::uint32_t p, const Context& context) {
  require_prime(p);
  return betti_numbers(collapsed(complex, context), p, context);
}

std::vector<std::size_t> betti_numbers(const OrderedBoundaries& boundaries, std::uint32_t p, const Context& context) {
  require_prime(p);
  const std::vector<BoundaryRank> ranks = p == 2 ? boundary_ranks(coefficients::Two(), boundaries, context)
                                                 : boundary_ranks(coefficients::Prime(p), boundaries, context);
  std::vector<std::size_t> betti;
  for (int k = 0; k <= boundaries.dimension(); ++k) betti.push_back(betti_number(boundaries, ranks, k));
  return betti;
}

IntegerHomology integer_homology(const SimplicialComplex& complex, const Context& context) {
  return integer_homology(collapsed(complex, context), context);
}

IntegerHomology integer_homology(const OrderedBoundaries& boundaries, const Context& context) {
  std::vector<BoundaryRank> ranks;
  try {
    ranks = boundary_ranks(coefficients::Narrow(), boundaries, context);
  } catch (const coefficients::Overflow&) {
    ranks = boundary_ranks(coefficients::Wide(), boundaries, context);
  }
  IntegerHomology result;
  for (int k = 0; k <= boundaries.dimension(); ++k) {
    result.betti.push_back(betti_number(boundaries, ranks, k));
    result.torsion.push_back(std::move(ranks[k + 1].divisors));
  }
  return result;
}

std::vector<std::size_t> betti_numbers(const IntegerHomology& homology, std::uint32_t p) {
  std::vector<std::size_t> betti = homology.betti;
  for (std::size_t k = 0; k < betti.size(); ++k) {
    for (const Integer& order : homology.torsion[k]) {
      if (mpz_divisible_ui_p(order.raw(), p) == 0) continue;
      ++betti[k];
      if (k + 1 < betti.size()) ++betti[k + 1];
    }
  }
  return betti;
}

bool is_prime(std::uint32_t n) {
  if (n < 2) return false;
  for (std::uint64_t d = 2; d * d <= n; d += d == 2 ? 1 : 2)
    if (n % d == 0) return false;
  return true;
}

std::vector<std::uint32_t> torsion_primes(const IntegerHomology& homology) {
  std::vector<std::uint32_t> primes;
  for (const std::vector<Integer>& orders : homology.torsion) {
    for (Integer order : orders) {
      for (std::uint32_t d = 2; d < std::uint32_t{1} << 16 && order != Integer(1); d += d == 2 ? 1 : 2) {
        if (mpz_divisible_ui_p(order.raw(), d) == 0) continue;
        primes.push_back(d);
        while (mpz_divisible_ui_p(order.raw(), d) != 0) mpz_divexact_ui(order.raw(), order.raw(), d);
      }
      if (order == Integer(1) || order.bit_length() > 31) continue;
      primes.push_back(static_cast<std::uint32_t>(mpz_get_ui(order.raw())));
    }
  }
  std::sort(primes.begin(), primes.end());
  primes.erase(std::unique(primes.begin(), primes.end()), primes.end());
  return primes;
}

}  // namespace quoin
