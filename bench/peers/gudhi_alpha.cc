// SPDX-License-Identifier: Apache-2.0
// Writes the alpha complex of random points on a torus, by GUDHI and CGAL with safe values, for persistence_bench.
//
//   gudhi_alpha POINTS FILE
#include <iostream>  // which GUDHI's headers take for granted

#include <gudhi/Alpha_complex_3d.h>
#include <gudhi/Simplex_tree.h>

#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "../delaunay_points.h"
#include "../filtered_simplices.h"

namespace {

using Alpha = Gudhi::alpha_complex::Alpha_complex_3d<Gudhi::alpha_complex::complexity::SAFE, false, false>;

std::vector<Alpha::Bare_point_3> torus(std::size_t count) {
  std::vector<Alpha::Bare_point_3> points;
  for (const auto& [x, y, z] : delaunay_points::torus(count)) points.emplace_back(x, y, z);
  return points;
}

void run(std::size_t count, const std::string& path) {
  Alpha alpha(torus(count));
  Gudhi::Simplex_tree<> tree;
  if (!alpha.create_complex(tree)) throw std::runtime_error("no complex");
  filtered_simplices::List list;
  std::vector<std::uint32_t> simplex;
  for (const auto handle : tree.filtration_simplex_range()) {
    simplex.clear();
    for (const auto vertex : tree.simplex_vertex_range(handle)) simplex.push_back(static_cast<std::uint32_t>(vertex));
    list.add(tree.filtration(handle), simplex.data(), simplex.size());
  }
  filtered_simplices::write(path, list);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "gudhi_alpha POINTS FILE\n");
    return 2;
  }
  try {
    run(std::strtoull(argv[1], nullptr, 10), argv[2]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
