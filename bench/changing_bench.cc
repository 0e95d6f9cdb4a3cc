// SPDX-License-Identifier: Apache-2.0
// Times single changes of a Delaunay triangulation of space: of COUNT generated points, takes away and adds some, in an
// order without locality; prints a line of JSON, with microseconds of the processor for each. peers/cgal_changing.cc
// does the same with CGAL.
//
//   changing_bench [--changes N] KIND COUNT
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include "changing_order.h"
#include "delaunay_points.h"
#include "peak_memory.h"
#include "quoin/triangulation/changing_delaunay3.h"

namespace {

double since(std::clock_t start, std::size_t changes) {
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC * 1e6 / static_cast<double>(changes);
}

void run(const std::string& kind, std::size_t count, std::size_t changes) {
  std::vector<quoin::Point3> points;
  for (const auto& [x, y, z] : delaunay_points::make(kind, count)) points.push_back({x, y, z});
  const std::vector<std::size_t> order = changing_order(points.size(), changes);
  const long before = resident_kb();
  std::clock_t start = std::clock();
  quoin::ChangingDelaunay3 changing(points, quoin::Context({.threads = 1}));
  const double build = since(start, points.size());
  // Ids by an insertion once more, which is taken back.
  std::vector<std::uint32_t> vertices;
  start = std::clock();
  for (const std::size_t i : order) vertices.push_back(changing.insert(points[i]));
  const double find = since(start, order.size());
  for (const std::uint32_t v : vertices) {
    while (changing.multiplicity(v) > 1) changing.remove(v);
  }
  start = std::clock();
  for (const std::uint32_t v : vertices) {
    if (changing.lives(v)) changing.remove(v);
  }
  const double remove = since(start, order.size());
  start = std::clock();
  for (const std::size_t i : order) changing.insert(points[i]);
  const double insert = since(start, order.size());
  std::printf(
      "{\"points\": %zu, \"cells\": %zu, \"build\": %.2f, \"find\": %.2f, \"remove\": %.2f, \"insert\": %.2f, "
      "\"before_kb\": %ld, \"peak_kb\": %ld}\n",
      points.size(), changing.cells().size(), build, find, remove, insert, before, peak_kb());
}

}  // namespace

int main(int argc, char** argv) {
  std::size_t changes = 20000;
  std::vector<std::string> words;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--changes" && i + 1 < argc) {
      changes = std::strtoull(argv[++i], nullptr, 10);
    } else {
      words.push_back(word);
    }
  }
  try {
    if (words.size() != 2) throw std::invalid_argument("changing_bench [--changes N] KIND COUNT");
    run(words[0], std::strtoull(words[1].c_str(), nullptr, 10), changes);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
