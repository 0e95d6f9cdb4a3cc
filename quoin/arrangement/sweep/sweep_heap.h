// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "quoin/arrangement/curve_family.h"
#include "quoin/arrangement/sweep/sweep_status.h"

namespace quoin {

/// Pending crossings: at most one for every node of the status, the first one with its upper neighbour. A heap of four
/// children over nodes; because a node has one entry, none is ever stale and there are never more than active curves.
template <CurveFamily F>
class SweepHeap {
 public:
  using Point = typename F::Point;

  SweepHeap(const F& family, SweepStatus& status)
      : family_(family), status_(status), certain_gap_(2 * family.key_error()) {}

  bool is_empty() const { return heap_.empty(); }
  std::uint32_t top() const { return heap_[0].node; }
  const Point& point(std::uint32_t node) const { return points_[node]; }
  bool has(std::uint32_t node) const { return status_[node].heap_place != SweepStatus::none; }

  /// `node` must have no entry.
  void push(std::uint32_t node, const Point& point) {
    if (points_.size() < status_.capacity()) points_.resize(status_.capacity());
    points_[node] = point;
    heap_.push_back({family_.sweep_key(point), node});
    rise(heap_.size() - 1);
  }
  void remove(std::uint32_t node) {
    const std::size_t place = status_[node].heap_place;
    if (place == SweepStatus::none) return;
    status_[node].heap_place = SweepStatus::none;
    const Entry last = heap_.back();
    heap_.pop_back();
    if (last.node == node) return;
    heap_[place] = last;
    status_[last.node].heap_place = static_cast<std::uint32_t>(place);
    if (place > 0 && is_before(last, heap_[(place - 1) / 4])) {
      rise(place);
    } else {
      sink(place);
    }
  }

 private:
  /// The rounded key stands beside the node, so that most comparisons stay within the heap.
  struct Entry {
    double key;
    std::uint32_t node;
  };

  bool is_before(const Entry& a, const Entry& b) const {
    const double gap = a.key - b.key;
    if (std::fabs(gap) > std::max(certain_gap_, 0x1p-44 * std::fabs(a.key))) [[likely]]
      return gap < 0;
    return family_.compare_xy(points_[a.node], points_[b.node]) == Sign::negative;
  }
  void set(std::size_t place, const Entry& entry) {
    heap_[place] = entry;
    status_[entry.node].heap_place = static_cast<std::uint32_t>(place);
  }
  void rise(std::size_t place) {
    const Entry entry = heap_[place];
    while (place > 0) {
      const std::size_t parent = (place - 1) / 4;
      if (!is_before(entry, heap_[parent])) break;
      set(place, heap_[parent]);
      place = parent;
    }
    set(place, entry);
  }
  void sink(std::size_t place) {
    const Entry entry = heap_[place];
    for (;;) {
      const std::size_t first = 4 * place + 1;
      if (first >= heap_.size()) break;
      std::size_t least = first;
      for (std::size_t child = first + 1; child < std::min(first + 4, heap_.size()); ++child) {
        if (is_before(heap_[child], heap_[least])) least = child;
      }
      if (!is_before(heap_[least], entry)) break;
      set(place, heap_[least]);
      place = least;
    }
    set(place, entry);
  }

  const F& family_;
  SweepStatus& status_;
  double certain_gap_;  // of two keys, beyond which they order like the points
  std::vector<Entry> heap_;
  std::vector<Point> points_;  // by node
};

}  // namespace quoin
