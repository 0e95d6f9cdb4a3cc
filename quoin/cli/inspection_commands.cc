// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "quoin/cli/commands.h"
#include "quoin/cli/diagnosis.h"
#include "quoin/cli/failure.h"
#include "quoin/cli/inputs.h"
#include "quoin/cli/streams.h"
#include "quoin/cli/summary.h"
#include "quoin/solid/check.h"

namespace quoin::cli {

namespace {

using Json = nlohmann::ordered_json;

// What is known about one file; `json` holds it, and more than the text says.
struct Inspection {
  explicit Inspection(const std::string& name) { json["file"] = name; }

  Json json;
  std::string text;
  std::vector<std::string> warnings;
  int exit_code = 0;
  std::string error;  // of an input that is refused
};

void refuse(Inspection& inspection, const Failure& failure) {
  inspection.error = failure.message;
  inspection.exit_code = failure.exit_code;
  inspection.json.update(as_json(failure));
}

void print_text(const Inspection& inspection, const Options& options) {
  print_warnings(inspection.warnings, options);
  if (!options.quiet) report_stream(options) << inspection.text << std::flush;
  if (!inspection.error.empty()) note_stream() << "quoin: " << inspection.error << "\n";
}

// Goes on to the next file after one that is refused or cannot be read; the exit code is the greatest of all.
template <class Inspect>
int inspect_all(const Inspect& inspect, const Options& options, const Context& context) {
  int exit_code = 0;
  Json all = Json::array();
  for (const std::string& name : options.inputs) {
    Inspection one(name);
    try {
      inspect(name, one);
    } catch (...) {
      refuse(one, current_failure());
    }
    one.json["warnings"] = one.warnings;
    exit_code = std::max(exit_code, one.exit_code);
    if (!options.json) print_text(one, options);
    if (options.json && !one.error.empty()) note_stream() << "quoin: " << one.error << "\n";
    all.push_back(std::move(one.json));
    if (context.is_cancelled()) break;
  }
  if (options.json) print_json(options.inputs.size() == 1 ? all[0] : all, options);
  return exit_code;
}

void inform(const std::string& name, Inspection& result, const Options& options, const Context& context) {
  Input input = read_input(name, options, result.warnings, context);
  const LeafResult leaf = make_leaf(input, name, context);
  const std::vector<std::string> findings = describe(input, leaf.diagnosis);
  Brep* exact = std::get_if<Brep>(&input);
  Json summary;
  if (!leaf.leaf) {
    summary = exact != nullptr ? summarize_surface(*exact, context)
                               : summarize_surface(std::get<Mesh>(input), leaf.diagnosis);
    summary["centroid"] = nullptr;
  } else {
    for (const std::string& line : findings) result.warnings.push_back(shown(name) + ": " + line);
    if (leaf.leaf->tiles.empty()) result.warnings.push_back(shown(name) + ": " + no_faces);
    const Solid solid = exact != nullptr ? Solid() : Solid::from_leaf(leaf.leaf, context);
    const Brep& boundary = exact != nullptr ? *exact : solid.boundary();
    summary = summarize(boundary, context);
    summary["centroid"] = summarize_centroid(boundary, context);
  }
  result.json.update(summary);
  result.text = as_text(result.json);
  if (leaf.leaf) return;
  result.json["diagnosis"] = as_json(leaf.diagnosis);
  refuse(result, {refusal(name, "does not bound a solid", findings), exit_refused});
}

// What the independent check or the diagnosis of a mesh finds; whether the file bounds a solid as it is.
bool find_faults(const std::string& name, Inspection& result, std::vector<std::string>& findings,
                 const Options& options, const Context& context) {
  const Input input = read_input(name, options, result.warnings, context);
  const LeafResult leaf = make_leaf(input, name, context);
  result.json["diagnosis"] = as_json(leaf.diagnosis);
  if (const Brep* exact = std::get_if<Brep>(&input)) {
    findings = check_boundary(*exact, 20, context);
    return findings.empty();
  }
  findings = describe(leaf.diagnosis);
  if (leaf.leaf && leaf.leaf->tiles.empty()) findings.emplace_back(no_faces);
  return leaf.leaf && leaf.diagnosis.crossing_faces.count == 0 && leaf.diagnosis.inverted_components.count == 0;
}

void verify(const std::string& name, Inspection& result, const Options& options, const Context& context) {
  std::vector<std::string> findings;
  result.json["valid"] = false;
  result.json["findings"] = Json::array();
  const bool valid = find_faults(name, result, findings, options, context);
  result.json["valid"] = valid;
  result.json["findings"] = findings;
  result.text = name + ": " + (valid ? "a valid solid" : "not a valid solid") + "\n";
  for (const std::string& finding : findings) result.text += "  " + finding + "\n";
  result.exit_code = valid ? 0 : exit_refused;
}

}  // namespace

int run_info(const Options& options, const Context& context) {
  return inspect_all([&](const std::string& name, Inspection& result) { inform(name, result, options, context); },
                     options, context);
}

int run_check(const Options& options, const Context& context) {
  return inspect_all([&](const std::string& name, Inspection& result) { verify(name, result, options, context); },
                     options, context);
}

}  // namespace quoin::cli
