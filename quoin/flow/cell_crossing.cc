// SPDX-License-Identifier: Apache-2.0
#include "quoin/flow/cell_crossing.h"

#include "quoin/flow/facet_formulas.h"

namespace quoin {

using flow::RoundedLine;
using flow::RoundedPlace;
using flow::RoundedRay;

CellCrosser::CellCrosser(const FlowCells& flow)
    : flow_(flow),
      cells_(flow.cells()),
      points_(flow.triangulation().scaled_points()),
      chain_(flow.triangulation().scaled_points()) {}

// (from, to, corner, slot) is oriented as the simplex, so its vertex off the facet is above.
FlowTriangle CellCrosser::entry(const CellSide& side) const {
  const OtherSlots ends = other_slots[side.corner][side.facet.slot];
  const std::array<std::uint32_t, 4>& v = cells_[side.facet.cell].vertices;
  return {v[ends.behind], v[ends.ahead], v[side.corner]};
}

bool CellCrosser::is_usable(const RoundedRay& ray) {
  ++filters_.starts.calls;
  filters_.starts.undecided += ray.is_usable() ? 0 : 1;
  return ray.is_usable();
}

CellExit CellCrosser::exit(const FacetSpoke& spoke, std::uint32_t point, const FlowTriangle& entry) {
  CellExit found{.kind = CellExit::Kind::facet, .facet = spoke.facet, .is_above = spoke.is_above};
  found.point = chain_.add_landing(point, entry, spoke.vertex);
  return found;
}

// The lines in front of the point have y . direction > 0: the least power / slope is met first. Those behind it are
// left out by the sign of the slope alone, since slope <= power.
CellExit CellCrosser::forward(std::uint32_t point, const CellSide& side) {
  const FlowTriangle entry = this->entry(side);
  const RoundedRay ray = chain_.ray(point, entry);
  if (!is_usable(ray)) return exact_exit(side, point, true);
  bool has_best = false;
  bool is_certain = true;
  FacetSpoke best{};
  RoundedLine best_line;
  for_each_spoke(flow_, side, [&](const FacetSpoke& spoke) {
    if (!is_certain || spoke.vertex == entry[2]) return;
    const RoundedLine line = ray.line(points_[spoke.vertex]);
    if (line.slope < -line.slope_error) return;
    const int order = has_best ? RoundedRay::compare(line, best_line) : -1;
    filters_.comparisons.calls += has_best ? 1 : 0;
    if (order > 0) return;
    is_certain = order < 0;
    filters_.comparisons.undecided += is_certain ? 0 : 1;
    best = spoke;
    best_line = line;
    has_best = true;
  });
  if (is_certain && !has_best) return {};
  if (!is_certain) return exact_exit(side, point, true);
  ++filters_.exits.calls;
  if (!(best_line.slope > best_line.slope_error) || !(best_line.power > best_line.power_error)) {
    ++filters_.exits.undecided;
    return exact_exit(side, point, true);
  }
  RoundedPlace place;
  const bool lands = ray.land(best_line, place);
  ++filters_.landings.calls;
  filters_.landings.undecided += lands ? 0 : 1;
  CellExit found{.kind = CellExit::Kind::facet, .facet = best.facet, .is_above = best.is_above};
  found.point =
      lands ? chain_.add_landing(point, entry, best.vertex, place) : chain_.add_landing(point, entry, best.vertex);
  return found;
}

CellExit CellCrosser::backward(std::uint32_t point, const CellSide& side) {
  const FlowTriangle entry = this->entry(side);
  if (flow_.is_critical_edge(side.facet.cell, 5 - edge_number[side.corner][side.facet.slot])) {
    return {.kind = CellExit::Kind::midpoint, .is_at_midpoint = true};
  }
  std::size_t count = 0;
  FacetSpoke best{};
  for_each_spoke(flow_, side, [&](const FacetSpoke& spoke) {
    if (power_of(flow_, spoke) != Sign::negative) return;
    best = spoke;
    ++count;
  });
  if (count == 0) return at_midpoint(side, entry);
  if (count == 1) return exit(best, point, entry);
  const RoundedRay ray = chain_.ray(point, entry);
  if (!is_usable(ray)) return exact_exit(side, point, false);
  bool has_best = false;
  bool is_certain = true;
  RoundedLine best_line;
  for_each_spoke(flow_, side, [&](const FacetSpoke& spoke) {
    if (!is_certain || power_of(flow_, spoke) != Sign::negative) return;
    const RoundedLine line = ray.line(points_[spoke.vertex]);
    const int order = has_best ? RoundedRay::compare(line, best_line) : 1;
    filters_.comparisons.calls += has_best ? 1 : 0;
    if (order < 0) return;
    is_certain = order > 0;
    filters_.comparisons.undecided += is_certain ? 0 : 1;
    best = spoke;
    best_line = line;
    has_best = true;
  });
  return is_certain ? exit(best, point, entry) : exact_exit(side, point, false);
}

CellExit CellCrosser::vertex_exit(const std::vector<FacetSpoke>& ring, const std::vector<bool>& is_met) const {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (ring[i].is_joined && is_met[i] && is_met[(i + 1) % ring.size()]) {
      return {.kind = CellExit::Kind::vertex, .cell = ring[i].facet.cell};
    }
  }
  return {};
}

CellExit CellCrosser::at_midpoint(const CellSide& side, const FlowTriangle& entry) {
  std::vector<FacetSpoke> ring;
  std::vector<bool> is_met;
  std::size_t count = 0;
  FacetSpoke touching{};
  for_each_spoke(flow_, side, [&](const FacetSpoke& spoke) {
    ring.push_back(spoke);
    is_met.push_back(power_of(flow_, spoke) == Sign::zero);
    if (!is_met.back()) return;
    touching = spoke;
    ++count;
  });
  CellExit found;
  if (count > 1) {
    found = vertex_exit(ring, is_met);
  } else {
    found = {.kind = CellExit::Kind::facet, .facet = touching.facet, .is_above = touching.is_above};
    found.point = chain_.add_centre({entry[0], entry[1], touching.vertex});
  }
  found.is_at_midpoint = true;
  return found;
}

CellExit CellCrosser::exact_exit(const CellSide& side, std::uint32_t point, bool is_forward) {
  ++undecided_;
  const FlowTriangle entry = this->entry(side);
  const auto p = chain_.corners(entry);
  const flow::Vector<Rational> y =
      flow::LineFromMidpoint<Rational>(*p[0], *p[1], *p[2]).at(chain_.exact_place(point, entry));
  std::vector<FacetSpoke> ring;
  std::vector<bool> is_met;
  std::size_t best = 0;
  bool has_best = false;
  Rational least;
  std::size_t count = 0;
  for_each_spoke(flow_, side, [&](const FacetSpoke& spoke) {
    ring.push_back(spoke);
    is_met.push_back(false);
    if (is_forward ? spoke.vertex == entry[2] : power_of(flow_, spoke) != Sign::negative) return;
    const flow::FacetLine<Rational> line(*p[0], *p[1], points_[spoke.vertex]);
    const Rational slope = dot(y, line.direction);
    if (is_forward && slope.sign() != Sign::positive) return;
    const Rational lambda = line.power / slope;
    if (has_best && (is_forward ? lambda > least : lambda < least)) return;
    if (!has_best || lambda != least) {
      is_met.assign(is_met.size(), false);
      count = 0;
    }
    has_best = true;
    least = lambda;
    best = ring.size() - 1;
    is_met.back() = true;
    ++count;
  });
  if (count == 0) return {};
  if (count > 1) return vertex_exit(ring, is_met);
  const CellExit found = exit(ring[best], point, entry);
  chain_.exact_place(found.point, chain_.triangle(found.point));
  return found;
}

}  // namespace quoin
