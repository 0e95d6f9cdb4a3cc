// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/overlay/winding_cells.h"

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

/// Winding numbers per cell: one exact line per connected part of the complex, then a walk across its walls.
class CellWindings {
 public:
  CellWindings(const Sheets& sheets, const CellComplex& complex, const Context& context)
      : complex_(complex), number_(complex.cell_count, 0), is_known_(complex.cell_count, false) {
    link_walls();
    for (const Patch& patch : complex.patches) {
      if (is_known_[patch.front]) continue;
      context.poll();
      const SheetWinding seed = winding_at(sheets, patch.sheet);
      const int number = seed.windings.empty() ? 0 : seed.windings.front().number;
      spread(seed.in_front ? patch.front : patch.back, number);
    }
  }

  int number(std::uint32_t cell) const { return number_[cell]; }

 private:
  void link_walls() {
    first_wall_.assign(complex_.cell_count + 1, 0);
    for (const Patch& p : complex_.patches) {
      ++first_wall_[p.front + 1];
      ++first_wall_[p.back + 1];
    }
    for (std::size_t c = 0; c < complex_.cell_count; ++c) first_wall_[c + 1] += first_wall_[c];
    walls_.resize(first_wall_.back());
    std::vector<std::uint32_t> fill(first_wall_.begin(), first_wall_.end() - 1);
    for (std::uint32_t p = 0; p < complex_.patches.size(); ++p) {
      walls_[fill[complex_.patches[p].front]++] = p;
      walls_[fill[complex_.patches[p].back]++] = p;
    }
  }

  void spread(std::uint32_t start, int number) {
    number_[start] = number;
    is_known_[start] = true;
    std::vector<std::uint32_t> waiting{start};
    while (!waiting.empty()) {
      const std::uint32_t cell = waiting.back();
      waiting.pop_back();
      for (std::uint32_t w = first_wall_[cell]; w < first_wall_[cell + 1]; ++w) {
        const Patch& patch = complex_.patches[walls_[w]];
        const bool from_front = patch.front == cell;
        const std::uint32_t other = from_front ? patch.back : patch.front;
        if (is_known_[other]) continue;
        const int change = change_across(complex_, walls_[w]);
        number_[other] = number_[cell] + (from_front ? change : -change);
        is_known_[other] = true;
        waiting.push_back(other);
      }
    }
  }

  const CellComplex& complex_;
  std::vector<int> number_;
  std::vector<bool> is_known_;
  std::vector<std::uint32_t> first_wall_;
  std::vector<std::uint32_t> walls_;
};

}  // namespace

CellTruth classify_winding_cells(const Sheets& sheets, const CellComplex& complex, const CellMembership& is_inside,
                                 const Context& context) {
  context.progress("winding numbers", 0);
  const CellWindings windings(sheets, complex, context);
  CellTruth truth;
  truth.inside.assign(complex.cell_count, 0);
  std::vector<bool> is_settled(complex.cell_count, false);
  const auto settle = [&](std::uint32_t cell, const Patch& patch) {
    if (is_settled[cell]) return;
    is_settled[cell] = true;
    const auto point = [&] { return point_near_sheet(sheets, patch.sheet, cell == patch.front, context); };
    if (is_inside(windings.number(cell), point)) truth.inside[cell] = 1;
  };
  for (const Patch& patch : complex.patches) {
    context.poll();
    settle(patch.front, patch);
    settle(patch.back, patch);
  }
  return truth;
}

}  // namespace quoin::overlay
