// SPDX-License-Identifier: Apache-2.0
#include "quoin/flow/unstable_arcs.h"

#include <algorithm>

#include "quoin/base/error.h"

namespace quoin {

namespace {

UnstableArc joined(const UnstableArc& first, const UnstableArc& rest) {
  UnstableArc arc = rest;
  arc.segments += first.segments;
  arc.longest_cascade = std::max(first.longest_cascade, rest.longest_cascade);
  arc.has_passed_regular |= first.has_passed_regular;
  return arc;
}

}  // namespace

ArcTracer::ArcTracer(const FlowComplex& flow, AtRegularPoint at_regular, FlowNumbers numbers)
    : flow_(flow),
      at_regular_(at_regular),
      points_(flow, numbers),
      known_(flow.faces().count(3)),
      is_known_(flow.faces().count(3), false) {}

ArcTracer::Leg ArcTracer::leg(std::uint32_t cell, const Context& context) {
  points_.clear();
  std::uint32_t at = points_.add_centre({3, cell});
  Leg leg;
  while (true) {
    if (points_.size() % 256 == 0) context.poll();
    const FlowStep step = flow_step(points_, at, at_regular_);
    leg.is_last = step.stops || step.point == FlowPoints::none;
    if (step.stops) {
      leg.arc.end = step.segment.start;
      return leg;
    }
    ++leg.arc.segments;
    leg.arc.has_passed_regular |= step.passes;
    leg.arc.is_infinite = leg.is_last;
    if (leg.is_last) return leg;
    at = step.point;
    leg.arc.end = points_.face(at);
    if (leg.arc.end.dimension == 3) return leg;
    ++leg.arc.longest_cascade;
    ++crossing_count_;
  }
}

// Down the legs to a vertex whose way is known, and back up. Without recursion: ways are long.
UnstableArc ArcTracer::trace_cell(std::uint32_t cell, const Context& context) {
  std::vector<std::pair<std::uint32_t, UnstableArc>> legs;
  std::uint32_t at = cell;
  while (!is_known_[at]) {
    const Leg next = leg(at, context);
    if (next.is_last) {
      known_[at] = next.arc;
      is_known_[at] = true;
    } else {
      legs.emplace_back(at, next.arc);
      at = next.arc.end.index;
    }
  }
  for (; !legs.empty(); legs.pop_back()) {
    known_[legs.back().first] = joined(legs.back().second, known_[at]);
    at = legs.back().first;
    is_known_[at] = true;
  }
  return known_[cell];
}

UnstableArcs ArcTracer::trace(std::uint32_t polygon, const Context& context) {
  if (polygon >= flow_.faces().count(2) || !flow_.is_critical({2, polygon})) {
    throw InputError("unstable arcs of a polygon that is not critical");
  }
  UnstableArcs arcs;
  for (std::size_t side = 0; side < 2; ++side) {
    const UnstableArc first{.is_infinite = true, .segments = 1};
    const std::uint32_t cell = flow_.faces().cells_of_polygon(polygon)[side];
    arcs.arcs[side] = cell == DeloneFaces::outside ? first : joined(first, trace_cell(cell, context));
  }
  return arcs;
}

}  // namespace quoin
