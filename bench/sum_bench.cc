// SPDX-License-Identifier: Apache-2.0
// Times Minkowski sums of two polytopes given as points, and prints a line of JSON; peers/cgal_sum.cc does the same.
//
//   sum_bench [--rounds N] A B             files of points, a line each
//   sum_bench --write SHAPE DEGREES OUT    the vertices of a shape, turned about two axes (polytope_points.h)
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include "command_words.h"
#include "peak_memory.h"
#include "point_file.h"
#include "polytope_points.h"
#include "quoin/polytope/minkowski_sum.h"

namespace {

using Clock = std::chrono::steady_clock;

std::vector<quoin::Point3> points_of(const std::string& file) {
  std::vector<quoin::Point3> points;
  for (const auto& [x, y, z] : point_file::read(file)) points.push_back({x, y, z});
  return points;
}

/// From points to polytopes, and from these to the sum, apart.
void run(const std::string& first, const std::string& second, int rounds) {
  const std::vector<quoin::Point3> a = points_of(first);
  const std::vector<quoin::Point3> b = points_of(second);
  const quoin::Context context({.threads = 1});
  double build = 1e300;
  double best = 1e300;
  quoin::PolytopeSum sum;
  for (int round = 0; round < rounds; ++round) {
    const auto start = Clock::now();
    const quoin::Polytope p = quoin::Polytope::hull_of(a, context);
    const quoin::Polytope q = quoin::Polytope::hull_of(b, context);
    const auto built = Clock::now();
    sum = quoin::minkowski_sum(p, q, context);
    build = std::min(build, std::chrono::duration<double>(built - start).count());
    best = std::min(best, std::chrono::duration<double>(Clock::now() - built).count());
  }
  std::printf(
      "{\"seconds\": %.9f, \"build_seconds\": %.9f, \"vertices\": %zu, \"edges\": %zu, \"facets\": %zu, "
      "\"peak_kb\": %ld}\n",
      best, build, sum.vertices.size(), sum.edge_count(), sum.facet_count(), peak_kb());
}

}  // namespace

int main(int argc, char** argv) {
  return bench::exit_code_of([&] {
    bench::CommandWords given(argc, argv);
    if (given.take_flag("--write")) {
      const auto& words = given.rest(3, "sum_bench --write NAME DEGREES FILE");
      const double degrees = std::stod(words[1]);
      const polytope_points::Points points = polytope_points::named(words[0]);
      point_file::write(words[2], degrees == 0 ? points : polytope_points::turned(points, degrees));
      return;
    }
    const int rounds = given.take_number("--rounds", 1);
    const auto& words = given.rest(2, "sum_bench [--rounds N] A B");
    run(words[0], words[1], rounds);
  });
}
