// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/overlay/cells.h"

#include <vector>

#include "quoin/base/disjoint_sets.h"
#include "quoin/base/error.h"
#include "quoin/base/parallel.h"

namespace quoin::overlay {

namespace {

class CellBuilder {
 public:
  CellBuilder(const Sheets& sheets, const Fans& fans, const Context& context)
      : sheets_(sheets), fans_(fans), context_(context), patch_sets_(sheets.count()) {}

  CellComplex run() {
    join_tiles();
    join_plain_fans();
    number_patches();
    DisjointSets cells(2 * complex_.patches.size());
    for (const Fan& fan : fans_.fans) {
      if (!fan.is_plain) join_cells(fans_.sides_of(fan), cells);
    }
    number_cells(cells);
    return std::move(complex_);
  }

 private:
  bool is_involved(std::uint32_t tile) const {
    const std::uint32_t facet = sheets_.scene->facet_of_tile[tile];
    return facet != none && sheets_.network->involved[facet];
  }

  // Edges between tiles of which none is involved; the others occur in fans. Such edges stay within a leaf.
  void join_tiles() {
    for_each_chunk(context_, sheets_.scene->leaves.size(), 1,
                   [&](const Chunk& chunk) { join_tiles_of(static_cast<std::uint32_t>(chunk.index)); });
  }

  void join_tiles_of(std::uint32_t leaf) {
    const Scene& scene = *sheets_.scene;
    const std::vector<std::uint32_t>& twins = scene.leaves[leaf]->twins;
    const std::uint32_t first = scene.first_tile[leaf];
    for (std::uint32_t h = 0; h < twins.size(); ++h) {
      if (h % 65536 == 0) context_.poll();
      if (twins[h] == Leaf::no_twin || twins[h] < h) continue;
      const std::uint32_t a = first + h / 3;
      const std::uint32_t b = first + twins[h] / 3;
      if (!is_involved(a) && !is_involved(b)) patch_sets_.unite(a, b);
    }
  }

  void join_plain_fans() {
    for (const Fan& fan : fans_.fans) {
      if (fan.is_plain) patch_sets_.unite(fans_.sides[fan.first].sheet, fans_.sides[fan.first + 1].sheet);
    }
  }

  void number_patches() {
    const auto count = static_cast<std::uint32_t>(sheets_.count());
    complex_.patch_of.resize(count);
    std::vector<Winding> across;
    for (std::uint32_t s = 0; s < count; ++s) {
      if (s % 65536 == 0) context_.poll();
      const std::uint32_t root = patch_sets_.find(s);
      if (root != s) {
        complex_.patch_of[s] = complex_.patch_of[root];
        continue;
      }
      if (s < sheets_.tile_count() && sheets_.is_replaced(s)) {
        complex_.patch_of[s] = none;
        continue;
      }
      complex_.patch_of[s] = static_cast<std::uint32_t>(complex_.patches.size());
      complex_.patches.push_back({s, 0, 0});
      windings_across(sheets_, s, across);
      complex_.windings.insert(complex_.windings.end(), across.begin(), across.end());
      complex_.patch_first_winding.push_back(static_cast<std::uint32_t>(complex_.windings.size()));
    }
  }

  // The cell slot counterclockwise or clockwise of a side: the front of a forward sheet faces counterclockwise.
  std::uint32_t slot(const Side& side, bool counterclockwise) const {
    return 2 * complex_.patch_of[side.sheet] + (side.forward == counterclockwise ? 0 : 1);
  }

  void join_cells(std::span<const Side> sides, DisjointSets& cells) {
    for (std::size_t i = 0; i < sides.size(); ++i) {
      const Side& here = sides[i];
      const Side& after = sides[i + 1 == sides.size() ? 0 : i + 1];
      if (here.rank == after.rank && i + 1 != sides.size())
        throw InternalError("two regions of the overlay lie on one another");
      cells.unite(slot(here, true), slot(after, false));
    }
  }

  void number_cells(DisjointSets& cells) {
    std::vector<std::uint32_t> number(cells.size(), none);
    for (std::uint32_t s = 0; s < cells.size(); ++s) {
      const std::uint32_t root = cells.find(s);
      if (number[root] == none) number[root] = complex_.cell_count++;
      Patch& patch = complex_.patches[s / 2];
      (s % 2 == 0 ? patch.front : patch.back) = number[root];
    }
  }

  const Sheets& sheets_;
  const Fans& fans_;
  const Context& context_;
  DisjointSets patch_sets_;
  CellComplex complex_;
};

}  // namespace

CellComplex make_cells(const Sheets& sheets, const Fans& fans, const Context& context) {
  context.progress("cells", 0);
  return CellBuilder(sheets, fans, context).run();
}

}  // namespace quoin::overlay
