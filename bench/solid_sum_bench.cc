// SPDX-License-Identifier: Apache-2.0
// Times Minkowski sums of two solids and prints a line of JSON; peers/cgal_solid_sum.cc does the same.
//
//   solid_sum_bench [--rounds N] [--threads N] A.off B.off
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include "command_words.h"
#include "peak_memory.h"
#include "quoin/io/mesh_file.h"
#include "quoin/polytope/convolution.h"
#include "quoin/polytope/solid_sum.h"
#include "quoin/solid/measure.h"
#include "quoin/solid/placement.h"

namespace {

using Clock = std::chrono::steady_clock;

quoin::Solid solid_of(const std::string& file, const quoin::Context& context) {
  const quoin::MeshFile read = quoin::read_mesh(std::filesystem::path(file), {}, context);
  const quoin::LeafResult leaf = quoin::make_leaf(read.mesh, {}, context);
  if (!leaf.leaf) throw std::runtime_error(file + " bounds no solid");
  return quoin::Solid::from_leaf(leaf.leaf, context);
}

/// From solids to the sum.
void run(const std::string& first, const std::string& second, int rounds, unsigned threads) {
  const quoin::Context context({.threads = threads});
  const quoin::Solid a = solid_of(first, context);
  const quoin::Solid b = solid_of(second, context);
  double best = 1e300;
  quoin::Solid sum;
  for (int round = 0; round < rounds; ++round) {
    const auto start = Clock::now();
    sum = quoin::minkowski_sum(a, b, context);
    best = std::min(best, std::chrono::duration<double>(Clock::now() - start).count());
  }
  const long peak = peak_kb();
  const auto surface = quoin::convolution(quoin::TiledSurface(*quoin::leaf_of(a, "a", context)),
                                          quoin::TiledSurface(*quoin::leaf_of(b, "b", context)), context);
  std::printf("{\"seconds\": %.9f, \"facets\": %zu, \"triangles\": %zu, \"volume\": %.17g, \"peak_kb\": %ld}\n", best,
              sum.boundary().face_count(), surface->tiles.size(), quoin::rounded_volume(sum.boundary(), context), peak);
}

}  // namespace

int main(int argc, char** argv) {
  return bench::exit_code_of([&] {
    bench::CommandWords given(argc, argv);
    const int rounds = given.take_number("--rounds", 1);
    const unsigned threads = given.take_number("--threads", 1U);
    const auto& words = given.rest(2, "solid_sum_bench [--rounds N] [--threads N] A.off B.off");
    run(words[0], words[1], rounds, threads);
  });
}
