// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/topology/filtration.h"

namespace quoin {

/// How boundaries are reduced; the pairs are the same.
enum class PersistenceMethod {
  automatic,   ///< homology where every facet of the highest simplices has at most two of these, else cohomology
  homology,    ///< boundaries, from the highest dimension down, without known cycles ("twist")
  cohomology,  ///< coboundaries, from the lowest dimension up, without known coboundaries ("clearing")
};

struct PersistenceOptions {
  std::uint32_t prime = 2;  ///< coefficients: the field of so many elements
  PersistenceMethod method = PersistenceMethod::automatic;
  bool keeps_empty = false;  ///< pairs too that are born and die with the same grade
};

/// A class of homology that is born with one simplex and dies with another, or never.
struct PersistencePair {
  static constexpr std::uint32_t never = 0xFFFFFFFFU;
  int degree = 0;
  std::uint32_t birth = 0;      ///< a simplex of dimension `degree`
  std::uint32_t death = never;  ///< one of the next dimension
  friend constexpr bool operator==(const PersistencePair&, const PersistencePair&) = default;
};

/// The persistent homology of a filtration: its pairs by degree, then in the order in which they are born. Exact, as
/// nothing but the order of grades matters; pairs of different grades do not depend on the order within a grade.
///
/// Connected components, and classes of the highest degree where every facet has at most two simplices, are found with
/// disjoint sets in near linear time; all else by reduction, O(n^3) at worst.
/// @throws InputError  the number of coefficients is not a prime below 2^31
/// @throws Cancelled
/// Source: Chen, Kerber (2011); de Silva, Morozov, Vejdemo-Johansson: Dualities in persistent (co)homology (2011);
/// Delfinado, Edelsbrunner (1995) for components and their duals.
std::vector<PersistencePair> persistence(const Filtration& filtration, const PersistenceOptions& options,
                                         const Context& context);

/// Betti numbers over the field after all simplices of a grade have entered.
std::vector<std::size_t> betti_numbers_at(const Filtration& filtration, const std::vector<PersistencePair>& pairs,
                                          std::uint32_t grade);

}  // namespace quoin
