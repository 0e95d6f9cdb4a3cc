// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "quoin/assembly/assembly.h"
#include "quoin/base/error.h"
#include "quoin/cli/assembly_inputs.h"
#include "quoin/cli/assembly_page.h"
#include "quoin/cli/assembly_report.h"
#include "quoin/cli/commands.h"
#include "quoin/cli/coordinates.h"
#include "quoin/cli/failure.h"
#include "quoin/cli/planar.h"
#include "quoin/cli/streams.h"
#include "quoin/cli/target_writing.h"
#include "quoin/cli/targets.h"

namespace quoin::cli {

namespace {

using Json = nlohmann::ordered_json;

constexpr double sums_announced = 1e5;
constexpr double seconds_of_a_sum = 5e-5;
constexpr double crossings_announced = 2e5;
constexpr double crossings_refused = 2e8;

std::string short_number(double value) {
  const double rounded = std::round(value * 10) / 10;
  return Json(rounded).dump();
}

/// Says what is about to be computed, if it is much.
std::function<void(const MotionEstimate&)> announcer(const Options& options) {
  return [&options](const MotionEstimate& estimate) {
    if (estimate.crossings < crossings_announced) return;
    const std::string size = "the motion space of " + std::to_string(estimate.regions) + " regions with " +
                             std::to_string(estimate.arcs) + " arcs has about " +
                             short_number(estimate.crossings / 1e6) + " million vertices";
    if (estimate.crossings > crossings_refused) {
      throw InputError(
          size +
          ": too many; try --prune, or ask for the sequence only (--sequence-only), for what can begin to move "
          "(--infinitesimal), or for some directions (--direction)");
    }
    if (options.quiet) return;
    note_stream() << "quoin: " << size << ": about " << short_number(estimate.seconds) << " s and "
                  << short_number(estimate.bytes / 1e9) << " GB; interrupt it, or give --timeout, to stop\n";
  };
}

/// The same of the sums of pieces, which come first.
void announce_sums(const std::vector<AssemblyPart>& parts, const Options& options) {
  double sums = 0;
  double before = 0;
  for (const AssemblyPart& part : parts) {
    sums += before * static_cast<double>(part.pieces.size());
    before += static_cast<double>(part.pieces.size());
  }
  if (sums < sums_announced || options.quiet) return;
  note_stream() << "quoin: " << short_number(sums / 1e6) << " million sums of pieces: about "
                << short_number(sums * seconds_of_a_sum) << " s; interrupt it, or give --timeout, to stop\n";
}

std::uint32_t part_named(const std::string& name, const std::vector<AssemblyPart>& parts) {
  for (std::uint32_t p = 0; p < parts.size(); ++p) {
    if (parts[p].name == name) return p;
  }
  throw InputError("--base " + name + ": no part has that name");
}

SphereDirection direction_of(const std::string& text) {
  const std::vector<Rational> numbers = parse_argument(text, 3, "--direction", 0);
  return SphereDirection(std::array{numbers[0], numbers[1], numbers[2]}).primitive();
}

AssemblyQuestion question_of(const Options& options, const std::vector<AssemblyPart>& parts) {
  AssemblyQuestion question;
  const bool has_limits = !options.directions.empty() || options.one_part || !options.base.empty();
  question.sequence = options.sequence || options.sequence_only || has_limits;
  question.solutions = !options.infinitesimal && !options.sequence_only && options.directions.empty();
  question.infinitesimal = !options.sequence_only && options.directions.empty();
  question.partition.announce = announcer(options);
  question.partition.prune = options.prune;
  question.partition.max_solutions = options.limit;
  question.disassembly.announce = announcer(options);
  question.disassembly.one_part_at_a_time = options.one_part;
  for (const std::string& text : options.directions) question.disassembly.directions.push_back(direction_of(text));
  if (!options.base.empty()) question.disassembly.base = part_named(options.base, parts);
  return question;
}

void warn_of_limit(const Partition& found, const std::string& what, std::vector<std::string>& warnings) {
  if (found.has_all) return;
  warnings.push_back("not all " + what + " are listed, only " + std::to_string(found.solution_count) +
                     "; --limit sets how many");
}

}  // namespace

int run_assembly(const Options& options, const Context& context) {
  std::vector<std::string> warnings;
  for (const std::string& text : options.directions) direction_of(text);
  const std::vector<AssemblyPart> parts = read_parts(options, warnings, context);
  announce_sums(parts, options);
  const AssemblyPlan plan = analyse_assembly(parts, question_of(options, parts), context);
  if (plan.partition) warn_of_limit(*plan.partition, "solutions", warnings);
  if (plan.infinitesimal) warn_of_limit(plan.infinitesimal->partition, "sets that can begin to move", warnings);
  Json report = assembly_report(parts, plan);
  for (const Target& target : targets_of(options)) {
    if (target.kind == Target::Kind::report) {
      write_target(target, [&](std::ostream& out) { out << report.dump(2) << "\n"; });
    } else {
      write_assembly_page(parts, plan, target, options, context);
    }
  }
  print_report(std::move(report), assembly_text(parts, plan), warnings, options);
  return 0;
}

}  // namespace quoin::cli
