// SPDX-License-Identifier: Apache-2.0
#include "quoin/topology/collapse.h"

#include <algorithm>

namespace quoin {

namespace {

// A complex that simplices leave, with the number of cofacets that each of the others has left.
class Dismantling {
 public:
  Dismantling(const SimplicialComplex& complex, const Context& context, int least)
      : complex_(complex), context_(context), least_(least), queues_(complex.dimension() + 1) {
    for (int k = 0; k <= complex.dimension(); ++k) {
      context.poll();
      cofacets_.push_back(complex.cofacets(k));
      is_gone_.emplace_back(complex.count(k), false);
      left_.emplace_back(complex.count(k));
      for (std::uint32_t i = 0; i < complex.count(k); ++i) {
        left_[k][i] = static_cast<std::uint32_t>(cofacets_[k][i].size());
        if (left_[k][i] == 1) note_free({k, i});
      }
    }
  }

  // Calls visit(face, coface) for each collapse until nothing is free.
  template <class Visit>
  void collapse(const Visit& visit) {
    while (busiest_ >= 0) {
      Queue& queue = queues_[busiest_];
      if (queue.next == queue.faces.size()) {
        --busiest_;
        continue;
      }
      if ((++steps_ & 4095U) == 0) context_.poll();
      const SimplexId face{busiest_, queue.faces[queue.next++]};
      if (is_gone(face) || left_[face.dimension][face.index] != 1) continue;
      const SimplexId coface{face.dimension + 1, cofacet_left(face)};
      remove(coface);
      remove(face);
      visit(face, coface);
    }
  }

  bool is_gone(SimplexId s) const { return is_gone_[s.dimension][s.index]; }

  void remove(SimplexId s) {
    is_gone_[s.dimension][s.index] = true;
    if (s.dimension == 0) return;
    for (const std::uint32_t facet : complex_.facets(s))
      if (--left_[s.dimension - 1][facet] == 1) note_free({s.dimension - 1, facet});
  }

 private:
  struct Queue {
    std::vector<std::uint32_t> faces;  // that came free, in this order; some are so no longer
    std::size_t next = 0;
  };

  void note_free(SimplexId s) {
    if (s.dimension < least_) return;
    queues_[s.dimension].faces.push_back(s.index);
    busiest_ = std::max(busiest_, s.dimension);
  }

  std::uint32_t cofacet_left(SimplexId s) const {
    const auto cofacets = cofacets_[s.dimension][s.index];
    return *std::find_if(cofacets.begin(), cofacets.end(),
                         [&](std::uint32_t c) { return !is_gone_[s.dimension + 1][c]; });
  }

  const SimplicialComplex& complex_;
  const Context& context_;
  int least_;
  std::vector<SimplexIncidence> cofacets_;
  std::vector<std::vector<bool>> is_gone_;
  std::vector<std::vector<std::uint32_t>> left_;
  std::vector<Queue> queues_;  // by dimension
  int busiest_ = -1;           // no queue of a higher dimension has anything
  std::size_t steps_ = 0;
};

}  // namespace

CollapseResult collapse(const SimplicialComplex& complex, const Context& context, int least) {
  Dismantling dismantling(complex, context, least);
  CollapseResult result;
  dismantling.collapse([&](SimplexId face, SimplexId coface) {
    result.steps.push_back({face.index, coface.index, coface.dimension});
  });
  for (int k = 0; k <= complex.dimension(); ++k)
    for (std::uint32_t i = 0; i < complex.count(k); ++i)
      if (!dismantling.is_gone({k, i})) result.rest.push_back({k, i});
  return result;
}

SimplicialComplex rest_of_collapse(const SimplicialComplex& complex, const CollapseResult& result,
                                   const Context& context) {
  SimplexList list;
  for (const SimplexId s : result.rest) list.add(complex.labels(s));
  return SimplicialComplex::closure_of(list, context);
}

CollapseOrder collapse_order(const SimplicialComplex& complex, const Context& context) {
  context.progress("collapsing", 0);
  CollapseOrder order;
  order.simplices.resize(complex.dimension() + 1);
  order.critical.assign(complex.dimension() + 1, 0);
  Dismantling dismantling(complex, context, 0);
  const auto note_pair = [&](SimplexId face, SimplexId coface) {
    order.simplices[face.dimension].push_back(face.index);
    order.simplices[coface.dimension].push_back(coface.index);
  };
  dismantling.collapse(note_pair);
  for (int k = complex.dimension(); k >= 0; --k) {
    for (std::uint32_t i = 0; i < complex.count(k); ++i) {
      if (dismantling.is_gone({k, i})) continue;
      order.simplices[k].push_back(i);
      ++order.critical[k];
      dismantling.remove({k, i});
      dismantling.collapse(note_pair);
    }
  }
  for (std::vector<std::uint32_t>& simplices : order.simplices) std::reverse(simplices.begin(), simplices.end());
  return order;
}

}  // namespace quoin
