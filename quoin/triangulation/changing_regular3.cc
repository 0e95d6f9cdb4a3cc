// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/changing_regular3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/triangulation/regular_cells.h"

namespace quoin {

namespace {

void require_weights(std::span<const Point3> points, std::span<const double> weights) {
  if (weights.size() != points.size()) {
    throw InputError(std::to_string(points.size()) + " points with " + std::to_string(weights.size()) + " weights");
  }
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (!std::isfinite(weights[i])) {
      throw InputError("the weight of point " + std::to_string(i) + " of the triangulation is not finite");
    }
  }
}

/// Those that are equal to a heavier one.
std::vector<WeightedPoint3> lighter_points(const VertexPoints& distinct, std::span<const double> weights) {
  std::vector<WeightedPoint3> lighter;
  for (std::uint32_t v = 0; v < distinct.points.size(); ++v) {
    double heaviest = weights[distinct.inputs_of(v)[0]];
    for (const std::uint32_t i : distinct.inputs_of(v)) heaviest = std::max(heaviest, weights[i]);
    for (const std::uint32_t i : distinct.inputs_of(v)) {
      if (weights[i] < heaviest) lighter.push_back({distinct.points[v], weights[i] + 0.0});
    }
  }
  return lighter;
}

}  // namespace

ChangingRegular3::ChangingRegular3(std::span<const Point3> points, std::span<const double> weights,
                                   const Context& context) try {
  require_weights(points, weights);
  if (points.empty()) return;
  VertexPoints distinct(points, Scaling::none, context);
  const std::vector<WeightedPoint3> lighter = lighter_points(distinct, weights);
  points_ = ChangingWeightedPoints3(std::move(distinct), weights);
  const std::size_t count = points_.count();
  const std::array<std::uint32_t, 4> simplex = begin(context);
  RegularCells found;
  if (dimension_ > 1) found = regular_cells(points_.signs(), count, simplex, context);
  for (const WeightedPoint3& site : lighter) {
    const std::uint32_t known = points_.find(site);
    if (known != no_vertex) {
      points_.add_once_more(known);
    } else {
      found.hidden.push_back(points_.add(site));
    }
  }
  if (dimension_ < 2) {
    begin_line(context);
    return;
  }
  cells_ = ChangingCells3<RegularSigns>(std::move(found.cells), points_.id_count());
  cells_.hide(points_.signs(), found.hidden, context);
} catch (const std::bad_alloc&) {
  refuse_for_memory(points.size());
}

std::uint32_t ChangingRegular3::insert(const Point3& p, double weight) {
  return insert(p, weight, no_context());
}

std::uint32_t ChangingRegular3::insert(const Point3& p, double weight, const Context& context) {
  if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) throw InputError("the point is not finite");
  if (!std::isfinite(weight)) throw InputError("the weight is not finite");
  return insert_site({{p.x + 0.0, p.y + 0.0, p.z + 0.0}, weight + 0.0}, context);
}

bool ChangingRegular3::is_hidden(std::uint32_t v) const {
  if (dimension_ > 1) return cells_.is_hidden(v);
  if (!lives(v)) return false;
  const std::span<const std::uint32_t> shown = line();
  const auto less = [this](std::uint32_t a, const WeightedPoint3& b) { return points_.is_before(a, b); };
  const auto at = std::lower_bound(shown.begin(), shown.end(), points_.site(v), less);
  return at == shown.end() || *at != v;
}

std::size_t ChangingRegular3::hidden_count() const {
  return dimension_ > 1 ? cells_.hidden_count() : vertex_count() - line().size();
}

}  // namespace quoin
