// SPDX-License-Identifier: Apache-2.0
// Times CGAL's sequential Delaunay triangulation, in seconds of the processor, on the points of delaunay_bench.
//
//   cgal_delaunay [--rounds N] KIND COUNT
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "../delaunay_points.h"
#include "../peak_memory.h"

int main(int argc, char** argv) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Triangulation = CGAL::Delaunay_triangulation_3<Kernel>;
  int rounds = 1;
  std::vector<std::string> words;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--rounds" && i + 1 < argc) {
      rounds = std::atoi(argv[++i]);
    } else {
      words.push_back(word);
    }
  }
  if (words.size() != 2) {
    std::fprintf(stderr, "cgal_delaunay KIND COUNT\n");
    return 2;
  }
  std::vector<Kernel::Point_3> points;
  {
    const auto made = delaunay_points::make(words[0], std::strtoull(words[1].c_str(), nullptr, 10));
    points.reserve(made.size());
    for (const auto& [x, y, z] : made) points.emplace_back(x, y, z);
  }
  const long before = resident_kb();
  double best = 1e300;
  std::size_t vertices = 0;
  std::size_t cells = 0;
  for (int round = 0; round < rounds; ++round) {
    const std::clock_t start = std::clock();
    const Triangulation result(points.begin(), points.end());
    best = std::min(best, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    vertices = result.number_of_vertices();
    cells = result.number_of_finite_cells();
  }
  std::printf(
      "{\"seconds\": %.9f, \"points\": %zu, \"vertices\": %zu, \"cells\": %zu, \"before_kb\": %ld, \"peak_kb\": %ld}\n",
      best, points.size(), vertices, cells, before, peak_kb());
  return 0;
}
