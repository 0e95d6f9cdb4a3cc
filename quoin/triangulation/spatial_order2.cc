// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/spatial_order2.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "quoin/base/error.h"
#include "quoin/triangulation/distinct_points.h"

namespace quoin {

namespace {

constexpr std::size_t poll_step = 1 << 16;

// Hilbert's curve four levels at a time. A state is two bits: whether x and y are swapped (1) and both reversed (2);
// at each level the quadrant (x bit, y bit) has a position along the curve and changes the state below it.
struct CurveTable {
  std::array<std::array<std::uint8_t, 256>, 4> key{};
  std::array<std::array<std::uint8_t, 256>, 4> state{};
};

constexpr CurveTable make_table() {
  constexpr std::array<std::array<unsigned, 4>, 4> position{{{0, 1, 3, 2}, {0, 3, 1, 2}, {2, 3, 1, 0}, {2, 1, 3, 0}}};
  constexpr std::array<unsigned, 4> change{1, 0, 0, 3};
  CurveTable table;
  for (unsigned start = 0; start < 4; ++start) {
    for (unsigned xy = 0; xy < 256; ++xy) {
      unsigned state = start;
      unsigned key = 0;
      for (unsigned level = 4; level-- > 0;) {
        const unsigned quadrant = ((xy >> (4 + level)) & 1) * 2 + ((xy >> level) & 1);
        const unsigned place = position[state][quadrant];
        key = key * 4 + place;
        state ^= change[place];
      }
      table.key[start][xy] = static_cast<std::uint8_t>(key);
      table.state[start][xy] = static_cast<std::uint8_t>(state);
    }
  }
  return table;
}

constexpr CurveTable curve = make_table();

std::uint32_t curve_key(unsigned x, unsigned y) {
  unsigned state = 0;
  std::uint32_t key = 0;
  for (unsigned shift = 16; shift > 0;) {
    shift -= 4;
    const unsigned xy = ((x >> shift) & 15) * 16 + ((y >> shift) & 15);
    key = key << 8 | curve.key[state][xy];
    state = curve.state[state][xy];
  }
  return key;
}

// Coordinates are halved first, so that no difference of finite ones overflows.
class Axis {
 public:
  Axis(double low, double high) : low_(low / 2), high_(high / 2) {
    const double extent = high_ - low_;
    factor_ = extent > 0 ? 65536 / extent : 0;
    if (std::isfinite(factor_)) return;
    // Cells of an extent below 2^-1008 are no doubles: both are scaled.
    scale_ = 0x1p60;
    factor_ = 65536 / (extent * scale_);
  }
  unsigned cell(double x) const {
    const double place = (x / 2 - low_) * scale_ * factor_;
    // Zero times infinity, of the smallest extents, is no number: the first cell too.
    return place > 0 ? static_cast<unsigned>(std::min(place, 65535.0)) : 0;
  }

 private:
  double low_;
  double high_;
  double scale_ = 1;
  double factor_;
};

// (key, index)
using Record = std::uint64_t;

class Sorter {
 public:
  Sorter(std::span<const Point2> points, const Context& context) : points_(points), context_(context) {}

  LargeVector<Record> run() {
    require_finite();
    LargeVector<Record> records(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) records[i] = i;
    {
      LargeVector<Record> other(points_.size());
      sort_by_curve(records, other);
    }
    split_cells(records);
    return records;
  }

 private:
  static constexpr std::size_t few = 48;

  const Point2& point(Record record) const { return points_[static_cast<std::uint32_t>(record)]; }

  void require_finite() const {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (i % poll_step == 0) context_.poll();
      if (!std::isfinite(points_[i].x) || !std::isfinite(points_[i].y)) {
        throw InputError("point " + std::to_string(i) + " is not finite");
      }
    }
  }

  void set_keys(std::span<Record> records) const {
    Point2 low = point(records[0]);
    Point2 high = low;
    for (const Record record : records) {
      const Point2& p = point(record);
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const Axis x(low.x, high.x);
    const Axis y(low.y, high.y);
    for (Record& record : records) {
      const Point2& p = point(record);
      record = Record{curve_key(x.cell(p.x), y.cell(p.y))} << 32 | static_cast<std::uint32_t>(record);
    }
  }

  // Radix sort of the keys; records of equal keys keep their order. Three passes, so the result ends in `other`.
  void sort_by_curve(LargeVector<Record>& records, LargeVector<Record>& other) const {
    if (records.empty()) return;
    set_keys(records);
    for (unsigned shift = 32; shift < 64; shift += 11) {
      context_.poll();
      constexpr std::size_t buckets = 1 << 11;
      std::array<std::size_t, buckets> begin{};
      for (const Record r : records) ++begin[(r >> shift) % buckets];
      std::size_t sum = 0;
      for (std::size_t& b : begin) sum += std::exchange(b, sum);
      for (const Record r : records) other[begin[(r >> shift) % buckets]++] = r;
      std::swap(records, other);
    }
  }

  // Runs of equal keys, from the largest to the smallest boxes.
  void split_cells(std::span<Record> all) const {
    std::vector<std::span<Record>> pending{all};
    while (!pending.empty()) {
      const std::span<Record> list = pending.back();
      pending.pop_back();
      for (std::size_t begin = 0; begin < list.size();) {
        if (begin % 1024 == 0) context_.poll();
        std::size_t end = begin + 1;
        while (end < list.size() && list[end] >> 32 == list[begin] >> 32) ++end;
        const std::span<Record> run = list.subspan(begin, end - begin);
        begin = end;
        if (run.size() > 1 && sort_cell(run)) pending.push_back(run);
      }
    }
  }

  // True if the run is now sorted by keys of its own, which do not all agree.
  bool sort_cell(std::span<Record> run) const {
    const auto point_at = [&](std::size_t i) -> const Point2& { return point(run[i]); };
    if (detail::has_more_distinct_points<few, Point2>(run.size(), point_at, context_)) {
      set_keys(run);
      const std::uint64_t key = run[0] >> 32;
      if (std::any_of(run.begin(), run.end(), [&](Record r) { return r >> 32 != key; })) {
        std::sort(run.begin(), run.end());
        return true;
      }
    }
    std::sort(run.begin(), run.end(), [&](Record a, Record b) {
      const Point2& p = point(a);
      const Point2& q = point(b);
      if (p.x != q.x) return p.x < q.x;
      if (p.y != q.y) return p.y < q.y;
      return static_cast<std::uint32_t>(a) < static_cast<std::uint32_t>(b);
    });
    return false;
  }

  std::span<const Point2> points_;
  const Context& context_;
};

// Equal points are neighbours; the first of each group stays.
void merge_equal(SpatialOrder2& order) {
  const auto is_repeated = [&](std::size_t i) { return i > 0 && order.points[i] == order.points[i - 1]; };
  std::size_t first = 0;
  while (first < order.points.size() && !is_repeated(first)) ++first;
  if (first == order.points.size()) return;
  order.input_begin.reserve(order.points.size() + 1);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < order.points.size(); ++i) {
    if (kept > 0 && order.points[i] == order.points[kept - 1]) continue;
    order.points[kept++] = order.points[i];
    order.input_begin.push_back(static_cast<std::uint32_t>(i));
  }
  order.input_begin.push_back(static_cast<std::uint32_t>(order.points.size()));
  order.points.resize(kept);
}

}  // namespace

SpatialOrder2 spatial_order(std::span<const Point2> points, const Context& context) {
  // What stays is asked for before what goes, so that the allocator can give the latter back.
  SpatialOrder2 order;
  order.points.reserve(points.size() + 1);
  order.inputs.reserve(points.size());
  const LargeVector<Record> records = Sorter(points, context).run();
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (i % poll_step == 0) context.poll();
    const auto input = static_cast<std::uint32_t>(records[i]);
    order.points.push_back({points[input].x + 0.0, points[input].y + 0.0});
    order.inputs.push_back(input);
  }
  merge_equal(order);
  return order;
}

}  // namespace quoin
