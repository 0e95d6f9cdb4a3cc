// SPDX-License-Identifier: Apache-2.0
// Times GUDHI's alpha complexes, which are made by CGAL, and their persistence on the inputs of alpha_bench; seconds of
// the processor, from points to a filtration in order, and from there to all pairs over two elements. `fast` takes
// doubles for values and for what triangulates, `safe` intervals that are made exact where they must.
//
//   gudhi_alpha_time [--rounds N] fast|safe torus|cube|ball|sphere|scan|lattice|jittered[-grid] COUNT
#include <iostream>  // which GUDHI's headers take for granted

#include <gudhi/Alpha_complex_3d.h>
#include <gudhi/Persistent_cohomology.h>
#include <gudhi/Simplex_tree.h>

#include <cstdio>
#include <ctime>
#include <exception>
#include <string>
#include <vector>

#include "../delaunay_points.h"
#include "../peak_memory.h"

namespace {

using Gudhi::alpha_complex::complexity;

// The options for persistence, but not in single precision.
struct Options : Gudhi::Simplex_tree_options_fast_persistence {
  using Filtration_value = double;
};
using Tree = Gudhi::Simplex_tree<Options>;
using Cohomology = Gudhi::persistent_cohomology::Persistent_cohomology<Tree, Gudhi::persistent_cohomology::Field_Zp>;

double seconds_since(std::clock_t start) {
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// How many faces there were not, and is not counted: `fast` loses some, and persistence then crashes.
std::size_t insert_lost_faces(Tree& tree) {
  std::vector<std::vector<Tree::Vertex_handle>> lost;
  std::vector<double> values;
  for (const auto simplex : tree.complex_simplex_range()) {
    const auto range = tree.simplex_vertex_range(simplex);
    const std::vector<Tree::Vertex_handle> vertices(range.begin(), range.end());
    for (std::size_t left_out = 0; vertices.size() > 1 && left_out < vertices.size(); ++left_out) {
      std::vector<Tree::Vertex_handle> face = vertices;
      face.erase(face.begin() + static_cast<std::ptrdiff_t>(left_out));
      if (tree.find(face) != tree.null_simplex()) continue;
      lost.push_back(std::move(face));
      values.push_back(tree.filtration(simplex));
    }
  }
  const std::size_t before = tree.num_simplices();
  for (std::size_t i = 0; i < lost.size(); ++i) tree.insert_simplex_and_subfaces(lost[i], values[i]);
  if (!lost.empty()) {
    tree.make_filtration_non_decreasing();
    tree.initialize_filtration();
  }
  return tree.num_simplices() - before;
}

template <complexity kind>
void run(const std::string& family, std::size_t count, int rounds) {
  using Alpha = Gudhi::alpha_complex::Alpha_complex_3d<kind, false, false>;
  std::vector<typename Alpha::Bare_point_3> points;
  for (const auto& [x, y, z] : delaunay_points::make(family, count)) points.emplace_back(x, y, z);
  const long before = resident_kb();
  double complex_seconds = 1e300;
  double pair_seconds = 1e300;
  std::size_t simplices = 0;
  std::size_t lost = 0;
  std::vector<std::size_t> pairs;
  for (int round = 0; round < rounds; ++round) {
    std::clock_t start = std::clock();
    Alpha alpha(points);
    Tree tree;
    if (!alpha.create_complex(tree)) throw std::runtime_error("no complex");
    tree.initialize_filtration();
    complex_seconds = std::min(complex_seconds, seconds_since(start));
    lost = insert_lost_faces(tree);
    start = std::clock();
    Cohomology cohomology(tree, true);
    cohomology.init_coefficients(2);
    cohomology.compute_persistent_cohomology(0);
    pair_seconds = std::min(pair_seconds, seconds_since(start));
    simplices = tree.num_simplices();
    pairs.assign(4, 0);
    for (const auto& pair : cohomology.get_persistent_pairs()) ++pairs[tree.dimension(std::get<0>(pair))];
  }
  std::printf(
      "{\"points\": %zu, \"simplices\": %zu, \"lost\": %zu, \"complex\": %.3f, \"persistence\": %.3f, \"pairs\": [%zu, "
      "%zu, %zu], "
      "\"before_kb\": %ld, \"peak_kb\": %ld}\n",
      points.size(), simplices, lost, complex_seconds, pair_seconds, pairs[0], pairs[1], pairs[2], before, peak_kb());
}

}  // namespace

int main(int argc, char** argv) {
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
  try {
    if (words.size() != 3 || (words[0] != "fast" && words[0] != "safe"))
      throw std::invalid_argument("gudhi_alpha_time fast|safe KIND COUNT");
    const std::size_t count = std::strtoull(words[2].c_str(), nullptr, 10);
    words[0] == "fast" ? run<complexity::FAST>(words[1], count, rounds)
                       : run<complexity::SAFE>(words[1], count, rounds);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
