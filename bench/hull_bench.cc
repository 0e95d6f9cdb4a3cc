// SPDX-License-Identifier: Apache-2.0
// Times the convex hull of generated points and prints a line of JSON; peers/qhull_hull.cc does the same with Qhull.
//
//   hull_bench [--rounds N] [--threads N] cube|ball|sphere|lattice COUNT
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

#include "command_words.h"
#include "hull_points.h"
#include "peak_memory.h"
#include "quoin/polytope/hull.h"

namespace {

void run(const std::string& kind, std::size_t count, int rounds, unsigned threads) {
  const auto points = hull_points::make<quoin::Point3>(kind, count);
  const quoin::Context context({.threads = threads});
  double best = 1e300;
  std::size_t vertices = 0;
  std::size_t facets = 0;
  for (int round = 0; round < rounds; ++round) {
    const auto start = std::chrono::steady_clock::now();
    const quoin::ConvexHull hull = quoin::convex_hull(points, context);
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    vertices = hull.vertices.size();
    facets = hull.facet_count();
  }
  std::printf("{\"seconds\": %.9f, \"vertices\": %zu, \"facets\": %zu, \"peak_kb\": %ld}\n", best, vertices, facets,
              peak_kb());
}

}  // namespace

int main(int argc, char** argv) {
  return bench::exit_code_of([&] {
    bench::CommandWords given(argc, argv);
    const int rounds = given.take_number("--rounds", 1);
    const unsigned threads = given.take_number("--threads", 1U);
    const auto& words = given.rest(2, "hull_bench KIND COUNT");
    run(words[0], std::strtoull(words[1].c_str(), nullptr, 10), rounds, threads);
  });
}
