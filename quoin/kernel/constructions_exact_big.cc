// SPDX-License-Identifier: Apache-2.0
#include "quoin/kernel/constructions_exact_impl.h"

namespace quoin::detail {

template class ExactTable<NumbersBig>;

}  // namespace quoin::detail
