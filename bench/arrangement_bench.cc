// SPDX-License-Identifier: Apache-2.0
// Times one operation on arrangements, over a file written by make_arrangement_inputs, and prints a line of JSON.
//
//   arrangement_bench arrange FILE [--rounds N] [--threads N]
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "bench/peak_memory.h"
#include "quoin/arrangement/linear_arrangement.h"

namespace {

using quoin::LinearFamily;

struct Input {
  std::string kind;
  std::vector<double> numbers;
};

Input read_input(const char* path) {
  std::ifstream file(path);
  Input input;
  std::size_t count = 0;
  file >> input.kind >> count;
  for (double number; file >> number;) input.numbers.push_back(number);
  return input;
}

}  // namespace

int main(int argc, char** argv) {
  int rounds = 1;
  for (int i = 3; i + 1 < argc; ++i) {
    if (std::strcmp(argv[i], "--rounds") == 0) rounds = std::atoi(argv[i + 1]);
  }
  const Input input = read_input(argv[2]);
  double best = 1e300;
  quoin::dcel::Counts counts;
  for (int round = 0; round < rounds; ++round) {
    LinearFamily family;
    quoin::PieceList<LinearFamily> list;
    for (std::size_t i = 0; i + 4 <= input.numbers.size(); i += 4) {
      const double* n = input.numbers.data() + i;
      family.add_segment(list, quoin::Point2{n[0], n[1]}, quoin::Point2{n[2], n[3]});
    }
    const auto begin = std::chrono::steady_clock::now();
    const quoin::LinearArrangement result = arrange(std::move(family), list, quoin::Context());
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    counts = result.counts();
  }
  std::printf("{\"seconds\": %.6f, \"vertices\": %zu, \"edges\": %zu, \"faces\": %zu}\n", best, counts.vertices,
              counts.edges, counts.faces);
}
