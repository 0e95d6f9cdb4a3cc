// SPDX-License-Identifier: Apache-2.0
//
// The peer: CGAL corefinement of OFF files one after the other, from meshes in memory to a mesh in memory.
//
//   cgal_corefine exact|inexact union|difference REPEATS FILE...
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "../peak_memory.h"

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Of the rounded points: exact sums over a large mesh take minutes and are not what is measured.
template <class Mesh>
double rounded_volume(const Mesh& mesh) {
  double six = 0;
  for (const auto f : mesh.faces()) {
    double p[3][3];
    std::size_t corner = 0;
    for (const auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh)) {
      for (int k = 0; k < 3; ++k) p[corner][k] = CGAL::to_double(mesh.point(v)[k]);
      ++corner;
    }
    six += p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) + p[0][1] * (p[1][2] * p[2][0] - p[1][0] * p[2][2]) +
           p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0]);
  }
  return six / 6;
}

template <class Kernel>
int run(bool is_union, int repeats, int count, char** files) {
  using Mesh = CGAL::Surface_mesh<typename Kernel::Point_3>;
  std::vector<Mesh> inputs(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    if (!CGAL::IO::read_OFF(std::string(files[i]), inputs[i])) return 3;
    PMP::triangulate_faces(inputs[i]);
  }
  std::vector<double> lazy;
  std::vector<double> evaluated;
  double volume = 0;
  std::size_t faces = 0;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    std::vector<Mesh> meshes = inputs;
    const auto start = Clock::now();
    Mesh out = std::move(meshes[0]);
    for (int i = 1; i < count; ++i) {
      const bool done = is_union ? PMP::corefine_and_compute_union(out, meshes[i], out)
                                 : PMP::corefine_and_compute_difference(out, meshes[i], out);
      if (!done) return 1;
    }
    lazy.push_back(seconds_since(start));
    for (const auto v : out.vertices()) {
      if constexpr (requires { out.point(v).exact(); }) out.point(v).exact();
    }
    evaluated.push_back(seconds_since(start));
    faces = out.number_of_faces();
    if (repeat == 0) volume = rounded_volume(out);
  }
  std::sort(lazy.begin(), lazy.end());
  std::sort(evaluated.begin(), evaluated.end());
  std::printf("{\"seconds\": %.6f, \"evaluated\": %.6f, \"volume\": %.17g, \"triangles\": %zu, \"peak_kb\": %ld}\n",
              lazy[lazy.size() / 2], evaluated[evaluated.size() / 2], volume, faces, peak_kb());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 5) return 2;
  const bool is_union = std::strcmp(argv[2], "union") == 0;
  const int repeats = std::atoi(argv[3]);
  if (std::strcmp(argv[1], "exact") == 0)
    return run<CGAL::Exact_predicates_exact_constructions_kernel>(is_union, repeats, argc - 4, argv + 4);
  return run<CGAL::Exact_predicates_inexact_constructions_kernel>(is_union, repeats, argc - 4, argv + 4);
}
