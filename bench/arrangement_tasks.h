// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

#include "arrangement_input.h"
#include "peak_memory.h"
#include "quoin/arrangement/cells/dcel.h"
#include "quoin/base/context.h"

/// Operations that arrangement_bench times.
namespace bench {

using arrangement_input::Input;

struct Task {
  std::string mode;
  std::string strategy;  ///< of `locate`: ric (trapezoidal map) or landmarks (grid)
  std::vector<std::string> files;
  int rounds = 1;
  unsigned threads = 1;
};

inline quoin::ContextOptions context_options(const Task& task) {
  quoin::ContextOptions options;
  options.threads = task.threads;
  return options;
}

/// Least wall and processor time of several rounds.
class Best {
 public:
  void start() {
    begin_ = std::chrono::steady_clock::now();
    cpu_begin_ = std::clock();
  }
  void stop() {
    seconds_ = std::min(seconds_, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count());
    cpu_seconds_ = std::min(cpu_seconds_, static_cast<double>(std::clock() - cpu_begin_) / CLOCKS_PER_SEC);
  }
  double seconds() const { return seconds_; }
  double cpu_seconds() const { return cpu_seconds_; }

 private:
  std::chrono::steady_clock::time_point begin_;
  std::clock_t cpu_begin_ = 0;
  double seconds_ = 1e300;
  double cpu_seconds_ = 1e300;
};

inline std::string member(const char* name, double value) {
  char text[80];
  std::snprintf(text, sizeof text, ", \"%s\": %.17g", name, value);
  return text;
}

inline void report(const Best& best, std::size_t vertices, std::size_t edges, std::size_t faces,
                   const std::string& more = {}) {
  std::printf(
      "{\"seconds\": %.9f, \"cpu_seconds\": %.9f, \"vertices\": %zu, \"edges\": %zu, \"faces\": %zu, "
      "\"peak_kb\": %ld%s}\n",
      best.seconds(), best.cpu_seconds(), vertices, edges, faces, peak_kb(), more.c_str());
}

inline void report(const Best& best, const quoin::dcel::Counts& counts, const std::string& more = {}) {
  report(best, counts.vertices, counts.edges, counts.faces, more);
}

void arrange(const Task& task);
void overlay(const Task& task);
void unite(const Task& task);
void locate(const Task& task);
void minkowski(const Task& task);

}  // namespace bench
