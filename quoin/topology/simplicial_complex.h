// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/base/large_vector.h"
#include "quoin/topology/simplex_list.h"

namespace quoin {

/// A simplex of a complex: its dimension, and its place among those of that dimension.
struct SimplexId {
  int dimension = 0;
  std::uint32_t index = 0;
  friend constexpr auto operator<=>(const SimplexId&, const SimplexId&) = default;
};

/// Simplices of one dimension with the places of their facets, or cofacets, in one array.
struct SimplexIncidence {
  std::vector<std::size_t> begin;    ///< one more than there are simplices
  std::vector<std::uint32_t> items;  ///< of simplex i: items[begin[i]] ... items[begin[i + 1] - 1]

  std::span<const std::uint32_t> operator[](std::size_t i) const {
    return {items.data() + begin[i], begin[i + 1] - begin[i]};
  }
};

/// A finite abstract simplicial complex: a set of simplices closed under faces.
///
/// The simplices of each dimension lie in lexicographic order of their vertices, each oriented by its vertices in
/// ascending order, with the places of its facets: 8 bytes for each of its k + 1 vertices and 4 more. Vertices are
/// renumbered 0, 1, 2, ... in the order of the numbers they were given by, which `label` keeps. Immutable.
class SimplicialComplex {
 public:
  /// No simplex has more vertices: its faces alone would be more than a million.
  static constexpr std::size_t most_vertices = 20;

  /// The empty complex, of dimension -1.
  SimplicialComplex() = default;

  /// All listed simplices and their faces, each once, whatever the order of their vertices.
  ///
  /// O(m log d) for m simplices of the result with d of one dimension at a vertex.
  /// @throws InputError  a simplex has no vertex, a vertex twice, or more than `most_vertices`; there are 2^32 or more
  ///                     simplices of one dimension
  static SimplicialComplex closure_of(const SimplexList& simplices, const Context& context);
  /// The same of simplices of one dimension below four, which follow each other: so many vertices each, one to four.
  /// Several times as fast, unless numbers of vertices are far apart.
  /// @throws InputError  the list is no multiple of the width; a simplex has a vertex twice
  static SimplicialComplex closure_of_cells(std::span<const std::uint32_t> vertices, std::size_t width,
                                            const Context& context);

  int dimension() const { return static_cast<int>(layers_.size()) - 1; }
  /// Number of simplices of dimension k; zero where there is none.
  std::size_t count(int k) const { return k < 0 || k > dimension() ? 0 : layers_[k].size; }
  /// Number of all simplices.
  std::size_t size() const;

  /// The number by which vertex v was given.
  std::uint32_t label(std::uint32_t v) const { return labels_[v]; }
  /// The k + 1 vertices of a simplex of dimension k in ascending order.
  std::span<const std::uint32_t> vertices(SimplexId s) const {
    return {layers_[s.dimension].vertices.data() + std::size_t{s.index} * (s.dimension + 1),
            static_cast<std::size_t>(s.dimension + 1)};
  }
  /// The places of the facets of a simplex of dimension above zero: that at j lacks vertex j, and has the sign (-1)^j
  /// in the boundary.
  std::span<const std::uint32_t> facets(SimplexId s) const {
    return {layers_[s.dimension].facets.data() + std::size_t{s.index} * (s.dimension + 1),
            static_cast<std::size_t>(s.dimension + 1)};
  }
  /// The facets of all simplices of dimension k > 0, k + 1 for each.
  std::span<const std::uint32_t> facets(int k) const { return layers_[k].facets; }
  /// The labels of the vertices of a simplex.
  std::vector<std::uint32_t> labels(SimplexId s) const;

  /// The simplex with these vertices, in ascending order. O(log d)
  std::optional<SimplexId> find(std::span<const std::uint32_t> vertices) const;
  /// The simplex with the vertices of these labels, in any order.
  std::optional<SimplexId> find_labels(std::span<const std::uint32_t> labels) const;

  /// The simplices of dimension k + 1 that have those of dimension k as facets, in ascending order. O(size)
  SimplexIncidence cofacets(int k) const;

  /// The alternating sum of the numbers of simplices.
  std::int64_t euler_characteristic() const;

 private:
  static constexpr std::uint32_t nowhere = 0xFFFFFFFFU;

  // The place of the simplex with these vertices, of a dimension that there is, or `nowhere`.
  std::uint32_t place_of(std::span<const std::uint32_t> vertices) const;

  struct Layer {
    std::size_t size = 0;
    LargeVector<std::uint32_t> vertices;
    LargeVector<std::uint32_t> facets;
    std::vector<std::uint32_t> first;  // where the simplices begin whose least vertex is v; one more than vertices
  };
  friend class ComplexBuilder;
  friend class CellComplexBuilder;

  std::vector<Layer> layers_;
  std::vector<std::uint32_t> labels_;
};

/// How many connected components a complex has, and the component of each vertex, numbered by least vertices. O(size)
struct ComplexComponents {
  std::size_t count = 0;
  std::vector<std::uint32_t> of_vertex;
};
ComplexComponents connected_components(const SimplicialComplex& complex);

/// The boundary of simplices of dimension k > 0 as a sparse matrix of 1 and -1, by columns.
struct BoundaryMatrix {
  std::size_t rows = 0;
  std::size_t columns = 0;
  struct Entry {
    std::uint32_t row;
    std::int8_t value;
  };
  std::vector<Entry> entries;  ///< column by column, the same number in each
  std::size_t column_size = 0;

  std::span<const Entry> column(std::size_t j) const {
    return std::span(entries).subspan(j * column_size, column_size);
  }
};
BoundaryMatrix boundary_matrix(const SimplicialComplex& complex, int k);

}  // namespace quoin
