// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>
#include <CLI/CLI.hpp>
#include <cmath>
#include <csignal>
#include <iostream>
#include <map>

#include "quoin/base/error.h"
#include "quoin/cli/commands.h"

namespace quoin::cli {
namespace {

constexpr int exit_refused = 1;
constexpr int exit_usage = 2;
constexpr int exit_file = 3;
constexpr int exit_cancelled = 4;

std::atomic<Context*> running{nullptr};

void cancel_running(int) {
  if (Context* context = running.load()) context->cancel();
}

void add_common(CLI::App& command, Options& options, bool writes) {
  if (writes) {
    command.add_option(
        "-o,--output", options.outputs,
        "file to write, format by its ending: off obj stl ply (rounded, certified), html (a page to look at), "
        "qsolid (exact); '-' for OFF on standard output; may be repeated");
    command.add_flag("--accept-rounding", options.accept_rounding,
                     "write a mesh even where rounding makes faces cross, or parts vanish or fuse");
  }
  command.add_flag("--json", options.json, "report as JSON");
  command.add_option("--threads", options.threads, "threads to use (default: all)");
  command.add_option("--timeout", options.timeout, "give up after this many seconds")->check(CLI::PositiveNumber);
  command.add_option("--seed", options.seed, "for algorithms that draw random numbers");
  command.add_option("--weld", options.weld_tolerance, "weld vertices within this distance (default: equal ones only)");
  command.add_flag("-q,--quiet", options.quiet, "no report, no warnings");
  command.add_flag("-v,--verbose", options.verbose, "the whole summary, and stages as they begin");
}

ContextOptions context_options(const Options& options) {
  ContextOptions result;
  result.threads = options.threads;
  result.seed = options.seed;
  if (options.timeout)
    result.timeout = std::chrono::milliseconds(static_cast<std::int64_t>(std::min(*options.timeout, 1e9) * 1000));
  if (!options.quiet && (options.verbose || isatty(STDERR_FILENO) != 0)) {
    result.progress = [](std::string_view stage, double) {
      std::cerr << "\rquoin: " << stage << "\x1b[K" << std::flush;
    };
  }
  return result;
}

int run(const std::string& command, const Options& options) {
  Context context(context_options(options));
  running = &context;
  struct sigaction action {};
  action.sa_handler = &cancel_running;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  using Run = int (*)(const Options&, const Context&);
  static const std::map<std::string, Run> runs{
      {"csg", run_csg},           {"info", run_info},       {"check", run_check},
      {"repair", run_repair},     {"convert", run_convert}, {"view", run_view},
      {"classify", run_classify}, {"section", run_section}, {"interfere", run_interfere}};
  const auto found = runs.find(command);
  const int code = found == runs.end() ? run_boolean(command, options, context) : found->second(options, context);
  running = nullptr;
  return code;
}

void add_queries(CLI::App& app, Options& options) {
  CLI::App* classify = app.add_subcommand("classify", "where points and lines lie: in, out, on a face, edge or vertex");
  add_common(*classify, options, false);
  classify->add_option("file", options.inputs, "a mesh or .qsolid")->required()->expected(1);
  classify->add_option("--point", options.points, "x,y,z (may be repeated)");
  classify->add_option("--points", options.points_file, "file with a point per line; '-' for standard input");
  classify->add_option("--line", options.lines, "x,y,z,dx,dy,dz: a point of it and its direction (may be repeated)");
  CLI::App* section = app.add_subcommand("section", "what a plane cuts out of a solid, exactly");
  add_common(*section, options, false);
  section->add_option("file", options.inputs, "a mesh or .qsolid")->required()->expected(1);
  section
      ->add_option("--plane", options.plane,
                   "a,b,c,d: the points with a x + b y + c z = d; seen from where (a,b,c) points")
      ->required();
  section->add_option("-o,--output", options.outputs, "SVG drawing to write; '-' for standard output; may be repeated");
  CLI::App* interfere = app.add_subcommand("interfere", "whether solids overlap, touch or stay apart, pair by pair");
  add_common(*interfere, options, false);
  interfere->add_option("files", options.inputs, "two or more meshes")->required()->expected(2, 1 << 20);
}

void add_commands(CLI::App& app, Options& options) {
  const auto add = [&](const char* name, const char* text, bool writes) {
    CLI::App* command = app.add_subcommand(name, text);
    add_common(*command, options, writes);
    return command;
  };
  for (const auto& [name, text] : {std::pair{"union", "the points in any of the solids"},
                                   {"intersection", "the points in all of the solids"},
                                   {"difference", "the points of the first solid in none of the others"},
                                   {"xor", "the points in an odd number of the solids"}}) {
    add(name, text, true)
        ->add_option("files", options.inputs, "meshes that bound solids; '-' for standard input")
        ->required();
  }
  CLI::App* csg = add("csg", "any expression: quoin csg 'a - (b | c)' a=x.stl b=y.off c=z.ply -o result.stl", true);
  csg->add_option("expression", options.expression, "| union, - difference, & intersection, ^ xor, ! complement, ( )")
      ->required();
  csg->add_option("operands", options.inputs, "NAME=FILE for each name")->required();
  add("info", "what a solid is: volume, area, counts, bounds", false)->add_option("files", options.inputs)->required();
  add("check", "whether files bound valid solids, and what is wrong if not", false)
      ->add_option("files", options.inputs)
      ->required();
  add("repair", "orientation, duplicate and degenerate faces, self-crossings", true)
      ->add_option("file", options.inputs)
      ->required()
      ->expected(1);
  add("convert", "one format to another, faces merged where coplanar", true)
      ->add_option("file", options.inputs)
      ->required()
      ->expected(1);
  add("view", "a page to look at a solid in the browser", true)
      ->add_option("file", options.inputs)
      ->required()
      ->expected(1);
  add_queries(app, options);
}

int main_with_exceptions(int argc, char** argv) {
  CLI::App app(
      "Quoin: exact Booleans of solids.\n\nExit codes: 0 done, 1 refused with a reason, 2 usage, 3 file trouble, 4 "
      "cancelled or out of time.");
  app.name("quoin");
  app.set_version_flag("--version", "quoin " QUOIN_VERSION);
  app.require_subcommand(1);
  Options options;
  add_commands(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : exit_usage;
  }
  return run(app.get_subcommands().front()->get_name(), options);
}

int guarded_main(int argc, char** argv) {
  try {
    return main_with_exceptions(argc, argv);
  } catch (const Cancelled& error) {
    std::cerr << "quoin: " << error.what() << "\n";
    return exit_cancelled;
  } catch (const FileError& error) {
    std::cerr << "quoin: " << error.what() << "\n";
    return exit_file;
  } catch (const std::bad_alloc&) {
    std::cerr << "quoin: out of memory\n";
    return exit_refused;
  } catch (const std::exception& error) {
    std::cerr << "quoin: " << error.what() << "\n";
    return exit_refused;
  }
}

}  // namespace
}  // namespace quoin::cli

int main(int argc, char** argv) {
  return quoin::cli::guarded_main(argc, argv);
}
