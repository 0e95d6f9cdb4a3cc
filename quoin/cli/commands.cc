// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/commands.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>

#include "quoin/base/error.h"
#include "quoin/cli/diagnosis.h"
#include "quoin/cli/expression_parser.h"
#include "quoin/cli/inputs.h"
#include "quoin/cli/outputs.h"
#include "quoin/cli/summary.h"
#include "quoin/io/exact_text.h"
#include "quoin/solid/check.h"
#include "quoin/solid/measure.h"
#include "quoin/solid/repair.h"
#include "quoin/solid/solid.h"

namespace quoin::cli {

namespace {

using Clock = std::chrono::steady_clock;
using Json = nlohmann::ordered_json;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

const char* name_of(Rounding rounding, bool accepted) {
  if (rounding == Rounding::exact) return "exact";
  return rounding == Rounding::certified ? "certified" : accepted ? "accepted" : "failed";
}

Json json_of(const Topology& topology) {
  return {{"components", topology.components},
          {"shells", topology.shells},
          {"voids", topology.voids},
          {"manifold", topology.is_manifold},
          {"handles", topology.handles}};
}

// By how much rounding changed the topology, file by file.
Json json_of(const std::vector<TopologyChange>& changes, const Brep& boundary, const Context& context) {
  Json json = Json::array();
  for (const TopologyChange& change : changes) {
    Json before = json_of(change.before);
    Json after = json_of(change.after);
    before["volume"] = rounded_volume(boundary, context);
    after["volume"] = rounded_volume(*change.resolved, context);
    json.push_back({{"file", change.file}, {"before", std::move(before)}, {"after", std::move(after)}});
  }
  return json;
}

// The summary of what the files hold: the exact boundary, or what snapping made of it.
Json summary_of_result(const Brep& boundary, const OutputReport& output, const Context& context) {
  if (!output.resolved) return summarize(boundary, context);
  Json summary = summarize(*output.resolved, context);
  summary["inputs"] = boundary.leaf_names;
  return summary;
}

// The report of a command that made a solid, on standard output, or on standard error where the solid itself goes
// there.
int report(const Brep& boundary, const OutputReport& output, const std::vector<std::string>& warnings, double seconds,
           const Options& options, const Context& context, const Json& details) {
  const bool uses_stdout = std::find(options.outputs.begin(), options.outputs.end(), "-") != options.outputs.end();
  std::ostream& out = uses_stdout ? std::cerr : std::cout;
  Json json;
  json["seconds"] = seconds;
  json["threads"] = context.threads();
  json["rounding"] = name_of(output.rounding, options.accept_rounding);
  json["max_displacement"] = output.max_displacement;
  json["rounding_rounds"] = output.rounds;
  json["outputs"] = options.outputs;
  if (options.json) {
    if (!output.topology_changes.empty())
      json["topology_changes"] = json_of(output.topology_changes, boundary, context);
    json["warnings"] = warnings;
    for (const std::string& note : output.notes) json["warnings"].push_back(note);
    json["result"] = summary_of_result(boundary, output, context);
    json.update(details);
    out << json.dump(2) << "\n";
  } else if (!options.quiet) {
    out << as_text(json);
    if (options.verbose || options.outputs.empty()) out << as_text(summary_of_result(boundary, output, context));
  }
  if (!options.json) print_warnings(warnings, options);
  for (const std::string& note : output.notes) std::cerr << "quoin: " << note << "\n";
  if (output.written) return 0;
  std::cerr << "quoin: not written: --accept-rounding takes the file as it is, .qsolid holds the exact solid\n";
  return 1;
}

int finish(const Brep& boundary, const std::string& title, std::vector<std::string> warnings, Clock::time_point start,
           const Options& options, const Context& context, const Json& details = Json::object()) {
  if (boundary.face_count() == 0) {
    warnings.emplace_back(boundary.is_unbounded ? "the result is all of space" : "the result is empty");
  }
  const OutputReport output = write_outputs(boundary, title, options, context);
  return report(boundary, output, warnings, seconds_since(start), options, context, details);
}

std::string stem(const std::string& name) {
  return name == "-" ? "input" : std::filesystem::path(name).stem().string();
}

}  // namespace

int run_boolean(const std::string& operation, const Options& options, const Context& context) {
  const Clock::time_point start = Clock::now();
  std::vector<std::string> warnings;
  std::vector<Solid> solids;
  for (const std::string& name : options.inputs) solids.push_back(load_operand(name, options, warnings, context));
  Solid result;
  if (operation == "union") {
    result = unite(solids, context);
  } else if (operation == "intersection") {
    result = intersect(solids, context);
  } else if (operation == "xor") {
    result = symmetric_difference(solids, context);
  } else {
    result = subtract(solids[0], std::span(solids).subspan(1), context);
  }
  return finish(result.boundary(), operation, std::move(warnings), start, options, context);
}

int run_csg(const Options& options, const Context& context) {
  const Clock::time_point start = Clock::now();
  std::vector<std::string> warnings;
  std::vector<std::string> names;
  std::vector<Solid> solids;
  for (const std::string& input : options.inputs) {
    const std::size_t equals = input.find('=');
    if (equals == std::string::npos || equals == 0)
      throw InputError("'" + input + "': operands of csg are given as NAME=FILE");
    names.push_back(input.substr(0, equals));
  }
  const Expression expression = parse_expression(options.expression, names);
  for (const std::string& input : options.inputs) {
    solids.push_back(load_operand(input.substr(input.find('=') + 1), options, warnings, context));
  }
  const Solid result = Solid::evaluate(expression, solids, context);
  return finish(result.boundary(), options.expression, std::move(warnings), start, options, context);
}

int run_info(const Options& options, const Context& context) {
  Json all = Json::array();
  for (const std::string& name : options.inputs) {
    std::vector<std::string> warnings;
    Json one;
    one["file"] = name;
    one.update(summarize(*load_boundary(name, options, warnings, context), context));
    if (options.json) {
      one["warnings"] = warnings;
      all.push_back(one);
    } else {
      print_warnings(warnings, options);
      std::cout << as_text(one);
    }
  }
  if (options.json) std::cout << (all.size() == 1 ? all[0] : all).dump(2) << "\n";
  return 0;
}

namespace {

// The verdict on one file.
Json check_file(const std::string& name, const Options& options, const Context& context) {
  std::vector<std::string> findings;
  std::vector<std::string> warnings;
  Json diagnosis;
  bool valid = false;
  if (is_exact_text(name)) {
    const Brep boundary = read_exact_text(read_file(name), name);
    findings = check_boundary(boundary, 20, context);
    valid = findings.empty();
    const LeafResult leaf = make_leaf(boundary, "", {}, context);
    diagnosis = as_json(leaf.diagnosis);
  } else {
    const LeafResult leaf = make_leaf(load_mesh(name, options, warnings, context), {}, context);
    findings = describe(leaf.diagnosis);
    diagnosis = as_json(leaf.diagnosis);
    valid = leaf.leaf != nullptr && leaf.diagnosis.crossing_faces.count == 0 &&
            leaf.diagnosis.inverted_components.count == 0;
    if (leaf.leaf && leaf.leaf->tiles.empty()) findings.push_back(no_faces);
  }
  if (!options.json) print_warnings(warnings, options);
  return {{"file", name}, {"valid", valid}, {"findings", findings}, {"diagnosis", diagnosis}, {"warnings", warnings}};
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

}  // namespace

int run_check(const Options& options, const Context& context) {
  bool all_valid = true;
  Json all = Json::array();
  for (const std::string& name : options.inputs) {
    Json one = check_file(name, options, context);
    const bool valid = one["valid"];
    all_valid = all_valid && valid;
    if (!options.json) {
      std::cout << name << ": " << (valid ? "a valid solid" : "not a valid solid") << "\n";
      for (const std::string finding : one["findings"]) std::cout << "  " << finding << "\n";
    }
    all.push_back(std::move(one));
  }
  if (options.json) std::cout << (all.size() == 1 ? all[0] : all).dump(2) << "\n";
  return all_valid ? 0 : 1;
}

int run_repair(const Options& options, const Context& context) {
  const Clock::time_point start = Clock::now();
  const std::string& name = options.inputs[0];
  std::vector<std::string> warnings;
  const Mesh mesh = load_mesh(name, options, warnings, context);
  const RepairResult repaired = repair_mesh(mesh, context);
  for (const RepairChange& change : repaired.changes)
    warnings.push_back("repaired: " + describe(change.what, change.faces));
  LeafResult leaf = make_leaf(repaired.mesh, {}, context);
  rename_faces(leaf.diagnosis, repaired.source_face);
  if (!leaf.leaf) {
    std::string message = name + ": cannot be repaired to a solid";
    for (const std::string& change : warnings) message += "\n  " + change;
    for (const RepairChange& refusal : repaired.refusals)
      message += "\n  left as it was: " + describe(refusal.what, refusal.faces);
    for (const std::string& line : describe(leaf.diagnosis)) message += "\n  " + line;
    throw InputError(message);
  }
  const Json details{{"repairs", as_json(repaired.changes)}, {"diagnosis", as_json(leaf.diagnosis)}};
  if (leaf.diagnosis.crossing_faces.count != 0)
    warnings.push_back("repaired: faces that cross, by taking the points of positive winding number");
  for (const std::string& line : describe(leaf.diagnosis)) warnings.push_back(name + ": " + line);
  if (warnings.empty()) warnings.push_back("there was nothing to repair");
  const Solid result = Solid::from_leaf(leaf.leaf, context);
  return finish(result.boundary(), stem(name), std::move(warnings), start, options, context, details);
}

int run_convert(const Options& options, const Context& context) {
  const Clock::time_point start = Clock::now();
  std::vector<std::string> warnings;
  const std::shared_ptr<const Brep> boundary = load_boundary(options.inputs[0], options, warnings, context);
  return finish(*boundary, stem(options.inputs[0]), std::move(warnings), start, options, context);
}

int run_view(const Options& options, const Context& context) {
  Options with_page = options;
  if (with_page.outputs.empty()) with_page.outputs.push_back(stem(options.inputs[0]) + ".html");
  const Clock::time_point start = Clock::now();
  std::vector<std::string> warnings;
  const std::shared_ptr<const Brep> boundary = load_boundary(options.inputs[0], options, warnings, context);
  const int code = finish(*boundary, stem(options.inputs[0]), std::move(warnings), start, with_page, context);
  if (!options.quiet && !options.json) std::cout << "open " << with_page.outputs[0] << " in a browser\n";
  return code;
}

}  // namespace quoin::cli
