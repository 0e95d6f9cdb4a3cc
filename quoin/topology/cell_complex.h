// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/topology/simplicial_complex.h"

namespace quoin {

/// Makes the closure of simplices of one dimension, from the highest dimension down.
///
/// For each vertex, the facets of which it is the least come from simplices that it is the least or the second of. They
/// are few, so they are sorted where they are in the cache, and equal ones are numbered once, without looking any up.
class CellComplexBuilder {
 public:
  CellComplexBuilder(std::span<const std::uint32_t> vertices, std::size_t width, const Context& context);

  SimplicialComplex build();

 private:
  void number_vertices();
  template <std::size_t W>
  void sort_cells();
  template <std::size_t W>
  void derive_facets();
  void finish_edges();

  std::span<const std::uint32_t> given_;
  std::size_t width_;
  const Context& context_;
  SimplicialComplex result_;
};

}  // namespace quoin
