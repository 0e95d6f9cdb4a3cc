// SPDX-License-Identifier: Apache-2.0
#include "quoin/topology/incremental_betti.h"

#include <algorithm>

#include "quoin/base/disjoint_sets.h"
#include "quoin/base/error.h"
#include "quoin/topology/homology.h"
#include "quoin/topology/manifold.h"
#include "quoin/topology/persistence.h"

namespace quoin {

namespace {

// Edges that join components end one, the others close a cycle.
void step_through_edges(const SimplicialComplex& ball, std::span<const SimplexId> order, BettiSteps& births) {
  DisjointSets sets(ball.count(0));
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (order[i].dimension != 1) continue;
    const auto ends = ball.vertices(order[i]);
    births[i] = sets.find(ends[0]) == sets.find(ends[1]);
    sets.unite(ends[0], ends[1]);
  }
}

// Backwards, a triangle that leaves joins what is on its sides: if that was apart, it had closed a void.
void step_back_through_triangles(const SimplicialComplex& ball, std::span<const SimplexId> order, BettiSteps& births) {
  const SimplexIncidence tetrahedra = ball.cofacets(2);
  const auto outside = static_cast<std::uint32_t>(ball.count(3));
  DisjointSets sets(ball.count(3) + 1);
  for (std::size_t i = order.size(); i-- > 0;) {
    if (order[i].dimension != 2) continue;
    const auto sides = tetrahedra[order[i].index];
    const std::uint32_t other = sides.size() == 2 ? sides[1] : outside;
    births[i] = sets.find(sides[0]) != sets.find(other);
    sets.unite(sides[0], other);
  }
}

// With a cone over its boundary it is a homology sphere, in which complements have dual homology.
void require_ball(const SimplicialComplex& ball, const Context& context) {
  const auto is_point = [](const IntegerHomology& homology) {
    return homology.betti == std::vector<std::size_t>{1, 0, 0, 0} &&
           std::all_of(homology.torsion.begin(), homology.torsion.end(), [](const auto& list) { return list.empty(); });
  };
  if (ball.dimension() != 3 || !check_manifold(ball, context).is_manifold() ||
      !is_point(integer_homology(ball, context)))
    throw InputError("incremental Betti numbers in space: the whole is not a ball of dimension 3");
}

}  // namespace

BettiSteps incremental_betti(const SimplicialComplex& complex, std::span<const SimplexId> order, std::uint32_t p,
                             const Context& context) {
  const Filtration filtration = filtration_by_order(complex, order);
  BettiSteps births(order.size(), true);
  for (const PersistencePair& pair : persistence(filtration, {.prime = p}, context))
    if (pair.death != PersistencePair::never) births[filtration.grade[pair.degree + 1][pair.death]] = false;
  return births;
}

BettiSteps incremental_betti_in_space(const SimplicialComplex& ball, std::span<const SimplexId> order,
                                      const Context& context) {
  require_ball(ball, context);
  filtration_by_order(ball, order);  // for what it refuses
  context.poll();
  BettiSteps births(order.size(), true);
  step_through_edges(ball, order, births);
  step_back_through_triangles(ball, order, births);
  for (std::size_t i = 0; i < order.size(); ++i)
    if (order[i].dimension == 3) births[i] = false;
  return births;
}

std::vector<std::vector<std::size_t>> betti_numbers_by_step(std::span<const SimplexId> order, const BettiSteps& births,
                                                            int dimension) {
  std::vector<std::size_t> betti(dimension + 1, 0);
  std::vector<std::vector<std::size_t>> result;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (births[i]) {
      ++betti[order[i].dimension];
    } else {
      --betti[order[i].dimension - 1];
    }
    result.push_back(betti);
  }
  return result;
}

}  // namespace quoin
