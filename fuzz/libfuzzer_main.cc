// SPDX-License-Identifier: Apache-2.0
// Built once per target with QUOIN_FUZZ_TARGET set to its name.
#include "fuzz/targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  quoin::fuzz::QUOIN_FUZZ_TARGET({data, size});
  return 0;
}
