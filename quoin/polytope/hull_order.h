// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/point.h"

namespace quoin {

/// Some of the given points, by their indices, in an order that suits incremental constructions: in rounds, each eight
/// times as large as the one before and chosen by chance, and in each along a Hilbert curve. Of equal points the one
/// that was given first comes first. Depends on the points alone. O(n).
/// Source: Amenta, Choi and Rote 2003; Skilling 2004 (Hilbert curves).
std::vector<std::uint32_t> biased_random_order(std::span<const Point3> points, std::span<const std::uint32_t> chosen,
                                               const Context& context);

}  // namespace quoin
