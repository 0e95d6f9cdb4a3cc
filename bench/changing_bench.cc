// SPDX-License-Identifier: Apache-2.0
// Times single changes of a Delaunay triangulation of space: of COUNT generated points, takes away and adds some, in an
// order without locality; prints a line of JSON, with microseconds of the processor for each. peers/cgal_changing.cc
// does the same with CGAL. With --weights, of a regular triangulation, with weights as changing_weights.h says.
//
//   changing_bench [--changes N] [--weights MOST] KIND COUNT
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include "changing_order.h"
#include "changing_weights.h"
#include "delaunay_points.h"
#include "peak_memory.h"
#include "quoin/triangulation/changing_delaunay3.h"
#include "quoin/triangulation/changing_regular3.h"

namespace {

double since(std::clock_t start, std::size_t changes) {
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC * 1e6 / static_cast<double>(changes);
}

struct Task {
  std::vector<quoin::Point3> points;
  std::vector<double> weights;
  std::vector<std::size_t> order;

  Task(const std::string& kind, std::size_t count, std::size_t changes, double most_weight) {
    const std::vector<delaunay_points::Point> made = delaunay_points::make(kind, count);
    for (const auto& [x, y, z] : made) points.push_back({x, y, z});
    weights = changing_weights(made, most_weight);
    order = changing_order(points.size(), changes);
  }
};

/// `insert_one(i)` inserts one of the points. Hidden ones neither go nor come.
template <class Triangulation, class Insert, class IsHidden>
void run(const Task& task, Triangulation& changing, double build, long before, const Insert& insert_one,
         const IsHidden& is_hidden) {
  const std::size_t cells = changing.cells().size();
  // Ids by an insertion once more, which is taken back.
  std::vector<std::uint32_t> vertices;
  std::clock_t start = std::clock();
  for (const std::size_t i : task.order) vertices.push_back(insert_one(i));
  const double find = since(start, task.order.size());
  for (const std::uint32_t v : vertices) {
    while (changing.multiplicity(v) > 1) changing.remove(v);
  }
  std::vector<std::size_t> shown;
  std::vector<std::uint32_t> goers;
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    if (is_hidden(vertices[k])) continue;
    shown.push_back(task.order[k]);
    goers.push_back(vertices[k]);
  }
  start = std::clock();
  for (const std::uint32_t v : goers) {
    if (changing.lives(v)) changing.remove(v);
  }
  const double remove = since(start, goers.size());
  start = std::clock();
  for (const std::size_t i : shown) insert_one(i);
  const double insert = since(start, shown.size());
  if (changing.cells().size() != cells) throw std::logic_error("other cells than before");
  std::printf(
      "{\"points\": %zu, \"cells\": %zu, \"build\": %.2f, \"find\": %.2f, \"remove\": %.2f, \"insert\": %.2f, "
      "\"before_kb\": %ld, \"peak_kb\": %ld}\n",
      task.points.size(), cells, build, find, remove, insert, before, peak_kb());
}

void run_delaunay(const Task& task) {
  const long before = resident_kb();
  const std::clock_t start = std::clock();
  quoin::ChangingDelaunay3 changing(task.points, quoin::Context({.threads = 1}));
  const double build = since(start, task.points.size());
  const auto insert = [&](std::size_t i) { return changing.insert(task.points[i]); };
  run(task, changing, build, before, insert, [](std::uint32_t) { return false; });
}

void run_regular(const Task& task) {
  const long before = resident_kb();
  const std::clock_t start = std::clock();
  quoin::ChangingRegular3 changing(task.points, task.weights, quoin::Context({.threads = 1}));
  const double build = since(start, task.points.size());
  std::fprintf(stderr, "%zu hidden\n", changing.hidden_count());
  const auto insert = [&](std::size_t i) { return changing.insert(task.points[i], task.weights[i]); };
  run(task, changing, build, before, insert, [&](std::uint32_t v) { return changing.is_hidden(v); });
}

}  // namespace

int main(int argc, char** argv) {
  std::size_t changes = 20000;
  double most_weight = -1;
  std::vector<std::string> words;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--changes" && i + 1 < argc) {
      changes = std::strtoull(argv[++i], nullptr, 10);
    } else if (word == "--weights" && i + 1 < argc) {
      most_weight = std::strtod(argv[++i], nullptr);
    } else {
      words.push_back(word);
    }
  }
  try {
    if (words.size() != 2) throw std::invalid_argument("changing_bench [--changes N] [--weights MOST] KIND COUNT");
    const Task task(words[0], std::strtoull(words[1].c_str(), nullptr, 10), changes, most_weight);
    most_weight < 0 ? run_delaunay(task) : run_regular(task);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
