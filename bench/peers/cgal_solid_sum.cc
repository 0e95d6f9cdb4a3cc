// SPDX-License-Identifier: Apache-2.0
// Times CGAL's Minkowski sum of two solids: Nef polyhedra, decomposed into convex pieces whose sums are united.
//
//   cgal_solid_sum A.off B.off
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/IO/Polyhedron_iostream.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/convert_nef_polyhedron_to_polygon_mesh.h>
#include <CGAL/minkowski_sum_3.h>

#include <chrono>
#include <cstdio>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>

#include "../peak_memory.h"

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

Nef read(const char* file) {
  std::ifstream in(file);
  Polyhedron surface;
  in >> surface;
  if (surface.empty() || !surface.is_closed()) throw std::runtime_error(std::string(file) + " is no closed surface");
  return Nef(surface);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "cgal_solid_sum A.off B.off\n");
    return 2;
  }
  try {
    Nef a = read(argv[1]);
    Nef b = read(argv[2]);
    const auto start = std::chrono::steady_clock::now();
    const Nef sum = CGAL::minkowski_sum_3(a, b);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const long peak = peak_kb();
    Surface surface;
    CGAL::convert_nef_polyhedron_to_polygon_mesh(sum, surface, true);
    std::printf("{\"seconds\": %.9f, \"facets\": %zu, \"volume\": %.17g, \"peak_kb\": %ld}\n", seconds,
                static_cast<std::size_t>(sum.number_of_facets()),
                CGAL::to_double(CGAL::Polygon_mesh_processing::volume(surface)), peak);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
