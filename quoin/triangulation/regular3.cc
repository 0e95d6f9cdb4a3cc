// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/regular3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <numeric>
#include <string>

#include "quoin/base/error.h"
#include "quoin/number/rational.h"
#include "quoin/triangulation/affine_basis.h"
#include "quoin/triangulation/flat_cells.h"
#include "quoin/triangulation/insertion_rounds.h"
#include "quoin/triangulation/regular_signs.h"

namespace quoin {

namespace {

/// A point of a line by a coordinate along it, and its height above it, less its weight.
struct Lifted {
  std::uint32_t vertex;
  Rational along;
  Rational height;
};

bool is_above(const Lifted& b, const Lifted& a, const Lifted& c) {
  return (b.height - a.height) * (c.along - a.along) > (c.height - a.height) * (b.along - a.along);
}

}  // namespace

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
    cells_ = cells_of_chain(lower_chain());
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
  cells_ = insert_in_rounds(
      signs, vertex_count_, {v[0], v[1], v[2], dimension_ == 2 ? apex : v[3]}, context,
      [this](std::uint32_t hidden) { is_hidden_[hidden] = true; }, InsertionSplit::of(vertex_count_));
  if (dimension_ == 2) cells_ = without_apex(cells_, apex);
}

/// Along a line: what is left of the vertices, in order. Source: Andrew 1979.
std::vector<std::uint32_t> Regular3::lower_chain() {
  std::vector<std::uint32_t> order(vertex_count_);
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [this](std::uint32_t a, std::uint32_t b) {
    return lexicographically_less(points_.points[a], points_.points[b]);
  });
  const Point3& first = points_.points[order.front()];
  const Point3& last = points_.points[order.back()];
  const std::size_t axis = first.x != last.x ? 0 : first.y != last.y ? 1 : 2;
  std::vector<Lifted> chain;
  for (const std::uint32_t v : order) {
    const Point3& p = points_.points[v];
    Rational height = -Rational(weights_[v]);
    for (const double x : {p.x, p.y, p.z}) height += Rational(x) * Rational(x);
    Lifted next{v, Rational(p[axis]), std::move(height)};
    while (chain.size() > 1 && is_above(chain.back(), chain[chain.size() - 2], next)) {
      is_hidden_[chain.back().vertex] = true;
      chain.pop_back();
    }
    chain.push_back(std::move(next));
  }
  std::vector<std::uint32_t> vertices;
  for (const Lifted& lifted : chain) vertices.push_back(lifted.vertex);
  return vertices;
}

}  // namespace quoin
