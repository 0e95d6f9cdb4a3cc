// SPDX-License-Identifier: Apache-2.0
// Times GUDHI's persistent cohomology on the inputs of persistence_bench, with values in double.
//
//   gudhi_persistence [--rounds N] [--prime P] grid N SMOOTHING | rips ... | file PATH
#include <iostream>  // which GUDHI's headers take for granted

#include <gudhi/Persistent_cohomology.h>
#include <gudhi/Simplex_tree.h>

#include <chrono>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "../filtered_simplices.h"
#include "../interval_sum.h"
#include "../peak_memory.h"

namespace {

using Clock = std::chrono::steady_clock;

// The options for persistence, but not in single precision.
struct Options : Gudhi::Simplex_tree_options_fast_persistence {
  using Filtration_value = double;
};
using Tree = Gudhi::Simplex_tree<Options>;
using Cohomology = Gudhi::persistent_cohomology::Persistent_cohomology<Tree, Gudhi::persistent_cohomology::Field_Zp>;

double seconds(Clock::time_point from, Clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

void run(const std::vector<std::string>& words, int rounds, int prime) {
  const filtered_simplices::List input = filtered_simplices::make(words);
  const long input_kb = peak_kb();
  double build = 1e300;
  double best = 1e300;
  std::vector<std::size_t> pairs;
  IntervalSum intervals;
  std::size_t count = 0;
  for (int round = 0; round < rounds; ++round) {
    const auto start = Clock::now();
    Tree tree;
    std::vector<int> simplex;
    for (std::size_t i = 0; i < input.size(); ++i) {
      simplex.assign(input.vertices.begin() + static_cast<std::ptrdiff_t>(input.begin[i]),
                     input.vertices.begin() + static_cast<std::ptrdiff_t>(input.begin[i + 1]));
      tree.insert_simplex(simplex, input.values[i]);
    }
    tree.initialize_filtration();
    const auto built = Clock::now();
    Cohomology cohomology(tree, true);
    cohomology.init_coefficients(prime);
    cohomology.compute_persistent_cohomology(0);
    const auto end = Clock::now();
    build = std::min(build, seconds(start, built));
    best = std::min(best, seconds(built, end));
    count = tree.num_simplices();
    pairs.assign(static_cast<std::size_t>(tree.dimension()) + 1, 0);
    intervals = {};
    for (const auto& [birth, death, prime_of_pair] : cohomology.get_persistent_pairs()) {
      const int degree = tree.dimension(birth);
      ++pairs[static_cast<std::size_t>(degree)];
      intervals.add(degree, tree.filtration(birth), tree.filtration(death));  // infinite without end
    }
  }
  std::printf("{\"simplices\": %zu, \"build_seconds\": %.9f, \"seconds\": %.9f, \"pairs\": [", count, build, best);
  for (std::size_t k = 0; k < pairs.size(); ++k) std::printf("%s%zu", k == 0 ? "" : ", ", pairs[k]);
  std::printf("], \"intervals\": \"%016llx\", \"input_kb\": %ld, \"peak_kb\": %ld}\n",
              static_cast<unsigned long long>(intervals.value()), input_kb, peak_kb());
}

}  // namespace

int main(int argc, char** argv) {
  int rounds = 1;
  int prime = 2;
  std::vector<std::string> words;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--rounds" && i + 1 < argc) {
      rounds = std::atoi(argv[++i]);
    } else if (word == "--prime" && i + 1 < argc) {
      prime = std::atoi(argv[++i]);
    } else {
      words.push_back(word);
    }
  }
  try {
    run(words, rounds, prime);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
