// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "quoin/kernel/constructions.h"

namespace quoin::overlay {

/// Gives equal points one id: the smallest of those inserted.
class PointMerger {
 public:
  explicit PointMerger(const Constructions& table) : table_(&table) {}
  /// The id that stands for the point; the point's own when it is the first of its value.
  PointId insert(PointId point);

 private:
  void grow();
  const Constructions* table_;
  std::vector<std::uint32_t> slots_;
  std::size_t used_ = 0;
};

}  // namespace quoin::overlay
