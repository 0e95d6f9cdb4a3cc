// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "quoin/base/parallel.h"
#include "quoin/triangulation/incremental3.h"
#include "quoin/triangulation/insertion_progress.h"
#include "quoin/triangulation/rank_region.h"

namespace quoin {

/// Inserts points on several threads, each those of a region of its own.
///
/// A point that would change what is not its region's is late, and comes later: in other regions, or alone. What is
/// late, and which place of the array each cell gets, depends on the points and regions alone: regions share nothing
/// that changes, and each has places of its own.
template <class Signs>
class RegionInsertion {
 public:
  using Engine = IncrementalTriangulation<Signs>;
  using Place = typename Engine::Place;

  /// `whole` inserts what comes before and after; vertices are 0 to `cycle` - 1.
  RegionInsertion(const Signs& signs, CellArray& cells, Engine& whole, std::uint32_t cycle, std::size_t regions,
                  InsertionProgress& progress, const Context& context)
      : cells_(cells), whole_(whole), cycle_(cycle), progress_(progress), context_(context) {
    hands_.reserve(regions);
    for (std::size_t r = 0; r < regions; ++r) hands_.emplace_back(signs, cells);
  }

  /// Divides all vertices into so many regions of equal length, of which the first begins at this part of the cycle.
  /// `visit(region, insert)` calls `insert` with all points of a region; there are about `points` in all. Returns what
  /// is late, ascending.
  template <class Visit, class WhenHidden>
  std::vector<std::uint32_t> insert(std::size_t regions, double begin, std::size_t points, const Visit& visit,
                                    const WhenHidden& when_hidden) {
    const std::span<Hand> hands = std::span<Hand>(hands_).first(regions);
    place_regions(hands, begin);

    hand_out_cells(hands, points);
    for_each_chunk(context_, regions, 1, [&](const Chunk& chunk) { insert_region(hands[chunk.index], visit); });
    std::vector<std::uint32_t> late;
    for (Hand& hand : hands) {
      if (hand.engine.last() != Engine::no_cell) whole_.begin_at(hand.engine.last());
      whole_.pool().take_all_of(hand.engine.pool());
      late.insert(late.end(), hand.late.begin(), hand.late.end());
      hand.late = {};
      for (const std::uint32_t v : hand.hidden) when_hidden(v);
      hand.hidden = {};
    }
    std::sort(late.begin(), late.end());
    return late;
  }

 private:
  static constexpr std::size_t run = 1024;  // cells
  static constexpr std::size_t hints = 32;  // where walks begin, at so many points along the region

  struct Hand {
    Engine engine;
    RankRegion region;
    std::array<std::uint32_t, hints> begins{};
    std::vector<std::uint32_t> late;
    std::vector<std::uint32_t> hidden;

    Hand(const Signs& signs, CellArray& cells) : engine(signs, cells) {}
  };

  void place_regions(std::span<Hand> hands, double begin) {
    const auto bound = [&](std::size_t r) {
      const double part = begin + static_cast<double>(r) / static_cast<double>(hands.size());
      return static_cast<std::uint32_t>(part * static_cast<double>(cycle_));
    };
    for (std::size_t r = 0; r < hands.size(); ++r) {
      const std::uint32_t end = r + 1 < hands.size() ? bound(r + 1) : bound(0) + cycle_;
      hands[r].region = {bound(r) % cycle_, end - bound(r), cycle_};
    }
    for (Hand& hand : hands) {
      hand.engine.begin_at(Engine::no_cell);
      for (std::size_t k = 0; k < hints; ++k) {
        const RankRegion& region = hand.region;
        const auto v = static_cast<std::uint32_t>((region.begin + region.length * (2 * k + 1) / (2 * hints)) % cycle_);
        const std::uint32_t cell = whole_.locate(v, WholeRegion());
        whole_.begin_at(cell);
        hand.begins[k] = region.owns(cells_[cell].vertices) ? cell : Engine::no_cell;
      }
    }
  }

  /// As many as so many points have taken so far, and some more; no more than the array has room for. By turns, so that
  /// what is left over lies at the end of the array, where it takes no memory.
  void hand_out_cells(std::span<Hand> hands, std::size_t points) {
    CellPool& pool = whole_.pool();
    const auto used = static_cast<double>(cells_.size() - pool.size());
    const double per_point = used / static_cast<double>(progress_.done() + 4);
    const auto wanted = static_cast<std::size_t>(static_cast<double>(points) * per_point * 1.05);
    const std::size_t room = std::min(cells_.capacity(), Engine::most_cells);
    while (pool.size() < wanted + hands.size() * run && cells_.size() + run <= room) {
      const std::size_t begin = cells_.size();
      cells_.resize(begin + run);
      pool.add_run(static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(begin + run));
    }
    std::vector<CellPool> parts = pool.divided(hands.size());
    for (std::size_t r = 0; r < hands.size(); ++r) hands[r].engine.pool() = std::move(parts[r]);
  }

  template <class Visit>
  void insert_region(Hand& hand, const Visit& visit) {
    Engine& engine = hand.engine;
    std::size_t done = 0;
    std::size_t interval = hints;
    visit(hand.region, [&](std::uint32_t v) {
      const std::size_t k = std::uint64_t{hand.region.steps_to(v)} * hints / hand.region.length;
      if (k != interval) begin_near(hand, k);
      interval = k;
      const Place place = engine.last() == Engine::no_cell
                              ? Place::late
                              : engine.insert(v, hand.region, [&](std::uint32_t w) { hand.hidden.push_back(w); });
      if (place == Place::hidden) hand.hidden.push_back(v);
      if (place == Place::late) hand.late.push_back(v);
      if (++done % 256 == 0) context_.poll();
      if (done % 4096 == 0) progress_.add(4096);
    });
    // What is late is counted when it comes.
    progress_.add(done % 4096);
    progress_.take_back(hand.late.size());
  }

  /// A cell that was the region's is that still, or no cell.
  void begin_near(Hand& hand, std::size_t k) {
    const std::uint32_t cell = hand.begins[k];
    if (cell != Engine::no_cell && !hand.engine.is_free(cell)) hand.engine.begin_at(cell);
  }

  CellArray& cells_;
  Engine& whole_;
  std::uint32_t cycle_;
  InsertionProgress& progress_;
  const Context& context_;
  std::vector<Hand> hands_;
};

}  // namespace quoin
