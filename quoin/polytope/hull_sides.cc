// SPDX-License-Identifier: Apache-2.0
//
// Many points at once. Planes across the longest axis part all points, corners and new ones, into sides, and each
// thread inserts the points of one side. A triangle whose corners are of several sides is a border; what would replace
// one waits until the threads are done.
//
// Threads share nothing that changes. What a point of a side replaces has all corners on that side, as have the new
// triangles. A neighbour of such a triangle has two corners on that side: it is of that side, or a border of which
// only the link at this edge changes. No other side comes near that link, as a triangle that has edges on two sides
// would have corners on both at the point the edges share.
//
// The result is a hull, as if the sides had come one after the other. What a point sees is connected, begins with a
// triangle of its side and has no border in it; triangles that another side has made meanwhile could be reached
// through borders alone.
#include <algorithm>
#include <array>
#include <limits>

#include "quoin/base/parallel.h"
#include "quoin/polytope/hull_builder.h"

namespace quoin {

namespace {

constexpr std::size_t most_sides = 16;
constexpr std::uint32_t least_per_side = 4096;  // points
constexpr std::uint32_t least_before = 1024;    // points that came before, so that few triangles are borders
constexpr std::uint32_t sample_size = 1024;

}  // namespace

struct HullBuilder::Sides {
  struct Side {
    Hand hand;
    std::vector<std::uint32_t> late;   // points that would change a border, or found no place
    std::uint32_t begins_near = none;  // its first point
  };
  std::size_t axis = 0;
  std::vector<double> cuts;
  std::vector<Side> list;

  /// Where as many of the points are on each side, roughly.
  Sides(std::span<const Point3> points, std::size_t count) : list(count) {
    std::array<std::vector<double>, 3> sample;
    const std::size_t step = points.size() / sample_size + 1;
    double longest = -1;
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i < points.size(); i += step) sample[k].push_back(points[i][k]);
      std::sort(sample[k].begin(), sample[k].end());
      const double length = sample[k].back() / 2 - sample[k].front() / 2;
      if (length > longest) axis = k;
      longest = std::max(longest, length);
    }
    for (std::size_t i = 1; i < count; ++i) cuts.push_back(sample[axis][sample[axis].size() * i / count]);
  }

  std::size_t of(const Point3& p) const {
    const double height = p[axis];
    std::size_t side = 0;
    for (const double cut : cuts) side += static_cast<std::size_t>(cut <= height);
    return side;
  }
};

void HullBuilder::insert_many(std::uint32_t first, std::uint32_t end, const Context& context) {
  const std::uint32_t count = end - first;
  const std::size_t side_count = std::min<std::size_t>({context.threads(), most_sides, count / least_per_side});
  const bool has_epochs = single_.epoch < none / 2 && count < none / 8;
  if (side_count < 2 || first < least_before || !has_epochs || table_ != nullptr) {
    insert_one_by_one(first, end, context);
    return;
  }
  Sides sides(points_.subspan(first, count), side_count);
  mark_borders(sides, first, end, context);
  hand_out_triangles(sides, count);
  for_each_chunk(context, side_count, 1,
                 [&](const Chunk& chunk) { insert_side(sides, chunk.index, first, end, context); });
  take_back(sides);
  tally_.most_sides = std::max(tally_.most_sides, side_count);
  tally_.on_sides += count;
  for (const Sides::Side& side : sides.list) {
    tally_.late += side.late.size();
    for (std::size_t i = 0; i < side.late.size(); ++i) {
      if (i % 256 == 0) context.poll();
      insert_late(side.late[i]);
    }
  }
  rate_ = static_cast<double>(single_.inserted) / count;
  single_.inserted = 0;
}

void HullBuilder::insert_one_by_one(std::uint32_t first, std::uint32_t end, const Context& context) {
  for (std::uint32_t i = first; i < end; ++i) {
    if (i % 256 == 0) context.poll();
    insert(single_, i);
  }
  if (end > first) rate_ = static_cast<double>(single_.inserted) / (end - first);
  single_.inserted = 0;
}

/// And finds a triangle of each side from which its first point is near.
void HullBuilder::mark_borders(Sides& sides, std::uint32_t first, std::uint32_t end, const Context& context) {
  std::size_t found = 0;
  for (std::uint32_t i = first; i < end && found < sides.list.size(); ++i) {
    std::uint32_t& start = sides.list[sides.of(points_[i])].begins_near;
    if (start != none) continue;
    start = i;
    ++found;
  }
  struct Nearest {
    double distance = std::numeric_limits<double>::infinity();
    std::uint32_t triangle = none;
  };
  constexpr std::size_t grain = 16384;
  std::vector<std::array<Nearest, most_sides>> nearest(chunk_count(triangles_.size(), grain));
  for_each_chunk(context, triangles_.size(), grain, [&](const Chunk& chunk) {
    for (std::size_t t = chunk.begin; t < chunk.end; ++t) {
      Triangle& triangle = triangles_[t];
      if (triangle.is_free()) continue;
      const Point3& p = points_[triangle.corners[0]];
      const std::size_t side = sides.of(p);
      if (side != sides.of(points_[triangle.corners[1]]) || side != sides.of(points_[triangle.corners[2]])) {
        triangle.mark = border_mark;
        continue;
      }
      if (triangle.mark == border_mark) triangle.mark = 0;
      Nearest& best = nearest[chunk.index][side];
      const std::uint32_t start = sides.list[side].begins_near;
      if (start == none) continue;
      const Point3& q = points_[start];
      double distance = 0;
      for (std::size_t k = 0; k < 3; ++k) distance += (p[k] / 2 - q[k] / 2) * (p[k] / 2 - q[k] / 2);
      if (best.triangle == none || distance < best.distance) best = {distance, static_cast<std::uint32_t>(t)};
    }
  });
  for (std::size_t s = 0; s < sides.list.size(); ++s) {
    Nearest best;
    for (const auto& of_chunk : nearest) {
      if (best.triangle == none || of_chunk[s].distance < best.distance) best = of_chunk[s];
    }
    sides.list[s].hand.hint = best.triangle;
  }
}

/// An insertion makes two triangles more than it takes away, or fewer. `rate_` mostly falls.
void HullBuilder::hand_out_triangles(Sides& sides, std::uint32_t count) {
  const double expected = 2 * std::min(1.0, 1.25 * rate_ + 0.01) * count / static_cast<double>(sides.list.size());
  const auto room = static_cast<std::uint32_t>(expected * 1.01) + 256;
  for (Sides::Side& side : sides.list) {
    Hand& hand = side.hand;
    hand.may_grow = false;
    hand.border = border_mark;
    hand.epoch = single_.epoch;
    hand.fresh = static_cast<std::uint32_t>(triangles_.size());
    hand.fresh_end = hand.fresh + room;
    triangles_.resize(hand.fresh_end);
    planes_.resize(hand.fresh_end);
  }
}

void HullBuilder::insert_side(Sides& sides, std::size_t side, std::uint32_t first, std::uint32_t end,
                              const Context& context) {
  Hand& hand = sides.list[side].hand;
  std::vector<std::uint32_t>& late = sides.list[side].late;
  std::size_t tried = 0;
  for (std::uint32_t i = first; i < end; ++i) {
    if (i % 256 == 0) context.poll();
    if (sides.of(points_[i]) != side) continue;
    // Where most points wait, trying costs more than it saves.
    const bool gives_up = hand.hint == none || (tried >= 1024 && late.size() > tried / 2);
    if (gives_up || insert(hand, i) == Place::border) late.push_back(i);
    ++tried;
  }
}

/// What is free, for the points that wait.
void HullBuilder::take_back(Sides& sides) {
  for (const Sides::Side& side : sides.list) {
    const Hand& hand = side.hand;
    single_.free.insert(single_.free.end(), hand.free.begin(), hand.free.end());
    for (std::uint32_t t = hand.fresh; t < hand.fresh_end; ++t) {
      triangles_[t].corners = {none, none, none};
      single_.free.push_back(t);
    }
    single_.epoch = std::max(single_.epoch, hand.epoch);
    single_.inserted += hand.inserted;
    if (hand.hint != none) single_.hint = hand.hint;
  }
}

/// A point that equals it may have come before it, as a corner of the triangle in whose cone it is.
void HullBuilder::insert_late(std::uint32_t point) {
  const Found found = locate(single_, point);
  if (found.place == Place::outside) {
    replace_visible(single_, mark_visible(single_, found.triangle, point), point);
    ++single_.inserted;
    return;
  }
  std::uint32_t t = found.triangle;
  for (unsigned k = 0; k < 3; ++k) {
    const std::uint32_t corner = triangles_[t].corners[k];
    if (corner < point || points_[corner] != points_[point]) continue;
    ++tally_.renamed;
    while (triangles_[t].corners[k] == corner) {
      triangles_[t].corners[k] = point;
      const std::uint32_t across = triangles_[t].across[k];
      k = next(index_of(triangles_[across], t));
      t = across;
    }
    return;
  }
}

}  // namespace quoin
