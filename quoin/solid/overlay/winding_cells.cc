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

/// The cells that are in the set for sure: those with a winding number, and those of number zero beside them without a
/// tile between them whose normal points there, or the patch would be boundary without a normal that points out.
/// Between cells of number zero there are tiles of both directions, which tell nothing.
std::vector<bool> sure_cells(const Sheets& sheets, const CellComplex& complex, const std::vector<int>& numbers) {
  std::vector<bool> is_sure(complex.cell_count, false);
  for (std::uint32_t cell = 0; cell < complex.cell_count; ++cell) is_sure[cell] = numbers[cell] != 0;
  for (const Patch& patch : complex.patches) {
    const bool has_front = numbers[patch.front] != 0;
    if (has_front == (numbers[patch.back] != 0)) continue;
    const CoverSides sides = sides_of_covers(sheets, patch.sheet);
    if (has_front && !sides.back) is_sure[patch.back] = true;
    if (!has_front && !sides.front) is_sure[patch.front] = true;
  }
  return is_sure;
}

}  // namespace

CellTruth classify_winding_cells(const Sheets& sheets, const CellComplex& complex, CellVerdict kind,
                                 const CellQuestion& question, const Context& context) {
  context.progress("winding numbers", 0);
  const std::vector<int> numbers = winding_numbers(sheets, complex, Walls(complex), context);
  std::vector<bool> is_settled = sure_cells(sheets, complex, numbers);
  CellTruth truth;
  truth.inside.assign(complex.cell_count, 0);
  for (std::uint32_t cell = 0; cell < complex.cell_count; ++cell) {
    if (is_settled[cell] && kind == CellVerdict::inside) truth.inside[cell] = 1;
  }
  for (const Patch& patch : complex.patches) {
    context.poll();
    for (const std::uint32_t cell : {patch.front, patch.back}) {
      if (is_settled[cell]) continue;
      is_settled[cell] = true;
      if (question(point_near_sheet(sheets, patch.sheet, cell == patch.front, context)) == kind) truth.inside[cell] = 1;
    }
  }
  return truth;
}

}  // namespace quoin::overlay
