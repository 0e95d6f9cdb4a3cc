// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "../arrangement_input.h"
#include "../peak_memory.h"

/// What the peers of arrangements share. All numbers are those of a lazy exact kernel.
namespace peer {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using arrangement_input::Input;

/// What is to be done, as on the command line.
struct Task {
  std::string mode;
  std::vector<std::string> files;
  int rounds = 1;
  std::string strategy;  ///< of point location: "ric" or "landmarks"
};

/// The smallest of the times of several rounds, and that of the processor, which other load disturbs less. Kernel
/// objects are made anew for each round, because lazy numbers remember what they have computed.
class Best {
 public:
  void start() {
    start_ = Clock::now();
    cpu_start_ = std::clock();
  }
  void stop() {
    seconds_ = std::min(seconds_, std::chrono::duration<double>(Clock::now() - start_).count());
    cpu_seconds_ = std::min(cpu_seconds_, static_cast<double>(std::clock() - cpu_start_) / CLOCKS_PER_SEC);
  }
  double seconds() const { return seconds_; }
  double cpu_seconds() const { return cpu_seconds_; }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_;
  std::clock_t cpu_start_ = 0;
  double seconds_ = std::numeric_limits<double>::infinity();
  double cpu_seconds_ = std::numeric_limits<double>::infinity();
};

inline Kernel::Point_2 point_at(std::span<const std::int64_t> numbers, std::size_t i) {
  return {static_cast<double>(numbers[2 * i]), static_cast<double>(numbers[2 * i + 1])};
}

inline std::vector<Input> read_all(const Task& task, const char* kind) {
  std::vector<Input> inputs;
  for (const std::string& file : task.files) {
    inputs.push_back(arrangement_input::read(file));
    if (inputs.back().kind != kind) throw std::runtime_error(file + " is not a file of " + kind);
  }
  return inputs;
}

/// `rest` is further members, each with a comma in front.
template <class Arrangement>
void report(const Best& best, const Arrangement& a, const std::string& rest = {}) {
  std::printf(
      "{\"seconds\": %.6f, \"cpu_seconds\": %.6f, \"vertices\": %zu, \"edges\": %zu, \"faces\": %zu%s, \"peak_kb\": "
      "%ld}\n",
      best.seconds(), best.cpu_seconds(), static_cast<std::size_t>(a.number_of_vertices()),
      static_cast<std::size_t>(a.number_of_edges()), static_cast<std::size_t>(a.number_of_faces()), rest.c_str(),
      peak_kb());
}

inline std::string member(const char* name, double value) {
  char text[96];
  std::snprintf(text, sizeof text, ", \"%s\": %.17g", name, value);
  return text;
}

// cgal_arrangement_segments.cc
void arrange_segments(const Task& task);
void overlay_segments(const Task& task);
// cgal_arrangement_location.cc
void locate(const Task& task);
// cgal_arrangement_circles.cc
void arrange_circles(const Task& task);
void unite_discs(const Task& task);
// cgal_arrangement_sphere.cc
void arrange_geodesics(const Task& task);
void arrange_great_circles(const Task& task);
// cgal_arrangement_polygons.cc
void unite_polygons(const Task& task);
void add_polygons(const Task& task);

}  // namespace peer
