// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/overlay/winding_cells.h"

#include <span>
#include <vector>

#include "quoin/solid/overlay/cell_sample.h"
#include "quoin/solid/overlay/winding.h"

namespace quoin::overlay {

namespace {

int change_across(const CellComplex& complex, std::uint32_t patch) {
  int change = 0;
  for (const Winding& w : complex.windings_across(patch)) change += w.number;
  return change;
}

/// The patches at every cell.
class Walls {
 public:
  explicit Walls(const CellComplex& complex) : first_(complex.cell_count + 1, 0) {
    for (const Patch& p : complex.patches) {
      ++first_[p.front + 1];
      ++first_[p.back + 1];
    }
    for (std::size_t c = 0; c < complex.cell_count; ++c) first_[c + 1] += first_[c];
    patches_.resize(first_.back());
    std::vector<std::uint32_t> fill(first_.begin(), first_.end() - 1);
    for (std::uint32_t p = 0; p < complex.patches.size(); ++p) {
      patches_[fill[complex.patches[p].front]++] = p;
      patches_[fill[complex.patches[p].back]++] = p;
    }
  }
  std::span<const std::uint32_t> of(std::uint32_t cell) const {
    return {patches_.data() + first_[cell], patches_.data() + first_[cell + 1]};
  }

 private:
  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> patches_;
};

/// Winding numbers per cell: one exact line per connected part of the complex, then a walk across its walls.
std::vector<int> winding_numbers(const Sheets& sheets, const CellComplex& complex, const Walls& walls,
                                 const Context& context) {
  std::vector<int> numbers(complex.cell_count, 0);
  std::vector<bool> is_known(complex.cell_count, false);
  std::vector<std::uint32_t> waiting;
  const auto settle = [&](std::uint32_t cell, int number) {
    if (is_known[cell]) return;
    is_known[cell] = true;
    numbers[cell] = number;
    waiting.push_back(cell);
  };
  for (const Patch& start : complex.patches) {
    if (is_known[start.front]) continue;
    context.poll();
    const SheetWinding seed = winding_at(sheets, start.sheet);
    settle(seed.in_front ? start.front : start.back, seed.windings.empty() ? 0 : seed.windings.front().number);
    while (!waiting.empty()) {
      const std::uint32_t cell = waiting.back();
      waiting.pop_back();
      for (const std::uint32_t wall : walls.of(cell)) {
        const Patch& patch = complex.patches[wall];
        const int change = change_across(complex, wall);
        if (patch.front == cell) settle(patch.back, numbers[cell] + change);
        if (patch.back == cell) settle(patch.front, numbers[cell] - change);
      }
    }
  }
  return numbers;
}

/// Kinds of cells and what they imply. Across a patch without a tile whose normal points into a cell, that cell is in
/// the set if the other is: or the patch would be boundary without a normal that points out.
class CellKinds {
 public:
  CellKinds(const Sheets& sheets, const CellComplex& complex, const Walls& walls)
      : complex_(complex), walls_(walls), is_settled_(complex.cell_count, false), kinds_(complex.cell_count) {
    for (const Patch& patch : complex.patches) sides_.push_back(sides_of_covers(sheets, patch.sheet));
  }

  bool is_settled(std::uint32_t cell) const { return is_settled_[cell]; }
  CellVerdict kind(std::uint32_t cell) const { return kinds_[cell]; }

  void settle(std::uint32_t cell, CellVerdict kind) {
    mark(cell, kind);
    while (!waiting_.empty()) {
      const std::uint32_t next = waiting_.back();
      waiting_.pop_back();
      for (const std::uint32_t wall : walls_.of(next)) spread(next, wall);
    }
  }

 private:
  void mark(std::uint32_t cell, CellVerdict kind) {
    if (is_settled_[cell]) return;
    is_settled_[cell] = true;
    kinds_[cell] = kind;
    waiting_.push_back(cell);
  }

  void spread(std::uint32_t cell, std::uint32_t wall) {
    const Patch& patch = complex_.patches[wall];
    const bool is_front = patch.front == cell;
    const std::uint32_t other = is_front ? patch.back : patch.front;
    const bool points_to_other = is_front ? sides_[wall].back : sides_[wall].front;
    const bool points_here = is_front ? sides_[wall].front : sides_[wall].back;
    if (kinds_[cell] == CellVerdict::inside) {
      if (!points_to_other) mark(other, CellVerdict::inside);
    } else if (!points_here) {
      mark(other, kinds_[cell]);  // not inside, or this cell would be
    }
  }

  const CellComplex& complex_;
  const Walls& walls_;
  std::vector<CoverSides> sides_;  // by patch
  std::vector<bool> is_settled_;
  std::vector<CellVerdict> kinds_;
  std::vector<std::uint32_t> waiting_;
};

}  // namespace

CellTruth classify_winding_cells(const Sheets& sheets, const CellComplex& complex, CellVerdict kind,
                                 const CellQuestion& question, const Context& context) {
  context.progress("winding numbers", 0);
  const Walls walls(complex);
  const std::vector<int> numbers = winding_numbers(sheets, complex, walls, context);
  CellKinds kinds(sheets, complex, walls);
  for (std::uint32_t cell = 0; cell < complex.cell_count; ++cell) {
    if (numbers[cell] != 0) kinds.settle(cell, CellVerdict::inside);
  }
  for (const Patch& patch : complex.patches) {
    context.poll();
    for (const std::uint32_t cell : {patch.front, patch.back}) {
      if (kinds.is_settled(cell)) continue;
      kinds.settle(cell, question(point_near_sheet(sheets, patch.sheet, cell == patch.front, context)));
    }
  }
  CellTruth truth;
  for (std::uint32_t cell = 0; cell < complex.cell_count; ++cell) {
    truth.inside.push_back(kinds.is_settled(cell) && kinds.kind(cell) == kind ? 1 : 0);
  }
  return truth;
}

}  // namespace quoin::overlay
