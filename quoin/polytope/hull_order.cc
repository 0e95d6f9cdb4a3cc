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
constexpr unsigned cell_bits = 3 * bits_per_axis;
constexpr unsigned key_bits = cell_bits + 3;  // the round comes first
static_assert(key_bits == 3 * digit_bits && most_rounds == 8);
constexpr std::size_t few = 16;  // points of one cell that stay as they come

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

/// From coordinates to the cells of a cube around some points. Halves, so that no difference overflows; of points so
/// near that halves would lose something, differences themselves, which are exact, times a power of two.
class Cells {
 public:
  template <class PointAt>
  Cells(std::size_t count, const PointAt& point_at, const Context& context) {
    std::vector<Box> boxes(chunk_count(count, grain));
    for_each_chunk(context, count, grain, [&](const Chunk& chunk) {
      Box box;
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
        const Point3& p = point_at(i);
        for (std::size_t axis = 0; axis < 3; ++axis) {
          box.low[axis] = std::min(box.low[axis], p[axis]);
          box.high[axis] = std::max(box.high[axis], p[axis]);
        }
      }
      boxes[chunk.index] = box;
    });
    Box all;
    for (const Box& box : boxes) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        all.low[axis] = std::min(all.low[axis], box.low[axis]);
        all.high[axis] = std::max(all.high[axis], box.high[axis]);
      }
    }
    set_scale(all);
  }

  bool are_points_equal() const { return are_points_equal_; }

  /// The points that are first and last along the longest axis are in different cells, unless all are equal.
  std::uint64_t key(const Point3& p) const {
    constexpr double last = (1U << bits_per_axis) - 1;
    std::array<std::uint32_t, 3> cell{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double place = (p[axis] * part_ - low_[axis]) * lift_ * per_cell_;
      cell[axis] = static_cast<std::uint32_t>(std::clamp(place, 0.0, last));
    }
    return hilbert_key(cell, bits_per_axis);
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  struct Box {
    std::array<double, 3> low{infinity, infinity, infinity};
    std::array<double, 3> high{-infinity, -infinity, -infinity};
  };

  void set_scale(const Box& box) {
    double half = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      half = std::max(half, box.high[axis] / 2 - box.low[axis] / 2);
      are_points_equal_ = are_points_equal_ && !(box.low[axis] < box.high[axis]);
    }
    if (half < 0x1p-900) {
      part_ = 1;
      lift_ = 0x1p600;
    }
    double size = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low_[axis] = box.low[axis] * part_;
      size = std::max(size, (box.high[axis] * part_ - low_[axis]) * lift_);
    }
    per_cell_ = are_points_equal_ ? 0 : static_cast<double>(1U << bits_per_axis) / size;
  }

  std::array<double, 3> low_{};
  double part_ = 0.5;
  double lift_ = 1;
  double per_cell_ = 0;
  bool are_points_equal_ = true;
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

/// Sorts by keys, and what is in one cell along a finer curve of its own.
class Sorter {
 public:
  Sorter(std::span<const Point3> points, std::size_t count, const Context& context)
      : points_(points), other_(count), context_(context) {}

  /// Of keys that are set; the list has as many places as were promised.
  void sort(UnsetVector<Keyed>& list) {
    for (unsigned pass = 0; pass < 3; ++pass) {
      sort_by_digit(list, other_, pass * digit_bits, context_);
      list.swap(other_);
    }
    refine_cells(list);
  }

 private:
  void refine_cells(std::span<Keyed> list) {
    for (std::size_t begin = 0; begin < list.size();) {
      std::size_t end = begin + 1;
      while (end < list.size() && list[end].key == list[begin].key) ++end;
      if (end - begin > few) refine(list.subspan(begin, end - begin));
      begin = end;
    }
  }

  /// Each time the points are of at least two cells, of a size that falls by a factor of almost 1024: no deeper than
  /// the range of doubles allows.
  void refine(std::span<Keyed> list) {
    context_.poll();
    const auto point_at = [&](std::size_t i) -> const Point3& { return points_[list[i].point]; };
    const Cells cells(list.size(), point_at, context_);
    if (cells.are_points_equal()) return;
    const std::uint64_t round = list[0].key >> cell_bits << cell_bits;
    for_each_chunk(context_, list.size(), grain, [&](const Chunk& chunk) {
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) list[i].key = round | cells.key(point_at(i));
    });
    sort_by_key(list);
    refine_cells(list);
  }

  /// Stable.
  void sort_by_key(std::span<Keyed> list) {
    if (list.size() < 4096) {
      std::stable_sort(list.begin(), list.end(), [](const Keyed& a, const Keyed& b) { return a.key < b.key; });
      return;
    }
    const std::span<Keyed> other(other_.data(), list.size());
    sort_by_digit(list, other, 0, context_);
    sort_by_digit(other, list, digit_bits, context_);
    sort_by_digit(list, other, 2 * digit_bits, context_);
    std::copy(other.begin(), other.end(), list.begin());
  }

  std::span<const Point3> points_;
  UnsetVector<Keyed> other_;
  const Context& context_;
};

}  // namespace

RandomOrder biased_random_order(std::span<const Point3> points, std::span<const std::uint32_t> chosen,
                                const Context& context) {
  const Cells cells(
      chosen.size(), [&](std::size_t i) -> const Point3& { return points[chosen[i]]; }, context);
  UnsetVector<Keyed> list(chosen.size());
  for_each_chunk(context, list.size(), grain, [&](const Chunk& chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const Point3& p = points[chosen[i]];
      list[i] = {round_of(p) << cell_bits | cells.key(p), chosen[i]};
    }
  });
  Sorter(points, list.size(), context).sort(list);
  RandomOrder order;
  order.points.resize(list.size());
  for_each_chunk(context, list.size(), grain, [&](const Chunk& chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) order.points[i] = list[i].point;
  });
  for (std::size_t round = 0; round <= RandomOrder::rounds; ++round) {
    const auto is_before = [](const Keyed& k, std::uint64_t r) { return k.key >> cell_bits < r; };
    const auto begin = std::lower_bound(list.begin(), list.end(), round, is_before);
    order.round_begin[round] = static_cast<std::size_t>(begin - list.begin());
  }
  return order;
}

}  // namespace quoin
