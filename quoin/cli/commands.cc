// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/commands.h"

#include <algorithm>

#include "quoin/base/error.h"
#include "quoin/cli/diagnosis.h"
#include "quoin/cli/expression_parser.h"
#include "quoin/cli/inputs.h"
#include "quoin/cli/reporting.h"
#include "quoin/cli/streams.h"
#include "quoin/cli/targets.h"
#include "quoin/solid/repair.h"
#include "quoin/solid/solid.h"

namespace quoin::cli {

namespace {

using Json = nlohmann::ordered_json;

Solid combine(const std::string& operation, std::span<const Solid> solids, const Context& context) {
  if (operation == "union") return unite(solids, context);
  if (operation == "intersection") return intersect(solids, context);
  if (operation == "xor") return symmetric_difference(solids, context);
  return subtract(solids[0], solids.subspan(1), context);
}

constexpr std::size_t listed_faces = 100;

// What a repair did, in faces of the file.
Json as_json(const std::vector<RepairChange>& changes) {
  Json json = Json::array();
  for (const RepairChange& change : changes) {
    const std::size_t listed = std::min(listed_faces, change.faces.size());
    json.push_back({{"change", change.what},
                    {"count", change.faces.size()},
                    {"faces", std::vector<std::uint32_t>(change.faces.begin(),
                                                         change.faces.begin() + static_cast<std::ptrdiff_t>(listed))}});
  }
  return json;
}

// An input after its repair, as an operand.
struct Repaired {
  LeafResult leaf;  // findings name faces of the file
  std::vector<RepairChange> changes;
  std::vector<RepairChange> refusals;
  std::vector<std::string> findings;
};

// Exact text stays as it is: its faces are those of the solid of positive winding number that they bound.
Repaired repair_input(const Input& input, const std::string& name, const Context& context) {
  Repaired result;
  if (const Mesh* mesh = std::get_if<Mesh>(&input)) {
    RepairResult repaired = repair_mesh(*mesh, context);
    result.leaf = make_leaf(repaired.mesh, {}, context);
    rename_faces(result.leaf.diagnosis, repaired.source_face);
    result.changes = std::move(repaired.changes);
    result.refusals = std::move(repaired.refusals);
  } else {
    result.leaf = make_leaf(input, name, context);
  }
  result.findings = describe(input, result.leaf.diagnosis);
  return result;
}

std::vector<std::string> lines_of(const std::vector<RepairChange>& changes) {
  std::vector<std::string> lines;
  lines.reserve(changes.size());
  for (const RepairChange& change : changes) lines.push_back("repaired: " + describe(change.what, change.faces));
  return lines;
}

}  // namespace

int run_boolean(const Options& options, const Context& context) {
  const Clock::time_point start = Clock::now();
  std::vector<std::string> warnings;
  const std::vector<Solid> solids = load_operands(options.inputs, options, warnings, context);
  const Solid result = combine(options.command, solids, context);
  return finish({result.boundary(), options.command, std::move(warnings), start}, options, context);
}

int run_csg(const Options& options, const Context& context) {
  const Clock::time_point start = Clock::now();
  std::vector<std::string> names;
  std::vector<std::string> files;
  for (NamedInput& input : named_inputs(options)) {
    names.push_back(std::move(input.name));
    files.push_back(std::move(input.file));
  }
  const Expression expression = parse_expression(options.expression, names, context);
  std::vector<std::string> warnings;
  const std::vector<Solid> solids = load_operands(files, options, warnings, context);
  const Solid result = Solid::evaluate(expression, solids, context);
  return finish({result.boundary(), options.expression, std::move(warnings), start}, options, context);
}

int run_repair(const Options& options, const Context& context) {
  const Clock::time_point start = Clock::now();
  const std::string& name = options.inputs[0];
  std::vector<std::string> warnings;
  const Input input = read_input(name, options, warnings, context);
  Repaired repaired = repair_input(input, name, context);
  std::vector<std::string> changes = lines_of(repaired.changes);
  if (!repaired.leaf.leaf) {
    for (const RepairChange& refusal : repaired.refusals)
      changes.push_back("left as it was: " + describe(refusal.what, refusal.faces));
    changes.insert(changes.end(), repaired.findings.begin(), repaired.findings.end());
    throw InputError(refusal(name, "cannot be repaired to a solid", changes));
  }
  if (repaired.leaf.diagnosis.crossing_faces.count != 0)
    changes.emplace_back("repaired: faces that cross, by taking the points of positive winding number");
  if (changes.empty() && repaired.findings.empty()) changes.emplace_back("there was nothing to repair");
  warnings.insert(warnings.end(), changes.begin(), changes.end());
  for (const std::string& line : repaired.findings) warnings.push_back(shown(name) + ": " + line);
  const Json details{{"repairs", as_json(repaired.changes)}, {"diagnosis", as_json(repaired.leaf.diagnosis)}};
  const Solid result = solid_of_leaf(input, std::move(repaired.leaf.leaf), context);
  return finish({result.boundary(), title_of(name), std::move(warnings), start, details}, options, context);
}

int run_convert(const Options& options, const Context& context) {
  const Clock::time_point start = Clock::now();
  std::vector<std::string> warnings;
  const std::shared_ptr<const Brep> boundary = load_boundary(options.inputs[0], options, warnings, context);
  return finish({*boundary, title_of(options.inputs[0]), std::move(warnings), start}, options, context);
}

int run_view(const Options& options, const Context& context) {
  Options with_page = options;
  if (with_page.outputs.empty()) {
    with_page.outputs.push_back(title_of(options.inputs[0]) + ".html");
    require_known_targets(with_page);
  }
  const int code = run_convert(with_page, context);
  if (options.quiet || options.json) return code;
  for (const Target& target : targets_of(with_page)) {
    if (target.kind == Target::Kind::page && !target.is_stream())
      report_stream(with_page) << "open " << target.name << " in a browser\n";
  }
  return code;
}

}  // namespace quoin::cli
