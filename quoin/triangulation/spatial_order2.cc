// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/spatial_order2.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>

#include "quoin/base/error.h"
#include "quoin/base/parallel.h"
#include "quoin/base/parallel_sort.h"
#include "quoin/triangulation/curve_keys2.h"
#include "quoin/triangulation/distinct_points.h"

namespace quoin {

namespace {

// (key, index)
using Record = std::uint64_t;
using Records = UnsetVector<Record>;

// Long lists are passed in chunks, by all threads; no result depends on how many these are.
constexpr std::size_t grain = 1 << 16;
// Cells of so many points are not divided.
constexpr std::size_t few = 48;

struct Box {
  Point2 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Point2 high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  void add(const Point2& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
};

Box union_of(const std::vector<Box>& boxes) {
  Box all;
  for (const Box& box : boxes) {
    all.add(box.low);
    all.add(box.high);
  }
  return all;
}

bool same_key(Record a, Record b) {
  return a >> 32 == b >> 32;
}

// Where chunks of a sorted list begin, and its end, so that no run of equal keys is in two.
std::vector<std::size_t> chunks_of_runs(std::span<const Record> list) {
  std::vector<std::size_t> bounds{0};
  for (std::size_t at = grain; at < list.size(); at += grain) {
    if (at < bounds.back()) continue;
    const Record before = list[at - 1];
    const auto end = std::partition_point(list.begin() + static_cast<std::ptrdiff_t>(at), list.end(),
                                          [&](Record r) { return same_key(r, before); });
    bounds.push_back(static_cast<std::size_t>(end - list.begin()));
  }
  if (bounds.back() < list.size()) bounds.push_back(list.size());
  return bounds;
}

// Sorts by cells, and divides those of many points. Those of few stay together, with one key, ascending by input.
class Sorter {
 public:
  Sorter(std::span<const Point2> points, const Context& context) : points_(points), context_(context) {}

  Records run() const {
    const Box box = finite_box();
    Records records(points_.size());
    if (records.empty()) return records;
    set_keys(records, box, [](std::size_t i) { return static_cast<std::uint32_t>(i); });
    {
      Records other(points_.size());
      sort_by_keys(records, other);
      std::swap(records, other);
    }
    split_cells(records);
    return records;
  }

 private:
  static constexpr std::size_t digits = 1 << 11;
  static constexpr std::size_t most_chunks = 64;  // of a sort, as each counts all digits

  static std::uint32_t index_of(Record record) { return static_cast<std::uint32_t>(record); }
  const Point2& point(Record record) const { return points_[index_of(record)]; }

  Box finite_box() const {
    std::vector<Box> boxes(chunk_count(points_.size(), grain));
    std::vector<std::size_t> bad(boxes.size(), points_.size());
    for_each_chunk(context_, points_.size(), grain, [&](const Chunk& chunk) {
      Box box;
      for (std::size_t i = chunk.end; i-- > chunk.begin;) {
        box.add(points_[i]);
        if (!std::isfinite(points_[i].x) || !std::isfinite(points_[i].y)) bad[chunk.index] = i;
      }
      boxes[chunk.index] = box;
    });
    for (const std::size_t i : bad) {
      if (i < points_.size()) throw InputError("point " + std::to_string(i) + " is not finite");
    }
    return union_of(boxes);
  }

  Box box_of(std::span<const Record> records) const {
    std::vector<Box> boxes(chunk_count(records.size(), grain));
    for_each_chunk(context_, records.size(), grain, [&](const Chunk& chunk) {
      Box box;
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) box.add(point(records[i]));
      boxes[chunk.index] = box;
    });
    return union_of(boxes);
  }

  template <class Index>
  void set_keys(std::span<Record> records, const Box& box, const Index& index) const {
    const detail::CurveKeys2 key(box.low, box.high);
    for_each_chunk(context_, records.size(), grain, [&](const Chunk& chunk) {
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
        const std::uint32_t input = index(i);
        records[i] = Record{key(points_[input])} << 32 | input;
      }
    });
  }

  // Radix sort; records of equal keys keep their order. Three passes, so the result ends in `to`.
  void sort_by_keys(std::span<Record> from, std::span<Record> to) const {
    // Where those of a chunk with each digit begin: after all smaller digits, and those of the chunks before.
    const std::size_t step = std::max(grain, from.size() / most_chunks + 1);
    std::vector<std::array<std::uint32_t, digits>> begin(chunk_count(from.size(), step));
    for (unsigned shift = 32; shift < 64; shift += 11) {
      const auto digit = [shift](Record r) { return (r >> shift) % digits; };
      for_each_chunk(context_, from.size(), step, [&](const Chunk& chunk) {
        auto& counts = begin[chunk.index];
        counts.fill(0);
        for (std::size_t i = chunk.begin; i < chunk.end; ++i) ++counts[digit(from[i])];
      });
      std::uint32_t sum = 0;
      for (std::size_t d = 0; d < digits; ++d) {
        for (auto& of_chunk : begin) sum += std::exchange(of_chunk[d], sum);
      }
      for_each_chunk(context_, from.size(), step, [&](const Chunk& chunk) {
        auto& next = begin[chunk.index];
        for (std::size_t i = chunk.begin; i < chunk.end; ++i) to[next[digit(from[i])]++] = from[i];
      });
      std::swap(from, to);
    }
  }

  // Runs longer than a chunk are divided one after the other, each on all threads.
  void split_cells(std::span<Record> list) const {
    const std::vector<std::size_t> bounds = chunks_of_runs(list);
    std::vector<std::vector<std::span<Record>>> long_runs(bounds.size() - 1);
    for_each_chunk(context_, long_runs.size(), 1, [&](const Chunk& chunk) {
      const std::span<Record> part = list.subspan(bounds[chunk.begin], bounds[chunk.end] - bounds[chunk.begin]);
      for_each_run(part, [&](std::span<Record> run) {
        if (run.size() > grain) {
          long_runs[chunk.index].push_back(run);
        } else if (run.size() > few) {
          split_cell(run);
        }
      });
    });
    for (const auto& of_chunk : long_runs) {
      for (const std::span<Record> run : of_chunk) split_cell(run);
    }
  }

  template <class Visit>
  void for_each_run(std::span<Record> list, const Visit& visit) const {
    std::size_t polled = 0;
    for (std::size_t begin = 0; begin < list.size();) {
      std::size_t end = begin + 1;
      while (end < list.size() && same_key(list[end], list[begin])) ++end;
      visit(list.subspan(begin, end - begin));
      begin = end;
      if (begin < polled + 1024) continue;
      context_.poll();
      polled = begin;
    }
  }

  // From the largest to the smallest boxes. The key is as before in the end.
  void split_cell(std::span<Record> cell) const {
    const Record key = cell[0] >> 32 << 32;
    std::vector<std::span<Record>> pending{cell};
    while (!pending.empty()) {
      const std::span<Record> list = pending.back();
      pending.pop_back();
      if (!sort_cell(list)) continue;
      for_each_run(list, [&](std::span<Record> run) {
        if (run.size() > 1) pending.push_back(run);
      });
    }
    for (Record& r : cell) r = key | index_of(r);
  }

  // True if the run is now sorted by keys of its own, which do not all agree.
  bool sort_cell(std::span<Record> run) const {
    const auto point_at = [&](std::size_t i) -> const Point2& { return point(run[i]); };
    if (detail::has_more_distinct_points<few, Point2>(run.size(), point_at, context_)) {
      set_keys(run, box_of(run), [&](std::size_t i) { return index_of(run[i]); });
      if (std::any_of(run.begin(), run.end(), [&](Record r) { return !same_key(r, run[0]); })) {
        sort_run(run, std::less<>());
        return true;
      }
    }
    sort_run(run, [&](Record a, Record b) {
      const Point2& p = point(a);
      const Point2& q = point(b);
      if (p.x != q.x) return p.x < q.x;
      if (p.y != q.y) return p.y < q.y;
      return index_of(a) < index_of(b);
    });
    return false;
  }

  // Short runs are sorted by the thread that has them.
  template <class Less>
  void sort_run(std::span<Record> run, const Less& less) const {
    if (run.size() > grain) {
      sort_parallel(context_, run, less);
    } else {
      std::sort(run.begin(), run.end(), less);
    }
  }

  std::span<const Point2> points_;
  const Context& context_;
};

// Puts points into the order of their records, those of cells with few points lexicographically.
class Gatherer {
 public:
  Gatherer(std::span<const Point2> points, std::span<const Record> records, SpatialOrder2& order,
           const Context& context)
      : points_(points), records_(records), order_(order), context_(context) {}

  // Returns whether some are equal.
  bool gather(std::size_t begin, std::size_t end) const {
    bool has_equal = false;
    for (std::size_t first = begin; first < end;) {
      std::size_t i = first;
      do {
        put(i);
        ++i;
      } while (i < end && same_key(records_[i], records_[first]));
      if (i - first <= few) sort_lexicographically(first, i);
      for (std::size_t k = first + 1; k < i; ++k) has_equal |= order_.points[k] == order_.points[k - 1];
      first = i;
    }
    return has_equal;
  }

 private:
  void put(std::size_t i) const {
    constexpr std::size_t ahead = 16;
    if (i % grain == 0) context_.poll();
    if (i + ahead < records_.size()) __builtin_prefetch(&points_[static_cast<std::uint32_t>(records_[i + ahead])]);
    const auto input = static_cast<std::uint32_t>(records_[i]);
    order_.points[i] = {points_[input].x + 0.0, points_[input].y + 0.0};
    order_.inputs[i] = input;
  }

  // By insertion: equal ones stay ascending by input.
  void sort_lexicographically(std::size_t begin, std::size_t end) const {
    for (std::size_t i = begin + 1; i < end; ++i) {
      const Point2 p = order_.points[i];
      const std::uint32_t input = order_.inputs[i];
      std::size_t to = i;
      for (; to > begin && lexicographically_less(p, order_.points[to - 1]); --to) {
        order_.points[to] = order_.points[to - 1];
        order_.inputs[to] = order_.inputs[to - 1];
      }
      order_.points[to] = p;
      order_.inputs[to] = input;
    }
  }

  std::span<const Point2> points_;
  std::span<const Record> records_;
  SpatialOrder2& order_;
  const Context& context_;
};

// Equal points are neighbours; the first of each group stays.
void merge_equal(SpatialOrder2& order, const Context& context) {
  order.input_begin.reserve(order.points.size() + 1);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < order.points.size(); ++i) {
    if (i % grain == 0) context.poll();
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
  const Records records = Sorter(points, context).run();
  order.points.resize(points.size());
  order.inputs.resize(points.size());
  const std::vector<std::size_t> bounds = chunks_of_runs(records);
  std::atomic<bool> has_equal{false};
  for_each_chunk(context, bounds.size() - 1, 1, [&](const Chunk& chunk) {
    if (Gatherer(points, records, order, context).gather(bounds[chunk.begin], bounds[chunk.end])) has_equal = true;
  });
  if (has_equal) merge_equal(order, context);
  return order;
}

}  // namespace quoin
