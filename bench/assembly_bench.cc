// SPDX-License-Identifier: Apache-2.0
// Prints how long assemblies take, as tables.
//
//   assembly_bench [--rounds N]        the Split Star by pieces of a part, in the columns of Table 5.2 of Fogel 2009
//   assembly_bench --stacks PARTS...   stacks of so many boxes, of equal and of different sizes
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include "peak_memory.h"
#include "quoin/assembly/assembly.h"
#include "quoin/assembly/test_assemblies.h"

namespace {

using namespace quoin;
using namespace quoin::test_assemblies;
using Clock = std::chrono::steady_clock;

AssemblyPart timed_part(const std::string& name, const Pieces& pieces) {
  const auto start = Clock::now();
  std::vector<Polytope> polytopes;
  for (const Points& piece : pieces) polytopes.push_back(Polytope::hull_of(piece, one_thread));
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  AssemblyPart part = make_part(name, std::move(polytopes), one_thread);
  part.map_seconds = seconds;
  return part;
}

std::vector<AssemblyPart> timed_parts(const std::vector<Pieces>& pieces) {
  std::vector<AssemblyPart> parts;
  for (std::size_t p = 0; p < pieces.size(); ++p) parts.push_back(timed_part(std::to_string(p), pieces[p]));
  return parts;
}

/// A pieces and B vertices of a part, C pieces, D sums, E arrangements that the source builds; then seconds of phases.
void print_split_star(int pieces, int rounds) {
  AssemblyPlan best;
  for (int round = 0; round < rounds; ++round) {
    AssemblyPlan plan = analyse_assembly(timed_parts(split_star_pieces(pieces)), {}, one_thread);
    if (round == 0 || plan.times.total() < best.times.total()) best = std::move(plan);
  }
  std::size_t vertices = 0;
  const Pieces first = split_star_pieces(pieces)[0];
  for (const Points& piece : first) vertices += piece.size();
  const std::size_t sums = best.pairs.counts.total();
  const PhaseTimes& t = best.times;
  std::printf("| %d | %zu | %d | %zu | %zu | n/a | %.4f | %.4f | %.4f | %.4f | %.4f | %.4f | %.4f | %.4f |\n", pieces,
              vertices, 6 * pieces, sums, 12 * static_cast<std::size_t>(pieces) + 2 * sums + 31, t.maps, t.reflections,
              t.sums, t.projections, t.unions, t.motion_space, t.processing, t.total());
}

std::vector<Pieces> boxes(int count, bool are_equal) {
  Random random(3);
  std::vector<Pieces> parts;
  double at = 0;
  for (int i = 0; i < count; ++i) {
    const auto more = [&](double unit) { return are_equal ? 0 : unit * static_cast<double>(random() % 64); };
    const double height = 1 + more(1.0 / 64);
    const double x = 2 + more(1.0 / 32);
    const double y = 2 + more(1.0 / 32);
    parts.push_back({box({-x, -y, at}, {x, y, at + height})});
    at += height;
  }
  return parts;
}

void print_stack(int count, bool are_equal) {
  AssemblyQuestion question;
  question.partition.max_solutions = 1000;
  const auto start = Clock::now();
  const AssemblyPlan plan = analyse_assembly(timed_parts(boxes(count, are_equal)), question, one_thread);
  const double all = std::chrono::duration<double>(Clock::now() - start).count();
  question.solutions = false;
  question.sequence = true;
  const auto again = Clock::now();
  const AssemblyPlan sequence = analyse_assembly(timed_parts(boxes(count, are_equal)), question, one_thread);
  const double apart = std::chrono::duration<double>(Clock::now() - again).count();
  const MotionCounts& cells = plan.partition->cells;
  std::printf("| %d | %s | %zu | %zu | %zu | %.3f | %.3f | %ld |\n", count, are_equal ? "equal" : "different",
              plan.pairs.pairs.size(), plan.groups.size(), cells.vertices + cells.edges + cells.faces, all, apart,
              peak_kb() / 1024);
  if (!sequence.disassembly->is_complete()) throw std::runtime_error("a stack did not come apart");
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  try {
    if (words.size() > 1 && words[0] == "--stacks") {
      std::printf("| parts | boxes | pairs | regions | cells | all solutions, s | sequence, s | peak MB |\n");
      std::printf("|---|---|---|---|---|---|---|---|\n");
      for (const bool are_equal : {true, false}) {
        for (std::size_t k = 1; k < words.size(); ++k) print_stack(std::stoi(words[k]), are_equal);
      }
      return 0;
    }
    const bool has_rounds = words.size() == 2 && words[0] == "--rounds";
    if (!words.empty() && !has_rounds) throw std::invalid_argument("assembly_bench [--rounds N] | --stacks PARTS...");
    std::printf("| A | B | C | D | E | 1 | 2 | 3 | 4 | 5 | 6 | 7 | 8 | sum 2-8 |\n");
    std::printf("|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (const int pieces : {3, 5, 8}) print_split_star(pieces, has_rounds ? std::stoi(words[1]) : 1);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
