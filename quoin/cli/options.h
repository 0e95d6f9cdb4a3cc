// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace quoin::cli {

/// The name that stands for standard input or standard output.
inline constexpr const char* standard_stream = "-";

/// What all commands understand.
struct Options {
  std::string command;
  std::vector<std::string> inputs;   ///< files, or "-" for standard input; of `csg`: NAME=FILE
  std::vector<std::string> outputs;  ///< files with a known ending, "-" for standard output
  std::string format;                ///< of "-" among the outputs: an ending without its dot; empty: OFF
  std::string expression;            ///< of `csg`
  std::vector<std::string> points;   ///< of `classify`: "x,y,z"
  std::vector<std::string> lines;    ///< of `classify`: "x,y,z,dx,dy,dz"
  std::string points_file;           ///< of `classify`: a point per line, "-" for standard input
  std::string plane;                 ///< of `section`: "a,b,c,d"
  bool json = false;
  bool quiet = false;
  bool verbose = false;
  bool accept_rounding = false;
  unsigned threads = 0;
  std::uint64_t seed = 0;
  std::optional<double> timeout;  ///< seconds
  std::optional<double> weld_tolerance;
};

}  // namespace quoin::cli
