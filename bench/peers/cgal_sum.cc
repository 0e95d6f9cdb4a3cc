// SPDX-License-Identifier: Apache-2.0
// Times CGAL's Minkowski sum of two polytopes given as points: of Nef polyhedra, or as the hull of all sums of
// vertices.
//
//   cgal_sum nef|hull A B
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/convex_hull_3.h>
#include <CGAL/minkowski_sum_3.h>

#include <chrono>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "../peak_memory.h"
#include "../point_file.h"

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;
using Points = std::vector<Kernel::Point_3>;
using Clock = std::chrono::steady_clock;

Points points_of(const std::string& file) {
  Points points;
  for (const auto& [x, y, z] : point_file::read(file)) points.emplace_back(x, y, z);
  return points;
}

Polyhedron hull_of(const Points& points) {
  Polyhedron result;
  CGAL::convex_hull_3(points.begin(), points.end(), result);
  return result;
}

void report(Clock::time_point start, std::size_t vertices, std::size_t facets) {
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  std::printf("{\"seconds\": %.9f, \"vertices\": %zu, \"facets\": %zu, \"peak_kb\": %ld}\n", seconds, vertices, facets,
              peak_kb());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "cgal_sum nef|hull A B\n");
    return 2;
  }
  try {
    const Points a = points_of(argv[2]);
    const Points b = points_of(argv[3]);
    if (std::string(argv[1]) == "hull") {
      const auto start = Clock::now();
      Points sums;
      sums.reserve(a.size() * b.size());
      for (const auto& p : a) {
        for (const auto& q : b) sums.push_back(p + (q - CGAL::ORIGIN));
      }
      const Polyhedron sum = hull_of(sums);
      report(start, sum.size_of_vertices(), sum.size_of_facets());
      return 0;
    }
    Polyhedron first = hull_of(a);
    Polyhedron second = hull_of(b);
    Nef p(first);
    Nef q(second);
    const auto start = Clock::now();
    const Nef sum = CGAL::minkowski_sum_3(p, q);
    report(start, sum.number_of_vertices(), sum.number_of_facets());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
