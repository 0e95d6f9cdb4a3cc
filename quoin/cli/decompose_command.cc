// SPDX-License-Identifier: Apache-2.0
#include <filesystem>

#include "quoin/base/error.h"
#include "quoin/cli/commands.h"
#include "quoin/cli/failure.h"
#include "quoin/cli/inputs.h"
#include "quoin/cli/outputs.h"
#include "quoin/cli/planar.h"
#include "quoin/cli/reporting.h"
#include "quoin/cli/streams.h"
#include "quoin/cli/summary.h"
#include "quoin/cli/targets.h"
#include "quoin/polytope/decomposition.h"
#include "quoin/solid/measure.h"
#include "quoin/solid/placement.h"

namespace quoin::cli {

namespace {

using Json = nlohmann::ordered_json;

/// "part.stl", 3 -> "part-3.stl"
std::string numbered(const std::string& name, std::size_t number) {
  const std::filesystem::path path(name);
  return (path.parent_path() / (path.stem().string() + "-" + std::to_string(number) + path.extension().string()))
      .string();
}

Options with_output(const Options& options, const std::string& name) {
  Options one = options;
  one.outputs = {name};
  return one;
}

/// Every piece moved away from the centre of all by a quarter of its distance: convex pieces without common insides
/// come apart.
Solid exploded(const ConvexDecomposition& d, const Brep& whole, const Context& context) {
  const RationalPoint3 centre = *centroid(whole, context);
  std::vector<Solid> moved;
  for (std::size_t i = 0; i < d.pieces.size(); ++i) {
    const RationalPoint3 own = *centroid(d.pieces[i].boundary(), context);
    auto leaf = std::make_shared<Leaf>(
        *translated(*leaf_of(d.pieces[i], "piece", context), (own - centre) * (Rational(1) / Rational(4)), context));
    leaf->name = "piece " + std::to_string(i + 1);
    moved.push_back(Solid::of_leaf(std::move(leaf)));
  }
  return unite(moved, context);
}

Json as_json(const ConvexDecomposition& d, const Context& context) {
  Json json{{"pieces", d.pieces.size()}, {"lower_bound", d.lower_bound}, {"notches", d.notches}, {"cuts", d.cuts}};
  Json volumes = Json::array();
  for (const Solid& piece : d.pieces) volumes.push_back(rounded_volume(piece.boundary(), context));
  json["volumes"] = volumes;
  return json;
}

/// What became of the files of all pieces.
struct Written {
  std::vector<std::string> files;
  std::vector<std::string> notes;
  std::string refusals;
};

void write_one(const Brep& boundary, const std::string& name, const Options& options, Written& written,
               const Context& context) {
  const OutputReport report = write_outputs(boundary, title_of(name), with_output(options, name), context);
  written.notes.insert(written.notes.end(), report.notes.begin(), report.notes.end());
  for (const std::string& refusal : report.refusals) written.refusals += refusal + "\n  ";
  if (report.refusals.empty()) written.files.push_back(name);
}

Written write_pieces(const ConvexDecomposition& d, const Brep& whole, const Options& options, const Context& context) {
  Written written;
  for (const Target& target : targets_of(options)) {
    if (target.kind == Target::Kind::page) {
      if (!d.pieces.empty()) write_one(exploded(d, whole, context).boundary(), target.name, options, written, context);
      continue;
    }
    for (std::size_t i = 0; i < d.pieces.size(); ++i)
      write_one(d.pieces[i].boundary(), numbered(target.name, i + 1), options, written, context);
  }
  return written;
}

}  // namespace

int run_decomposition(const Options& options, const Context& context) {
  for (const Target& target : targets_of(options)) {
    if (target.is_stream()) throw UsageError("pieces are written to a file each, not to standard output");
  }
  const Clock::time_point start = Clock::now();
  std::vector<std::string> warnings;
  const Solid operand = load_operand(options.inputs[0], options, warnings, context);
  const Solid solid = Solid::evaluate(Expression::leaf(0), {&operand, 1}, context);
  const ConvexDecomposition d = convex_decomposition(solid, context);
  Json report{{"seconds", seconds_since(start)}};
  report.update(as_json(d, context));
  const Written written = write_pieces(d, solid.boundary(), options, context);
  warnings.insert(warnings.end(), written.notes.begin(), written.notes.end());
  report["outputs"] = written.files;
  if (!written.refusals.empty())
    throw InputError(written.refusals + "not written: --accept-rounding takes them as they are");
  Json without_volumes = report;
  without_volumes.erase("volumes");
  const std::string text = as_text(without_volumes);
  print_report(std::move(report), text, warnings, options);
  return 0;
}

}  // namespace quoin::cli
