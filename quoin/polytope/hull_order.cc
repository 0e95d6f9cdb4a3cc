// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/hull_order.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "quoin/base/large_vector.h"
#include "quoin/base/parallel.h"

#include "quoin/kernel/hilbert_key.h"

namespace quoin {

namespace {

constexpr unsigned bits_per_axis = 10;
constexpr unsigned most_rounds = RandomOrder::rounds;
constexpr unsigned digit_bits = 11;
constexpr std::size_t grain = 16384;
constexpr unsigned key_bits = 3 * bits_per_axis + 3;  // the round comes first
static_assert(key_bits == 3 * digit_bits && most_rounds == 8);

struct Keyed {
  std::uint64_t key;
  std::uint32_t point;
};

/// By the coordinates, so that equal points are in one round: 0 for about one in 8^7, 7 for seven in eight.
std::uint64_t round_of(const Point3& p) {
  std::uint64_t hash = 0;
  for (const double coordinate : {p.x, p.y, p.z}) {
    hash = (hash ^ std::bit_cast<std::uint64_t>(coordinate + 0.0)) * 0x9E3779B97F4A7C15U;  // -0 becomes 0
    hash ^= hash >> 29;
  }
  hash = (hash ^ (hash >> 32)) * 0xBF58476D1CE4E5B9U;
  const auto eighths = static_cast<unsigned>(std::countl_zero(hash | 1)) / 3;
  return most_rounds - 1 - std::min(eighths, most_rounds - 1);
}

/// From coordinates to the cells of a cube around all points. Halves, so that no difference overflows.
class Cells {
 public:
  Cells(std::span<const Point3> points, std::span<const std::uint32_t> chosen, const Context& context) {
    std::vector<Box> boxes(chunk_count(chosen.size(), grain));
    for_each_chunk(context, chosen.size(), grain, [&](const Chunk& chunk) {
      Box box;
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          box.low[axis] = std::min(box.low[axis], points[chosen[i]][axis]);
          box.high[axis] = std::max(box.high[axis], points[chosen[i]][axis]);
        }
      }
      boxes[chunk.index] = box;
    });
    Box all;
    double size = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const Box& box : boxes) {
        all.low[axis] = std::min(all.low[axis], box.low[axis]);
        all.high[axis] = std::max(all.high[axis], box.high[axis]);
      }
      size = std::max(size, all.high[axis] / 2 - all.low[axis] / 2);
    }
    low_ = all.low;
    per_cell_ = static_cast<double>(1U << bits_per_axis) / std::max(size, 0x1p-1000);
  }

  std::array<std::uint32_t, 3> of(const Point3& p) const {
    constexpr double last = (1U << bits_per_axis) - 1;
    std::array<std::uint32_t, 3> cell{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      cell[axis] = static_cast<std::uint32_t>(std::clamp((p[axis] / 2 - low_[axis] / 2) * per_cell_, 0.0, last));
    }
    return cell;
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  struct Box {
    std::array<double, 3> low{infinity, infinity, infinity};
    std::array<double, 3> high{-infinity, -infinity, -infinity};
  };
  std::array<double, 3> low_{};
  double per_cell_ = 1;
};

/// Stable. Each thread counts digits in a part of the list, and moves that part to where it belongs.
void sort_by_digit(std::span<const Keyed> from, std::span<Keyed> to, unsigned shift, const Context& context) {
  constexpr std::size_t digits = std::size_t{1} << digit_bits;
  const auto digit = [shift](const Keyed& k) { return static_cast<std::size_t>(k.key >> shift) & (digits - 1); };
  const std::size_t part = std::max(grain, chunk_count(from.size(), context.threads()));
  std::vector<std::array<std::size_t, digits>> places(chunk_count(from.size(), part));
  for_each_chunk(context, from.size(), part, [&](const Chunk& chunk) {
    std::array<std::size_t, digits>& counts = places[chunk.index];
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) ++counts[digit(from[i])];
  });
  std::size_t place = 0;
  for (std::size_t d = 0; d < digits; ++d) {
    for (auto& of_part : places) place += std::exchange(of_part[d], place);
  }
  for_each_chunk(context, from.size(), part, [&](const Chunk& chunk) {
    std::array<std::size_t, digits>& next = places[chunk.index];
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) to[next[digit(from[i])]++] = from[i];
  });
}

}  // namespace

RandomOrder biased_random_order(std::span<const Point3> points, std::span<const std::uint32_t> chosen,
                                const Context& context) {
  const Cells cells(points, chosen, context);
  UnsetVector<Keyed> list(chosen.size());
  for_each_chunk(context, list.size(), grain, [&](const Chunk& chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const Point3& p = points[chosen[i]];
      list[i] = {round_of(p) << (3 * bits_per_axis) | hilbert_key(cells.of(p), bits_per_axis), chosen[i]};
    }
  });
  UnsetVector<Keyed> other(list.size());
  for (unsigned pass = 0; pass < 3; ++pass) {
    sort_by_digit(list, other, pass * digit_bits, context);
    list.swap(other);
  }
  RandomOrder order;
  order.points.resize(list.size());
  for_each_chunk(context, list.size(), grain, [&](const Chunk& chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) order.points[i] = list[i].point;
  });
  for (std::size_t round = 0; round <= RandomOrder::rounds; ++round) {
    const auto is_before = [](const Keyed& k, std::uint64_t r) { return k.key >> (3 * bits_per_axis) < r; };
    const auto begin = std::lower_bound(list.begin(), list.end(), round, is_before);
    order.round_begin[round] = static_cast<std::size_t>(begin - list.begin());
  }
  return order;
}

}  // namespace quoin
