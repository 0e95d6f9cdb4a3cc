// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "quoin/arrangement/curve_family.h"
#include "quoin/arrangement/sweep_status.h"

namespace quoin {

/// Pending crossings: at most one for every node of the status, the first one with its upper neighbour. A heap of four
/// children over nodes; because a node has one entry, none is ever stale and there are never more than active curves.
template <CurveFamily F>
class SweepHeap {
 public:
  using Point = typename F::Point;

  SweepHeap(const F& family, SweepStatus& status) : family_(family), status_(status) {}

  bool is_empty() const { return heap_.empty(); }
  std::uint32_t top() const { return heap_[0]; }
  const Point& point(std::uint32_t node) const { return points_[node]; }
  bool has(std::uint32_t node) const { return status_[node].heap_place != SweepStatus::none; }

  /// `node` must have no entry.
  void push(std::uint32_t node, const Point& point) {
    if (points_.size() < status_.capacity()) points_.resize(status_.capacity());
    points_[node] = point;
    heap_.push_back(node);
    rise(heap_.size() - 1);
  }
  void remove(std::uint32_t node) {
    const std::size_t place = status_[node].heap_place;
    if (place == SweepStatus::none) return;
    status_[node].heap_place = SweepStatus::none;
    const std::uint32_t last = heap_.back();
    heap_.pop_back();
    if (last == node) return;
    heap_[place] = last;
    status_[last].heap_place = static_cast<std::uint32_t>(place);
    rise(place);
    sink(status_[last].heap_place);
  }

 private:
  bool is_before(std::uint32_t a, std::uint32_t b) const {
    return family_.compare_xy(points_[a], points_[b]) == Sign::negative;
  }
  void set(std::size_t place, std::uint32_t node) {
    heap_[place] = node;
    status_[node].heap_place = static_cast<std::uint32_t>(place);
  }
  void rise(std::size_t place) {
    const std::uint32_t node = heap_[place];
    while (place > 0) {
      const std::size_t parent = (place - 1) / 4;
      if (!is_before(node, heap_[parent])) break;
      set(place, heap_[parent]);
      place = parent;
    }
    set(place, node);
  }
  void sink(std::size_t place) {
    const std::uint32_t node = heap_[place];
    for (;;) {
      const std::size_t first = 4 * place + 1;
      if (first >= heap_.size()) break;
      std::size_t least = first;
      for (std::size_t child = first + 1; child < std::min(first + 4, heap_.size()); ++child) {
        if (is_before(heap_[child], heap_[least])) least = child;
      }
      if (!is_before(heap_[least], node)) break;
      set(place, heap_[least]);
      place = least;
    }
    set(place, node);
  }

  const F& family_;
  SweepStatus& status_;
  std::vector<std::uint32_t> heap_;
  std::vector<Point> points_;  // by node
};

}  // namespace quoin
