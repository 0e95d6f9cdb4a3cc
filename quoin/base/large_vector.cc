// SPDX-License-Identifier: Apache-2.0
#include "quoin/base/large_vector.h"

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace quoin::detail {

// Blocks of up to 128 megabytes mostly get pages that were in use before. Of larger ones many were not, and a virtual
// machine must first get a huge one from its host: triangulations of ten million points took a third longer with them.
void ask_for_huge_pages([[maybe_unused]] void* block, [[maybe_unused]] std::size_t bytes) noexcept {
#if defined(__linux__)
  constexpr std::size_t most = std::size_t{1} << 27;
  if (bytes <= most) madvise(block, bytes, MADV_HUGEPAGE);
#endif
}

}  // namespace quoin::detail
