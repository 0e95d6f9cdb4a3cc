// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/alpha_shape.h"

#include <algorithm>

namespace quoin {

namespace {
constexpr std::size_t poll_interval = 4096;
}  // namespace

AlphaIntervals::AlphaIntervals(const AlphaComplex& alpha, const Context& context) : alpha_(alpha) {
  const SimplicialComplex& complex = alpha.complex();
  const int top = alpha.dimension();
  for (int k = 0; k <= top; ++k) {
    regular_.emplace_back(complex.count(k), AlphaInterval::never);
    interior_.emplace_back(complex.count(k), 0);
  }
  if (top < 0) return;
  for (std::uint32_t i = 0; i < complex.count(top); ++i) {
    regular_[top][i] = interior_[top][i] = alpha.grade_of({top, i});
  }
  std::vector<std::uint8_t> cells(top > 0 ? complex.count(top - 1) : 0);  // of each facet of them
  for (int k = top; k > 0; --k) {
    for (std::uint32_t i = 0; i < complex.count(k); ++i) {
      if (i % poll_interval == 0) context.poll();
      const std::uint32_t grade = alpha.grade_of({k, i});
      for (const std::uint32_t facet : complex.facets({k, i})) {
        regular_[k - 1][facet] = std::min(regular_[k - 1][facet], grade);
        interior_[k - 1][facet] = std::max(interior_[k - 1][facet], interior_[k][i]);
        if (k == top) ++cells[facet];
      }
    }
    if (k < top) continue;
    // On the hull; the faces of these have them among their cofaces.
    for (std::size_t f = 0; f < cells.size(); ++f) {
      if (cells[f] < 2) interior_[k - 1][f] = AlphaInterval::never;
    }
  }
}

AlphaShape alpha_shape(const AlphaComplex& alpha, const AlphaIntervals& intervals, std::uint32_t grades,
                       const Context& context) {
  AlphaShape shape;
  for (int k = 0; k <= alpha.dimension(); ++k) {
    for (std::uint32_t i = 0; i < alpha.complex().count(k); ++i) {
      if (i % poll_interval == 0) context.poll();
      const SimplexId s{k, i};
      const AlphaPlace place = intervals.of(s).place(grades);
      if (place == AlphaPlace::singular) shape.singular.push_back(s);
      if (place == AlphaPlace::regular) shape.regular.push_back(s);
      if (place == AlphaPlace::interior) shape.interior.push_back(s);
    }
  }
  return shape;
}

SimplicialComplex alpha_subcomplex(const AlphaComplex& alpha, std::uint32_t grades, const Context& context) {
  SimplexList list;
  for (int k = 0; k <= alpha.dimension(); ++k) {
    for (std::uint32_t i = 0; i < alpha.complex().count(k); ++i) {
      if (i % poll_interval == 0) context.poll();
      if (alpha.grade_of({k, i}) < grades) list.add(alpha.complex().vertices({k, i}));
    }
  }
  return SimplicialComplex::closure_of(list, context);
}

}  // namespace quoin
