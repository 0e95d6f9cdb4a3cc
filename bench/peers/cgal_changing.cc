// SPDX-License-Identifier: Apache-2.0
// Times single removals and insertions in CGAL's Delaunay triangulation of space, in microseconds of the processor, on
// the points of changing_bench.
//
// With --fast, by its policy for fast location; with --weights, its regular triangulation, in which hidden points
// cannot be removed: these neither go nor come.
//
//   cgal_changing [--changes N] [--fast] [--weights MOST] KIND COUNT
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "../changing_order.h"
#include "../changing_weights.h"
#include "../delaunay_points.h"

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
  const std::size_t cells = changing.number_of_cells();
  std::fprintf(stderr, "%zu vertices\n", changing.number_of_vertices());
  std::vector<typename Triangulation::Vertex_handle> vertices;
  start = std::clock();
  for (const std::size_t i : order) vertices.push_back(changing.insert(points[i]));
  const double find = since(start, order.size());
  start = std::clock();
  std::vector<std::size_t> removed;
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (vertices[k] == typename Triangulation::Vertex_handle() || !changing.is_vertex(vertices[k])) continue;
    changing.remove(vertices[k]);
    removed.push_back(order[k]);
  }
  const double remove = since(start, removed.size());
  start = std::clock();
  for (const std::size_t i : removed) changing.insert(points[i]);
  const double insert = since(start, removed.size());
  std::printf(
      "{\"points\": %zu, \"cells\": %zu, \"build\": %.2f, \"find\": %.2f, \"remove\": %.2f, \"insert\": %.2f}\n",
      points.size(), cells, build, find, remove, insert);
}

}  // namespace

int main(int argc, char** argv) {
  std::size_t changes = 20000;
  bool is_fast = false;
  double most_weight = -1;
  std::vector<std::string> words;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--changes" && i + 1 < argc) {
      changes = std::strtoull(argv[++i], nullptr, 10);
    } else if (word == "--weights" && i + 1 < argc) {
      most_weight = std::strtod(argv[++i], nullptr);
    } else if (word == "--fast") {
      is_fast = true;
    } else {
      words.push_back(word);
    }
  }
  if (words.size() != 2) {
    std::fprintf(stderr, "cgal_changing [--changes N] [--fast] [--weights MOST] KIND COUNT\n");
    return 2;
  }
  const auto made = delaunay_points::make(words[0], std::strtoull(words[1].c_str(), nullptr, 10));
  std::vector<Kernel::Point_3> points;
  for (const auto& [x, y, z] : made) points.emplace_back(x, y, z);
  if (most_weight >= 0) {
    const std::vector<double> weights = changing_weights(made, most_weight);
    std::vector<Kernel::Weighted_point_3> weighted;
    for (std::size_t i = 0; i < points.size(); ++i) weighted.emplace_back(points[i], weights[i]);
    run<CGAL::Regular_triangulation_3<Kernel>>(weighted, changes);
  } else if (is_fast) {
    run<CGAL::Delaunay_triangulation_3<Kernel, CGAL::Fast_location>>(points, changes);
  } else {
    run<CGAL::Delaunay_triangulation_3<Kernel>>(points, changes);
  }
  return 0;
}
