// SPDX-License-Identifier: Apache-2.0
// Times Qhull on the points of hull_bench. It merges facets within its own estimate of rounding errors.
//
//   qhull_hull [--rounds N] cube|ball|sphere|lattice COUNT
#include <libqhull_r/qhull_ra.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "../hull_points.h"
#include "../peak_memory.h"

int main(int argc, char** argv) {
  int rounds = 1;
  std::vector<std::string> words;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--rounds" && i + 1 < argc) {
      rounds = std::atoi(argv[++i]);
    } else {
      words.push_back(word);
    }
  }
  if (words.size() != 2) {
    std::fprintf(stderr, "qhull_hull KIND COUNT\n");
    return 2;
  }
  auto points = hull_points::make(words[0], std::strtoull(words[1].c_str(), nullptr, 10));
  double best = 1e300;
  int vertices = 0;
  int facets = 0;
  for (int round = 0; round < rounds; ++round) {
    const auto start = std::chrono::steady_clock::now();
    qhT state;
    qhT* const qh = &state;
    QHULL_LIB_CHECK
    qh_zero(qh, stderr);
    char options[] = "qhull";
    const int failed =
        qh_new_qhull(qh, 3, static_cast<int>(points.size()), points[0].data(), False, options, nullptr, stderr);
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    if (failed != 0) return 1;
    vertices = qh->num_vertices;
    facets = qh->num_facets;
    qh_freeqhull(qh, qh_ALL);
    int kept = 0;
    int total = 0;
    qh_memfreeshort(qh, &kept, &total);
  }
  std::printf("{\"seconds\": %.9f, \"vertices\": %d, \"facets\": %d, \"peak_kb\": %ld}\n", best, vertices, facets,
              peak_kb());
  return 0;
}
