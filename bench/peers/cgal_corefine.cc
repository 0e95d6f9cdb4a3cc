// SPDX-License-Identifier: Apache-2.0
//
// The peer: CGAL corefinement of two OFF files, from meshes in memory to a mesh in memory.
//
//   cgal_corefine exact|inexact REPEATS A.off B.off
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <vector>

namespace {

template <class Kernel>
int run(int repeats, const char* a, const char* b) {
  using Mesh = CGAL::Surface_mesh<typename Kernel::Point_3>;
  Mesh first;
  Mesh second;
  if (!CGAL::IO::read_OFF(std::string(a), first) || !CGAL::IO::read_OFF(std::string(b), second)) return 3;
  std::vector<double> lazy;
  std::vector<double> evaluated;
  double volume = 0;
  std::size_t faces = 0;
  for (int i = 0; i < repeats; ++i) {
    Mesh p = first;
    Mesh q = second;
    Mesh out;
    const auto start = std::chrono::steady_clock::now();
    if (!CGAL::Polygon_mesh_processing::corefine_and_compute_union(p, q, out)) return 1;
    lazy.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    double sum = 0;
    for (const auto v : out.vertices()) {
      if constexpr (requires { out.point(v).exact(); }) out.point(v).exact();
      sum += CGAL::to_double(out.point(v).x());
    }
    evaluated.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    faces = out.number_of_faces();
    if (i == 0) volume = CGAL::to_double(CGAL::Polygon_mesh_processing::volume(out)) + 0 * sum;
  }
  std::sort(lazy.begin(), lazy.end());
  std::sort(evaluated.begin(), evaluated.end());
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  std::printf("{\"seconds\": %.6f, \"evaluated\": %.6f, \"volume\": %.17g, \"triangles\": %zu, \"peak_kb\": %ld}\n",
              lazy[lazy.size() / 2], evaluated[evaluated.size() / 2], volume, faces, usage.ru_maxrss);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) return 2;
  const int repeats = std::atoi(argv[2]);
  if (std::strcmp(argv[1], "exact") == 0)
    return run<CGAL::Exact_predicates_exact_constructions_kernel>(repeats, argv[3], argv[4]);
  return run<CGAL::Exact_predicates_inexact_constructions_kernel>(repeats, argv[3], argv[4]);
}
