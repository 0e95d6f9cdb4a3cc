// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/command_options.h"

#include <cstdint>
#include <limits>

#include "quoin/cli/number_options.h"

namespace quoin::cli {

namespace {

void add_common(CLI::App& command, Options& options) {
  command.add_flag("--json", options.json, "report as JSON, errors too");
  const auto set_threads = [&options](std::uint64_t number) { options.threads = static_cast<unsigned>(number); };
  add_whole_number(command, "--threads", set_threads, 0, std::numeric_limits<unsigned>::max(),
                   "threads to use (default: all)");
  add_number(command, "--timeout", options.timeout, above_zero, "give up after this many seconds");
  const auto set_seed = [&options](std::uint64_t number) { options.seed = number; };
  add_whole_number(command, "--seed", set_seed, 0, std::numeric_limits<std::uint64_t>::max(),
                   "for algorithms that draw random numbers");
  add_number(command, "--weld", options.weld_tolerance, from_zero,
             "weld vertices within this distance (default: equal ones only)");
  command.add_flag("-q,--quiet", options.quiet, "no report, no warnings");
  command.add_flag("-v,--verbose", options.verbose, "the whole summary, and stages as they begin");
}

}  // namespace

CLI::App* add_command(CLI::App& app, Options& options, const char* name, const char* text) {
  CLI::App* command = app.add_subcommand(name, text);
  add_common(*command, options);
  command->callback([&options, name] { options.command = name; });
  return command;
}

CLI::Option* add_repeatable(CLI::App& command, const std::string& names, std::vector<std::string>& values,
                            const std::string& text) {
  return command.add_option(names, values, text)->allow_extra_args(false);
}

}  // namespace quoin::cli
