// SPDX-License-Identifier: Apache-2.0
// Times single removals and insertions in CGAL's Delaunay triangulation of the plane or, with --weights, its regular
// one, in microseconds of the processor, on the points of changing2_bench.
//
//   cgal_changing2 [--changes N] [--weights S] KIND COUNT
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_2.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "../changing_order.h"
#include "../command_words.h"
#include "../plane_points.h"
#include "../plane_weights.h"

namespace {

double since(std::clock_t start, std::size_t changes) {
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC * 1e6 / static_cast<double>(changes);
}

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

template <class Triangulation, class Point>
void run(const std::vector<Point>& points, std::size_t changes) {
  const std::vector<std::size_t> order = changing_order(points.size(), changes);
  std::clock_t start = std::clock();
  Triangulation changing(points.begin(), points.end());
  const double build = since(start, points.size());
  const std::size_t vertices = changing.number_of_vertices();
  // A hidden point is inserted once more, and that one is removed.
  std::vector<typename Triangulation::Vertex_handle> handles;
  start = std::clock();
  for (const std::size_t i : order) handles.push_back(changing.insert(points[i]));
  const double find = since(start, order.size());
  start = std::clock();
  for (const auto v : handles) changing.remove(v);
  const double remove = since(start, order.size());
  start = std::clock();
  for (const std::size_t i : order) changing.insert(points[i]);
  const double insert = since(start, order.size());
  std::printf(
      "{\"points\": %zu, \"vertices\": %zu, \"build\": %.2f, \"find\": %.2f, \"remove\": %.2f, \"insert\": %.2f}\n",
      points.size(), vertices, build, find, remove, insert);
}

}  // namespace

int main(int argc, char** argv) {
  return bench::exit_code_of([&] {
    bench::CommandWords given(argc, argv);
    const auto changes = static_cast<std::size_t>(given.take_number("--changes", 20000));
    const int weights = given.take_number("--weights", 0);
    const auto& words = given.rest(2, "cgal_changing2 KIND COUNT");
    const std::size_t count = std::strtoull(words[1].c_str(), nullptr, 10);
    struct Place {
      double x, y;
    };
    const auto places = plane_points::make<Place>(words[0], count);
    if (weights == 0) {
      std::vector<Kernel::Point_2> points;
      for (const auto& [x, y] : places) points.emplace_back(x, y);
      run<CGAL::Delaunay_triangulation_2<Kernel>>(points, changes);
      return;
    }
    std::vector<Kernel::Weighted_point_2> points;
    for (const double weight : plane_points::weights(words[0], places.size(), weights)) {
      const auto& [x, y] = places[points.size()];
      points.emplace_back(Kernel::Point_2(x, y), weight);
    }
    run<CGAL::Regular_triangulation_2<Kernel>>(points, changes);
  });
}
