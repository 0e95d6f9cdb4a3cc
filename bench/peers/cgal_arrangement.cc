// SPDX-License-Identifier: Apache-2.0
//
// The peer of arrangements: CGAL with exact predicates and constructions, from kernel objects to an arrangement in
// memory. Prints one line of JSON; "seconds" is the best of several rounds.
//
//   cgal_arrangement [--rounds N] arrange FILE...                segments, circles, great circles or geodesic arcs
//   cgal_arrangement [--rounds N] overlay FILE FILE              of two files of segments that do not cross
//   cgal_arrangement [--rounds N] union FILE                     of polygons or of circles as discs
//   cgal_arrangement [--rounds N] locate ric|landmarks FILE QUERIES
//   cgal_arrangement [--rounds N] minkowski FILE FILE            of two polygons, by reduced convolution
#include "cgal_arrangement.h"

#include <cstdlib>
#include <exception>
#include <fstream>
#include <string_view>

namespace {

using peer::Task;

bool parse(int argc, char** argv, Task& task) {
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "--rounds" && i + 1 < argc) {
      task.rounds = std::max(1, std::atoi(argv[++i]));
    } else if (task.mode.empty()) {
      task.mode = word;
    } else if (task.mode == "locate" && task.strategy.empty()) {
      task.strategy = word;
    } else {
      task.files.emplace_back(word);
    }
  }
  if (task.mode == "arrange") return !task.files.empty();
  if (task.mode == "union") return task.files.size() == 1;
  return (task.mode == "overlay" || task.mode == "locate" || task.mode == "minkowski") && task.files.size() == 2;
}

std::string kind_of(const std::string& path) {
  std::string kind;
  std::ifstream(path) >> kind;
  return kind;
}

void run(const Task& task) {
  const std::string kind = kind_of(task.files[0]);
  if (task.mode == "overlay") return peer::overlay_segments(task);
  if (task.mode == "locate") return peer::locate(task);
  if (task.mode == "minkowski") return peer::add_polygons(task);
  if (task.mode == "union") return kind == "circles" ? peer::unite_discs(task) : peer::unite_polygons(task);
  if (kind == "segments") return peer::arrange_segments(task);
  if (kind == "circles") return peer::arrange_circles(task);
  if (kind == "geodesics") return peer::arrange_geodesics(task);
  if (kind == "great_circles") return peer::arrange_great_circles(task);
  throw std::runtime_error("nothing to arrange in " + task.files[0]);
}

}  // namespace

int main(int argc, char** argv) {
  Task task;
  if (!parse(argc, argv, task)) {
    std::fprintf(stderr,
                 "cgal_arrangement [--rounds N] arrange|overlay|union|locate ric|locate landmarks|minkowski FILE...\n");
    return 2;
  }
  try {
    run(task);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "cgal_arrangement: %s\n", error.what());
    return 1;
  }
  return 0;
}
