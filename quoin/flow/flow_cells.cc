// SPDX-License-Identifier: Apache-2.0
#include "quoin/flow/flow_cells.h"

#include <algorithm>
#include <bit>

#include "quoin/base/error.h"

namespace quoin {

namespace {

// Ways: slots of facets, 4 + numbers of edges, and these.
constexpr std::uint8_t is_maximum = 10;
constexpr std::uint8_t is_regular = 11;
constexpr std::uint8_t is_cluster = 12;
constexpr std::uint8_t is_member = 13;
constexpr std::uint8_t is_unknown = 14;

constexpr std::size_t fetched_before = 16;  // simplices

CellWay way_of(std::uint8_t code, std::uint32_t cell) {
  if (code < 4) return {CellWay::Kind::facet, cell, code};
  if (code < is_maximum) return {CellWay::Kind::edge, cell, code - 4U};
  return {code == is_maximum ? CellWay::Kind::maximum : CellWay::Kind::regular, cell, 0};
}

}  // namespace

FlowCells::FlowCells(const Delaunay3& triangulation, const Context& context)
    : triangulation_(triangulation), cells_(triangulation.cells()), signs_(triangulation.signs()) {
  if (triangulation.dimension() != 3) throw InputError("a survey of the flow needs points that are not in one plane");
  rows_.resize(cells_.size());
  counts_[0] = triangulation.vertex_count();
  find_shapes(context);
  find_critical_edges(context);
  find_in_clusters(context);
}

/// The neighbours of a simplex whose turn comes soon.
void FlowCells::fetch_neighbours(std::size_t cell) const {
  if (cell >= cells_.size()) return;
  for (const std::uint32_t mate : cells_[cell].neighbours) {
    __builtin_prefetch(&cells_[mate >> 2]);
    __builtin_prefetch(&rows_[mate >> 2], 1);
  }
}

void FlowCells::find_shapes(const Context& context) {
  CellSigns signs(triangulation_);
  // A ghost is in no edge's way, and no centre is behind it.
  for (std::uint32_t c = 0; c < cells_.size(); ++c) {
    if (cells_[c].vertices[3] == vertex_at_infinity) rows_[c].edges = 63 | ghost;
  }
  for (std::uint32_t c = 0; c < cells_.size(); ++c) {
    if (c % 1024 == 0) context.poll();
    fetch_neighbours(c + fetched_before);
    if (is_ghost(c)) continue;
    unsigned tested = 0;
    for (unsigned i = 0; i < 4; ++i) {
      const std::uint32_t other = cells_[c].neighbours[i] >> 2;
      if (other > c && !is_ghost(other)) tested |= 1U << i;
    }
    unsigned spheres = 0;
    rows_[c].shape = signs.shape(c, tested, spheres);
    unsigned edges = 63;
    for (unsigned i = 0; i < 4; ++i) {
      // Bit 6 stands for no edge, and is not among them.
      edges &= ~(1U << opposite_edge[i][rows_[c].shape.wide_corner(i)]);
      if ((spheres >> i & 1) == 0) [[likely]]
        continue;
      const CellFacet other = mate({c, i});
      rows_[c].bits = static_cast<std::uint8_t>(rows_[c].bits | 1U << i);
      rows_[other.cell].bits = static_cast<std::uint8_t>(rows_[other.cell].bits | 1U << other.slot);
    }
    rows_[c].edges = static_cast<std::uint8_t>(edges);
    find_simple_saddles(c);
  }
  undecided_ = signs.undecided();
}

/// Among the facets of a simplex and those before it, or on the hull: all is known of both.
void FlowCells::find_simple_saddles(std::uint32_t cell) {
  const Row row = rows_[cell];
  unsigned left = row.shape.centre_positive() & ~row.shape.wide();
  for (; left != 0; left &= left - 1) {
    const auto i = static_cast<unsigned>(std::countr_zero(left)) / 2;
    const CellFacet other = mate({cell, i});
    const bool is_hull = is_ghost(other.cell);
    if ((!is_hull && other.cell > cell) || !is_triangle({cell, i})) continue;
    if (!is_hull && rows_[other.cell].shape.centre_sign(other.slot) != Sign::positive) continue;
    const CellFacet first = is_hull ? CellFacet{cell, i} : other;
    rows_[first.cell].bits = static_cast<std::uint8_t>(rows_[first.cell].bits | 16U << first.slot);
    ++counts_[2];
  }
}

/// Whether the edge is critical: no corner opposite to it, all around, is right or obtuse. `ring` gets its simplices,
/// each with the edge's bit, all of them or as far as it took to know. Walks both ways round at once, as each step
/// waits for memory.
bool FlowCells::walk_ring(std::uint32_t cell, OtherSlots off, Ring& ring) const {
  const auto bit_at = [](const RingPlace& at) {
    return static_cast<std::uint8_t>(32U >> edge_number[at.behind][at.ahead]);
  };
  const auto allows = [&](const RingPlace& at) {
    ring.emplace_back(at.cell, bit_at(at));
    return (rows_[at.cell].edges & ring.back().second) != 0;
  };
  RingPlace one{cell, off.behind, off.ahead};
  RingPlace other{cell, off.ahead, off.behind};
  ring.clear();
  allows(one);
  for (;;) {
    const std::uint32_t last = other.cell;
    one = one.next(cells_);
    other = other.next(cells_);
    if (one.cell == last) return true;
    const bool is_allowed = allows(one);
    if (one.cell == other.cell) return is_allowed;
    if (!allows(other) || !is_allowed) return false;
  }
}

// Each ring is walked once: for the time being `way` says of which edges of simplices whose turn is still to come the
// answer is known.
void FlowCells::find_critical_edges(const Context& context) {
  Ring ring;
  for (std::uint32_t c = 0; c < cells_.size(); ++c) {
    if (c % 1024 == 0) context.poll();
    fetch_neighbours(c + fetched_before);
    if (is_ghost(c)) continue;
    unsigned left = rows_[c].edges & ~static_cast<unsigned>(rows_[c].way);
    for (; left != 0; left &= left - 1) {
      const auto e = static_cast<unsigned>(std::countr_zero(left));
      const bool is_critical = walk_ring(c, other_slots[edge_slots[e][0]][edge_slots[e][1]], ring);
      for (const auto& [cell, bit] : ring) {
        Row& row = rows_[cell];
        if (cell > c) row.way = static_cast<std::uint8_t>(row.way | bit);
        if (!is_critical) row.edges = static_cast<std::uint8_t>(row.edges & ~bit);
      }
      counts_[1] += is_critical ? 1 : 0;
    }
    rows_[c].way = inner(c) == 0 ? simple_way(rows_[c].shape) : is_unknown;
    counts_[3] += rows_[c].way == is_maximum ? 1 : 0;
  }
}

bool FlowCells::is_first_at_edge(std::uint32_t cell, unsigned edge) const {
  const OtherSlots off = other_slots[edge_slots[edge][0]][edge_slots[edge][1]];
  RingPlace at = RingPlace{cell, off.behind, off.ahead}.next(cells_);
  while (at.cell > cell || (at.cell != cell && is_ghost(at.cell))) at = at.next(cells_);
  return at.cell == cell;
}

/// Facets of a simplex in a larger Delone cell, where they are or may be parts of larger polygons.
void FlowCells::find_polygon_saddles(std::uint32_t cell) {
  for (unsigned i = 0; i < 4; ++i) {
    const CellFacet facet{cell, i};
    if ((inner(cell) >> i & 1) != 0 || shape(cell).centre_sign(i) != Sign::positive) continue;
    const CellFacet other = mate(facet);
    if (is_triangle(facet) || (!is_ghost(other.cell) && cell > other.cell)) continue;
    bool is_first = true;
    for (const CellFacet& part : polygon(facet)) {
      const CellFacet back = mate(part);
      const CellFacet& low = !is_ghost(back.cell) && back.cell < part.cell ? back : part;
      is_first &= facet.number() <= low.number();
    }
    if (!is_first || !is_critical_polygon(facet)) continue;
    rows_[cell].bits = static_cast<std::uint8_t>(rows_[cell].bits | 16U << i);
    ++counts_[2];
  }
}

std::uint8_t FlowCells::simple_way(const CellShape& shape) const {
  const unsigned behind = shape.centre_negative() & ~shape.obtuse();
  if (behind != 0) return static_cast<std::uint8_t>(std::countr_zero(behind) / 2);
  if (shape.centre_negative() == 0) return shape.centre_zero() == 0 ? is_maximum : is_regular;
  for (unsigned i = 0; i < 4; ++i) {
    const unsigned j = shape.obtuse_corner(i);
    if (j != i && shape.obtuse_corner(j) == i) return static_cast<std::uint8_t>(4 + 5 - edge_number[i][j]);
  }
  return is_regular;
}

void FlowCells::find_in_clusters(const Context& context) {
  for (std::uint32_t c = 0; c < cells_.size(); ++c) {
    if (c % 1024 == 0) context.poll();
    if (inner(c) == 0) continue;
    if (rows_[c].way == is_unknown) find_cluster_way(c);
    find_polygon_saddles(c);
  }
  std::sort(members_.begin(), members_.end(), [](const Member& a, const Member& b) { return a.cell < b.cell; });
}

void FlowCells::find_cluster_way(std::uint32_t first) {
  for (const std::uint32_t c : cluster(first)) {
    rows_[c].way = c == first ? is_cluster : is_member;
    if (c != first) members_.push_back({c, first});
  }
  Sign least = Sign::positive;
  CellWay way{CellWay::Kind::regular, first, 0};
  const std::vector<CellFacet> facets = polygons_of(first);
  for (const CellFacet& f : facets) {
    const Sign sign = shape(f.cell).centre_sign(f.slot);
    least = std::min(least, sign);
    if (sign == Sign::negative && way_of_polygon(f).corner == way_of_polygon(f).facet.slot) {
      way = {CellWay::Kind::facet, f.cell, f.slot};
    }
  }
  if (least == Sign::positive) {
    way.kind = CellWay::Kind::maximum;
    ++counts_[3];
  }
  for (std::size_t at = 0; least == Sign::negative && way.kind == CellWay::Kind::regular && at < facets.size(); ++at) {
    const CellFacet& f = facets[at];
    const unsigned corner = shape(f.cell).obtuse_corner(f.slot);
    if (corner == f.slot || is_inside_polygon({f, corner})) continue;
    const CellSide other = turned_inside({f, corner});
    if (shape(other.facet.cell).obtuse_corner(other.facet.slot) != other.corner) continue;
    way = {CellWay::Kind::edge, f.cell, 5 - edge_number[f.slot][corner]};
  }
  cluster_ways_.push_back({first, way});
}

std::uint32_t FlowCells::first_of(std::uint32_t cell) const {
  if (rows_[cell].way != is_member) return cell;
  return std::lower_bound(members_.begin(), members_.end(), cell,
                          [](const Member& m, std::uint32_t c) { return m.cell < c; })
      ->first;
}

CellWay FlowCells::way(std::uint32_t cell) const {
  const std::uint32_t first = first_of(cell);
  if (rows_[first].way != is_cluster) return way_of(rows_[first].way, first);
  return std::lower_bound(cluster_ways_.begin(), cluster_ways_.end(), first,
                          [](const ClusterWay& w, std::uint32_t c) { return w.first < c; })
      ->way;
}

}  // namespace quoin
