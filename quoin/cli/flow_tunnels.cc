// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/flow_tunnels.h"

#include <cstdint>

#include "quoin/topology/persistence.h"
#include "quoin/triangulation/alpha_complex.h"

namespace quoin::cli {

namespace {

/// By grade, the point of the one critical point of an index that has it; never_in_scene where there are others.
class OnlyPoints {
 public:
  explicit OnlyPoints(std::uint32_t grades) : point_(grades, none) {}

  void add(std::uint32_t grade, std::uint32_t point) { point_[grade] = point_[grade] == none ? point : never_in_scene; }
  std::uint32_t operator[](std::uint32_t grade) const { return point_[grade] == none ? never_in_scene : point_[grade]; }

 private:
  static constexpr std::uint32_t none = never_in_scene - 1;
  std::vector<std::uint32_t> point_;
};

}  // namespace

std::vector<GradedPair> tunnels_of(const FlowGraph& graph, const FlowGrades& grades, const FlowPlaces& places,
                                   const Context& context) {
  OnlyPoints edges(grades.count());
  OnlyPoints saddles(grades.count());
  for (std::uint32_t i = 0; i < grades.edges().size(); ++i) edges.add(grades.of_edge(i), places.first_edge + i);
  for (std::uint32_t i = 0; i < graph.saddles().size(); ++i) saddles.add(grades.of_saddle(i), places.first_saddle + i);
  const AlphaComplex alpha(graph.cells().triangulation(), context);
  const Filtration& filtration = alpha.filtration();
  std::vector<GradedPair> tunnels;
  for (const PersistencePair& pair : persistence(filtration, {}, context)) {
    if (tunnels.size() % 256 == 0) context.poll();
    if (pair.degree != 1) continue;
    const std::uint32_t from = filtration.grade_of({1, pair.birth});
    const std::uint32_t to = filtration.grade_of({2, pair.death});  // space has no tunnel that stays
    if (from == to) continue;
    const std::uint32_t birth = grades.up_to(alpha.exact_value(from)) - 1;
    const std::uint32_t death = grades.up_to(alpha.exact_value(to)) - 1;
    tunnels.push_back({1, birth, death, edges[birth], saddles[death]});
  }
  return tunnels;
}

}  // namespace quoin::cli
