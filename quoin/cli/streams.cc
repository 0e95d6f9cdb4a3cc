// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/streams.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <iostream>

#include "quoin/base/error.h"
#include "quoin/cli/polled_output.h"

namespace quoin::cli {

namespace {

bool progress_is_shown = false;  // the last line of the terminal is one of progress

void erase_progress() {
  if (!progress_is_shown) return;
  std::cerr << erasing_line << std::flush;
  progress_is_shown = false;
}

std::string described(std::string_view stage, double done) {
  std::string text = "quoin: " + std::string(stage);
  if (done > 0) text += " " + std::to_string(std::lround(100 * std::min(done, 1.0))) + " %";
  return text;
}

void print_on_terminal(std::string_view stage, double done) {
  static std::string shown;
  const std::string text = described(stage, done);
  if (progress_is_shown && text == shown) return;
  std::cerr << "\r" << text << "\x1b[K" << std::flush;
  shown = text;
  progress_is_shown = true;
}

void print_as_lines(std::string_view stage, double) {
  static std::string shown;
  if (stage == shown) return;
  shown = stage;
  std::cerr << "quoin: " << stage << std::endl;
}

}  // namespace

bool data_goes_to_standard_output(const Options& options) {
  return std::find(options.outputs.begin(), options.outputs.end(), standard_stream) != options.outputs.end();
}

std::ostream& data_stream() {
  erase_progress();
  return std::cout;
}

std::ostream& report_stream(const Options& options) {
  erase_progress();
  return data_goes_to_standard_output(options) ? std::cerr : std::cout;
}

std::ostream& note_stream() {
  erase_progress();
  return std::cerr;
}

std::string printable(std::string text) {
  std::ranges::replace_if(
      text, [](unsigned char c) { return (c < 0x20 && c != '\n' && c != '\t') || c == 0x7F; }, '?');
  return text;
}

void print_json(const nlohmann::ordered_json& json, const Options& options) {
  using Json = nlohmann::ordered_json;
  std::ostream& report = report_stream(options);
  PolledBuffer buffer(report);
  std::ostream out(&buffer);
  out.exceptions(std::ios::badbit);  // what ends it is not swallowed
  nlohmann::detail::serializer<Json> serializer(nlohmann::detail::output_adapter<char>(out), ' ',
                                                Json::error_handler_t::replace);  // names of files may be any bytes
  serializer.dump(json, true, false, 2);
  report << "\n";
}

void flush_standard_output() {
  errno = 0;
  if (std::cout.flush()) return;
  throw FileError(std::string("standard output: writing failed") +
                  (errno != 0 ? std::string(": ") + std::strerror(errno) : ""));
}

bool progress_goes_to_terminal(const Options& options) {
  return !options.quiet && isatty(STDERR_FILENO) != 0;
}

std::function<void(std::string_view stage, double done)> progress_printer(const Options& options) {
  if (progress_goes_to_terminal(options)) return &print_on_terminal;
  if (options.verbose && !options.quiet) return &print_as_lines;
  return {};
}

}  // namespace quoin::cli
