// SPDX-License-Identifier: Apache-2.0
#include "quoin/flow/saddle_arcs.h"

#include "quoin/flow/critical_values.h"

namespace quoin {

namespace {

// Ends of ways: simplices, of which there are less than 2^30; saddles by their place in a list, and these; and a bit.
constexpr std::uint32_t first_saddle = 0x40000000;
constexpr std::uint32_t at_infinity = 0x7FFFFFFF;
constexpr std::uint32_t unknown = 0x7FFFFFFE;
constexpr std::uint32_t has_passed = 0x80000000;

/// Without the bit.
bool is_saddle(std::uint32_t end) {
  return end >= first_saddle && end < unknown;
}

}  // namespace

SaddleArcs::SaddleArcs(const FlowCells& flow)
    : flow_(flow), crosser_(flow), end_(flow.cells().size(), unknown), segments_(flow.cells().size()) {}

/// The Delone cell on one side of a facet, or infinity.
std::uint32_t SaddleArcs::along(CellFacet facet, bool is_above) const {
  const std::uint32_t cell = is_above ? facet.cell : flow_.mate(facet).cell;
  return flow_.is_ghost(cell) ? at_infinity : flow_.first_of(cell);
}

SaddleArcs::Leg SaddleArcs::leg(std::uint32_t first, const Context& context) {
  const CellWay way = flow_.way(first);
  switch (way.kind) {
    case CellWay::Kind::facet:
      return {along({way.cell, way.place}, false), 1};
    case CellWay::Kind::maximum:
      return {first, 0};
    case CellWay::Kind::regular:
      return {along(flow_.way_past(first), false) | has_passed, 1};
    case CellWay::Kind::edge:
      break;
  }
  Leg leg;
  cross(way, leg, context);
  return leg;
}

void SaddleArcs::cross(const CellWay& way, Leg& leg, const Context& context) {
  const std::array<unsigned, 2> off = edge_slots[5 - way.place];
  CellSide side{{way.cell, off[1]}, off[0]};
  CrossingChain& chain = crosser_.chain();
  chain.clear();
  std::uint32_t point = chain.add_centre(crosser_.entry(side), flow_.cells()[way.cell].vertices[off[1]]);
  while (true) {
    if (chain.size() % 256 == 0) context.poll();
    const CellExit exit = crosser_.forward(point, side);
    ++leg.segments;
    leg.next = at_infinity;
    if (exit.kind == CellExit::Kind::vertex) leg.next = flow_.first_of(exit.cell);
    if (exit.kind != CellExit::Kind::facet) break;
    point = exit.point;
    side = flow_.way_of_polygon(exit.facet);
    if (side.corner != side.facet.slot) continue;
    const Sign above = crosser_.chain().side(point);
    if (above == Sign::zero) {
      if (flow_.is_critical_polygon(exit.facet)) {
        leg.next = first_saddle + static_cast<std::uint32_t>(in_saddles_.size());
        in_saddles_.push_back(exit.facet.cell);
        break;
      }
      const std::uint32_t behind = flow_.mate(exit.facet).cell;
      const bool is_own_first = flow_.is_ghost(behind) || flow_.is_before(exit.facet.cell, behind);
      leg.next = along(exit.facet, is_own_first) | has_passed;
    } else {
      leg.next = along(exit.facet, (above == Sign::positive) == exit.is_above);
    }
    ++leg.segments;
    break;
  }
  cascades_.add(chain.size() - 1);
}

// Down the legs to a vertex whose way is known, and back up. Without recursion: ways are long.
void SaddleArcs::trace(std::uint32_t first, const Context& context) {
  open_.clear();
  std::uint32_t at = first;
  while (end_[at] == unknown) {
    const Leg next = leg(at, context);
    const std::uint32_t cell = next.next & ~has_passed;
    if (cell == at || cell >= first_saddle) {
      end_[at] = next.next;
      segments_.set(at, next.segments);
    } else {
      open_.emplace_back(at, next);
      if (open_.size() % 1024 == 0) context.poll();
      at = cell;
    }
  }
  for (; !open_.empty(); open_.pop_back()) {
    const auto& [from, legs] = open_.back();
    end_[from] = end_[at] | (legs.next & has_passed);
    segments_.set(from, segments_[at] + legs.segments);
    at = from;
  }
}

SaddleEnd SaddleArcs::end(std::uint32_t cell, const Context& context) {
  SaddleEnd found;
  found.segments = 1;
  if (flow_.is_ghost(cell)) return found;
  const std::uint32_t first = flow_.first_of(cell);
  if (end_[first] == unknown) trace(first, context);
  const std::uint32_t end = end_[first] & ~has_passed;
  found.has_passed_regular = (end_[first] & has_passed) != 0;
  found.segments += segments_[first];
  if (is_saddle(end)) {
    found.kind = SaddleEnd::Kind::saddle;
    found.cell = in_saddles_[end - first_saddle];
  } else if (end != at_infinity) {
    found.kind = SaddleEnd::Kind::maximum;
    found.cell = end;
  }
  return found;
}

template <class Visit>
bool SaddleArcs::visit_way(std::uint32_t first, const Context& context, std::optional<std::uint32_t>& next,
                           const Visit& visit) {
  if (end_[first] == unknown) return false;
  const Histogram cascades = cascades_;
  const Leg way = leg(first, context);
  cascades_ = cascades;
  if (way.segments == 0) return false;
  const bool crosses = flow_.way(first).kind == CellWay::Kind::edge;
  for (std::uint32_t i = 1; crosses && i < crosser_.chain().size(); ++i) visit(i);
  const std::uint32_t behind = way.next & ~has_passed;
  if (behind < first_saddle) next = behind;
  return true;
}

std::optional<ArcLeg> SaddleArcs::way_on(std::uint32_t first, const Context& context, double part) {
  ArcLeg found;
  const double unscale = flow_.triangulation().unscale();
  const auto add = [&](std::uint32_t node) {
    const Point3 p = crosser_.chain().near_point(node, part);
    found.points.push_back({p.x * unscale, p.y * unscale, p.z * unscale});
  };
  if (!visit_way(first, context, found.next, add)) return std::nullopt;
  return found;
}

std::optional<ExactArcLeg> SaddleArcs::exact_way_on(std::uint32_t first, const Context& context) {
  ExactArcLeg found;
  const Rational unscale(flow_.triangulation().unscale());
  const auto add = [&](std::uint32_t node) { found.points.push_back(crosser_.chain().exact_point(node) * unscale); };
  if (!visit_way(first, context, found.next, add)) return std::nullopt;
  return found;
}

std::array<SaddleEnd, 2> SaddleArcs::ends(CellFacet saddle, const Context& context) {
  return {end(saddle.cell, context), end(flow_.mate(saddle).cell, context)};
}

}  // namespace quoin
