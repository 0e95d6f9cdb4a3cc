// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/spatial_order.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#if defined(__linux__)
#include <malloc.h>
#endif

#include "quoin/base/large_vector.h"
#include "quoin/base/parallel.h"
#include "quoin/kernel/hilbert_key.h"
#include "quoin/triangulation/distinct_points.h"

namespace quoin {

namespace {

constexpr unsigned bits_per_axis = 11;
constexpr unsigned digit_bits = 11;
constexpr std::size_t digits = std::size_t{1} << digit_bits;
constexpr std::size_t least_grain = std::size_t{1} << 15;  // points that a thread counts and moves at a time
constexpr std::size_t most_chunks = 64;
constexpr unsigned passes = 3 * bits_per_axis / digit_bits;
constexpr std::size_t few = 16;  // distinct points of one cell that are sorted by their coordinates

constexpr unsigned point_bits = 31;
static_assert(3 * bits_per_axis + point_bits == 64);

/// A point and its number along the curve, in one word.
class Keyed {
 public:
  Keyed() = default;
  Keyed(std::uint64_t key, std::uint32_t point) : bits_(key << point_bits | point) {}
  std::uint64_t key() const { return bits_ >> point_bits; }
  std::uint32_t point() const { return static_cast<std::uint32_t>(bits_ & ((std::uint64_t{1} << point_bits) - 1)); }
  friend bool operator<(Keyed a, Keyed b) { return a.bits_ < b.bits_; }

 private:
  std::uint64_t bits_ = 0;
};

/// From coordinates to the cells of a cube around points. Halves, so that no difference overflows.
class Cube {
 public:
  Cube(std::span<const Point3> points, std::span<const Keyed> list) {
    std::array<double, 3> high;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low_[axis] = std::numeric_limits<double>::infinity();
      high[axis] = -low_[axis];
    }
    for (const Keyed& k : list) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        low_[axis] = std::min(low_[axis], points[k.point()][axis]);
        high[axis] = std::max(high[axis], points[k.point()][axis]);
      }
    }
    double size = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) size = std::max(size, high[axis] / 2 - low_[axis] / 2);
    per_cell_ = static_cast<double>(1U << bits_per_axis) / std::max(size, 0x1p-1000);
  }

  std::uint64_t key(const Point3& p) const {
    constexpr double last = (1U << bits_per_axis) - 1;
    std::array<std::uint32_t, 3> cell{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      cell[axis] = static_cast<std::uint32_t>(std::clamp((p[axis] / 2 - low_[axis] / 2) * per_cell_, 0.0, last));
    }
    return hilbert_key(cell, bits_per_axis);
  }

 private:
  std::array<double, 3> low_{};
  double per_cell_ = 1;
};

class Sorter {
 public:
  Sorter(std::span<const Point3> points, const Context& context) : points_(points), context_(context) {}

  void sort(std::span<Keyed> list, std::uint64_t parent) {
    const auto point = [&](std::size_t i) -> const Point3& { return points_[list[i].point()]; };
    if (!detail::has_more_distinct_points<few, Point3>(list.size(), point, context_)) return sort_by_coordinates(list);
    const Cube cube(points_, list);
    for_each_chunk(context_, list.size(), 8192, [&](const Chunk& chunk) {
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
        list[i] = {cube.key(points_[list[i].point()]), list[i].point()};
      }
    });
    sort_by_key(list);
    for (std::size_t begin = 0; begin < list.size();) {
      const std::uint64_t key = list[begin].key();
      std::size_t end = begin + 1;
      while (end < list.size() && list[end].key() == key) ++end;
      const std::span<Keyed> run = list.subspan(begin, end - begin);
      // A cube that does not get smaller is of points that are equal, or too small to be divided.
      if (run.size() == list.size() && parent == list.size()) {
        sort_by_coordinates(run);
      } else if (run.size() > 1) {
        sort(run, list.size());
      }
      begin = end;
    }
  }

 private:
  void sort_by_coordinates(std::span<Keyed> list) const {
    context_.poll();
    std::sort(list.begin(), list.end(), [this](const Keyed& a, const Keyed& b) {
      const Point3& p = points_[a.point()];
      const Point3& q = points_[b.point()];
      return p == q ? a.point() < b.point() : lexicographically_less(p, q);
    });
  }

  void sort_by_key(std::span<Keyed> list) {
    if (list.size() < 2048) {
      std::sort(list.begin(), list.end());
      return;
    }
    LargeVector<Keyed> other(list.size());
    std::span<Keyed> from = list;
    std::span<Keyed> to(other);
    // Where those of a chunk with each digit begin: after all smaller digits, and those of the chunks before.
    const std::size_t grain = std::max(least_grain, list.size() / most_chunks + 1);
    std::vector<std::array<std::size_t, digits>> begin(chunk_count(list.size(), grain));
    for (unsigned pass = 0; pass < passes; ++pass) {
      const auto digit = [pass](const Keyed& k) {
        return static_cast<std::size_t>(k.key() >> (pass * digit_bits)) & (digits - 1);
      };
      for_each_chunk(context_, list.size(), grain, [&](const Chunk& chunk) {
        begin[chunk.index].fill(0);
        for (std::size_t i = chunk.begin; i < chunk.end; ++i) ++begin[chunk.index][digit(from[i])];
      });
      std::size_t sum = 0;
      for (std::size_t d = 0; d < digits; ++d) {
        for (auto& of_chunk : begin) sum += std::exchange(of_chunk[d], sum);
      }
      for_each_chunk(context_, list.size(), grain, [&](const Chunk& chunk) {
        for (std::size_t i = chunk.begin; i < chunk.end; ++i) to[begin[chunk.index][digit(from[i])]++] = from[i];
      });
      std::swap(from, to);
    }
    if (from.data() != list.data()) std::copy(from.begin(), from.end(), list.begin());
  }

  std::span<const Point3> points_;
  const Context& context_;
};

}  // namespace

std::vector<std::uint32_t> hilbert_order(std::span<const Point3> points, const Context& context) {
  std::vector<std::uint32_t> order(points.size());
  {
    LargeVector<Keyed> list(points.size());
    for (std::size_t i = 0; i < list.size(); ++i) list[i] = {0, static_cast<std::uint32_t>(i)};
    Sorter(points, context).sort(list, 0);
    for (std::size_t i = 0; i < list.size(); ++i) order[i] = list[i].point();
  }
#if defined(__GLIBC__)
  // Blocks of megabytes are kept where such were freed before: 16 bytes per point that what follows would not use.
  if (points.size() > (std::size_t{1} << 16)) malloc_trim(0);
#endif
  return order;
}

}  // namespace quoin
