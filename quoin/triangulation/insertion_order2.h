// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/triangulation/insertion_round.h"

namespace quoin::detail {

/// Which vertices come in which round of an insertion, ascending in each, and how many come before each: its place.
/// The three with which it starts are in none.
class InsertionOrder2 {
 public:
  InsertionOrder2(std::size_t count, const std::array<std::uint32_t, 3>& start, const Context& context)
      : count_(static_cast<std::uint32_t>(count)), start_(start) {
    for (std::uint32_t v = 0; v < count_; ++v) {
      if (v % poll_step == 0) context.poll();
      const unsigned round = insertion_round(v);
      if (round > 0 && !is_start(v)) rounds_[round].push_back(v);
    }
    std::size_t places = 0;
    for (unsigned round = insertion_rounds; round-- > 1;) {
      first_place_[round] = static_cast<std::uint32_t>(places);
      places += rounds_[round].size();
    }
    first_place_[0] = static_cast<std::uint32_t>(places);
  }

  std::size_t size(unsigned round) const {
    return round > 0 ? rounds_[round].size() : count_ - start_.size() - first_place_[0];
  }

  /// Calls visit(vertex, place) for vertices of a round from `begin` to before `end`, ascending.
  template <class Visit>
  void visit(unsigned round, std::uint32_t begin, std::uint32_t end, const Visit& visit) const {
    std::uint32_t place = first_place_[round];
    if (round == 0) {
      place += vertices_before(begin);
      for (std::uint32_t v = begin; v < std::min(end, count_); ++v) {
        if (insertion_round(v) == 0 && !is_start(v)) visit(v, place++);
      }
      return;
    }
    const std::vector<std::uint32_t>& list = rounds_[round];
    const auto first = std::lower_bound(list.begin(), list.end(), begin);
    place += static_cast<std::uint32_t>(first - list.begin());
    for (auto v = first; v != list.end() && *v < end; ++v) visit(*v, place++);
  }

 private:
  static constexpr std::uint32_t poll_step = 65536;

  bool is_start(std::uint32_t v) const { return v == start_[0] || v == start_[1] || v == start_[2]; }

  /// Of the last round.
  std::uint32_t vertices_before(std::uint32_t end) const {
    std::uint32_t before = end;
    for (const std::uint32_t v : start_) before -= v < end ? 1 : 0;
    for (const auto& list : rounds_) {
      before -= static_cast<std::uint32_t>(std::lower_bound(list.begin(), list.end(), end) - list.begin());
    }
    return before;
  }

  std::uint32_t count_;
  std::array<std::uint32_t, 3> start_;
  std::array<std::vector<std::uint32_t>, insertion_rounds> rounds_;  // but the last one
  std::array<std::uint32_t, insertion_rounds> first_place_{};
};

}  // namespace quoin::detail
