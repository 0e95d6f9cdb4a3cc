// SPDX-License-Identifier: Apache-2.0
#include "quoin/flow/flat_flow.h"

#include <algorithm>

#include "quoin/base/disjoint_sets.h"
#include "quoin/base/error.h"
#include "quoin/flow/critical_values.h"
#include "quoin/flow/facet_formulas.h"

namespace quoin {

std::vector<std::uint32_t> critical_faces(const FlowComplex& flow, unsigned dimension) {
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 0; i < flow.faces().count(dimension); ++i) {
    if (flow.is_critical({dimension, i})) found.push_back(i);
  }
  return found;
}

Interval square_radius_bounds(const FlowComplex& flow, DeloneFace face) {
  if (face.dimension == 0) return Interval(0.0);
  if (face.dimension == 1) {
    const std::array<std::uint32_t, 2> ends = flow.faces().edge(face.index);
    const flow::Vector<Interval> v = flow::between<Interval>(flow.point(ends[0]), flow.point(ends[1]));
    return dot(v, v) * Interval(0.25);
  }
  const flow::Circle<Interval> circle(flow::circle_points(flow, face.index));
  return dot(circle.centre, circle.centre) / (Interval(4.0) * circle.square_normal * circle.square_normal);
}

FlatFlow::FlatFlow(const FlowComplex& flow) : flow_(flow) {
  if (flow.faces().dimension() > 2) throw InputError("the flow in a plane needs points of one plane");
  known_.resize(flow.faces().count(2), FlatWay{.segments = 0});
}

std::uint32_t FlatFlow::beyond(std::uint32_t edge, std::uint32_t polygon) const {
  for (const RingPolygon& g : flow_.faces().ring(edge)) {
    if (g.polygon != polygon) return g.polygon;
  }
  return FlatWay::infinity;
}

std::optional<std::uint32_t> FlatFlow::exit(std::uint32_t polygon, bool& passes) const {
  passes = false;
  const DeloneFace crossed = flow_.crossed({2, polygon});
  if (crossed.dimension == 1) return crossed.index;
  if (flow_.is_critical({2, polygon})) return std::nullopt;
  // The centre is on one side.
  passes = true;
  const std::span<const std::uint32_t> sides = flow_.faces().sides(polygon);
  std::size_t at = 0;
  while (flow_.signs().at_side(flow_.faces(), polygon, at) != Sign::zero) ++at;
  return sides[at];
}

std::uint32_t FlatFlow::next(std::uint32_t polygon, bool& passes) const {
  const std::optional<std::uint32_t> edge = exit(polygon, passes);
  return edge ? beyond(*edge, polygon) : polygon;
}

void FlatFlow::trace(std::uint32_t polygon, const Context& context) {
  std::vector<std::uint32_t> open;
  FlatWay behind{.segments = 0};
  bool passes = false;
  for (std::uint32_t at = polygon;;) {
    if (known_[at].first != FlatWay::infinity) {
      behind = known_[at];
      break;
    }
    const std::uint32_t after = next(at, passes);
    if (after == at) {
      behind = known_[at] = {.end = at, .first = at, .segments = 0};
      break;
    }
    open.push_back(at);
    if (open.size() % 256 == 0) context.poll();
    if (after == FlatWay::infinity) break;
    at = after;
  }
  for (; !open.empty(); open.pop_back()) {
    next(open.back(), passes);
    behind.first = open.back();
    ++behind.segments;
    behind.has_passed_regular |= passes;
    known_[open.back()] = behind;
  }
}

std::array<FlatWay, 2> FlatFlow::ways(std::uint32_t edge, const Context& context) {
  std::array<FlatWay, 2> found;
  std::size_t i = 0;
  for (const RingPolygon& g : flow_.faces().ring(edge)) {
    if (known_[g.polygon].first == FlatWay::infinity) trace(g.polygon, context);
    found.at(i) = known_[g.polygon];
    ++found.at(i).segments;
    ++i;
  }
  return found;
}

FlatSurvey survey_flat_unstable(FlatFlow& flow, const Context& context) {
  FlatSurvey survey;
  std::uint32_t number = 0;
  for (const std::uint32_t edge : critical_faces(flow.complex(), 1)) {
    if (number % 256 == 0) context.poll();
    for (const FlatWay& way : flow.ways(edge, context)) {
      survey.segments.add(way.segments);
      survey.to_infinity += way.end == FlatWay::infinity ? 1 : 0;
      if (way.has_passed_regular) survey.passed_regular.push_back(number);
    }
    ++number;
  }
  return survey;
}

StableSurvey survey_flat_stable(const FlowComplex& flow, const Context& context) {
  StableSurvey survey;
  std::uint32_t number = 0;
  for (const std::uint32_t polygon : critical_faces(flow, 2)) {
    if (number % 64 == 0) context.poll();
    const StableSurface surface = stable_surface(flow, polygon, context);
    survey.triangles += surface.triangles.size();
    for (const StableSide& side : surface.sides) survey.depths.add(side.depth);
    survey.crossings.exact_points += surface.points.exact_count();
    if (surface.has_regular_point) survey.with_regular_point.push_back(number);
    ++number;
  }
  return survey;
}

FlatShape flat_shape(const FlowComplex& flow, const Rational& square, const Context& context) {
  FlatShape shape;
  const Interval around = Interval::around(square);
  for (unsigned d = 0; d < 3; ++d) {
    std::size_t steps = 0;
    for (const std::uint32_t i : critical_faces(flow, d)) {
      if (++steps % 256 == 0) context.poll();
      const auto exact = [&] { return flow.square_radius({d, i}); };
      if (is_at_most(square_radius_bounds(flow, {d, i}), exact, square, around)) shape.faces[d].push_back(i);
    }
  }
  DisjointSets parts(flow.faces().count(0));
  std::size_t joined = 0;
  for (const std::uint32_t e : shape.faces[1]) {
    const std::array<std::uint32_t, 2> ends = flow.faces().edge(e);
    if (parts.find(ends[0]) == parts.find(ends[1])) continue;
    parts.unite(ends[0], ends[1]);
    ++joined;
  }
  shape.betti_numbers = {shape.faces[0].size() - joined, shape.faces[1].size() - joined - shape.faces[2].size(), 0};
  return shape;
}

}  // namespace quoin
