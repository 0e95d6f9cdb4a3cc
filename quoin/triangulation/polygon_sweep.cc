// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/polygon_sweep.h"

#include <algorithm>
#include <iterator>
#include <tuple>

namespace quoin {

namespace {

constexpr std::uint32_t none = 0xFFFFFFFFU;

}  // namespace

template <class Points>
bool PolygonSweep<Points>::run() {
  if (!sort_vertices() || !make_edges()) return false;
  std::size_t first = 0;
  for (std::uint32_t v = 0; v < vertices_.size(); ++v) {
    std::size_t end = first;
    while (end < by_left_.size() && edges_[by_left_[end]].left == v) ++end;
    if (!visit(v, std::span(by_left_).subspan(first, end - first))) return false;
    first = end;
  }
  return status_.empty();
}

template <class Points>
bool PolygonSweep<Points>::sort_vertices() {
  vertices_.assign(loop_points_.begin(), loop_points_.end());
  std::sort(vertices_.begin(), vertices_.end());
  vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
  std::sort(vertices_.begin(), vertices_.end(), [&](std::uint32_t i, std::uint32_t j) {
    const Sign order = points_.compare(i, j);
    return order != Sign::zero ? order == Sign::negative : i < j;
  });
  const auto same = [&](std::uint32_t i, std::uint32_t j) { return points_.compare(i, j) == Sign::zero; };
  return std::adjacent_find(vertices_.begin(), vertices_.end(), same) == vertices_.end();
}

template <class Points>
bool PolygonSweep<Points>::make_edges() {
  std::vector<std::uint32_t> rank_of(points_.size(), none);
  for (std::uint32_t r = 0; r < vertices_.size(); ++r) rank_of[vertices_[r]] = r;
  for (std::size_t l = 0; l + 1 < loop_begin_.size(); ++l) {
    const std::uint32_t begin = loop_begin_[l];
    const std::uint32_t end = loop_begin_[l + 1];
    if (end == begin) return false;
    if (end - begin == 1) continue;
    for (std::uint32_t i = begin; i < end; ++i) {
      const std::uint32_t from = rank_of[loop_points_[i]];
      const std::uint32_t to = rank_of[loop_points_[i + 1 == end ? begin : i + 1]];
      if (from == to) return false;
      edges_.push_back(from < to ? Edge{from, to, true, false} : Edge{to, from, false, true});
    }
  }
  by_left_.resize(edges_.size());
  for (std::uint32_t e = 0; e < edges_.size(); ++e) by_left_[e] = e;
  std::sort(by_left_.begin(), by_left_.end(), [&](std::uint32_t e, std::uint32_t f) {
    return std::tie(edges_[e].left, edges_[e].right, e) < std::tie(edges_[f].left, edges_[f].right, f);
  });
  if (!join_slits()) return false;
  gaps_.assign(edges_.size(), Gap{none, none, none});
  ending_.assign(vertices_.size(), 0);
  for (const std::uint32_t e : by_left_) ++ending_[edges_[e].right];
  return true;
}

// Of two edges between the same vertices the first stays, for both. False where they have one direction.
template <class Points>
bool PolygonSweep<Points>::join_slits() {
  std::size_t kept = 0;
  for (const std::uint32_t e : by_left_) {
    Edge* const last = kept == 0 ? nullptr : &edges_[by_left_[kept - 1]];
    if (last == nullptr || last->left != edges_[e].left || last->right != edges_[e].right) {
      by_left_[kept++] = e;
      continue;
    }
    if ((last->inside_above && edges_[e].inside_above) || (last->inside_below && edges_[e].inside_below)) return false;
    last->inside_above = last->inside_below = true;
  }
  by_left_.resize(kept);
  return true;
}

template <class Points>
Sign PolygonSweep<Points>::turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
  return points_.turn(vertices_[a], vertices_[b], vertices_[c]);
}

// Positive when the vertex lies above the edge, zero when the edge ends there.
template <class Points>
Sign PolygonSweep<Points>::side(std::uint32_t edge, std::uint32_t vertex) const {
  const Edge& e = edges_[edge];
  return e.right == vertex ? Sign::zero : turn(e.left, e.right, vertex);
}

// Of edges that do not cross and that some vertical line meets both.
template <class Points>
bool PolygonSweep<Points>::is_below(std::uint32_t e, std::uint32_t f) const {
  const Edge& a = edges_[e];
  const Edge& b = edges_[f];
  Sign sign = Sign::zero;
  if (a.left <= b.left) {
    if (a.left != b.left) sign = turn(a.left, a.right, b.left);
    if (sign == Sign::zero) sign = turn(a.left, a.right, b.right);
  } else {
    sign = -turn(b.left, b.right, a.left);
    if (sign == Sign::zero) sign = -turn(b.left, b.right, a.right);
  }
  return sign != Sign::zero ? sign == Sign::positive : e < f;
}

// Whether two neighbours in the status keep apart up to the end of the first of them.
template <class Points>
bool PolygonSweep<Points>::are_apart(std::uint32_t lower, std::uint32_t upper) const {
  const Edge& a = edges_[lower];
  const Edge& b = edges_[upper];
  if (a.right == b.right) return turn(a.left, a.right, b.left) != Sign::zero || a.left > b.left;
  if (a.right < b.right) return turn(b.left, b.right, a.right) == Sign::negative;
  return turn(a.left, a.right, b.right) == Sign::positive;
}

template <class Points>
bool PolygonSweep<Points>::visit(std::uint32_t vertex, std::span<std::uint32_t> starting) {
  const auto [first, above] = status_.equal_range(Probe{vertex});
  std::uint32_t ended = 0;
  for (auto e = first; e != above; ++e) {
    if (edges_[*e].right != vertex) return false;  // runs through the vertex
    ++ended;
  }
  if (ended != ending_[vertex]) return false;
  const std::uint32_t below = first == status_.begin() ? none : *std::prev(first);
  const bool inside_below = below != none && edges_[below].inside_above;
  const bool inside_above = ended == 0 ? inside_below : edges_[*std::prev(above)].inside_above;
  if (ended == 0 && starting.empty() && !inside_below) return false;

  Gap lower{none, none, none};
  Gap upper{none, none, none};
  if (ended == 0) {
    if (inside_below) std::tie(lower, upper) = split(gaps_[below], vertex);
  } else {
    if (inside_below) add_at_top(lower = gaps_[below], vertex);
    if (inside_above) add_at_bottom(upper = gaps_[*std::prev(above)], vertex);
    if (!close_gaps(vertex, first, above)) return false;
  }
  const auto after = status_.erase(first, above);

  std::sort(starting.begin(), starting.end(), [&](std::uint32_t e, std::uint32_t f) { return is_below(e, f); });
  bool inside = inside_below;
  for (std::size_t i = 0; i < starting.size(); ++i) {
    if (edges_[starting[i]].inside_below != inside) return false;
    inside = edges_[starting[i]].inside_above;
    if (inside) gaps_[starting[i]] = i + 1 == starting.size() ? upper : fresh_gap(vertex);
  }
  if (inside != inside_above) return false;
  if (inside_below) gaps_[below] = starting.empty() ? merge(lower, upper) : lower;
  return insert_edges(starting, after);
}

template <class Points>
bool PolygonSweep<Points>::close_gaps(std::uint32_t vertex, typename Status::iterator first,
                                      typename Status::iterator end) {
  for (auto e = first; e != end && std::next(e) != end; ++e) {
    if (edges_[*e].inside_above && !close(gaps_[*e], vertex)) return false;
  }
  return true;
}

template <class Points>
bool PolygonSweep<Points>::insert_edges(std::span<const std::uint32_t> starting, typename Status::iterator above) {
  for (std::size_t i = 0; i + 1 < starting.size(); ++i) {
    const Edge& e = edges_[starting[i]];
    if (turn(e.left, e.right, edges_[starting[i + 1]].right) != Sign::positive) return false;
  }
  for (const std::uint32_t e : starting) status_.insert(above, e);
  const auto check = [&](typename Status::iterator upper) {
    return upper == status_.begin() || upper == status_.end() || are_apart(*std::prev(upper), *upper);
  };
  if (!check(above)) return false;
  if (starting.empty()) return true;
  return check(std::prev(above, static_cast<std::ptrdiff_t>(starting.size())));
}

template <class Points>
std::uint32_t PolygonSweep<Points>::new_link(std::uint32_t vertex) {
  links_.push_back({vertex, none, none});
  return static_cast<std::uint32_t>(links_.size() - 1);
}

template <class Points>
auto PolygonSweep<Points>::fresh_gap(std::uint32_t vertex) -> Gap {
  const std::uint32_t link = new_link(vertex);
  return {link, link, link};
}

template <class Points>
void PolygonSweep<Points>::emit(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  triangles_.push_back({vertices_[a], vertices_[b], vertices_[c]});
}

// Cuts off what the vertex sees from the top of the chain, then puts it there.
template <class Points>
void PolygonSweep<Points>::add_at_top(Gap& gap, std::uint32_t vertex) {
  while (gap.top != gap.bottom) {
    const std::uint32_t v = links_[gap.top].vertex;
    const std::uint32_t w = links_[links_[gap.top].below].vertex;
    if (turn(w, vertex, v) != Sign::positive) break;
    emit(w, vertex, v);
    gap.top = links_[gap.top].below;
  }
  const std::uint32_t link = new_link(vertex);
  links_[gap.top].above = link;
  links_[link].below = gap.top;
  gap.top = gap.recent = link;
}

template <class Points>
void PolygonSweep<Points>::add_at_bottom(Gap& gap, std::uint32_t vertex) {
  while (gap.bottom != gap.top) {
    const std::uint32_t v = links_[gap.bottom].vertex;
    const std::uint32_t w = links_[links_[gap.bottom].above].vertex;
    if (turn(v, vertex, w) != Sign::positive) break;
    emit(v, vertex, w);
    gap.bottom = links_[gap.bottom].above;
  }
  const std::uint32_t link = new_link(vertex);
  links_[gap.bottom].below = link;
  links_[link].above = gap.bottom;
  gap.bottom = gap.recent = link;
}

// The vertex lies inside the gap and sees the vertex met last: the chain parts there.
template <class Points>
auto PolygonSweep<Points>::split(const Gap& gap, std::uint32_t vertex) -> std::pair<Gap, Gap> {
  const std::uint32_t copy = new_link(links_[gap.recent].vertex);
  links_[copy].above = links_[gap.recent].above;
  if (gap.recent != gap.top) links_[links_[copy].above].below = copy;
  Gap lower{gap.bottom, gap.recent, none};
  Gap upper{copy, gap.recent == gap.top ? copy : gap.top, none};
  add_at_top(lower, vertex);
  add_at_bottom(upper, vertex);
  return {lower, upper};
}

// Both end in the same vertex, the lower one above, the upper one below.
template <class Points>
auto PolygonSweep<Points>::merge(const Gap& lower, const Gap& upper) -> Gap {
  if (upper.bottom == upper.top) return lower;
  const std::uint32_t next = links_[upper.bottom].above;
  links_[lower.top].above = next;
  links_[next].below = lower.top;
  return {lower.bottom, upper.top, lower.top};
}

// All edges around the gap have met in the vertex, which sees the whole chain.
template <class Points>
bool PolygonSweep<Points>::close(const Gap& gap, std::uint32_t vertex) {
  for (std::uint32_t link = gap.bottom; link != gap.top; link = links_[link].above) {
    const std::uint32_t v = links_[link].vertex;
    const std::uint32_t w = links_[links_[link].above].vertex;
    if (turn(v, vertex, w) != Sign::positive) return false;
    emit(v, vertex, w);
  }
  return true;
}

template class PolygonSweep<PlainPoints>;
template class PolygonSweep<ProjectedPoints>;

}  // namespace quoin
