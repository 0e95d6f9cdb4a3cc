// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>

#include "quoin/cli/commands.h"
#include "quoin/cli/exact_targets.h"
#include "quoin/cli/failure.h"
#include "quoin/cli/planar.h"
#include "quoin/cli/planar_pictures.h"
#include "quoin/cli/planar_regions.h"
#include "quoin/cli/polygon_motion.h"
#include "quoin/cli/set_report.h"

namespace quoin::cli {

namespace {

SetOperation operation_of(const std::string& name) {
  static const std::map<std::string, SetOperation> operations{{"union", SetOperation::unite},
                                                              {"intersection", SetOperation::intersect},
                                                              {"difference", SetOperation::subtract},
                                                              {"xor", SetOperation::symmetric_difference}};
  return operations.at(name);
}

template <class F>
PolygonSet<F> combine_plainly(const Regions<F>& regions, SetOperation operation, const Context& context) {
  std::vector<PolygonSet<F>> sets;
  for (std::uint32_t operand = 0; operand < regions.groups.operand_count; ++operand) {
    sets.push_back(set_of_operand(regions, operand));
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
    return combine_regions(regions.drawn, regions.groups, SetOperation::unite);
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
int finish_set(const PolygonSet<F>& set, const std::vector<std::string>& warnings, const Options& options,
               const Context& context) {
  SetReport report{{{"operation", options.operation}}, {}, warnings};
  describe_set(set, report);
  write_set(set, report, options, context);
  write_set_picture(set, options);
  print_report(std::move(report.json), report.text + "\n", report.warnings, options);
  return 0;
}

template <class F>
int combine_with(std::span<const PlanarInput> inputs, std::vector<std::string>& warnings, const Options& options,
                 const Context& context) {
  if (std::any_of(inputs.begin(), inputs.end(), [](const PlanarInput& input) { return input.exact.has_value(); })) {
    return finish_set(combine_sets<F>(inputs, warnings, options, context), warnings, options, context);
  }
  const Regions<F> regions = read_regions<F>(inputs, fill_rule(options), warnings, context);
  const SetOperation operation = operation_of(options.operation);
  return finish_set(options.plain ? combine_plainly(regions, operation, context)
                                  : combine_regions(regions.drawn, regions.groups, operation),
                    warnings, options, context);
}

/// Refuses options that say nothing to the operation.
void require_fitting_options(const Options& options) {
  const bool is_sum = options.operation == "minkowski";
  const bool is_offset = options.operation == "offset";
  const auto refuse = [](const std::string& option, const std::string& owner) {
    throw UsageError(option + " is of " + owner);
  };
  if (!is_offset && options.distance) refuse("--distance", "polygon offset");
  if (!is_offset && options.precision) refuse("--precision", "polygon offset");
  if (!is_offset && options.inner) refuse("--inner", "polygon offset");
  if (!is_sum && options.tight) refuse("--tight", "polygon minkowski");
  if (!is_sum && options.reflect) refuse("--reflect", "polygon minkowski");
  if ((is_sum || is_offset) && options.plain) refuse("--plain", "union, intersection, difference and xor");
  if (is_sum && options.inputs.size() != 2) throw UsageError("polygon minkowski takes two files");
  if (is_offset && options.inputs.size() != 1) throw UsageError("polygon offset takes one file");
}

}  // namespace

int run_polygon(const Options& options, const Context& context) {
  require_fitting_options(options);
  (void)fill_rule(options);  // refused before anything is read
  if (options.operation == "minkowski") return run_minkowski(options, context);
  if (options.operation == "offset") return run_offset(options, context);
  std::vector<std::string> warnings;
  const std::vector<PlanarInput> inputs = read_drawings(options, warnings, context);
  return any_arcs(inputs) ? combine_with<CircularFamily>(inputs, warnings, options, context)
                          : combine_with<LinearFamily>(inputs, warnings, options, context);
}

}  // namespace quoin::cli
