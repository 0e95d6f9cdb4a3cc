// SPDX-License-Identifier: Apache-2.0
#include "quoin/flow/flow_points.h"

#include <algorithm>
#include <utility>

#include "quoin/flow/facet_formulas.h"

namespace quoin {

std::uint32_t FlowPoints::add(Node node) {
  points_.push_back(std::move(node));
  return size() - 1;
}

std::uint32_t FlowPoints::add_centre(DeloneFace face) {
  return add({.face = face, .is_centre = true, .t = {}});
}

std::uint32_t FlowPoints::add_place(const RationalPoint3& place, DeloneFace face) {
  Node node{.face = face, .t = {}, .place = place};
  if (face.dimension == 2) {
    const flow::Vector<Rational> n = flow::normal<Rational>(*flow_, face.index);
    const RationalPoint3 normal{n.x, n.y, n.z};
    const RationalPoint3 first = exact_point(flow_->point(flow_->faces().polygon(face.index)[0]));
    node.exact_t = dot(place - first, normal) / dot(normal, normal);
    node.t = Interval::around(*node.exact_t);
  }
  return add(std::move(node));
}

std::uint32_t FlowPoints::add_crossing(std::uint32_t parent, std::uint32_t edge, std::uint32_t polygon,
                                       const Interval& t) {
  return add({.face = {2, polygon}, .parent = parent, .edge = edge, .t = t});
}

std::uint32_t FlowPoints::apex_of_cell(std::uint32_t cell, std::uint32_t polygon) const {
  const std::span<const std::uint32_t> corners = flow_->faces().polygon(polygon);
  for (const std::uint32_t v : flow_->faces().cell(cell)) {
    if (std::find(corners.begin(), corners.end(), v) == corners.end()) return v;
  }
  return none;
}

Interval FlowPoints::place(std::uint32_t point, std::uint32_t polygon) const {
  const Node& node = points_[point];
  if (node.face.dimension == 2) return node.t;
  return flow::place_of_cell<Interval>(*flow_, polygon, apex_of_cell(node.face.index, polygon));
}

Rational FlowPoints::exact_place(std::uint32_t point, std::uint32_t polygon) {
  if (points_[point].face.dimension == 2) return exact_t(point);
  return flow::place_of_cell<Rational>(*flow_, polygon, apex_of_cell(points_[point].face.index, polygon));
}

Rational FlowPoints::landing(const Node& node) {
  const DeloneFaces& faces = flow_->faces();
  const DeloneFace from = points_[node.parent].face;
  const std::uint32_t apex = faces.apex(node.face.index, faces.side_of(node.face.index, node.edge));
  const flow::FacetLine<Rational> line(*flow_, node.edge, apex);
  const flow::Vector<Rational> normal = flow::normal<Rational>(*flow_, node.face.index);
  if (from.dimension == 1) {
    const RationalPoint3 y = *points_[node.parent].place - flow_->centre(from);
    return flow::landing<Rational>(line, normal, {y.x, y.y, y.z});
  }
  const std::uint32_t f = from.dimension == 2 ? from.index : faces.polygons_at_edge(from.index, node.edge)[0];
  const flow::LineFromMidpoint<Rational> start(*flow_, node.edge, f, faces.apex(f, faces.side_of(f, node.edge)));
  return flow::landing(line, normal, start.at(exact_place(node.parent, f)));
}

// From the last known point on, without recursion: chains are as long as orbits.
const Rational& FlowPoints::exact_t(std::uint32_t point) {
  static const Rational zero;
  if (points_[point].is_centre) return zero;
  std::vector<std::uint32_t> open;
  const auto is_open = [](const Node& node) { return node.face.dimension == 2 && !node.is_centre && !node.exact_t; };
  for (std::uint32_t at = point; is_open(points_[at]); at = points_[at].parent) open.push_back(at);
  for (; !open.empty(); open.pop_back()) {
    Node& node = points_[open.back()];
    node.exact_t = landing(node);
    node.t = Interval::around(*node.exact_t);
    ++exact_count_;
  }
  return *points_[point].exact_t;
}

Sign FlowPoints::side(std::uint32_t point) {
  const std::optional<Sign> sign = points_[point].t.sign();
  return sign && numbers_ == FlowNumbers::filtered ? *sign : exact_t(point).sign();
}

RationalPoint3 FlowPoints::exact(std::uint32_t point) {
  const Node& node = points_[point];
  if (node.place) return *node.place;
  if (node.is_centre || node.face.dimension != 2) return flow_->centre(node.face);
  const flow::Vector<Rational> n = flow::normal<Rational>(*flow_, node.face.index);
  return flow_->centre(node.face) + RationalPoint3{n.x, n.y, n.z} * exact_t(point);
}

Point3 FlowPoints::rounded(std::uint32_t point) {
  const RationalPoint3 p = exact(point);
  return {p.x.to_double(), p.y.to_double(), p.z.to_double()};
}

std::size_t FlowPoints::depth(std::uint32_t point) const {
  std::size_t count = 0;
  for (std::uint32_t at = point; points_[at].parent != none; at = points_[at].parent) ++count;
  return count;
}

}  // namespace quoin
