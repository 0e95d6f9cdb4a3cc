// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/parallel.h"
#include "quoin/triangulation/insertion2.h"
#include "quoin/triangulation/insertion_progress.h"

namespace quoin::detail {

/// A vertex, and how many are inserted before it, by which it has places for triangles.
struct PlacedVertex {
  std::uint32_t vertex;
  std::uint32_t place;

  /// The first of the two.
  std::uint32_t triangle() const { return 4 + 2 * place; }
};

/// Inserts points of the plane on several threads, each those of a region of its own.
///
/// A point that would change what is not its region's is late, and comes later: in other regions, or alone. What is
/// late, and where each triangle is, depends on the points and regions alone: regions share nothing that changes.
template <class Predicates>
class RegionInsertion2 {
 public:
  using Engine = Insertion2<Predicates>;
  using Place = typename Engine::Place;

  /// `whole` inserts what comes before and after.
  RegionInsertion2(const Predicates& predicates, TriangleArray2& triangles, Engine& whole, std::uint32_t vertex_count,
                   std::size_t regions, InsertionProgress& progress, const Context& context)
      : predicates_(predicates),
        triangles_(triangles),
        whole_(whole),
        vertex_count_(vertex_count),
        progress_(progress),
        context_(context) {
    hands_.reserve(regions);
    for (std::size_t r = 0; r < regions; ++r) hands_.emplace_back(predicates, triangles, vertex_count);
  }

  /// Divides all vertices into so many regions of equal length, of which the first begins at this part of all.
  /// `visit(begin, end, insert)` calls insert(PlacedVertex) for all points from `begin` to before `end`, of `points` in
  /// all. Returns those that are late, ascending.
  template <class Visit>
  std::vector<PlacedVertex> insert(std::size_t regions, double begin, std::size_t points, const Visit& visit) {
    const std::span<Hand> hands = std::span<Hand>(hands_).first(regions);
    place_regions(hands, begin);
    const std::size_t hints = std::max(least_hints, points / regions / hint_step);
    for_each_chunk(context_, regions, 1, [&](const Chunk& chunk) { place_hints(hands[chunk.index], hints); });
    for_each_chunk(context_, regions, 1, [&](const Chunk& chunk) { insert_region(hands[chunk.index], visit); });
    std::vector<PlacedVertex> late;
    for (Hand& hand : hands) {
      if (hand.engine.last() != Engine::no_triangle) whole_.begin_at(hand.engine.last());
      late.insert(late.end(), hand.late.begin(), hand.late.end());
      hand.late = std::vector<PlacedVertex>();
    }
    std::sort(late.begin(), late.end(), [](PlacedVertex a, PlacedVertex b) { return a.vertex < b.vertex; });
    return late;
  }

  /// Appends the places of no triangle.
  void append_left_over(std::vector<std::uint32_t>& places) {
    for (Hand& hand : hands_) {
      const std::vector<std::uint32_t>& list = hand.engine.left_over();
      places.insert(places.end(), list.begin(), list.end());
    }
  }

 private:
  static constexpr std::size_t hint_step = 512;  // points from one at which walks may begin to the next
  static constexpr std::size_t least_hints = 32;
  static constexpr std::size_t poll_step = 64;  // exact arithmetic of large spans takes long
  static constexpr std::size_t report_step = 4096;

  struct alignas(64) Hand {
    Engine engine;
    RankRegion ranks;
    PlaneRegion region;
    std::vector<std::uint32_t> hints;
    std::vector<PlacedVertex> late;

    Hand(const Predicates& predicates, TriangleArray2& triangles, std::uint32_t infinite)
        : engine(predicates, triangles, infinite) {}
  };

  void place_regions(std::span<Hand> hands, double begin) {
    for (std::size_t r = 0; r < hands.size(); ++r) {
      hands[r].ranks = part_of_cycle(vertex_count_, hands.size(), begin, r);
      hands[r].region = PlaneRegion(hands[r].ranks, vertex_count_);
    }
  }

  /// The triangles at vertices spread evenly over the region, where they are its.
  void place_hints(Hand& hand, std::size_t count) const {
    hand.hints.resize(count);
    hand.engine.begin_at(whole_.last());
    for (std::size_t k = 0; k < count; ++k) {
      if (k % poll_step == 0) context_.poll();
      const std::uint32_t v = part_of(hand, k).begin;
      const std::uint32_t t = hand.engine.find(predicates_.point(v), WholePlane());
      hand.engine.begin_at(t);
      hand.hints[k] = hand.region.owns(triangles_[t].corner) ? t : Engine::no_triangle;
    }
    hand.engine.begin_at(Engine::no_triangle);
  }

  /// From one hint to the next.
  RankRegion part_of(const Hand& hand, std::size_t k) const {
    const std::uint64_t length = hand.ranks.length;
    const auto bound = [&](std::size_t i) { return static_cast<std::uint32_t>(length * i / hand.hints.size()); };
    return {(hand.ranks.begin + bound(k)) % vertex_count_, bound(k + 1) - bound(k), vertex_count_};
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

  template <class Visit>
  void insert_points(Hand& hand, const Visit& visit) {
    std::size_t seen = 0;
    std::size_t done = 0;  // what is late is counted when it comes
    bool is_late = true;
    const auto insert_one = [&](const PlacedVertex& v) {
      if (++seen % poll_step == 0) context_.poll();
      is_late = hand.engine.last() == Engine::no_triangle ||
                hand.engine.insert(v.vertex, v.triangle(), hand.region) == Place::late;
      if (is_late) {
        hand.late.push_back(v);
      } else if (++done % report_step == 0) {
        progress_.add(report_step);
      }
    };
    for (std::size_t k = 0; k < hand.hints.size(); ++k) {
      if (is_late) begin_at_hint(hand, k);
      for (const auto& [begin, end] : part_of(hand, k).runs()) {
        if (has_failed_.load(std::memory_order_relaxed)) return;
        visit(begin, end, insert_one);
      }
    }
    progress_.add(done % report_step);
  }

  /// Where the way from the last triangle may be shut. A triangle that was the region's is that still, or its place is
  /// left over.
  void begin_at_hint(Hand& hand, std::size_t k) {
    const std::uint32_t t = hand.hints[k];
    if (t != Engine::no_triangle && !hand.engine.is_left_over(t)) hand.engine.begin_at(t);
  }

  const Predicates& predicates_;
  TriangleArray2& triangles_;
  Engine& whole_;
  std::uint32_t vertex_count_;
  InsertionProgress& progress_;
  const Context& context_;
  std::vector<Hand> hands_;
  std::atomic<bool> has_failed_{false};
};

}  // namespace quoin::detail
