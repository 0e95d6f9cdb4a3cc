// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace quoin::testing {

/// While it lives, one allocation of this thread throws std::bad_alloc: the first after `others`.
class FailingAllocation {
 public:
  explicit FailingAllocation(std::size_t others);
  ~FailingAllocation();
  FailingAllocation(const FailingAllocation&) = delete;
  FailingAllocation& operator=(const FailingAllocation&) = delete;

  bool has_failed() const;
};

}  // namespace quoin::testing
