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

#include "../filtered_simplices.h"

namespace {

using Alpha = Gudhi::alpha_complex::Alpha_complex_3d<Gudhi::alpha_complex::complexity::SAFE, false, false>;

// Close to a torus of radii 3 and 1, by points of a tube whose cross-section is a circle made of random directions.
std::vector<Alpha::Bare_point_3> torus(std::size_t count) {
  Random random(3);
  const auto direction = [&] {
    for (;;) {
      const double x = static_cast<double>(random.between(-(1 << 30), 1 << 30)) / (1 << 30);
      const double y = static_cast<double>(random.between(-(1 << 30), 1 << 30)) / (1 << 30);
      const double square = x * x + y * y;
      if (square < 1 && square > 0.01) return std::pair{x / std::sqrt(square), y / std::sqrt(square)};
    }
  };
  std::vector<Alpha::Bare_point_3> points;
  while (points.size() < count) {
    const auto around = direction();
    const auto tube = direction();
    const double r = 3 + tube.first;
    points.emplace_back(r * around.first, r * around.second, tube.second);
  }
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
