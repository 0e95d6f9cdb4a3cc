// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/reporting.h"

#include <filesystem>

#include "quoin/cli/failure.h"
#include "quoin/cli/inputs.h"
#include "quoin/cli/outputs.h"
#include "quoin/cli/streams.h"
#include "quoin/cli/summary.h"

namespace quoin::cli {

namespace {

using Json = nlohmann::ordered_json;

const char* name_of(Rounding rounding, bool accepted) {
  if (rounding == Rounding::exact) return "exact";
  return rounding == Rounding::certified ? "certified" : accepted ? "accepted" : "failed";
}

// The summary of what the files hold: the exact boundary, or what snapping made of it.
Json summary_of_result(const Brep& boundary, const OutputReport& output, const Context& context) {
  if (!output.resolved) return summarize(boundary, context);
  Json summary = summarize(*output.resolved, context);
  summary["inputs"] = boundary.leaf_names;
  return summary;
}

void print_report(const Made& made, const OutputReport& output, Json json, const Failure* failure,
                  const Options& options, const Context& context) {
  if (options.json) {
    if (!output.topology_changes.empty())
      json["topology_changes"] = as_json(output.topology_changes, made.boundary, context);
    json["warnings"] = made.warnings;
    json["result"] = summary_of_result(made.boundary, output, context);
    json.update(made.details);
    if (failure != nullptr) json.update(as_json(*failure));
    print_json(json, options);
    return;
  }
  if (!options.quiet) {
    std::string text = as_text(json);
    if (options.verbose || options.outputs.empty()) text += as_text(summary_of_result(made.boundary, output, context));
    report_stream(options) << text;
  }
  print_warnings(made.warnings, options);
}

}  // namespace

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::string title_of(const std::string& input) {
  return input == standard_stream ? "input" : std::filesystem::path(input).stem().string();
}

int finish(Made made, const Options& options, const Context& context) {
  if (made.boundary.face_count() == 0)
    made.warnings.emplace_back(made.boundary.is_unbounded ? "the result is all of space" : "the result is empty");
  const OutputReport output = write_outputs(made.boundary, made.title, options, context);
  made.warnings.insert(made.warnings.end(), output.notes.begin(), output.notes.end());
  Json json;
  json["seconds"] = seconds_since(made.start);
  json["threads"] = context.threads();
  json["rounding"] = name_of(output.rounding, options.accept_rounding);
  json["max_displacement"] = output.max_displacement;
  json["rounding_rounds"] = output.rounds;
  json["outputs"] = options.outputs;
  if (output.refusals.empty()) {
    print_report(made, output, std::move(json), nullptr, options, context);
    return 0;
  }
  Failure failure;
  for (const std::string& refusal : output.refusals) failure.message += refusal + "\n  ";
  failure.message += "not written: --accept-rounding takes the file as it is, .qsolid holds the exact solid";
  print_report(made, output, std::move(json), &failure, options, context);
  if (!options.json || !data_goes_to_standard_output(options)) note_stream() << "quoin: " << failure.message << "\n";
  return failure.exit_code;
}

}  // namespace quoin::cli
