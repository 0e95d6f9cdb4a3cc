// SPDX-License-Identifier: Apache-2.0
//
// Times one Boolean of OFF files from polygon arrays in memory to certified triangles in memory.
//
//   overlay_bench union|difference THREADS REPEATS FILE...
//
// With QUOIN_STAGES=1 in the environment the median processor time of each stage goes to stderr.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "bench/peak_memory.h"
#include "quoin/base/parallel.h"
#include "quoin/io/mesh_file.h"
#include "quoin/solid/exit.h"
#include "quoin/solid/measure.h"
#include "quoin/solid/solid.h"

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Processor time of all threads, which other programs on the machine disturb less than wall time.
double processor_seconds() {
  std::timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Processor time of each stage, from the progress reports; a stage lasts until the next one is reported.
class StageClock {
 public:
  void enter(std::string_view stage) {
    const double now = processor_seconds();
    if (!current_.empty()) run_[current_] += now - since_;
    current_ = stage;
    since_ = now;
  }
  void end_run() {
    enter("");
    for (const auto& [stage, seconds] : run_) seconds_[stage].push_back(seconds);
    run_.clear();
  }
  void print() {
    for (auto& [stage, seconds] : seconds_) {
      std::nth_element(seconds.begin(), seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2),
                       seconds.end());
      std::fprintf(stderr, "%-20s %8.3f ms\n", stage.c_str(), 1e3 * seconds[seconds.size() / 2]);
    }
  }

 private:
  std::string current_;
  double since_ = 0;
  std::map<std::string, double> run_;
  std::map<std::string, std::vector<double>> seconds_;
};

struct Timings {
  double door = 0;
  double overlay = 0;
  double exit = 0;
  double all() const { return door + overlay + exit; }
};

}  // namespace

int main(int argc, char** argv) {
  using namespace quoin;
  if (argc < 5) {
    std::fprintf(stderr, "overlay_bench union|difference THREADS REPEATS FILE...\n");
    return 2;
  }
  ContextOptions options;
  options.threads = static_cast<unsigned>(std::atoi(argv[2]));
  StageClock stages;
  const bool wants_stages = std::getenv("QUOIN_STAGES") != nullptr;
  if (wants_stages) options.progress = [&](std::string_view stage, double) { stages.enter(stage); };
  const Context context(options);
  std::vector<Mesh> meshes;
  for (int i = 4; i < argc; ++i) meshes.push_back(read_mesh(std::filesystem::path(argv[i]), {}, context).mesh);
  std::vector<Timings> runs;
  double volume = 0;
  std::size_t triangles = 0;
  Rounding rounding = Rounding::exact;
  for (int repeat = 0; repeat < std::atoi(argv[3]); ++repeat) {
    Timings timings;
    auto start = Clock::now();
    std::vector<Solid> solids(meshes.size());
    for_each_chunk(context, meshes.size(), 1, [&](const Chunk& chunk) {
      solids[chunk.index] = Solid::of_leaf(make_leaf(meshes[chunk.index], {}, context).leaf);
    });
    timings.door = seconds_since(start);
    start = Clock::now();
    const Solid result = std::strcmp(argv[1], "union") == 0
                             ? unite(solids, context)
                             : subtract(solids[0], std::span(solids).subspan(1), context);
    timings.overlay = seconds_since(start);
    start = Clock::now();
    const Triangulated t = triangulate_boundary(result.boundary(), {}, context);
    timings.exit = seconds_since(start);
    runs.push_back(timings);
    stages.end_run();
    rounding = t.rounding;
    triangles = t.triangles.size();
    if (repeat == 0) volume = rounded_volume(result.boundary(), context);
  }
  std::sort(runs.begin(), runs.end(), [](const Timings& a, const Timings& b) { return a.all() < b.all(); });
  if (wants_stages) stages.print();
  const Timings& median = runs[runs.size() / 2];
  std::printf(
      "{\"seconds\": %.6f, \"door\": %.6f, \"overlay\": %.6f, \"exit\": %.6f, \"volume\": %.17g, \"triangles\": %zu, "
      "\"rounding\": %d, \"peak_kb\": %ld}\n",
      median.all(), median.door, median.overlay, median.exit, volume, triangles, static_cast<int>(rounding), peak_kb());
  return 0;
}
