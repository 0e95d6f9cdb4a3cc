// SPDX-License-Identifier: Apache-2.0
// Times alpha complexes of generated points and prints a line of JSON: seconds of the processor for the triangulation,
// for its simplices, for their values and order, and for the persistence; with more threads, of the wall.
//
//   alpha_bench [--rounds N] [--threads N] torus|cube|ball|sphere|scan|lattice|jittered[-grid] COUNT
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include "command_words.h"
#include "delaunay_points.h"
#include "peak_memory.h"
#include "quoin/topology/persistence.h"
#include "quoin/triangulation/alpha_complex.h"
#include "quoin/triangulation/delaunay3.h"

namespace {

class Stopwatch {
 public:
  explicit Stopwatch(bool is_of_wall) : is_of_wall_(is_of_wall), start_(now()) {}
  double lap() {
    const double from = start_;
    start_ = now();
    return start_ - from;
  }

 private:
  double now() const {
    if (!is_of_wall_) return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  }

  bool is_of_wall_;
  double start_;
};

std::vector<std::uint32_t> cells_of(const quoin::Delaunay3& triangulation) {
  std::vector<std::uint32_t> cells;
  cells.reserve(4 * triangulation.cells().size());
  for (std::size_t c = 0; c < triangulation.cells().size(); ++c) {
    const auto& v = triangulation.cells()[c].vertices;
    if (!triangulation.is_ghost(c)) cells.insert(cells.end(), v.begin(), v.begin() + triangulation.dimension() + 1);
  }
  return cells;
}

void run(const std::string& kind, std::size_t count, int rounds, unsigned threads) {
  std::vector<quoin::Point3> points;
  for (const auto& [x, y, z] : delaunay_points::make(kind, count)) points.push_back({x, y, z});
  const long before = resident_kb();
  const quoin::Context context({.threads = threads});
  double delaunay = 1e300;
  double complex = 1e300;
  double alpha = 1e300;
  double persistence = 1e300;
  std::size_t simplices = 0;
  std::size_t grades = 0;
  std::vector<std::size_t> pairs;
  for (int round = 0; round < rounds; ++round) {
    Stopwatch watch(threads > 1);
    const quoin::Delaunay3 triangulation(points, context);
    delaunay = std::min(delaunay, watch.lap());
    const std::size_t width = static_cast<std::size_t>(triangulation.dimension()) + 1;
    simplices = quoin::SimplicialComplex::closure_of_cells(cells_of(triangulation), width, context).size();
    complex = std::min(complex, watch.lap());
    const quoin::AlphaComplex filtered(triangulation, context);
    alpha = std::min(alpha, watch.lap());
    const auto found = quoin::persistence(filtered.filtration(), {}, context);
    persistence = std::min(persistence, watch.lap());
    grades = filtered.grade_count();
    pairs.assign(4, 0);
    for (const quoin::PersistencePair& pair : found) ++pairs[static_cast<std::size_t>(pair.degree)];
  }
  std::printf(
      "{\"points\": %zu, \"simplices\": %zu, \"grades\": %zu, \"delaunay\": %.3f, \"complex\": %.3f, "
      "\"values_and_order\": %.3f, \"persistence\": %.3f, \"pairs\": [%zu, %zu, %zu], \"before_kb\": %ld, "
      "\"peak_kb\": %ld}\n",
      points.size(), simplices, grades, delaunay, complex, std::max(0.0, alpha - complex), persistence, pairs[0],
      pairs[1], pairs[2], before, peak_kb());
}

}  // namespace

int main(int argc, char** argv) {
  return bench::exit_code_of([&] {
    bench::CommandWords given(argc, argv);
    const int rounds = given.take_number("--rounds", 1);
    const unsigned threads = given.take_number("--threads", 1U);
    const auto& words = given.rest(2, "alpha_bench KIND COUNT");
    run(words[0], std::strtoull(words[1].c_str(), nullptr, 10), rounds, threads);
  });
}
