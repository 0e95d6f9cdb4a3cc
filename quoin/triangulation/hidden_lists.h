// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace quoin {

/// Points that are hidden in a triangulation, each in the list of the cell that holds it; for a while, in a list of
/// those that are to be placed anew. Each step takes O(1), and no memory but where it says so.
class HiddenLists {
 public:
  static constexpr std::uint32_t none = 0xFFFFFFFF;

  /// For so many ids and cells. All memory that is ever taken; where it throws, nothing has changed.
  void reserve(std::size_t ids, std::size_t cells) {
    make_room(previous_, ids);
    make_room(next_, ids);
    make_room(first_, cells);
    if (ids > previous_.size()) previous_.resize(ids, shown);
    if (ids > next_.size()) next_.resize(ids, none);
    if (cells > first_.size()) first_.resize(cells, none);
  }

  bool has(std::uint32_t id) const { return id < previous_.size() && previous_[id] != shown; }
  std::size_t count() const { return count_; }
  /// The list of a cell ends with `none`.
  std::uint32_t first(std::uint32_t cell) const { return first_[cell]; }
  std::uint32_t next(std::uint32_t id) const { return next_[id]; }

  /// Hides a point that is shown.
  void put(std::uint32_t id, std::uint32_t cell) {
    ++count_;
    link(id, first_[cell], cell);
  }
  /// Shows a point of a cell's list.
  void take(std::uint32_t id) {
    --count_;
    const std::uint32_t before = std::exchange(previous_[id], shown);
    const std::uint32_t after = next_[id];
    ((before & is_list) != 0 ? first_[before & ~is_list] : next_[before]) = after;
    if (after != none) previous_[after] = before;
  }
  /// The list of one cell, which gets none, becomes that of another, which had none.
  void move(std::uint32_t from, std::uint32_t to) {
    const std::uint32_t id = std::exchange(first_[from], none);
    first_[to] = id;
    if (id != none) previous_[id] = to | is_list;
  }

  /// Hides a point that is shown; it is to be placed.
  void put_loose(std::uint32_t id) {
    ++count_;
    link(id, loose_, loose_list);
  }
  /// All points of a cell are to be placed.
  void loosen(std::uint32_t cell) {
    for (std::uint32_t id = std::exchange(first_[cell], none); id != none;) {
      link(std::exchange(id, next_[id]), loose_, loose_list);
    }
  }
  /// One that is to be placed goes into the list of a cell.
  std::uint32_t first_loose() const { return loose_; }
  void place_first_loose(std::uint32_t cell) {
    const std::uint32_t id = std::exchange(loose_, next_[loose_]);
    link(id, first_[cell], cell);
  }

 private:
  static constexpr std::uint32_t shown = 0xFFFFFFFE;
  static constexpr std::uint32_t is_list = 0x80000000;  // ids are smaller, and cells than loose_list
  static constexpr std::uint32_t loose_list = 0x7FFFFFFD;

  static void make_room(std::vector<std::uint32_t>& list, std::size_t size) {
    if (size > list.capacity()) list.reserve(std::max(size, 2 * list.capacity()));
  }
  void link(std::uint32_t id, std::uint32_t& first, std::uint32_t list) {
    previous_[id] = list | is_list;
    next_[id] = first;
    if (first != none) previous_[first] = id;
    first = id;
  }

  std::vector<std::uint32_t> first_;     ///< of each cell
  std::vector<std::uint32_t> previous_;  ///< of each id; of the first its list, with is_list
  std::vector<std::uint32_t> next_;
  std::uint32_t loose_ = none;
  std::size_t count_ = 0;
};

}  // namespace quoin
