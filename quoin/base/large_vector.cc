// SPDX-License-Identifier: Apache-2.0
#include "quoin/base/large_vector.h"

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace quoin::detail {

void ask_for_huge_pages([[maybe_unused]] void* block, [[maybe_unused]] std::size_t bytes) noexcept {
#if defined(__linux__)
  madvise(block, bytes, MADV_HUGEPAGE);
#endif
}

}  // namespace quoin::detail
