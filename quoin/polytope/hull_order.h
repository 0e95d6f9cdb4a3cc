// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/point.h"

namespace quoin {

struct RandomOrder {
  static constexpr unsigned rounds = 8;
  std::vector<std::uint32_t> points;
  std::array<std::size_t, rounds + 1> round_begin{};  ///< in `points`; its size last
};

/// Some of the given points, by their indices, in an order that suits incremental constructions: in rounds, each eight
/// times as large as the one before and chosen by chance, and in each along a Hilbert curve; more than a few points of
/// one cell of the curve along a finer curve of their own, and so on. Of equal points the one that was given first
/// comes first. Depends on the points alone. O(n) for points whose distances are of like size; at most O(n) per 10 bits
/// that they span. Source: Amenta, Choi and Rote 2003; Skilling 2004 (Hilbert curves).
RandomOrder biased_random_order(std::span<const Point3> points, std::span<const std::uint32_t> chosen,
                                const Context& context);

}  // namespace quoin
