// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/triangulation/cell_array.h"
#include "quoin/triangulation/delaunay_signs.h"
#include "quoin/triangulation/regular_signs.h"

namespace quoin {

/// The cells of a Delaunay or regular triangulation of dimension 3, without gaps, and a cell of each vertex; points
/// come and go. Points that are hidden are known by the cells that hold them.
///
/// A change that ends with an exception leaves all as it was. Signs are those of the points at the time of the call.
/// One that was moved from may be destroyed or assigned to, and no more.
template <class Signs>
class ChangingCells3 {
 public:
  ChangingCells3();
  ~ChangingCells3();
  ChangingCells3(const ChangingCells3& other);
  ChangingCells3(ChangingCells3&& other) noexcept;
  ChangingCells3& operator=(const ChangingCells3& other);
  ChangingCells3& operator=(ChangingCells3&& other) noexcept;

  /// Of these cells, or of the first one, as IncrementalTriangulation begins with; of points below `id_count`.
  ChangingCells3(CellArray cells, std::size_t id_count);
  ChangingCells3(const Signs& signs, const std::array<std::uint32_t, 4>& simplex, std::size_t id_count);

  const CellArray& cells() const;
  bool is_ghost(std::uint32_t cell) const { return cells()[cell].vertices[3] == vertex_at_infinity; }
  /// Some cell of a vertex, which may be that at infinity; the one that holds a hidden point.
  std::uint32_t cell_of(std::uint32_t v) const;
  bool is_hidden(std::uint32_t v) const;
  std::size_t hidden_count() const;

  /// Where a point that is not inserted yet belongs: a finite cell that holds it or a ghost whose facet sees it, by a
  /// walk. @throws Cancelled
  std::uint32_t locate(const Signs& signs, std::uint32_t v, std::uint32_t near, const Context& context);
  /// `found` is what `locate` gave. The point may be hidden, and may hide vertices. Hidden points of cells that go are
  /// located once more, O(1) expected for each, and these are not interrupted.
  /// @throws Cancelled; InputError where there are more than 2^30 cells
  void insert(const Signs& signs, std::uint32_t v, std::uint32_t found, const Context& context);
  /// Of a vertex. False where all other points lie in one plane; then nothing has changed. Hidden points of its star
  /// become vertices, or are located once more as by `insert`. @throws Cancelled
  bool remove(const Signs& signs, std::uint32_t v, const Context& context);
  /// Points that are no vertices, all within the hull, are hidden. @throws Cancelled
  void hide(const Signs& signs, std::span<const std::uint32_t> points, const Context& context);
  /// O(1).
  void remove_hidden(std::uint32_t v);
  /// Orients all cells the other way: a vertex has moved to the other side of the plane of all others.
  void turn_over();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace quoin
