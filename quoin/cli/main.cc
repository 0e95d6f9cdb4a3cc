// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <iostream>
#include <map>

#include "quoin/cli/arguments.h"
#include "quoin/cli/commands.h"
#include "quoin/cli/failure.h"
#include "quoin/cli/forced_end.h"
#include "quoin/cli/interruption.h"
#include "quoin/cli/memory_watch.h"
#include "quoin/cli/streams.h"
#include "quoin/cli/targets.h"

namespace quoin::cli {
namespace {

ContextOptions context_options(const Options& options) {
  ContextOptions result;
  result.threads = options.threads;
  result.seed = options.seed;
  if (options.timeout)
    result.timeout = std::chrono::milliseconds(static_cast<std::int64_t>(std::min(*options.timeout, 1e9) * 1000));
  result.progress = progress_printer(options);
  return result;
}

/// What is on the terminal is erased first: it may be progress.
LastWords last_words(const char* message, const Options& options) {
  LastWords words = words_of({message, exit_cancelled}, options);
  if (progress_goes_to_terminal(options)) words.error.insert(0, erasing_line);
  return words;
}

int run(const Options& options) {
  require_single_use_of_streams(options);
  require_known_targets(options);
  Context context(context_options(options));
  const InterruptionGuard guard(context);
  prepare_forced_end({.interrupted = last_words("cancelled", options),
                      .out_of_time = last_words("out of time", options),
                      .seconds = options.timeout,
                      .exit_code = exit_cancelled});
  const MemoryWatch watch(context, options.memory);
  using Run = int (*)(const Options&, const Context&);
  static const std::map<std::string, Run> runs{{"union", run_boolean},
                                               {"intersection", run_boolean},
                                               {"difference", run_boolean},
                                               {"xor", run_boolean},
                                               {"csg", run_csg},
                                               {"info", run_info},
                                               {"check", run_check},
                                               {"repair", run_repair},
                                               {"convert", run_convert},
                                               {"view", run_view},
                                               {"arrange", run_arrange},
                                               {"overlay", run_overlay},
                                               {"locate", run_locate},
                                               {"polygon", run_polygon},
                                               {"envelope", run_envelope},
                                               {"classify", run_classify},
                                               {"section", run_section},
                                               {"interfere", run_interfere},
                                               {"hull", run_hull},
                                               {"minkowski", run_minkowski_sum},
                                               {"erode", run_erosion},
                                               {"decompose", run_decomposition},
                                               {"distance", run_distance},
                                               {"width", run_width},
                                               {"gaussian-map", run_gaussian_map},
                                               {"assembly", run_assembly},
                                               {"homology", run_homology},
                                               {"persistence", run_persistence},
                                               {"delaunay", run_delaunay},
                                               {"constrained", run_constrained},
                                               {"voronoi", run_voronoi},
                                               {"alpha", run_alpha},
                                               {"flow", run_flow}};
  return runs.at(options.command)(options, context);
}

int main_with_failures(int argc, char** argv) {
  Options options;
  try {
    const std::optional<int> nothing_to_run = parse_arguments(argc, argv, options);
    const int code = nothing_to_run ? *nothing_to_run : run(options);
    end_in_order();
    flush_standard_output();
    return code;
  } catch (...) {
    end_in_order();
    const Failure failure = current_failure();
    print_failure(failure, options);
    std::cout.flush();
    return failure.exit_code;
  }
}

}  // namespace
}  // namespace quoin::cli

int main(int argc, char** argv) {
  return quoin::cli::main_with_failures(argc, argv);
}
