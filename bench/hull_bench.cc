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
  int rounds = 1;
  unsigned threads = 1;
  std::vector<std::string> words;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--rounds" && i + 1 < argc) {
      rounds = std::atoi(argv[++i]);
    } else if (word == "--threads" && i + 1 < argc) {
      threads = static_cast<unsigned>(std::atoi(argv[++i]));
    } else {
      words.push_back(word);
    }
  }
  try {
    if (words.size() != 2) throw std::invalid_argument("hull_bench KIND COUNT");
    run(words[0], std::strtoull(words[1].c_str(), nullptr, 10), rounds, threads);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
