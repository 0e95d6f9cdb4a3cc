// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/changing_weighted_points3.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace quoin {

namespace {

constexpr std::size_t few = 64;  // points that may go before bounds are found anew

/// All bits of the word bear upon all of the result. Source: Steele, Lea and Flood 2014 (SplitMix).
std::uint64_t mixed(std::uint64_t word) {
  word = (word ^ word >> 30) * 0xBF58476D1CE4E5B9U;
  word = (word ^ word >> 27) * 0x94D049BB133111EBU;
  return word ^ word >> 31;
}

std::uint64_t hash(const WeightedPoint3& site) {
  std::uint64_t h = 0;
  for (const double x : {site.point.x, site.point.y, site.point.z, site.weight}) {
    h = mixed(h + 0x9E3779B97F4A7C15U + std::bit_cast<std::uint64_t>(x));
  }
  return h;
}

}  // namespace

ChangingWeightedPoints3::ChangingWeightedPoints3(VertexPoints points, std::span<const double> weights)
    : ChangingPoints3(Scaling::none) {
  const auto count = static_cast<std::uint32_t>(points.points.size());
  std::vector<std::uint32_t> lighter(count);
  weights_.reserve(count);
  for (std::uint32_t v = 0; v < count; ++v) {
    const std::span<const std::uint32_t> inputs = points.inputs_of(v);
    double heaviest = weights[inputs[0]];
    for (const std::uint32_t i : inputs) heaviest = std::max(heaviest, weights[i]);
    set_weight(v, heaviest + 0.0);
    for (const std::uint32_t i : inputs) lighter[v] += weights[i] < heaviest ? 1 : 0;
  }
  ChangingPoints3::operator=(ChangingPoints3(std::move(points), Scaling::none));
  for (std::uint32_t v = 0; v < count; ++v) {
    while (lighter[v]-- > 0) remove_one_of_many(v);
    make_room();
    list(v);
  }
}

std::uint32_t ChangingWeightedPoints3::find(const WeightedPoint3& site) const {
  return table_.find(hash(site), [&](std::uint32_t id) { return this->site(id) == site; });
}

std::uint32_t ChangingWeightedPoints3::add(const WeightedPoint3& site) {
  make_room();
  const std::uint32_t id = ChangingPoints3::add(site.point);
  set_weight(id, site.weight);
  list(id);
  return id;
}

void ChangingWeightedPoints3::remove(std::uint32_t id) {
  table_.take(id, [this](std::uint32_t v) { return hash_of(v); });
  ChangingPoints3::remove(id);
  if (++gone_ > count() + few) find_weight_bounds();
}

void ChangingWeightedPoints3::add_apex(const Point3& p) {
  make_room();
  ChangingPoints3::add_apex(p);
  set_weight(apex(), 0);
}

void ChangingWeightedPoints3::turn_into_apex(std::uint32_t id, const Point3& p) {
  table_.take(id, [this](std::uint32_t v) { return hash_of(v); });
  ChangingPoints3::turn_into_apex(id, p);
  set_weight(id, 0);
}

std::uint32_t ChangingWeightedPoints3::turn_apex_into(const WeightedPoint3& site) {
  make_room();
  const std::uint32_t id = ChangingPoints3::turn_apex_into(site.point);
  set_weight(id, site.weight);
  list(id);
  return id;
}

std::vector<double> ChangingWeightedPoints3::weights(std::span<const std::uint32_t> ids) const {
  std::vector<double> list(ids.size());
  std::ranges::transform(ids, list.begin(), [this](std::uint32_t id) { return weights_[id]; });
  return list;
}

bool ChangingWeightedPoints3::is_before(std::uint32_t id, const WeightedPoint3& site) const {
  const Point3 p = original(id);
  return p == site.point ? weights_[id] > site.weight : lexicographically_less(p, site.point);
}

/// All memory for one more.
void ChangingWeightedPoints3::make_room() {
  table_.reserve_one([this](std::uint32_t v) { return hash_of(v); });
  const std::size_t size = id_count() + 1;
  if (size > weights_.capacity()) weights_.reserve(std::max(size, 2 * weights_.capacity()));
}

/// What the bounds tell is then true of this weight, too.
void ChangingWeightedPoints3::set_weight(std::uint32_t id, double weight) {
  if (id >= weights_.size()) weights_.resize(std::size_t{id} + 1);
  weights_[id] = weight;
  weight_extent_.add(weight);
}

void ChangingWeightedPoints3::list(std::uint32_t id) {
  table_.put(id, hash_of(id));
}

void ChangingWeightedPoints3::find_weight_bounds() {
  gone_ = 0;
  weight_extent_ = {};
  for (std::uint32_t id = 0; id < id_count(); ++id) {
    if (is_used(id)) weight_extent_.add(weights_[id]);
  }
}

std::uint64_t ChangingWeightedPoints3::hash_of(std::uint32_t id) const {
  return hash(site(id));
}

}  // namespace quoin
