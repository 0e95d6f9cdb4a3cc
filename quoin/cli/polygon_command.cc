// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "quoin/arrangement/circular_shapes.h"
#include "quoin/cli/commands.h"
#include "quoin/cli/exact_targets.h"
#include "quoin/cli/failure.h"
#include "quoin/cli/planar.h"
#include "quoin/cli/planar_pictures.h"
#include "quoin/cli/targets.h"
#include "quoin/io/drawing_curves.h"
#include "quoin/io/set_drawing.h"

namespace quoin::cli {

namespace {

using Json = nlohmann::ordered_json;

/// All regions of the inputs, arranged.
template <class F>
struct Regions {
  Arrangement<F> drawn;
  RegionCurves curves;
  RegionGroups groups;
};

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

template <class F>
Regions<F> read_regions(std::span<const PlanarInput> inputs, const std::optional<FillRule>& rule,
                        std::vector<std::string>& warnings, const Context& context) {
  F family;
  PieceList<F> list;
  Regions<F> regions;
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
    }
    regions.groups.operand_of_element.resize(first + input.drawing.elements.size(), regions.groups.operand_count);
    ++regions.groups.operand_count;
    for (const std::string& name : curves.ignored) warnings.push_back(input.name + ": " + name + " encloses nothing");
  }
  regions.drawn = arrange(std::move(family), list, context);
  if (rule) return regions;
  const std::optional<RingProblem> problem =
      find_ring_problem(regions.drawn, regions.groups.element_of_curve, regions.curves.is_hole);
  if (problem) {
    throw InputError(describe_problem(*problem, regions.curves) + place_of(regions.drawn, problem->edge) +
                     "; --fill even-odd or nonzero reads such rings by that rule");
  }
  return regions;
}

double area_of(const LinearPolygonSet& set, Json& json) {
  const Rational exact = area(set);
  json["exact_area"] = exact.to_string();
  return exact.to_double();
}

double area_of(const CircularPolygonSet& set, Json& json) {
  const CircularArrangement& arrangement = set.arrangement();
  double sum = 0;
  double error = 0;
  for (std::size_t e = 0; e < arrangement.edge_count(); ++e) {
    const dcel::EdgeId id(e);
    const bool above = set.contains(arrangement.cells().face(dcel::HalfedgeId(id, false)));
    const bool below = set.contains(arrangement.cells().face(dcel::HalfedgeId(id, true)));
    if (above == below) continue;
    const CertifiedDouble part = area_under(arrangement.family(), arrangement.branch(id), arrangement.left_point(id),
                                            arrangement.right_point(id));
    sum += below ? part.value : -part.value;
    error += part.error + 0x1p-52 * std::fabs(sum);
  }
  json["area_error"] = error;
  return sum;
}

template <class F>
int report_set(const PolygonSet<F>& set, std::vector<std::string> warnings, Json json, const Options& options,
               const Context& context) {
  const std::size_t polygons = set.is_unbounded() ? 0 : polygons_of(set).size();
  const dcel::Counts counts = set.arrangement().counts();
  json["unbounded"] = set.is_unbounded();
  json["polygons"] = polygons;
  json["vertices"] = counts.vertices;
  json["edges"] = counts.edges;
  json["isolated_vertices"] = counts.isolated_vertices;
  std::string text = std::to_string(polygons) + " polygons, " + std::to_string(counts.vertices) + " vertices";
  if (!set.is_unbounded()) {
    json["area"] = area_of(set, json);
    std::ostringstream out;
    out << ", area " << json["area"].template get<double>();
    text += out.str();
  }
  if (!set.is_regular())
    warnings.push_back("edges and points without area are shown in pictures and kept in .qarr only");
  const std::vector<Target> targets = targets_of(options);
  if (std::any_of(targets.begin(), targets.end(),
                  [](const Target& target) { return target.kind == Target::Kind::planar; })) {
    const SetDrawing drawn = draw_set(set, context);
    json["rounding"] = {{"max_displacement", drawn.max_displacement}, {"rounds", drawn.rounds}};
    if (drawn.vanished_rings > 0) {
      warnings.push_back(std::to_string(drawn.vanished_rings) + " rings are too thin to be written in doubles");
    }
    write_drawings(drawn.drawing, options, warnings, context);
  }
  write_set_picture(set, options);
  write_exact_targets(set, {}, options);
  print_report(std::move(json), text + "\n", warnings, options);
  return 0;
}

SetOperation operation_of(const std::string& name) {
  static const std::map<std::string, SetOperation> operations{{"union", SetOperation::unite},
                                                              {"intersection", SetOperation::intersect},
                                                              {"difference", SetOperation::subtract},
                                                              {"xor", SetOperation::symmetric_difference}};
  return operations.at(name);
}

template <class F>
PolygonSet<F> combine_plainly(const Regions<F>& regions, FillRule rule, SetOperation operation,
                              const Context& context) {
  std::vector<PolygonSet<F>> sets;
  for (std::uint32_t operand = 0; operand < regions.groups.operand_count; ++operand) {
    // The others' elements become an operand that is no part of a union of one.
    RegionGroups groups = regions.groups;
    for (std::uint32_t& of : groups.operand_of_element) of = of == operand ? 0 : 1;
    groups.operand_count = 2;
    sets.push_back(combine_regions(regions.drawn, groups, rule, SetOperation::first));
  }
  std::vector<const PolygonSet<F>*> pointers;
  for (const PolygonSet<F>& set : sets) pointers.push_back(&set);
  return combine<F>(pointers, operation, Regularity::plain, context);
}

/// The set of one input: what an exact text holds, or the regions of a drawing.
template <class F>
PolygonSet<F> set_of(const PlanarInput& input, const std::optional<FillRule>& rule, std::vector<std::string>& warnings,
                     const Context& context) {
  if (!input.exact) {
    const Regions<F> regions = read_regions<F>({&input, 1}, rule, warnings, context);
    return combine_regions(regions.drawn, regions.groups, rule.value_or(FillRule::even_odd), SetOperation::unite);
  }
  const auto* text = std::get_if<ArrangementText<F>>(&*input.exact);
  if (text == nullptr) throw InputError(input.name + ": an exact text of lines does not go with arcs");
  if (!text->members) throw InputError(input.name + ": it is an arrangement without members, no set");
  return *text->set();
}

template <class F>
PolygonSet<F> combine_sets(std::span<const PlanarInput> inputs, std::vector<std::string>& warnings,
                           const Options& options, const Context& context) {
  std::vector<PolygonSet<F>> sets;
  for (const PlanarInput& input : inputs) sets.push_back(set_of<F>(input, fill_rule(options), warnings, context));
  std::vector<const PolygonSet<F>*> pointers;
  for (const PolygonSet<F>& set : sets) pointers.push_back(&set);
  return combine<F>(pointers, operation_of(options.operation),
                    options.plain ? Regularity::plain : Regularity::regularized, context);
}

template <class F>
int combine_with(std::span<const PlanarInput> inputs, std::vector<std::string>& warnings, const Options& options,
                 const Context& context) {
  if (std::any_of(inputs.begin(), inputs.end(), [](const PlanarInput& input) { return input.exact.has_value(); })) {
    const PolygonSet<F> set = combine_sets<F>(inputs, warnings, options, context);
    return report_set(set, warnings, {{"operation", options.operation}}, options, context);
  }
  const std::optional<FillRule> rule = fill_rule(options);
  const Regions<F> regions = read_regions<F>(inputs, rule, warnings, context);
  const FillRule reading = rule.value_or(FillRule::even_odd);
  const SetOperation operation = operation_of(options.operation);
  const PolygonSet<F> set = options.plain ? combine_plainly(regions, reading, operation, context)
                                          : combine_regions(regions.drawn, regions.groups, reading, operation);
  return report_set(set, warnings, {{"operation", options.operation}}, options, context);
}

}  // namespace

int run_polygon(const Options& options, const Context& context) {
  std::vector<std::string> warnings;
  const std::vector<PlanarInput> inputs = read_drawings(options, warnings, context);
  return any_arcs(inputs) ? combine_with<CircularFamily>(inputs, warnings, options, context)
                          : combine_with<LinearFamily>(inputs, warnings, options, context);
}

}  // namespace quoin::cli
