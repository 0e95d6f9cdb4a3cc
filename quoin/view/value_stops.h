// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace quoin {

/// At which of many grades a page stops: all of them where they are few, else some. What enters between two stops
/// enters with the later one, so that what is seen at a stop is exact.
class ValueStops {
 public:
  /// All grades if they are `most` or fewer; else the last one, about `most` at even distances, and those wanted.
  /// O(grades). Wanted grades that there are not are passed over; no stops where there are no grades.
  ValueStops(std::uint32_t grades, std::uint32_t most, std::span<const std::uint32_t> wanted = {});

  std::uint32_t count() const { return static_cast<std::uint32_t>(grade_.size()); }
  /// The grade at which a stop is. Ascending.
  std::uint32_t grade(std::uint32_t stop) const { return grade_[stop]; }
  /// The first stop at which the grade has entered. O(1)
  std::uint32_t of(std::uint32_t grade) const { return stop_.empty() ? grade : stop_[grade]; }

 private:
  std::vector<std::uint32_t> grade_;
  std::vector<std::uint32_t> stop_;  // by grade; empty where each grade has a stop
};

}  // namespace quoin
