// SPDX-License-Identifier: Apache-2.0
//
// The peer: CGAL Nef polyhedra of OFF files. "seconds" is the operation alone, "with_conversion" includes making the
// polyhedra from meshes.
//
//   cgal_nef union|difference REPEATS FILE...
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/convert_nef_polyhedron_to_polygon_mesh.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "../peak_memory.h"

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) return 2;
  const bool is_union = std::strcmp(argv[1], "union") == 0;
  const int repeats = std::atoi(argv[2]);
  std::vector<Mesh> inputs(static_cast<std::size_t>(argc - 3));
  for (int i = 3; i < argc; ++i) {
    if (!CGAL::IO::read_OFF(std::string(argv[i]), inputs[i - 3])) return 3;
    CGAL::Polygon_mesh_processing::triangulate_faces(inputs[i - 3]);
  }
  std::vector<double> alone;
  std::vector<double> with_conversion;
  double volume = 0;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    const auto start = Clock::now();
    std::vector<Nef> operands;
    for (Mesh& mesh : inputs) operands.emplace_back(mesh);
    const auto converted = Clock::now();
    Nef result = operands[0];
    for (std::size_t i = 1; i < operands.size(); ++i) {
      if (is_union) {
        result += operands[i];
      } else {
        result -= operands[i];
      }
    }
    alone.push_back(seconds_since(converted));
    with_conversion.push_back(seconds_since(start));
    if (repeat > 0) continue;
    Mesh out;
    CGAL::convert_nef_polyhedron_to_polygon_mesh(result, out, true);
    volume = CGAL::to_double(CGAL::Polygon_mesh_processing::volume(out));
  }
  std::sort(alone.begin(), alone.end());
  std::sort(with_conversion.begin(), with_conversion.end());
  std::printf("{\"seconds\": %.6f, \"with_conversion\": %.6f, \"volume\": %.17g, \"peak_kb\": %ld}\n",
              alone[alone.size() / 2], with_conversion[with_conversion.size() / 2], volume, peak_kb());
  return 0;
}
