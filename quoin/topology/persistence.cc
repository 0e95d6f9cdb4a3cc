// SPDX-License-Identifier: Apache-2.0
#include "quoin/topology/persistence.h"

#include <cstdint>
#include <string>

#include "quoin/base/error.h"
#include "quoin/topology/column_reduction.h"
#include "quoin/topology/disjoint_pairs.h"
#include "quoin/topology/homology.h"
#include "quoin/topology/ordered_boundaries.h"

namespace quoin {

namespace {

// Which simplices of each dimension, by ranks, are born with which deaths, as far as is known.
class Pairing {
 public:
  Pairing(const OrderedBoundaries& boundaries, std::uint32_t prime, const Context& context)
      : boundaries_(boundaries), prime_(prime), context_(context) {
    for (int k = 0; k <= boundaries.dimension(); ++k) {
      death_.emplace_back(boundaries.count(k), PersistencePair::never);
      is_death_.emplace_back(boundaries.count(k), false);
    }
  }

  void run(PersistenceMethod method) {
    const int d = boundaries_.dimension();
    if (d < 1) return;
    context_.progress("persistence", 0);
    pair_components(boundaries_, context_, [&](std::uint32_t birth, std::uint32_t death) { note(0, birth, death); });
    const bool is_dual = d > 1 && pair_highest(method);
    const int rest = is_dual ? d - 1 : d;  // the highest dimension of simplices whose boundaries are left
    if (method == PersistenceMethod::cohomology || (method == PersistenceMethod::automatic && !is_dual)) {
      for (int k = 1; k < rest; ++k) reduce_coboundaries(k);
    } else {
      for (int k = rest; k > 1; --k) reduce_boundaries(k);
    }
  }

  std::uint32_t death(int k, std::uint32_t rank) const { return death_[k][rank]; }
  bool is_death(int k, std::uint32_t rank) const { return is_death_[k][rank]; }

 private:
  void note(int degree, std::uint32_t birth, std::uint32_t death) {
    death_[degree][birth] = death;
    is_death_[degree + 1][death] = true;
  }

  // Explicit methods reduce all that is not about components.
  bool pair_highest(PersistenceMethod method) {
    if (method != PersistenceMethod::automatic) return false;
    const int d = boundaries_.dimension();
    if (has_branching_wall()) return false;
    pair_dual_components(boundaries_, CoboundaryColumns(boundaries_, d - 1, context_), prime_ == 2, context_,
                         [&](std::uint32_t birth, std::uint32_t death) { note(d - 1, birth, death); });
    return true;
  }

  // Of three simplices of the highest dimension, or more.
  bool has_branching_wall() const {
    const LargeVector<std::uint32_t>& walls = boundaries_.facets(boundaries_.dimension());
    std::vector<std::uint8_t> cells(boundaries_.count(boundaries_.dimension() - 1), 0);
    for (std::size_t i = 0; i < walls.size(); ++i) {
      if (i % 16384 == 0) context_.poll();
      if (++cells[walls[i]] > 2) return true;
    }
    return false;
  }

  template <class Matrix, class Call>
  void reduce(const Matrix& matrix, const Call& visit) {
    if (prime_ == 2) {
      ColumnReduction<coefficients::Two, Matrix> reduction({}, matrix, context_);
      visit(reduction);
    } else {
      ColumnReduction<coefficients::Prime, Matrix> reduction(coefficients::Prime(prime_), matrix, context_);
      visit(reduction);
    }
  }

  // A simplex that is born with a class that dies is a cycle with others. Edges that join components are no pivots.
  void reduce_boundaries(int k) {
    reduce(BoundaryColumns(boundaries_, k, k == 2 ? &is_death_[1] : nullptr), [&](auto& reduction) {
      for (std::uint32_t rank = 0; rank < boundaries_.count(k); ++rank) {
        if (death_[k][rank] != PersistencePair::never) continue;
        const std::uint32_t pivot = reduction.reduce(rank);
        if (pivot != PivotBits::none) note(k - 1, pivot, rank);
      }
    });
  }

  void reduce_coboundaries(int k) {
    const CoboundaryColumns matrix(boundaries_, k, context_);
    reduce(matrix, [&](auto& reduction) {
      for (std::uint32_t column = 0; column < matrix.columns(); ++column) {
        const std::uint32_t rank = matrix.column_of(column);
        if (is_death_[k][rank]) continue;
        const std::uint32_t pivot = reduction.reduce(column);
        if (pivot != PivotBits::none) note(k, rank, matrix.row_of(pivot));
      }
    });
  }

  const OrderedBoundaries& boundaries_;
  std::uint32_t prime_;
  const Context& context_;
  std::vector<std::vector<std::uint32_t>> death_;
  std::vector<std::vector<bool>> is_death_;
};

}  // namespace

std::vector<PersistencePair> persistence(const Filtration& filtration, const PersistenceOptions& options,
                                         const Context& context) {
  if (options.prime >= std::uint32_t{1} << 31 || !is_prime(options.prime))
    throw InputError(std::to_string(options.prime) + " is not a prime number below 2^31");
  const auto order = filtration_order(filtration, context);
  const OrderedBoundaries boundaries(filtration.complex, order, context);
  Pairing pairing(boundaries, options.prime, context);
  pairing.run(options.method);
  std::vector<PersistencePair> pairs;
  for (int k = 0; k <= boundaries.dimension(); ++k) {
    for (std::uint32_t rank = 0; rank < boundaries.count(k); ++rank) {
      if (rank % 16384 == 0) context.poll();
      if (pairing.is_death(k, rank)) continue;
      PersistencePair pair{k, order[k][rank]};
      const std::uint32_t death = pairing.death(k, rank);
      if (death != PersistencePair::never) {
        pair.death = order[k + 1][death];
        if (!options.keeps_empty && filtration.grade[k][pair.birth] == filtration.grade[k + 1][pair.death]) continue;
      }
      pairs.push_back(pair);
    }
  }
  return pairs;
}

std::vector<std::size_t> betti_numbers_at(const Filtration& filtration, const std::vector<PersistencePair>& pairs,
                                          std::uint32_t grade) {
  std::vector<std::size_t> betti(filtration.complex.dimension() + 1, 0);
  for (const PersistencePair& pair : pairs) {
    const bool is_born = filtration.grade[pair.degree][pair.birth] <= grade;
    const bool is_dead = pair.death != PersistencePair::never && filtration.grade[pair.degree + 1][pair.death] <= grade;
    if (is_born && !is_dead) ++betti[pair.degree];
  }
  return betti;
}

}  // namespace quoin
