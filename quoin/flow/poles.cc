// SPDX-License-Identifier: Apache-2.0
#include "quoin/flow/poles.h"

#include <algorithm>
#include <optional>
#include <tuple>

#include "quoin/flow/critical_values.h"
#include "quoin/triangulation/smallest_spheres.h"

namespace quoin {

namespace {

std::vector<Point3> points_of(const Delaunay3& triangulation) {
  std::vector<Point3> points(triangulation.vertex_count());
  for (std::uint32_t v = 0; v < points.size(); ++v) points[v] = triangulation.point(v);
  return points;
}

/// Which of two simplices has the farther circumcentre: by intervals, closer ones, integers.
class RadiusOrder {
 public:
  explicit RadiusOrder(const FlowCells& flow)
      : flow_(flow),
        spheres_(points_of(flow.triangulation())),
        values_(flow.triangulation()),
        squares_(flow.cells().size()),
        is_close_(flow.cells().size(), false) {}

  void add(std::uint32_t cell) { squares_[cell] = spheres_.power(flow_.cells()[cell].vertices); }

  /// Larger, or equal and with the lexicographically larger centre.
  bool is_before(std::uint32_t a, std::uint32_t b) {
    std::optional<Sign> sign = compare(squares_[a], squares_[b]);
    if (!sign) sign = compare(close(a), close(b));
    if (!sign) sign = compare(exact(a), exact(b));
    if (*sign != Sign::zero) return *sign == Sign::negative;
    const RationalPoint3 from = values_.centre(a);
    const RationalPoint3 to = values_.centre(b);
    return std::tie(from.x, from.y, from.z) < std::tie(to.x, to.y, to.z);
  }

 private:
  const Interval& close(std::uint32_t cell) {
    if (!is_close_[cell]) squares_[cell] = spheres_.close_power(flow_.cells()[cell].vertices);
    is_close_[cell] = true;
    return squares_[cell];
  }
  ExactQuotient exact(std::uint32_t cell) const { return spheres_.exact_power(flow_.cells()[cell].vertices); }

  const FlowCells& flow_;
  SmallestSpheres spheres_;
  CriticalValues values_;
  std::vector<Interval> squares_;
  std::vector<bool> is_close_;
};

}  // namespace

Poles::Poles(const FlowCells& flow, const Context& context) : flow_(flow) {
  cell_.assign(flow.triangulation().vertex_count(), none);
  RadiusOrder order(flow);
  for (std::uint32_t c = 0; c < flow.cells().size(); ++c) {
    if (c % 256 == 0) context.poll();
    const std::array<std::uint32_t, 4>& corners = flow.cells()[c].vertices;
    if (flow.is_ghost(c)) {
      const CellFacet facet = flow.named(flow.mate({c, 3})).facet;
      for (unsigned i = 0; i < 3; ++i) hull_.push_back(static_cast<std::uint64_t>(corners[i]) << 32 | facet.number());
      continue;
    }
    order.add(c);
    for (const std::uint32_t v : corners) {
      std::uint32_t& best = cell_[v];
      if (best == none) {
        best = c;
      } else if (flow.first_of(best) != flow.first_of(c) && order.is_before(best, c)) {
        best = c;
      }
    }
  }
  std::sort(hull_.begin(), hull_.end());
  hull_.erase(std::unique(hull_.begin(), hull_.end()), hull_.end());
  for (const std::uint64_t corner : hull_) cell_[corner >> 32] = none;
}

template <class N>
flow::Vector<N> Poles::direction(std::uint32_t vertex) const {
  const Delaunay3& points = flow_.triangulation();
  const auto other = [&](std::uint32_t cell, unsigned slot) {
    return flow::between<N>(points.point(vertex), points.point(flow_.cells()[cell].vertices[slot]));
  };
  if (cell_[vertex] != none) {
    std::array<flow::Vector<N>, 3> sides;
    unsigned count = 0;
    for (unsigned i = 0; i < 4; ++i) {
      if (flow_.cells()[cell_[vertex]].vertices[i] != vertex) sides[count++] = other(cell_[vertex], i);
    }
    const auto& [a, b, c] = sides;
    return cross(b, c) * dot(a, a) + cross(c, a) * dot(b, b) + cross(a, b) * dot(c, c);
  }
  flow::Vector<N> sum{N(0), N(0), N(0)};
  const std::uint64_t first = static_cast<std::uint64_t>(vertex) << 32;
  for (auto at = std::lower_bound(hull_.begin(), hull_.end(), first); at != hull_.end() && *at >> 32 == vertex; ++at) {
    const auto named = static_cast<std::uint32_t>(*at);
    for (const CellFacet& part : flow_.polygon({named >> 2, named & 3})) {
      const auto& [i, j, k] = facet_slots[part.slot];
      // From the vertex, in the plane of the polygon.
      const flow::Vector<N> a = other(part.cell, i);
      const flow::Vector<N> b = other(part.cell, j);
      const flow::Vector<N> c = other(part.cell, k);
      sum = sum + cross(a, b) + cross(b, c) + cross(c, a);
    }
  }
  return sum;
}

template flow::Vector<Interval> Poles::direction<Interval>(std::uint32_t vertex) const;
template flow::Vector<Rational> Poles::direction<Rational>(std::uint32_t vertex) const;

}  // namespace quoin
