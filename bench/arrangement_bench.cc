// SPDX-License-Identifier: Apache-2.0
// Times one operation on arrangements over files of make_arrangement_inputs and prints a line of JSON; what a peer does
// with the same files is in peers/.
//
//   arrangement_bench [--rounds N] [--threads N] arrange FILE... | overlay A B | union FILE
//                     | locate ric|landmarks FILE QUERIES | minkowski A B
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

#include "arrangement_tasks.h"
#include "command_words.h"

namespace {

bench::Task read_task(bench::CommandWords given) {
  bench::Task task;
  task.rounds = given.take_number("--rounds", task.rounds);
  task.threads = given.take_number("--threads", task.threads);
  for (const std::string& word : given.rest()) {
    if (task.mode.empty()) {
      task.mode = word;
    } else if (task.mode == "locate" && task.strategy.empty()) {
      task.strategy = word;
    } else {
      task.files.push_back(word);
    }
  }
  return task;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const bench::Task task = read_task({argc, argv});
    if (task.mode == "arrange") {
      bench::arrange(task);
    } else if (task.mode == "overlay") {
      bench::overlay(task);
    } else if (task.mode == "union") {
      bench::unite(task);
    } else if (task.mode == "locate") {
      bench::locate(task);
    } else if (task.mode == "minkowski") {
      bench::minkowski(task);
    } else {
      std::fprintf(stderr, "which operation?\n");
      return 2;
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
