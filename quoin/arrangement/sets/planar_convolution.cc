// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/sets/planar_convolution.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>

namespace quoin::planar {

namespace {

using Edge = Convolution::Edge;

/// One operand: rings over a common list of points; edge i leaves point i.
struct Operand {
  struct Ring {
    std::uint32_t begin;
    std::uint32_t end;
    bool is_hole;
    Extent extent;
    std::vector<std::uint32_t> by_rank;  // edges
    std::uint32_t next(std::uint32_t i) const { return i + 1 == end ? begin : i + 1; }
    std::uint32_t previous(std::uint32_t i) const { return i == begin ? end - 1 : i - 1; }
  };
  std::vector<PlanarPoint> points;
  std::vector<Direction> directions;
  std::vector<std::uint32_t> rank;  // of directions among those of both operands; equal ones share it
  std::vector<Ring> rings;
  std::vector<std::uint32_t> first_ring;  // by component, and the number of all

  Operand(const LinearPolygonSet& set, const char* name) {
    for (const PlanarComponent& component : components_of(set, name)) {
      first_ring.push_back(static_cast<std::uint32_t>(rings.size()));
      for (const PlanarRing& ring : component.rings) {
        const auto begin = static_cast<std::uint32_t>(points.size());
        points.insert(points.end(), ring.points.begin(), ring.points.end());
        rings.push_back({begin, static_cast<std::uint32_t>(points.size()), ring.is_hole, extent_of(ring), {}});
      }
    }
    first_ring.push_back(static_cast<std::uint32_t>(rings.size()));
    for (const Ring& ring : rings) {
      for (std::uint32_t i = ring.begin; i < ring.end; ++i) directions.emplace_back(points[i], points[ring.next(i)]);
    }
  }
  void sort_rings() {
    for (Ring& ring : rings) {
      ring.by_rank.resize(ring.end - ring.begin);
      std::iota(ring.by_rank.begin(), ring.by_rank.end(), ring.begin);
      std::sort(ring.by_rank.begin(), ring.by_rank.end(),
                [&](std::uint32_t i, std::uint32_t j) { return rank[i] < rank[j]; });
    }
  }
};

void rank_directions(Operand& a, Operand& b) {
  const std::size_t of_a = a.directions.size();
  const auto direction = [&](std::size_t i) -> const Direction& {
    return i < of_a ? a.directions[i] : b.directions[i - of_a];
  };
  std::vector<std::uint32_t> order(of_a + b.directions.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return Direction::compare(direction(i), direction(j)) == Sign::negative;
  });
  a.rank.resize(of_a);
  b.rank.resize(b.directions.size());
  std::uint32_t rank = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i > 0 && Direction::compare(direction(order[i - 1]), direction(order[i])) != Sign::zero) ++rank;
    (order[i] < of_a ? a.rank[order[i]] : b.rank[order[i] - of_a]) = rank;
  }
  a.sort_rings();
  b.sort_rings();
}

/// Calls f for the edges of a ring with ranks in (low, high] or [low, high), cyclically.
template <class Call>
void for_each_between(const Operand& operand, const Operand::Ring& ring, std::uint32_t low, std::uint32_t high,
                      bool with_low, const Call& call) {
  const auto begin = ring.by_rank.begin();
  const auto end = ring.by_rank.end();
  const auto place = [&](std::uint32_t rank) {
    const auto less = [&](std::uint32_t edge, std::uint32_t r) { return operand.rank[edge] < r; };
    return std::lower_bound(begin, end, with_low ? rank : rank + 1, less);
  };
  const auto first = place(low);
  const auto last = place(high);
  if (low < high) {
    std::for_each(first, last, call);
  } else {
    std::for_each(first, end, call);
    std::for_each(begin, last, call);
  }
}

class Convolver {
 public:
  Convolver(Operand& a, Operand& b, Convolution& out) : a_(a), b_(b), out_(out) {}

  /// All rings of two components but holes that the other component cannot enter.
  void add_components(std::uint32_t i, std::uint32_t j) {
    const Extent& extent_of_a = a_.rings[a_.first_ring[i]].extent;
    const Extent& extent_of_b = b_.rings[b_.first_ring[j]].extent;
    for (std::uint32_t r = a_.first_ring[i]; r < a_.first_ring[i + 1]; ++r) {
      if (a_.rings[r].is_hole && !extent_of_b.fits_into(a_.rings[r].extent)) continue;
      for (std::uint32_t s = b_.first_ring[j]; s < b_.first_ring[j + 1]; ++s) {
        if (b_.rings[s].is_hole && !extent_of_a.fits_into(b_.rings[s].extent)) continue;
        add_rings(r, s);
      }
    }
  }

 private:
  void add_rings(std::uint32_t r, std::uint32_t s) {
    const Operand::Ring& ring_a = a_.rings[r];
    const Operand::Ring& ring_b = b_.rings[s];
    for (std::uint32_t q = ring_b.begin; q < ring_b.end; ++q) {
      const std::uint32_t before = ring_b.previous(q);
      const bool is_convex = Direction::turn(b_.directions[before], b_.directions[q]) == Sign::positive;
      const std::uint32_t low = b_.rank[is_convex ? before : q];
      const std::uint32_t high = b_.rank[is_convex ? q : before];
      for_each_between(a_, ring_a, low, high, false, [&](std::uint32_t e) {
        add_edge({e, q}, {ring_a.next(e), q}, r, s, a_.directions[e], is_convex);
      });
    }
    for (std::uint32_t p = ring_a.begin; p < ring_a.end; ++p) {
      const std::uint32_t before = ring_a.previous(p);
      const bool is_convex = Direction::turn(a_.directions[before], a_.directions[p]) == Sign::positive;
      const std::uint32_t low = a_.rank[is_convex ? before : p];
      const std::uint32_t high = a_.rank[is_convex ? p : before];
      for_each_between(b_, ring_b, low, high, true, [&](std::uint32_t e) {
        add_edge({p, e}, {p, ring_b.next(e)}, r, s, b_.directions[e], is_convex);
      });
    }
  }
  void add_edge(Convolution::Corner from, Convolution::Corner to, std::uint32_t r, std::uint32_t s,
                const Direction& direction, bool is_convex) {
    out_.edges.push_back({corner(from), corner(to), r, s, direction.is_lexicographically_negative(),
                          static_cast<std::int8_t>(is_convex ? 1 : -1)});
  }
  std::uint32_t corner(const Convolution::Corner& c) {
    const std::uint64_t key = std::uint64_t{c.p} << 32 | c.q;
    const auto [place, is_new] = number_of_.try_emplace(key, static_cast<std::uint32_t>(out_.corners.size()));
    if (is_new) out_.corners.push_back(c);
    return place->second;
  }

  Operand& a_;
  Operand& b_;
  Convolution& out_;
  std::unordered_map<std::uint64_t, std::uint32_t> number_of_;  // of corners
};

Convolution::Rings taken(Operand& operand) {
  Convolution::Rings result;
  for (const Operand::Ring& ring : operand.rings) {
    result.is_hole.push_back(ring.is_hole);
    for (std::uint32_t i = ring.begin; i < ring.end; ++i) {
      result.next.push_back(ring.next(i));
      result.previous.push_back(ring.previous(i));
    }
  }
  result.points = std::move(operand.points);
  return result;
}

/// Directions from `start` counterclockwise to `end`.
struct Cone {
  Direction start;
  Direction end;

  /// Or it is the start.
  bool contains(const Direction& d) const {
    const bool after_start = Direction::compare(d, start) != Sign::negative;
    const bool before_end = Direction::compare(d, end) == Sign::negative;
    if (Direction::compare(start, end) == Sign::negative) return after_start && before_end;
    return after_start || before_end;
  }
};

}  // namespace

Convolution convolve(const LinearPolygonSet& a, const LinearPolygonSet& b, const Context& context) {
  Operand operand_a(a, "the first operand of a sum");
  Operand operand_b(b, "the second operand of a sum");
  Convolution result;
  if (operand_a.rings.empty() || operand_b.rings.empty()) return result;
  rank_directions(operand_a, operand_b);
  Convolver convolver(operand_a, operand_b, result);
  for (std::uint32_t i = 0; i + 1 < operand_a.first_ring.size(); ++i) {
    for (std::uint32_t j = 0; j + 1 < operand_b.first_ring.size(); ++j) {
      context.poll();
      convolver.add_components(i, j);
    }
  }
  result.a = taken(operand_a);
  result.b = taken(operand_b);
  return result;
}

bool Convolution::meet_at(const Corner& corner) const {
  const PlanarPoint& p = a.points[corner.p];
  const PlanarPoint& q = b.points[corner.q];
  const Cone of_a{{p, a.points[a.next[corner.p]]}, {p, a.points[a.previous[corner.p]]}};
  const Cone of_b{{b.points[b.next[corner.q]], q}, {b.points[b.previous[corner.q]], q}};  // reflected
  return of_a.contains(of_b.start) || of_b.contains(of_a.start);
}

}  // namespace quoin::planar
