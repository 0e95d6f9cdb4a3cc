// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/triangulation/cell_array.h"
#include "quoin/triangulation/delaunay_signs.h"

namespace quoin {

/// The cells of a Delaunay triangulation of dimension 3, without gaps, and a cell of each vertex; vertices come and go.
///
/// A change that ends with an exception leaves all as it was. Signs are those of the vertices at the time of the call.
/// One that was moved from may be destroyed or assigned to, and no more.
class ChangingCells3 {
 public:
  ChangingCells3();
  ~ChangingCells3();
  ChangingCells3(const ChangingCells3& other);
  ChangingCells3(ChangingCells3&& other) noexcept;
  ChangingCells3& operator=(const ChangingCells3& other);
  ChangingCells3& operator=(ChangingCells3&& other) noexcept;

  /// Of these cells, or of the first one, as IncrementalTriangulation begins with; of vertices below `id_count`.
  ChangingCells3(CellArray cells, std::size_t id_count);
  ChangingCells3(const DelaunaySigns& signs, const std::array<std::uint32_t, 4>& simplex, std::size_t id_count);

  const CellArray& cells() const;
  bool is_ghost(std::uint32_t cell) const { return cells()[cell].vertices[3] == vertex_at_infinity; }
  /// Some cell of a vertex, which may be that at infinity.
  std::uint32_t cell_of(std::uint32_t v) const;

  /// Where a vertex that is not inserted yet belongs: a finite cell that holds it or a ghost whose facet sees it, by a
  /// walk. @throws Cancelled
  std::uint32_t locate(const DelaunaySigns& signs, std::uint32_t v, std::uint32_t near, const Context& context);
  /// `found` is what `locate` gave. @throws Cancelled; InputError where there are more than 2^30 cells
  void insert(const DelaunaySigns& signs, std::uint32_t v, std::uint32_t found, const Context& context);
  /// False where all others lie in one plane; then nothing has changed. @throws Cancelled
  bool remove(const DelaunaySigns& signs, std::uint32_t v, const Context& context);
  /// Orients all cells the other way: a vertex has moved to the other side of the plane of all others.
  void turn_over();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace quoin
