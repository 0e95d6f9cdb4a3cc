// SPDX-License-Identifier: Apache-2.0
// Times the Delaunay triangulation of generated points of the plane and prints a line of JSON, with
// seconds of the processor, or of the clock where there are more threads; peers/cgal_delaunay2.cc does the same
// with CGAL.
//
//   delaunay2_bench [--rounds N] [--threads N] [--canonical] uniform|grid|lattice|jittered|circle COUNT
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <string>
#include <vector>

#include "command_words.h"
#include "peak_memory.h"
#include "plane_points.h"
#include "quoin/triangulation/delaunay2.h"

namespace {

/// Seconds: of the processor for one thread, of the clock for more.
double now(unsigned threads) {
  if (threads == 1) return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void run(const std::string& kind, std::size_t count, int rounds, unsigned threads, bool canonical) {
  const std::vector<quoin::Point2> points = plane_points::make<quoin::Point2>(kind, count);
  const quoin::Context context({.threads = threads});
  const long before_kb = resident_kb();
  double best = 1e300;
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  for (int round = 0; round < rounds; ++round) {
    const double start = now(threads);
    const quoin::Delaunay2 delaunay(points, {.canonical = canonical}, context);
    best = std::min(best, now(threads) - start);
    vertices = delaunay.vertex_count();
    triangles = delaunay.links().finite_triangle_count();
  }
  std::printf(
      "{\"seconds\": %.9f, \"points\": %zu, \"vertices\": %zu, \"triangles\": %zu, \"peak_kb\": %ld, \"before_kb\": "
      "%ld}\n",
      best, points.size(), vertices, triangles, peak_kb(), before_kb);
}

}  // namespace

int main(int argc, char** argv) {
  return bench::exit_code_of([&] {
    bench::CommandWords given(argc, argv);
    const int rounds = given.take_number("--rounds", 1);
    const auto threads = static_cast<unsigned>(given.take_number("--threads", 1));
    const bool is_canonical = given.take_flag("--canonical");
    const auto& words = given.rest(2, "delaunay2_bench KIND COUNT");
    run(words[0], std::strtoull(words[1].c_str(), nullptr, 10), rounds, threads, is_canonical);
  });
}
