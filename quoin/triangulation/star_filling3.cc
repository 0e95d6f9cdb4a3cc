// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/star_filling3.h"

#include <algorithm>

#include "quoin/base/error.h"
#include "quoin/triangulation/circulators.h"
#include "quoin/triangulation/delaunay_signs.h"
#include "quoin/triangulation/insertion_round.h"
#include "quoin/triangulation/regular_signs.h"

namespace quoin {

namespace {

constexpr std::size_t few = 64;  // points that are inserted as they come
constexpr std::size_t poll_step = 256;

std::array<std::uint32_t, 3> facet_of(const TriangulationCell& cell, unsigned slot) {
  const auto& [a, b, c] = facet_slots[slot];
  return {cell.vertices[a], cell.vertices[b], cell.vertices[c]};
}

}  // namespace

template <class Signs>
bool StarFilling3<Signs>::find(const CellArray& cells, const HiddenLists& hidden, std::uint32_t v, std::uint32_t first,
                               const Context& context) {
  find_star(cells, 4, v, first, star_, &context);
  find_link_vertices(cells, 4, v, star_, points_);
  if (hidden.count() > 0) add_hidden(hidden, context);
  if (!choose_simplex(cells, v, context)) return false;
  read_hole(cells, v);
  triangulate(context);
  read_filling(v, context);
  return true;
}

template <class Signs>
void StarFilling3<Signs>::add_hidden(const HiddenLists& hidden, const Context& context) {
  for (const std::uint32_t c : star_) {
    for (std::uint32_t id = hidden.first(c); id != HiddenLists::none; id = hidden.next(id)) {
      if (points_.size() % poll_step == 0) context.poll();
      points_.push_back(id);
    }
  }
}

/// Three of the vertices of a cell, and one off their plane: of the points, or else beyond a facet opposite to v, and
/// then inserted with them. It changes nothing of what is in conflict with v, whose star has all cells that it has.
template <class Signs>
bool StarFilling3<Signs>::choose_simplex(const CellArray& cells, std::uint32_t v, const Context& context) {
  const auto is_finite = [&cells](std::uint32_t c) { return cells[c].vertices[3] != vertex_at_infinity; };
  const std::uint32_t base = *std::ranges::find_if(star_, is_finite);
  const auto [a, b, c] = facet_of(cells[base], slot_of(cells[base], v));
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (i % poll_step == 0) context.poll();
    simplex_ = {a, b, c, points_[i]};
    if (points_[i] != a && points_[i] != b && points_[i] != c && signs_.orientation(a, b, c, points_[i]) != 0)
      return true;
  }
  for (const std::uint32_t k : star_) {
    if (!is_finite(k)) continue;
    const std::uint32_t beyond = cells[k].neighbours[slot_of(cells[k], v)];
    simplex_[3] = cells[beyond >> 2].vertices[beyond & 3];
    if (simplex_[3] != vertex_at_infinity) return true;
  }
  return false;
}

template <class Signs>
void StarFilling3<Signs>::read_hole(const CellArray& cells, std::uint32_t v) {
  outside_.clear();
  for (const std::uint32_t c : star_) {
    const unsigned slot = slot_of(cells[c], v);
    outside_.push_back(side(facet_of(cells[c], slot), cells[c].neighbours[slot]));
  }
  sort(outside_);
}

template <class Signs>
void StarFilling3<Signs>::triangulate(const Context& context) {
  engine_.start(simplex_);
  if (points_.size() > few) return insert_in_rounds(context);
  const PollingRegion region(context);
  for (const std::uint32_t v : points_) insert(v, region);
}

/// By their ids they are in no order, so these are as good as ranks for rounds.
template <class Signs>
void StarFilling3<Signs>::insert_in_rounds(const Context& context) {
  const PollingRegion region(context);
  std::size_t inserted = 0;
  for (unsigned round = insertion_rounds; round-- > 0;) {
    for (const std::uint32_t v : points_) {
      if (insertion_round(v) != round) continue;
      if (++inserted % poll_step == 0) context.poll();
      insert(v, region);
    }
  }
}

template <class Signs>
void StarFilling3<Signs>::insert(std::uint32_t v, const PollingRegion& region) {
  if (std::ranges::find(simplex_, v) == simplex_.end()) engine_.insert(v, region, [](std::uint32_t) {});
}

template <class Signs>
void StarFilling3<Signs>::read_filling(std::uint32_t v, const Context& context) {
  engine_.find_conflicts(v, PollingRegion(context));
  engine_.close();
  fill_.assign(engine_.conflicts().begin(), engine_.conflicts().end());
  number_.assign(filling_.size(), no_vertex);
  for (std::uint32_t k = 0; k < fill_.size(); ++k) number_[fill_[k]] = k;
  inside_.clear();
  for (const HoleFacet& facet : engine_.facets()) {
    const std::uint32_t code = filling_[facet.outer >> 2].neighbours[facet.outer & 3];
    inside_.push_back(side(facet.vertices, number_[code >> 2] * 4 + (code & 3)));
  }
  sort(inside_);
  const auto is_same = [](const Side& a, const Side& b) { return a.edge == b.edge; };
  if (!std::ranges::equal(inside_, outside_, is_same)) {
    throw InternalError("what fills the star of vertex " + std::to_string(v) + " has another boundary");
  }
}

template <class Signs>
void StarFilling3<Signs>::write(CellArray& cells, std::span<const std::uint32_t> places) const {
  const auto place = [&](std::uint32_t code) { return places[code >> 2] * 4 + (code & 3); };
  for (std::size_t k = 0; k < fill_.size(); ++k) {
    const TriangulationCell& from = filling_[fill_[k]];
    TriangulationCell& to = cells[places[k]];
    to.vertices = from.vertices;
    for (unsigned i = 0; i < 4; ++i) {
      const std::uint32_t mate = from.neighbours[i];
      const std::uint32_t number = number_[mate >> 2];
      if (number != no_vertex) to.neighbours[i] = place(number * 4 + (mate & 3));
    }
  }
  for (std::size_t i = 0; i < inside_.size(); ++i) {
    const std::uint32_t inner = place(inside_[i].code);
    const std::uint32_t outer = outside_[i].code;
    cells[inner >> 2].neighbours[inner & 3] = outer;
    cells[outer >> 2].neighbours[outer & 3] = inner;
  }
}

/// Facets of a closed surface, all oriented alike, have no directed edge in common.
template <class Signs>
typename StarFilling3<Signs>::Side StarFilling3<Signs>::side(const std::array<std::uint32_t, 3>& facet,
                                                             std::uint32_t code) {
  const auto least = static_cast<std::size_t>(std::ranges::min_element(facet) - facet.begin());
  return {std::uint64_t{facet[least]} << 32 | facet[(least + 1) % 3], code};
}

template <class Signs>
void StarFilling3<Signs>::sort(std::vector<Side>& sides) {
  std::ranges::sort(sides, {}, &Side::edge);
}

template class StarFilling3<DelaunaySigns>;
template class StarFilling3<RegularSigns>;

}  // namespace quoin
