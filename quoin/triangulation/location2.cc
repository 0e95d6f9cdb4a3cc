// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/location2.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <unordered_set>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/kernel/call_grid.h"
#include "quoin/kernel/predicates2.h"
#include "quoin/triangulation/delaunay_walks.h"

namespace quoin {

namespace {

void require_finite(const Point2& query) {
  if (!std::isfinite(query.x) || !std::isfinite(query.y)) throw InputError("the query is not finite");
}

// Samples are evenly spaced ids, and ids follow a curve through all points. Rounded distances do: any start is right.
Vertex2 nearest_sample(const TriangulationView2& triangulation, const Point2& query) {
  const std::size_t count = triangulation.vertex_count();
  const auto samples = 1 + static_cast<std::size_t>(std::cbrt(static_cast<double>(count)));
  Vertex2 best(0);
  double least = 0;
  for (std::size_t i = 0; i < samples; ++i) {
    const Vertex2 v(count * i / samples);
    const double distance = std::hypot(triangulation.point(v).x - query.x, triangulation.point(v).y - query.y);
    if (i > 0 && !(distance < least)) continue;
    best = v;
    least = distance;
  }
  return best;
}

WeightedPoint2 weighted(const TriangulationView2& triangulation, Vertex2 v) {
  return {triangulation.point(v), triangulation.weight(v)};
}

// Of the distances of two vertices, or their powers.
Sign compare(const TriangulationView2& triangulation, const Point2& query, Vertex2 a, Vertex2 b) {
  return compare_powers(query, weighted(triangulation, a), weighted(triangulation, b));
}

Location2 locate_on_line(const TriangulationView2& triangulation, const Point2& query) {
  const std::span<const Vertex2> line = triangulation.line();
  const auto after = std::lower_bound(line.begin(), line.end(), query, [&](Vertex2 v, const Point2& q) {
    return lexicographically_less(triangulation.point(v), q);
  });
  Location2 found;
  if (after == line.end()) return found;
  if (triangulation.point(*after) == query) {
    found.place = Location2::Place::vertex;
    found.vertex = *after;
  } else if (after != line.begin() &&
             orientation(triangulation.point(after[-1]), triangulation.point(*after), query) == Sign::zero) {
    found.place = Location2::Place::edge;
    found.on_line = static_cast<std::size_t>(after - line.begin()) - 1;
  }
  return found;
}

// In the closed triangle, by the turns along its three edges, none negative.
Location2 place_in(const Triangulation2& links, Triangle2 t, const std::array<Sign, 3>& turns) {
  Location2 found;
  for (unsigned slot = 0; slot < 3; ++slot) {
    if (turns[slot] != Sign::zero) continue;
    found.place = Location2::Place::edge;
    found.edge = Edge2(t, slot);
    for (const unsigned other : {next_slot(slot), previous_slot(slot)}) {
      if (turns[other] != Sign::zero) continue;
      found.place = Location2::Place::vertex;
      found.vertex = links.corner(t, 3 - slot - other);
      return found;
    }
    return found;
  }
  found.place = Location2::Place::triangle;
  found.triangle = t;
  return found;
}

Vertex2 nearest_on_line(const TriangulationView2& triangulation, const Point2& query) {
  const std::span<const Vertex2> line = triangulation.line();
  if (line.empty()) return {};
  // Distances, and powers, of vertices fall and then rise, so this is a partition: the next is nearer.
  std::size_t low = 0;
  std::size_t high = line.size() - 1;
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    const bool falls = compare(triangulation, query, line[middle + 1], line[middle]) == Sign::negative;
    (falls ? low : high) = falls ? middle + 1 : middle;
  }
  Vertex2 smallest = line[low];
  for (std::size_t i = low + 1; i < line.size(); ++i) {
    if (compare(triangulation, query, line[low], line[i]) != Sign::zero) break;
    smallest = std::min(smallest, line[i]);
  }
  return smallest;
}

// The neighbour that is nearest to the query, the vertex itself if none is nearer; of equal ones the smallest.
Vertex2 nearest_neighbour(const TriangulationView2& triangulation, const Point2& query, Vertex2 v) {
  Vertex2 best = v;
  triangulation.links().for_edges_from(v, [&](Edge2 e) {
    const Vertex2 other = triangulation.links().target(e);
    if (triangulation.links().is_infinite(other)) return;
    const Sign order = compare(triangulation, query, other, best);
    if (order == Sign::negative || (order == Sign::zero && other < best)) best = other;
  });
  return best;
}

// All nearest vertices lie on an empty circle about the query, with weights on one face of the lower hull of lifted
// points: they are in one Delone cell or side, joined by edges between equally near ones.
Vertex2 smallest_of_ties(const TriangulationView2& triangulation, const Point2& query, Vertex2 v) {
  std::vector<Vertex2> tied{v};
  std::unordered_set<std::uint32_t> is_tied{v.value};
  for (std::size_t i = 0; i < tied.size(); ++i) {
    triangulation.links().for_edges_from(tied[i], [&](Edge2 e) {
      const Vertex2 other = triangulation.links().target(e);
      if (triangulation.links().is_infinite(other) || is_tied.count(other.value) != 0) return;
      if (compare(triangulation, query, other, v) != Sign::zero) return;
      is_tied.insert(other.value);
      tied.push_back(other);
    });
  }
  return *std::min_element(tied.begin(), tied.end());
}

// Nothing where it takes more steps from triangle to triangle.
std::optional<Location2> walk(const TriangulationView2& triangulation, const Point2& query, Vertex2 from,
                              std::size_t steps) {
  const Triangulation2& links = triangulation.links();
  Edge2 entry = links.edge_from(from);
  while (links.is_infinite(entry.triangle())) entry = links.around_source(entry);
  for (;; --steps) {
    const Triangle2 t = entry.triangle();
    std::array<Sign, 3> turns{};
    Edge2 exit;
    // The entry last: the walk came through it, but for the first.
    for (unsigned slot = next_slot(entry.slot()), k = 0; k < 3 && exit.is_none(); ++k, slot = next_slot(slot)) {
      const Edge2 e(t, slot);
      turns[slot] = orientation(triangulation.point(links.source(e)), triangulation.point(links.target(e)), query);
      if (turns[slot] == Sign::negative) exit = links.twin(e);
    }
    if (exit.is_none()) return place_in(links, t, turns);
    if (links.is_infinite(exit.triangle())) {
      Location2 found;
      found.edge = exit;
      return found;
    }
    if (steps == 0) return std::nullopt;
    entry = exit;
  }
}

}  // namespace

Location2 locate(const TriangulationView2& triangulation, const Point2& query, Vertex2 near) {
  require_finite(query);
  if (triangulation.dimension() < 2) return locate_on_line(triangulation, query);
  return walk_from(
      near.is_none() ? std::nullopt : std::optional(near),
      [&](Vertex2 from, std::size_t steps) { return walk(triangulation, query, from, steps); },
      [&] { return nearest_sample(triangulation, query); });
}

Vertex2 nearest_vertex(const TriangulationView2& triangulation, const Point2& query, Vertex2 near) {
  require_finite(query);
  if (triangulation.dimension() < 2) return nearest_on_line(triangulation, query);
  const Location2 place = locate(triangulation, query, near);
  if (place.place == Location2::Place::vertex && !triangulation.is_weighted()) return place.vertex;
  const Triangulation2& links = triangulation.links();
  Vertex2 best = place.vertex;
  if (place.place == Location2::Place::triangle) best = links.corner(place.triangle, 0);
  if (best.is_none()) best = links.source(place.edge);
  for (;;) {
    const Vertex2 next = nearest_neighbour(triangulation, query, best);
    if (next == best || compare(triangulation, query, next, best) == Sign::zero) break;
    best = next;
  }
  return smallest_of_ties(triangulation, query, best);
}

Sign compare_distances(const Point2& q, const Point2& a, const Point2& b) {
  const double ax = q.x - a.x;
  const double ay = q.y - a.y;
  const double bx = q.x - b.x;
  const double by = q.y - b.y;
  const double to_a = ax * ax + ay * ay;
  const double to_b = bx * bx + by * by;
  // Squares are off by 3 u of themselves, sums by 4 u, the difference by 5 u (1 + 8 u) = 5.5512e-16 of the sum; squares
  // that underflow by 2^-1075. Where anything overflows the bound is infinite.
  const int sign = filter::certain_sign(to_a - to_b, 6e-16 * (to_a + to_b) + 0x1p-1000);
  if (sign != 0) return static_cast<Sign>(sign);
  Tier ignored;
  const std::array<double, 6> values{q.x, q.y, a.x, a.y, b.x, b.y};
  return detail::decide_on_grid(values, ignored, [&]<class N>(const detail::CallReader<N>& difference) {
    using Quadratic = typename N::Quadratic;
    const auto square = [&](const Point2& p) {
      const auto x = difference(q.x, p.x);
      const auto y = difference(q.y, p.y);
      return detail::product<Quadratic>(x, x) + detail::product<Quadratic>(y, y);
    };
    return (square(a) - square(b)).sign();
  });
}

// Squares and their sums as in compare_distances, off by 4 u of their sum S; their difference, that of the weights, of
// size W, and the difference of these are rounded by u each: 6 u S + 2 u W, less than 6.7e-16 (S + W).
Sign compare_powers(const Point2& q, const WeightedPoint2& a, const WeightedPoint2& b) {
  if (a.weight == b.weight) return compare_distances(q, a.point, b.point);
  const auto square = [&q](const Point2& p) {
    const double x = q.x - p.x;
    const double y = q.y - p.y;
    return x * x + y * y;
  };
  const double to_a = square(a.point);
  const double to_b = square(b.point);
  const double weights = a.weight - b.weight;
  const double size = to_a + to_b + std::fabs(weights);
  const int sign = filter::certain_sign((to_a - to_b) - weights, 8e-16 * size + 0x1p-1000);
  if (sign != 0) return static_cast<Sign>(sign);
  return static_cast<Sign>(
      compare_powers({q.x, q.y, 0}, {a.point.x, a.point.y, 0}, a.weight, {b.point.x, b.point.y, 0}, b.weight));
}

}  // namespace quoin
