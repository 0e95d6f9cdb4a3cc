// SPDX-License-Identifier: Apache-2.0
// Times the Delaunay triangulation of generated points and prints a line of JSON, with
// seconds of the processor, or of the clock where there are more threads; peers/cgal_delaunay.cc does the same
// with CGAL.
//
//   delaunay_bench [--rounds N] [--threads N] [--canonical] cube|ball|sphere|scan|lattice|jittered[-grid] COUNT
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include "command_words.h"
#include "delaunay_points.h"
#include "peak_memory.h"
#include "quoin/triangulation/delaunay3.h"

namespace {

/// Seconds: of the processor for one thread, of the clock for more.
double now(unsigned threads) {
  if (threads == 1) return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void run(const std::string& kind, std::size_t count, int rounds, unsigned threads, bool is_canonical) {
  std::vector<quoin::Point3> points;
  {
    const auto made = delaunay_points::make(kind, count);
    points.reserve(made.size());
    for (const auto& [x, y, z] : made) points.push_back({x, y, z});
  }
  const long before = resident_kb();
  const quoin::Context context({.threads = threads});
  double best = 1e300;
  std::size_t vertices = 0;
  std::size_t cells = 0;
  for (int round = 0; round < rounds; ++round) {
    const auto start = now(threads);
    const quoin::Delaunay3 result(points, context, {.is_canonical = is_canonical});
    best = std::min(best, now(threads) - start);
    vertices = result.vertex_count();
    cells = result.finite_cell_count();
  }
  std::printf(
      "{\"seconds\": %.9f, \"points\": %zu, \"vertices\": %zu, \"cells\": %zu, \"before_kb\": %ld, \"peak_kb\": %ld}\n",
      best, points.size(), vertices, cells, before, peak_kb());
}

}  // namespace

int main(int argc, char** argv) {
  return bench::exit_code_of([&] {
    bench::CommandWords given(argc, argv);
    const int rounds = given.take_number("--rounds", 1);
    const unsigned threads = given.take_number("--threads", 1U);
    const bool is_canonical = given.take_flag("--canonical");
    const auto& words = given.rest(2, "delaunay_bench KIND COUNT");
    run(words[0], std::strtoull(words[1].c_str(), nullptr, 10), rounds, threads, is_canonical);
  });
}
