// SPDX-License-Identifier: Apache-2.0
// Times CGAL's Delaunay triangulation on the points of delaunay_bench: the sequential one in seconds of the processor,
// or, where QUOIN_PARALLEL_PEER is defined, the parallel one in seconds of the clock.
//
//   cgal_delaunay [--rounds N] KIND COUNT
//   cgal_delaunay_parallel [--rounds N] [--threads N] KIND COUNT
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#ifdef QUOIN_PARALLEL_PEER
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "../delaunay_points.h"
#include "../peak_memory.h"

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Points = std::vector<Kernel::Point_3>;

#ifdef QUOIN_PARALLEL_PEER
using Triangulation = CGAL::Delaunay_triangulation_3<
    Kernel, CGAL::Triangulation_data_structure_3<CGAL::Triangulation_vertex_base_3<Kernel>,
                                                 CGAL::Delaunay_triangulation_cell_base_3<Kernel>, CGAL::Parallel_tag>>;

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Locks are those of cells of a grid over the box of the points.
Triangulation triangulate(const Points& points) {
  Triangulation::Lock_data_structure locks(CGAL::bbox_3(points.begin(), points.end()), 50);
  return Triangulation(points.begin(), points.end(), &locks);
}
#else
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel>;

double now() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

Triangulation triangulate(const Points& points) {
  return Triangulation(points.begin(), points.end());
}
#endif

}  // namespace

int main(int argc, char** argv) {
  int rounds = 1;
  [[maybe_unused]] unsigned threads = 1;
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
  if (words.size() != 2) {
    std::fprintf(stderr, "cgal_delaunay KIND COUNT\n");
    return 2;
  }
#ifdef QUOIN_PARALLEL_PEER
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
#endif
  Points points;
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
    const double start = now();
    const Triangulation result = triangulate(points);
    best = std::min(best, now() - start);
    vertices = result.number_of_vertices();
    cells = result.number_of_finite_cells();
  }
  std::printf(
      "{\"seconds\": %.9f, \"points\": %zu, \"vertices\": %zu, \"cells\": %zu, \"before_kb\": %ld, \"peak_kb\": %ld}\n",
      best, points.size(), vertices, cells, before, peak_kb());
  return 0;
}
