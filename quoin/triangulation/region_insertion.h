// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
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
    has_room_ = true;
    for_each_chunk(context_, regions, 1, [&](const Chunk& chunk) { insert_region(hands[chunk.index], visit); });
    std::vector<std::uint32_t> late;
    for (Hand& hand : hands) {
      if (hand.engine.last() != Engine::no_cell) whole_.begin_at(hand.engine.last());
      whole_.pool().take_all_of(hand.engine.pool());
      late.insert(late.end(), hand.late.begin(), hand.late.end());
      hand.late = std::vector<std::uint32_t>();
      for (const std::uint32_t v : hand.hidden) when_hidden(v);
      hand.hidden = std::vector<std::uint32_t>();
      has_room_ = has_room_ && hand.engine.has_room();
    }
    std::sort(late.begin(), late.end());
    return late;
  }

  /// Whether all points that were late last time were so for what they would change, and not for want of cells.
  bool has_room() const { return has_room_; }

 private:
  static constexpr std::size_t run = 1024;  // cells
  static constexpr std::size_t hints = 32;  // where walks begin, at so many points along the region

  struct alignas(64) Hand {
    Engine engine;
    RankRegion region;
    std::array<std::uint32_t, hints> begins{};
    std::vector<std::uint32_t> late;
    std::vector<std::uint32_t> hidden;

    Hand(const Signs& signs, CellArray& cells) : engine(signs, cells) {}
  };

  void place_regions(std::span<Hand> hands, double begin) {
    for (std::size_t r = 0; r < hands.size(); ++r) hands[r].region = part_of_cycle(cycle_, hands.size(), begin, r);
    for (Hand& hand : hands) {
      hand.engine.begin_at(Engine::no_cell);
      for (std::size_t k = 0; k < hints; ++k) {
        const RankRegion& region = hand.region;
        const std::size_t rank = (region.begin + std::size_t{region.length} * (2 * k + 1) / (2 * hints)) % cycle_;
        // The last of the cycle is a vertex in a plane only.
        const auto v = static_cast<std::uint32_t>(std::min<std::size_t>(rank, cycle_ - 2));
        const std::uint32_t cell = whole_.locate(v, WholeRegion());
        whole_.begin_at(cell);
        hand.begins[k] = region.owns(cells_[cell].vertices) ? cell : Engine::no_cell;
      }
    }
  }

  /// As many as so many points have taken so far, and some more. By turns, so that what is left over lies at the end of
  /// the array, where it takes no memory.
  void hand_out_cells(std::span<Hand> hands, std::size_t points) {
    CellPool& pool = whole_.pool();
    const auto used = static_cast<double>(cells_.size() - pool.size());
    const double per_point = used / static_cast<double>(progress_.done() + 4);
    const auto wanted = static_cast<std::size_t>(static_cast<double>(points) * per_point * 1.05);
    const std::size_t enough = wanted + (hands.size() + 1) * run;
    const std::size_t missing = enough - std::min(enough, pool.size());
    if (cells_.size() + missing > cells_.capacity()) {
      cells_.reserve(std::min(cells_.size() + missing, std::max(Engine::most_cells, cells_.capacity())));
    }
    const std::size_t room = std::min(cells_.capacity(), Engine::most_cells);
    while (pool.size() < wanted + hands.size() * run && cells_.size() + run <= room) {
      const std::size_t begin = cells_.size();
      cells_.resize(begin + run);
      pool.add_run(static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(begin + run));
    }
    std::vector<CellPool> parts = pool.divided(hands.size());
    for (std::size_t r = 0; r < hands.size(); ++r) hands[r].engine.take_pool(std::move(parts[r]));
  }

  /// Where one fails, the others end too.
  template <class Visit>
  void insert_region(Hand& hand, const Visit& visit) {
    try {
      insert_points(hand, visit);
    } catch (...) {
      has_failed_ = true;
      throw;
    }
  }

  /// Once there are no cells for a point, all that come after it are late.
  template <class Visit>
  void insert_points(Hand& hand, const Visit& visit) {
    Engine& engine = hand.engine;
    std::size_t seen = 0;
    std::size_t done = 0;  // what is late is counted when it comes
    std::size_t interval = hints;
    visit(hand.region, [&](std::uint32_t v) {
      if (++seen % 256 == 0) context_.poll();
      if (has_failed_.load(std::memory_order_relaxed)) return;
      const std::size_t k = std::uint64_t{hand.region.steps_to(v)} * hints / hand.region.length;
      if (k != interval) begin_near(hand, k);
      interval = k;
      const Place place = engine.last() == Engine::no_cell || !engine.has_room()
                              ? Place::late
                              : engine.insert(v, hand.region, [&](std::uint32_t w) { hand.hidden.push_back(w); });
      if (place == Place::hidden) hand.hidden.push_back(v);
      if (place == Place::late) {
        hand.late.push_back(v);
      } else if (++done % 4096 == 0) {
        progress_.add(4096);
      }
    });
    progress_.add(done % 4096);
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
  bool has_room_ = true;
  std::atomic<bool> has_failed_{false};
};

}  // namespace quoin
