// SPDX-License-Identifier: Apache-2.0
// Times single changes of a triangulation of the plane, Delaunay or, with --weights, regular: of COUNT generated
// points, takes away and adds some, in an order without locality; prints a line of JSON, with microseconds of the
// processor for each. Weights go up to S times the area per point. peers/cgal_changing2.cc does the same with CGAL.
//
//   changing2_bench [--changes N] [--weights S] KIND COUNT
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "changing_order.h"
#include "command_words.h"
#include "peak_memory.h"
#include "plane_points.h"
#include "plane_weights.h"
#include "quoin/triangulation/changing_delaunay2.h"
#include "quoin/triangulation/changing_regular2.h"

namespace {

double since(std::clock_t start, std::size_t changes) {
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC * 1e6 / static_cast<double>(changes);
}

template <class Triangulation, class Point>
void run(const std::vector<Point>& points, std::size_t changes) {
  const std::vector<std::size_t> order = changing_order(points.size(), changes);
  const long before = resident_kb();
  std::clock_t start = std::clock();
  Triangulation changing(points, quoin::Context({.threads = 1}));
  const double build = since(start, points.size());
  const std::size_t vertices = changing.vertex_count();
  // Ids by an insertion once more, which is taken back.
  std::vector<quoin::Vertex2> ids;
  start = std::clock();
  for (const std::size_t i : order) ids.push_back(changing.insert(points[i]));
  const double find = since(start, order.size());
  for (const quoin::Vertex2 v : ids) {
    while (changing.multiplicity(v) > 1) changing.remove(v);
  }
  start = std::clock();
  for (const quoin::Vertex2 v : ids) {
    if (changing.lives(v)) changing.remove(v);
  }
  const double remove = since(start, order.size());
  start = std::clock();
  for (const std::size_t i : order) changing.insert(points[i]);
  const double insert = since(start, order.size());
  std::printf(
      "{\"points\": %zu, \"vertices\": %zu, \"build\": %.2f, \"find\": %.2f, \"remove\": %.2f, \"insert\": %.2f, "
      "\"before_kb\": %ld, \"peak_kb\": %ld}\n",
      points.size(), vertices, build, find, remove, insert, before, peak_kb());
}

}  // namespace

int main(int argc, char** argv) {
  return bench::exit_code_of([&] {
    bench::CommandWords given(argc, argv);
    const auto changes = static_cast<std::size_t>(given.take_number("--changes", 20000));
    const int weights = given.take_number("--weights", 0);
    const auto& words = given.rest(2, "changing2_bench KIND COUNT");
    const auto points = plane_points::make<quoin::Point2>(words[0], std::strtoull(words[1].c_str(), nullptr, 10));
    if (weights == 0) {
      run<quoin::ChangingDelaunay2>(points, changes);
      return;
    }
    std::vector<quoin::WeightedPoint2> weighted;
    for (const double weight : plane_points::weights(words[0], points.size(), weights)) {
      weighted.push_back({points[weighted.size()], weight});
    }
    run<quoin::ChangingRegular2>(weighted, changes);
  });
}
