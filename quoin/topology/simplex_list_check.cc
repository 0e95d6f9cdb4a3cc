// SPDX-License-Identifier: Apache-2.0
#include "quoin/topology/simplex_list_check.h"

#include <algorithm>
#include <span>

#include "quoin/topology/complex_builder.h"
#include "quoin/topology/simplicial_complex.h"

namespace quoin {

namespace {

constexpr std::uint32_t not_listed = ComplexBuilder::not_listed;

bool is_valid(std::span<const std::uint32_t> simplex) {
  if (simplex.empty() || simplex.size() > SimplicialComplex::most_vertices) return false;
  std::vector<std::uint32_t> sorted(simplex.begin(), simplex.end());
  std::sort(sorted.begin(), sorted.end());
  return std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
}

// Whether it takes an odd number of exchanges to bring distinct numbers into ascending order. O(k^2)
bool is_odd_order(std::span<const std::uint32_t> vertices) {
  bool is_odd = false;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    for (std::size_t j = i + 1; j < vertices.size(); ++j) is_odd ^= vertices[i] > vertices[j];
  return is_odd;
}

// The listed simplices of the highest dimension that share a facet with no third: whether each reverses it.
void find_incoherent(const SimplicialComplex& complex, const SimplexList& list,
                     const std::vector<std::uint32_t>& listing, SimplexListFindings& findings) {
  const int d = complex.dimension();
  if (d < 1) return;
  const SimplexIncidence cofacets = complex.cofacets(d - 1);
  const auto sign = [&](std::uint32_t facet, std::uint32_t simplex) {
    const auto facets = complex.facets({d, simplex});
    const auto place = std::find(facets.begin(), facets.end(), facet) - facets.begin();
    return (place % 2 != 0) != is_odd_order(list[listing[simplex]]);
  };
  for (std::uint32_t facet = 0; facet < complex.count(d - 1); ++facet) {
    const auto both = cofacets[facet];
    if (both.size() == 2 && sign(facet, both[0]) == sign(facet, both[1]))
      findings.incoherent.push_back(
          {std::min(listing[both[0]], listing[both[1]]), std::max(listing[both[0]], listing[both[1]])});
  }
  std::sort(findings.incoherent.begin(), findings.incoherent.end());
}

}  // namespace

SimplexListFindings check_simplices(const SimplexList& simplices, const Context& context) {
  SimplexListFindings findings;
  SimplexList valid;
  std::vector<std::uint32_t> origin;
  for (std::uint32_t i = 0; i < simplices.size(); ++i) {
    if (i % 4096 == 0) context.poll();
    if (is_valid(simplices[i])) {
      valid.add(simplices[i]);
      origin.push_back(i);
    } else {
      findings.invalid.push_back(i);
    }
  }
  ComplexBuilder builder(valid, context);
  const SimplicialComplex complex = builder.build();
  std::vector<std::vector<std::uint32_t>>& listing = builder.listing();
  for (std::vector<std::uint32_t>& places : listing)
    for (std::uint32_t& place : places) place = place == not_listed ? place : origin[place];
  for (const auto& [first, second] : builder.duplicates())
    findings.duplicates.push_back({origin[first], origin[second]});
  std::sort(findings.duplicates.begin(), findings.duplicates.end());
  for (int k = 0; k <= complex.dimension(); ++k)
    for (std::uint32_t i = 0; i < complex.count(k); ++i)
      if (listing[k][i] == not_listed) findings.missing_faces.push_back(complex.labels({k, i}));
  if (complex.dimension() >= 0) find_incoherent(complex, simplices, listing.back(), findings);
  return findings;
}

}  // namespace quoin
