// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <unordered_set>
#include <vector>

#include "quoin/kernel/point.h"
#include "quoin/kernel/predicates3.h"
#include "quoin/triangulation/cell_array.h"

namespace quoin {

/// Where a point is in a triangulation of space, of any dimension: in a face of it, which may be a cell or, of a lower
/// dimension, what takes the place of one; outside the convex hull of the vertices, but in the plane or on the line
/// that they span; or off that, which of dimension 0 is any other point.
struct DelaunayLocation {
  enum class Kind { vertex, edge, facet, cell, outside, outside_affine_hull };
  Kind kind = Kind::outside;
  /// A cell of the face; outside, a ghost of a facet of the hull that sees the point; 0 outside the affine hull.
  std::uint32_t cell = 0;
  unsigned slots = 0;  ///< bit i: slot i of the cell is a vertex of the face, or of the facet of the hull
};

/// @throws InputError where a point that is looked for is not finite
void require_finite(const Point3& p);

/// Sign of |p - a|^2 - |p - b|^2. Exact.
int compare_distances(const Point3& p, const Point3& a, const Point3& b);

/// Sign of (|p - a|^2 - weight_a) - (|p - b|^2 - weight_b), of power distances. Exact for all finite doubles.
int compare_powers(const Point3& p, const Point3& a, double weight_a, const Point3& b, double weight_b);

/// Steps after which a walk from where its caller wished begins anew, at a sampled place: more than walks across a
/// million points take that are spread evenly, in the plane or in space. What is long and thin has longer ones.
inline constexpr std::size_t most_steps_from_hint = 4096;
/// Of walks without a limit. These end, since cells are in an acyclic order as seen from any point (Edelsbrunner 1990).
inline constexpr std::size_t any_steps = std::numeric_limits<std::size_t>::max();

/// The smallest face that a point is in, by a walk from a cell of a triangulation of dimension 2 or 3, Delaunay or
/// regular; nothing where that takes more steps. `side(cell, slot)` is the side of the facet opposite to the slot on
/// which the point is, positive for that of the cell.
template <class Side>
std::optional<DelaunayLocation> walk_at_most(std::size_t steps, std::span<const TriangulationCell> cells,
                                             unsigned dimension, std::uint32_t start, const Side& side) {
  const auto is_ghost = [&](std::uint32_t c) { return cells[c].vertices[dimension] == vertex_at_infinity; };
  std::uint32_t here = is_ghost(start) ? cells[start].neighbours[dimension] >> 2 : start;
  for (;; --steps) {
    if (is_ghost(here)) return DelaunayLocation{DelaunayLocation::Kind::outside, here, (1U << dimension) - 1};
    unsigned slots = 0;
    unsigned exit = 0;
    for (; exit <= dimension; ++exit) {
      const Sign found = side(here, exit);
      if (found == Sign::negative) break;
      if (found == Sign::positive) slots |= 1U << exit;
    }
    if (exit > dimension)
      return DelaunayLocation{static_cast<DelaunayLocation::Kind>(std::popcount(slots) - 1), here, slots};
    if (steps == 0) return std::nullopt;
    here = cells[here].neighbours[exit] >> 2;
  }
}

/// The same of dimension 3. `at(v)` is the point of a vertex.
template <class At>
std::optional<DelaunayLocation> walk_to(const Point3& p, std::size_t steps, std::span<const TriangulationCell> cells,
                                        std::uint32_t start, const At& at) {
  return walk_at_most(steps, cells, 3, start, [&](std::uint32_t cell, unsigned slot) {
    const auto& v = cells[cell].vertices;
    const auto& [a, b, c] = facet_slots[slot];
    return orientation(at(v[a]), at(v[b]), at(v[c]), p);
  });
}

/// What a walk finds from the hint if there is one, and where that takes too long, or there is none, from `near()`.
/// `walk(start, steps)` gives nothing where it takes more steps.
template <class Start, class Walk, class Near>
auto walk_from(const std::optional<Start>& hint, const Walk& walk, const Near& near) {
  if (hint) {
    if (const auto found = walk(*hint, most_steps_from_hint)) return *found;
  }
  return *walk(near(), any_steps);
}

/// The vertex of least distance or power, of equal ones the one of the smallest number, by a walk over edges from a
/// vertex, each to a nearer one. `compare(v, w)` is the sign of the difference of theirs; `neighbours(v)` are those of
/// a vertex.
template <class Compare, class Neighbours>
std::uint32_t walk_to_least(std::uint32_t start, const Compare& compare, const Neighbours& neighbours) {
  // Distances less the square of the point are heights of lifted points above a plane, linear on each cell and convex:
  // the nearest of all is the one that no neighbour is nearer than. Others as near share a Delone cell with it, and are
  // reached through neighbours that are as near.
  std::uint32_t best = start;
  for (bool is_moving = true; is_moving;) {
    is_moving = false;
    for (const std::uint32_t v : neighbours(best)) {
      if (compare(v, best) < 0) {
        best = v;
        is_moving = true;
      }
    }
  }
  std::vector<std::uint32_t> ties{best};
  std::unordered_set<std::uint32_t> is_tied{best};
  for (std::size_t k = 0; k < ties.size(); ++k) {
    for (const std::uint32_t v : neighbours(ties[k])) {
      if (is_tied.count(v) != 0 || compare(v, best) != 0) continue;
      is_tied.insert(v);
      ties.push_back(v);
    }
  }
  return *std::min_element(ties.begin(), ties.end());
}

/// The same by distance. `at(v)` is the point of a vertex.
template <class At, class Neighbours>
std::uint32_t walk_to_nearest(const Point3& p, std::uint32_t start, const At& at, const Neighbours& neighbours) {
  return walk_to_least(
      start, [&](std::uint32_t v, std::uint32_t w) { return compare_distances(p, at(v), at(w)); }, neighbours);
}

}  // namespace quoin
