// SPDX-License-Identifier: Apache-2.0
// Times persistent homology and prints a line of JSON; peers/gudhi_persistence.cc does the same with GUDHI.
//
//   persistence_bench [--rounds N] [--threads N] [--prime P] [--method M] grid N SMOOTHING | rips ... | file PATH
#include <chrono>
#include <cstdio>
#include <exception>
#include <limits>
#include <string>
#include <vector>

#include "command_words.h"
#include "filtered_simplices.h"
#include "interval_sum.h"
#include "peak_memory.h"
#include "quoin/topology/homology.h"
#include "quoin/topology/persistence.h"

namespace {

using Clock = std::chrono::steady_clock;

double seconds(Clock::time_point from, Clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

struct Settings {
  int rounds = 1;
  unsigned threads = 1;
  quoin::PersistenceOptions how;
};

void run(const std::vector<std::string>& words, const Settings& settings) {
  filtered_simplices::List input = filtered_simplices::make(words);
  quoin::SimplexList simplices;
  for (std::size_t i = 0; i < input.size(); ++i)
    simplices.add({input.vertices.data() + input.begin[i], input.begin[i + 1] - input.begin[i]});
  input.vertices = {};
  input.begin = {};
  const long input_kb = peak_kb();
  const quoin::Context context({.threads = settings.threads});
  double build = 1e300;
  double best = 1e300;
  std::vector<std::size_t> pairs;
  IntervalSum intervals;
  std::size_t count = 0;
  for (int round = 0; round < settings.rounds; ++round) {
    const auto start = Clock::now();
    const quoin::Grades<double> grades = quoin::grades_of<double>(input.values);
    const quoin::Filtration filtration = quoin::filtration_of(simplices, grades.grade, context);
    const auto built = Clock::now();
    const auto found = quoin::persistence(filtration, settings.how, context);
    const auto end = Clock::now();
    build = std::min(build, seconds(start, built));
    best = std::min(best, seconds(built, end));
    pairs.assign(filtration.complex.dimension() + 1, 0);
    intervals = {};
    const auto value = [&](int dimension, std::uint32_t simplex) {
      return grades.values[filtration.grade[static_cast<std::size_t>(dimension)][simplex]];
    };
    for (const quoin::PersistencePair& pair : found) {
      ++pairs[pair.degree];
      const bool ends = pair.death != quoin::PersistencePair::never;
      intervals.add(pair.degree, value(pair.degree, pair.birth),
                    ends ? value(pair.degree + 1, pair.death) : std::numeric_limits<double>::infinity());
    }
    count = filtration.complex.size();
  }
  std::printf("{\"simplices\": %zu, \"build_seconds\": %.9f, \"seconds\": %.9f, \"pairs\": [", count, build, best);
  for (std::size_t k = 0; k < pairs.size(); ++k) std::printf("%s%zu", k == 0 ? "" : ", ", pairs[k]);
  std::printf("], \"intervals\": \"%016llx\", \"input_kb\": %ld, \"peak_kb\": %ld}\n",
              static_cast<unsigned long long>(intervals.value()), input_kb, peak_kb());
}

}  // namespace

int main(int argc, char** argv) {
  return bench::exit_code_of([&] {
    bench::CommandWords given(argc, argv);
    Settings settings;
    settings.rounds = given.take_number("--rounds", settings.rounds);
    settings.threads = given.take_number("--threads", settings.threads);
    settings.how.prime = given.take_number("--prime", settings.how.prime);
    settings.how.method = given.take_number("--method", settings.how.method);
    run(given.rest(), settings);
  });
}
