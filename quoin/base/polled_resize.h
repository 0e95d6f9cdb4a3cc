// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>

#include "quoin/base/context.h"

namespace quoin {

/// `list.resize(size, value)` of a list that is not longer, and polls: memory that is touched for the first time takes
/// up to a second per gigabyte.
template <class Vector>
void resize_and_poll(Vector& list, std::size_t size, const Context& context,
                     const typename Vector::value_type& value = {}) {
  constexpr std::size_t step = (std::size_t{1} << 22) / sizeof(typename Vector::value_type) + 1;
  list.reserve(size);
  while (list.size() < size) {
    context.poll();
    list.resize(std::min(size, list.size() + step), value);
  }
}

}  // namespace quoin
