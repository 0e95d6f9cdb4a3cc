// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/kernel/point.h"
#include "quoin/triangulation/changing_points3.h"
#include "quoin/triangulation/id_table.h"
#include "quoin/triangulation/regular_signs.h"
#include "quoin/triangulation/vertex_points.h"
#include "quoin/triangulation/weighted_point3.h"

namespace quoin {

/// Weighted points of space that come and go, as ChangingPoints3: equal points with different weights have an id each,
/// and are found by both.
class ChangingWeightedPoints3 : private ChangingPoints3 {
 public:
  using Site = WeightedPoint3;
  using Signs = RegularSigns;

  ChangingWeightedPoints3() : ChangingPoints3(Scaling::none) {}
  /// Of the heaviest of equal points, whose ids are numbers of vertices; weights are those of the points as given.
  ChangingWeightedPoints3(VertexPoints points, std::span<const double> weights);

  /// `no_vertex` if it is not there.
  std::uint32_t find(const WeightedPoint3& site) const;
  /// Of a weighted point that is not there; else as ChangingPoints3.
  std::uint32_t add(const WeightedPoint3& site);
  void remove(std::uint32_t id);

  void add_apex(const Point3& p);
  void turn_into_apex(std::uint32_t id, const Point3& p);
  std::uint32_t turn_apex_into(const WeightedPoint3& site);

  double weight(std::uint32_t id) const { return weights_[id]; }
  std::vector<double> weights(std::span<const std::uint32_t> ids) const;
  WeightedPoint3 site(std::uint32_t id) const { return {original(id), weights_[id]}; }
  /// Lexicographic order, in which the heaviest of equal points comes first.
  bool is_before(std::uint32_t id, const WeightedPoint3& site) const;

  RegularSigns signs() const { return {scaled_points(), weights_, extent(), weight_extent_, apex()}; }

  using ChangingPoints3::add_once_more;
  using ChangingPoints3::apex;
  using ChangingPoints3::count;
  using ChangingPoints3::id_count;
  using ChangingPoints3::ids;
  using ChangingPoints3::multiplicity;
  using ChangingPoints3::one_near;
  using ChangingPoints3::original;
  using ChangingPoints3::originals;
  using ChangingPoints3::remove_apex;
  using ChangingPoints3::remove_one_of_many;
  using ChangingPoints3::reserve_for_removals;

 private:
  void make_room();
  void set_weight(std::uint32_t id, double weight);
  void list(std::uint32_t id);
  void find_weight_bounds();
  std::uint64_t hash_of(std::uint32_t id) const;

  std::vector<double> weights_;  ///< of each id
  IdTable table_;                ///< of all that are there
  WeightExtent weight_extent_;
  std::size_t gone_ = 0;  ///< since bounds of weights were found
};

}  // namespace quoin
