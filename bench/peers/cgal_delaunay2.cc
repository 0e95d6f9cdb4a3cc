// SPDX-License-Identifier: Apache-2.0
// Times CGAL's Delaunay triangulation on the points of delaunay2_bench, in seconds of the processor.
//
//   cgal_delaunay2 [--rounds N] uniform|grid|lattice|jittered|circle COUNT
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "../peak_memory.h"
#include "../plane_points.h"

int main(int argc, char** argv) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
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
    std::fprintf(stderr, "cgal_delaunay2 KIND COUNT\n");
    return 2;
  }
  const std::vector<Kernel::Point_2> points =
      plane_points::make<Kernel::Point_2>(words[0], std::strtoull(words[1].c_str(), nullptr, 10));
  const long before_kb = resident_kb();
  double best = 1e300;
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  for (int round = 0; round < rounds; ++round) {
    const std::clock_t start = std::clock();
    const CGAL::Delaunay_triangulation_2<Kernel> delaunay(points.begin(), points.end());
    best = std::min(best, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    vertices = delaunay.number_of_vertices();
    triangles = delaunay.number_of_faces();
  }
  std::printf(
      "{\"seconds\": %.9f, \"points\": %zu, \"vertices\": %zu, \"triangles\": %zu, \"peak_kb\": %ld, \"before_kb\": "
      "%ld}\n",
      best, points.size(), vertices, triangles, peak_kb(), before_kb);
  return 0;
}
