// SPDX-License-Identifier: Apache-2.0
#include "quoin/topology/simplicial_complex.h"

#include <algorithm>

#include "quoin/base/disjoint_sets.h"
#include "quoin/topology/complex_builder.h"

namespace quoin {

SimplicialComplex SimplicialComplex::closure_of(const SimplexList& simplices, const Context& context) {
  return ComplexBuilder(simplices, context).build();
}

std::size_t SimplicialComplex::size() const {
  std::size_t sum = 0;
  for (const Layer& layer : layers_) sum += layer.size;
  return sum;
}

std::vector<std::uint32_t> SimplicialComplex::labels(SimplexId s) const {
  std::vector<std::uint32_t> result;
  for (const std::uint32_t v : vertices(s)) result.push_back(labels_[v]);
  return result;
}

std::uint32_t SimplicialComplex::place_of(std::span<const std::uint32_t> wanted) const {
  const Layer& layer = layers_[wanted.size() - 1];
  const std::size_t width = wanted.size();
  if (width == 1) return wanted[0] < layer.size ? wanted[0] : nowhere;
  std::uint32_t low = layer.first[wanted[0]];
  std::uint32_t high = layer.first[wanted[0] + 1];
  const std::uint32_t end = high;
  const auto search = [&](const auto& is_less) {  // the first that is not less
    while (low < high) {
      const std::uint32_t middle = low + (high - low) / 2;
      if (is_less(layer.vertices.data() + middle * width)) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
  };
  // Rows of a bucket have the first vertex in common.
  if (width == 2) {
    search([&](const std::uint32_t* row) { return row[1] < wanted[1]; });
  } else if (width == 3) {
    const std::uint64_t key = static_cast<std::uint64_t>(wanted[1]) << 32 | wanted[2];
    search([&](const std::uint32_t* row) { return (static_cast<std::uint64_t>(row[1]) << 32 | row[2]) < key; });
  } else {
    search([&](const std::uint32_t* row) {
      return std::lexicographical_compare(row, row + width, wanted.begin(), wanted.end());
    });
  }
  return low < end && std::equal(wanted.begin(), wanted.end(), layer.vertices.data() + low * width) ? low : nowhere;
}

std::optional<SimplexId> SimplicialComplex::find(std::span<const std::uint32_t> wanted) const {
  if (wanted.empty() || wanted.size() > layers_.size() || wanted[0] >= labels_.size()) return {};
  const std::uint32_t place = place_of(wanted);
  if (place == nowhere) return {};
  return SimplexId{static_cast<int>(wanted.size()) - 1, place};
}

std::optional<SimplexId> SimplicialComplex::find_labels(std::span<const std::uint32_t> wanted) const {
  std::vector<std::uint32_t> row;
  for (const std::uint32_t label : wanted) {
    const auto at = std::lower_bound(labels_.begin(), labels_.end(), label);
    if (at == labels_.end() || *at != label) return {};
    row.push_back(static_cast<std::uint32_t>(at - labels_.begin()));
  }
  std::sort(row.begin(), row.end());
  return find(row);
}

SimplexIncidence SimplicialComplex::cofacets(int k) const {
  SimplexIncidence result;
  result.begin.assign(count(k) + 1, 0);
  if (k < 0 || k >= dimension()) return result;
  const LargeVector<std::uint32_t>& lower = layers_[k + 1].facets;
  for (const std::uint32_t facet : lower) ++result.begin[facet + 1];
  for (std::size_t i = 1; i < result.begin.size(); ++i) result.begin[i] += result.begin[i - 1];
  result.items.resize(lower.size());
  std::vector<std::size_t> next(result.begin.begin(), result.begin.end() - 1);
  for (std::size_t i = 0; i < lower.size(); ++i)
    result.items[next[lower[i]]++] = static_cast<std::uint32_t>(i / static_cast<std::size_t>(k + 2));
  return result;
}

std::int64_t SimplicialComplex::euler_characteristic() const {
  std::int64_t sum = 0;
  for (int k = 0; k <= dimension(); ++k) sum += (k % 2 == 0 ? 1 : -1) * static_cast<std::int64_t>(count(k));
  return sum;
}

ComplexComponents connected_components(const SimplicialComplex& complex) {
  DisjointSets sets(complex.count(0));
  for (std::uint32_t e = 0; e < complex.count(1); ++e) {
    const auto ends = complex.vertices({1, e});
    sets.unite(ends[0], ends[1]);
  }
  ComplexComponents result;
  result.of_vertex.resize(sets.size());
  for (std::uint32_t v = 0; v < sets.size(); ++v) {
    const std::uint32_t least = sets.find(v);
    result.of_vertex[v] = least == v ? static_cast<std::uint32_t>(result.count++) : result.of_vertex[least];
  }
  return result;
}

BoundaryMatrix boundary_matrix(const SimplicialComplex& complex, int k) {
  BoundaryMatrix matrix;
  matrix.rows = complex.count(k - 1);
  matrix.columns = complex.count(k);
  matrix.column_size = static_cast<std::size_t>(k) + 1;
  for (std::uint32_t i = 0; i < matrix.columns; ++i) {
    std::int8_t sign = 1;
    for (const std::uint32_t facet : complex.facets({k, i})) {
      matrix.entries.push_back({facet, sign});
      sign = static_cast<std::int8_t>(-sign);
    }
  }
  return matrix;
}

}  // namespace quoin
