// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/changing_points3.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "quoin/base/error.h"

namespace quoin {

namespace {

constexpr std::size_t most_ids = std::size_t{1} << 30;
constexpr std::size_t few = 64;  // points that may go before bounds are found anew, and come before there is a grid

// For one more, in steps that grow.
template <class List>
void make_room(List& list, std::size_t size) {
  if (size > list.capacity()) list.reserve(std::max(size, 2 * list.capacity()));
}

double magnitude(const Point3& p) {
  return std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
}

}  // namespace

ChangingPoints3::ChangingPoints3(VertexPoints points, Scaling scaling)
    : scaling_(scaling),
      points_(std::move(points.points)),
      count_(points_.size()),
      scale_(1 / points.unscale),
      unscale_(points.unscale),
      tried_scale_(scale_) {
  multiplicity_.reserve(points_.size());
  for (std::uint32_t v = 0; v < points_.size(); ++v) {
    multiplicity_.push_back(static_cast<std::uint32_t>(points.inputs_of(v).size()));
    extent_.add(points_[v]);
    largest_ = std::max(largest_, magnitude(original(v)));
  }
  tried_scale_ = filter_scale(largest_);
  grid_.build(points_, ids());
}

std::uint32_t ChangingPoints3::add(const Point3& p) {
  if (count_ >= few && count_ >= 2 * grid_.size()) grid_.build(points_, ids());
  const std::uint32_t id = new_id(p);
  grid_.put(points_[id], id);
  multiplicity_[id] = 1;
  ++count_;
  return id;
}

std::uint32_t ChangingPoints3::new_id(const Point3& p) {
  if (free_.empty()) {
    const std::size_t size = points_.size() + 1;
    if (size > most_ids) throw InputError("a triangulation of space takes at most 2^30 points");
    make_room(points_, size);
    make_room(multiplicity_, size);
    make_room(free_, size);
    free_.push_back(static_cast<std::uint32_t>(points_.size()));
    points_.push_back({0, 0, 0});
    multiplicity_.push_back(0);
  }
  hold(p);
  const std::uint32_t id = free_.back();
  free_.pop_back();
  points_[id] = scaled(p);
  return id;
}

void ChangingPoints3::reserve_for_removals() {
  make_room(free_, points_.size());
}

void ChangingPoints3::remove(std::uint32_t id) {
  multiplicity_[id] = 0;
  free_.push_back(id);
  --count_;
  if (++gone_ > count_ + few) find_bounds();
}

void ChangingPoints3::add_apex(const Point3& p) {
  apex_ = new_id(p);
}

void ChangingPoints3::remove_apex() {
  free_.push_back(apex_);
  apex_ = no_vertex;
}

void ChangingPoints3::turn_into_apex(std::uint32_t id, const Point3& p) {
  multiplicity_[id] = 0;
  --count_;
  apex_ = id;
  points_[id] = {0, 0, 0};
  hold(p);
  points_[id] = scaled(p);
}

std::uint32_t ChangingPoints3::turn_apex_into(const Point3& p) {
  const std::uint32_t id = std::exchange(apex_, no_vertex);
  hold(p);
  points_[id] = scaled(p);
  grid_.put(points_[id], id);
  multiplicity_[id] = 1;
  ++count_;
  return id;
}

std::vector<std::uint32_t> ChangingPoints3::ids() const {
  std::vector<std::uint32_t> ids;
  ids.reserve(count_);
  for (std::uint32_t id = 0; id < points_.size(); ++id) {
    if (multiplicity_[id] > 0) ids.push_back(id);
  }
  return ids;
}

std::vector<Point3> ChangingPoints3::originals(std::span<const std::uint32_t> ids) const {
  std::vector<Point3> list(ids.size());
  std::ranges::transform(ids, list.begin(), [this](std::uint32_t id) { return original(id); });
  return list;
}

/// Rounded distances do.
std::uint32_t ChangingPoints3::one_near(const Point3& p) const {
  const Point3 q = scaled(p);
  const auto is_there = [this](std::uint32_t id) { return multiplicity_[id] > 0; };
  const std::uint32_t known = grid_.find(q, {points_.data(), points_.size()}, is_there);
  if (known != IdGrid::none) return known;
  const auto samples = 1 + static_cast<std::size_t>(std::cbrt(static_cast<double>(points_.size())));
  std::uint32_t best = vertex_at_infinity;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < samples; ++i) {
    const auto id = static_cast<std::uint32_t>(points_.size() * i / samples);
    if (multiplicity(id) == 0) continue;
    const Point3& at = points_[id];
    const double x = at.x - q.x;
    const double y = at.y - q.y;
    const double z = at.z - q.z;
    const double square = x * x + y * y + z * z;
    if (!(square < least)) continue;
    least = square;
    best = id;
  }
  return best;
}

/// What the bounds tell is then true of this point, too.
void ChangingPoints3::hold(const Point3& p) {
  largest_ = std::max(largest_, magnitude(p));
  if (!is_scale_right(p)) choose_scale(p);
  extent_.add(scaled(p));
}

/// A scale that was refused is tried again after a step of 2^64 only: at most 32 times while bounds do nothing but
/// grow.
bool ChangingPoints3::is_scale_right(const Point3& p) const {
  if (scaling_ == Scaling::none) return true;
  if (!scales_exactly(p, scale_)) return false;
  if (filter_scale(largest_ * scale_) == 1) return true;
  const double step = filter_scale(largest_) / tried_scale_;
  return step > 0x1p-64 && step < 0x1p64;
}

void ChangingPoints3::choose_scale(const Point3& p) {
  tried_scale_ = filter_scale(largest_);
  double scale = scaling_ == Scaling::allowed && scales_exactly(p, tried_scale_) ? tried_scale_ : 1;
  for (std::uint32_t id = 0; id < points_.size() && scale != 1; ++id) {
    if (is_used(id) && !scales_exactly(original(id), scale)) scale = 1;
  }
  extent_ = {};
  for (std::uint32_t id = 0; id < points_.size(); ++id) {
    if (!is_used(id)) continue;
    const Point3 q = original(id);
    points_[id] = {q.x * scale, q.y * scale, q.z * scale};
    extent_.add(points_[id]);
  }
  if (scale != scale_) grid_.clear();
  scale_ = scale;
  unscale_ = 1 / scale;
}

void ChangingPoints3::find_bounds() {
  gone_ = 0;
  largest_ = 0;
  Point3 last{0, 0, 0};
  for (std::uint32_t id = 0; id < points_.size(); ++id) {
    if (!is_used(id)) continue;
    last = original(id);
    largest_ = std::max(largest_, magnitude(last));
  }
  choose_scale(last);
}

}  // namespace quoin
