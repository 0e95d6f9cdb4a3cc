// SPDX-License-Identifier: Apache-2.0
// Times single removals and insertions in CGAL's Delaunay triangulation of space, in microseconds of the processor, on
// the points of changing_bench.
//
// With --fast, by its policy for fast location.
//
//   cgal_changing [--changes N] [--fast] KIND COUNT
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "../changing_order.h"
#include "../delaunay_points.h"

namespace {

double since(std::clock_t start, std::size_t changes) {
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC * 1e6 / static_cast<double>(changes);
}

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

template <class Triangulation>
void run(const std::string& kind, std::size_t count, std::size_t changes) {
  std::vector<Kernel::Point_3> points;
  for (const auto& [x, y, z] : delaunay_points::make(kind, count)) points.emplace_back(x, y, z);
  const std::vector<std::size_t> order = changing_order(points.size(), changes);
  std::clock_t start = std::clock();
  Triangulation changing(points.begin(), points.end());
  const double build = since(start, points.size());
  std::vector<typename Triangulation::Vertex_handle> vertices;
  start = std::clock();
  for (const std::size_t i : order) vertices.push_back(changing.insert(points[i]));
  const double find = since(start, order.size());
  start = std::clock();
  for (const auto v : vertices) {
    if (changing.is_vertex(v)) changing.remove(v);
  }
  const double remove = since(start, order.size());
  start = std::clock();
  for (const std::size_t i : order) changing.insert(points[i]);
  const double insert = since(start, order.size());
  std::printf(
      "{\"points\": %zu, \"cells\": %zu, \"build\": %.2f, \"find\": %.2f, \"remove\": %.2f, \"insert\": %.2f}\n",
      points.size(), changing.number_of_cells(), build, find, remove, insert);
}

}  // namespace

int main(int argc, char** argv) {
  std::size_t changes = 20000;
  bool is_fast = false;
  std::vector<std::string> words;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--changes" && i + 1 < argc) {
      changes = std::strtoull(argv[++i], nullptr, 10);
    } else if (word == "--fast") {
      is_fast = true;
    } else {
      words.push_back(word);
    }
  }
  if (words.size() != 2) {
    std::fprintf(stderr, "cgal_changing [--changes N] [--fast] KIND COUNT\n");
    return 2;
  }
  const std::size_t count = std::strtoull(words[1].c_str(), nullptr, 10);
  if (is_fast) {
    run<CGAL::Delaunay_triangulation_3<Kernel, CGAL::Fast_location>>(words[0], count, changes);
  } else {
    run<CGAL::Delaunay_triangulation_3<Kernel>>(words[0], count, changes);
  }
  return 0;
}
