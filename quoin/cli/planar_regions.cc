// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/planar_regions.h"

#include <sstream>

#include "quoin/base/error.h"

namespace quoin::cli {

namespace {

std::string describe_problem(const RingProblem& problem, const RegionCurves& curves) {
  const std::string& first = curves.names[problem.first_curve];
  const std::string& second = curves.names[problem.second_curve];
  switch (problem.kind) {
    case RingProblem::Kind::overlap:
      return problem.first_curve == problem.second_curve ? first + " runs along itself"
                                                         : first + " and " + second + " run along one another";
    case RingProblem::Kind::crosses_itself:
      return first + " crosses itself";
    case RingProblem::Kind::hole_outside:
      return first + " is a hole that reaches outside its polygon";
    case RingProblem::Kind::holes_overlap:
      break;
  }
  return first + " and " + second + " are holes that overlap";
}

template <class F>
std::string place_of(const Arrangement<F>& drawn, dcel::EdgeId edge) {
  const Point2 p = drawn.family().position(drawn.point(drawn.left(edge)));
  std::ostringstream out;
  out << " near (" << p.x << ", " << p.y << ")";
  return out.str();
}

}  // namespace

template <class F>
Regions<F> read_regions(std::span<const PlanarInput> inputs, const std::optional<FillRule>& rule,
                        std::vector<std::string>& warnings, const Context& context) {
  F family;
  PieceList<F> list;
  Regions<F> regions;
  std::vector<std::uint32_t> must_be_valid;  // by curve: its element, or none
  for (const PlanarInput& input : inputs) {
    RegionCurves curves;
    try {
      add_regions(family, list, input.drawing, curves);
    } catch (const InputError& error) {
      throw InputError(input.name + ": " + error.what());
    }
    const auto first = static_cast<std::uint32_t>(regions.groups.operand_of_element.size());
    for (std::size_t i = 0; i < curves.names.size(); ++i) {
      regions.curves.names.push_back(input.name + ": " + curves.names[i]);
      regions.curves.is_hole.push_back(curves.is_hole[i]);
      regions.groups.element_of_curve.push_back(first + curves.elements[i]);
      must_be_valid.push_back(input.drawing.has_rings_by_rule ? no_element : first + curves.elements[i]);
    }
    for (const FillRule own : curves.rules) regions.groups.rule_of_element.push_back(rule.value_or(own));
    regions.groups.operand_of_element.resize(first + input.drawing.elements.size(), regions.groups.operand_count);
    ++regions.groups.operand_count;
    for (const std::string& name : curves.ignored) warnings.push_back(input.name + ": " + name + " encloses nothing");
  }
  regions.drawn = arrange(std::move(family), list, context);
  if (rule) return regions;
  const std::optional<RingProblem> problem = find_ring_problem(regions.drawn, must_be_valid, regions.curves.is_hole);
  if (problem) {
    throw InputError(describe_problem(*problem, regions.curves) + place_of(regions.drawn, problem->edge) +
                     "; --fill even-odd or nonzero reads such rings by that rule");
  }
  return regions;
}

template Regions<LinearFamily> read_regions(std::span<const PlanarInput>, const std::optional<FillRule>&,
                                            std::vector<std::string>&, const Context&);
template Regions<CircularFamily> read_regions(std::span<const PlanarInput>, const std::optional<FillRule>&,
                                              std::vector<std::string>&, const Context&);

}  // namespace quoin::cli
