// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/hull_order.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "quoin/kernel/hilbert_key.h"

namespace quoin {

namespace {

constexpr unsigned bits_per_axis = 10;
constexpr unsigned most_rounds = 8;
constexpr unsigned digit_bits = 11;
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
  Cells(std::span<const Point3> points, std::span<const std::uint32_t> chosen) {
    std::array<double, 3> high;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low_[axis] = std::numeric_limits<double>::infinity();
      high[axis] = -low_[axis];
    }
    for (const std::uint32_t i : chosen) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        low_[axis] = std::min(low_[axis], points[i][axis]);
        high[axis] = std::max(high[axis], points[i][axis]);
      }
    }
    double size = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) size = std::max(size, high[axis] / 2 - low_[axis] / 2);
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
  std::array<double, 3> low_{};
  double per_cell_ = 1;
};

}  // namespace

std::vector<std::uint32_t> biased_random_order(std::span<const Point3> points, std::span<const std::uint32_t> chosen,
                                               const Context& context) {
  const Cells cells(points, chosen);
  std::vector<Keyed> list(chosen.size());
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    if (i % 4096 == 0) context.poll();
    const Point3& p = points[chosen[i]];
    list[i] = {round_of(p) << (3 * bits_per_axis) | hilbert_key(cells.of(p), bits_per_axis), chosen[i]};
  }
  std::vector<Keyed> other(list.size());
  for (unsigned pass = 0; pass < 3; ++pass) {
    context.poll();
    const auto digit = [pass](const Keyed& k) {
      return static_cast<std::size_t>(k.key >> (pass * digit_bits)) & ((1U << digit_bits) - 1);
    };
    std::vector<std::size_t> begin((std::size_t{1} << digit_bits) + 1, 0);
    for (const Keyed& k : list) ++begin[digit(k) + 1];
    for (std::size_t d = 1; d < begin.size(); ++d) begin[d] += begin[d - 1];
    for (const Keyed& k : list) other[begin[digit(k)]++] = k;
    list.swap(other);
  }
  std::vector<std::uint32_t> order(list.size());
  for (std::size_t i = 0; i < list.size(); ++i) order[i] = list[i].point;
  return order;
}

}  // namespace quoin
