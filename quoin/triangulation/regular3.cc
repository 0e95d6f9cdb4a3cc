// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/regular3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <numeric>
#include <string>
#include <utility>

#include "quoin/base/error.h"
#include "quoin/triangulation/affine_basis.h"
#include "quoin/triangulation/flat_cells.h"
#include "quoin/triangulation/lower_chain.h"
#include "quoin/triangulation/regular_cells.h"
#include "quoin/triangulation/regular_signs.h"

namespace quoin {

Regular3::Regular3(std::span<const Point3> points, std::span<const double> weights, const Context& context) try
    : points_(points, Scaling::none, context), vertex_count_(points_.points.size()) {
  if (weights.size() != points.size()) {
    throw InputError(std::to_string(points.size()) + " points with " + std::to_string(weights.size()) + " weights");
  }
  take_weights(weights);
  is_hidden_.assign(vertex_count_, false);
  const AffineBasis basis = affine_basis(points_.all(), context);
  dimension_ = static_cast<int>(basis.vertices.size()) - 1;
  if (dimension_ < 2) {
    cells_ = cells_of_chain(visible_chain(context));
  } else {
    triangulate(basis, context);
  }
} catch (const std::bad_alloc&) {
  refuse_for_memory(points.size());
}

void Regular3::take_weights(std::span<const double> weights) {
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (!std::isfinite(weights[i])) {
      throw InputError("the weight of point " + std::to_string(i) + " of the triangulation is not finite");
    }
  }
  weights_.resize(vertex_count_);
  for (std::uint32_t v = 0; v < vertex_count_; ++v) {
    double heaviest = weights[inputs(v)[0]];
    for (const std::uint32_t i : inputs(v)) heaviest = std::max(heaviest, weights[i]);
    weights_[v] = heaviest;
  }
}

void Regular3::triangulate(const AffineBasis& basis, const Context& context) {
  const auto apex = static_cast<std::uint32_t>(vertex_count_);
  const std::vector<std::uint32_t>& v = basis.vertices;
  if (dimension_ == 2) {
    // A corner of the hull, so never hidden, whatever its weight.
    points_.points.push_back(point_off_plane(points_.all(), basis));
    weights_.push_back(0);
  }
  const RegularSigns signs(points_.all(), weights_, dimension_ == 2);
  RegularCells found = regular_cells(signs, vertex_count_, {v[0], v[1], v[2], dimension_ == 2 ? apex : v[3]}, context);
  for (const std::uint32_t hidden : found.hidden) is_hidden_[hidden] = true;
  cells_ = dimension_ == 2 ? without_apex(found.cells, apex) : std::move(found.cells);
}

/// Along a line: what is left of the vertices, in order.
std::vector<std::uint32_t> Regular3::visible_chain(const Context& context) {
  std::vector<std::uint32_t> order(vertex_count_);
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [this](std::uint32_t a, std::uint32_t b) {
    return lexicographically_less(points_.points[a], points_.points[b]);
  });
  std::vector<Point3> points;
  std::vector<double> weights;
  for (const std::uint32_t v : order) {
    points.push_back(points_.points[v]);
    weights.push_back(weights_[v]);
  }
  is_hidden_.assign(vertex_count_, true);
  std::vector<std::uint32_t> chain;
  for (const std::uint32_t place : lower_chain(points, weights, context)) {
    is_hidden_[order[place]] = false;
    chain.push_back(order[place]);
  }
  return chain;
}

int Regular3::power_side(const RegularSigns& signs, std::size_t cell, std::uint32_t vertex) const {
  const std::array<std::uint32_t, 4>& v = cells_[cell].vertices;
  if (dimension_ == 3) return signs.power_sign(v[0], v[1], v[2], v[3], vertex);
  if (dimension_ == 2) return signs.power_sign(v[0], v[1], v[2], static_cast<std::uint32_t>(vertex_count_), vertex);
  if (dimension_ == 0 || vertex == v[0] || vertex == v[1]) return 0;
  const auto at = [this](std::uint32_t i) { return WeightedPoint3{point(i), weight(i)}; };
  return -to_int(side_of_chord(at(vertex), at(v[0]), at(v[1])));
}

}  // namespace quoin
