// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "quoin/base/context.h"

namespace quoin::io {

/// What LZF has packed (the format of LibLZF, as PCD files use it): runs of up to 32 bytes as they are, and copies of
/// up to 264 bytes from up to 8192 bytes before. Nothing where the bytes do not unpack to exactly `size`; sizes that no
/// such bytes unpack to are told before anything is allocated. O(size). @throws Cancelled
std::optional<std::string> unpack_lzf(std::string_view packed, std::size_t size, const Context& context);

}  // namespace quoin::io
