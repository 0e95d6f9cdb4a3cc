// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/base/sign.h"
#include "quoin/kernel/predicates2.h"
#include "quoin/triangulation/cavity_fill2.h"
#include "quoin/triangulation/changing_points2.h"
#include "quoin/triangulation/changing_triangles2.h"
#include "quoin/triangulation/insertion2.h"

/// What triangulations of the plane to which points are added and from which they are taken have in common, with
/// weights or without. The infinite vertex is 0.
namespace quoin::detail {

inline constexpr std::uint32_t changing_infinite = 0;

/// Whether all vertices but one, whose star this is, lie on a line: of `count` in all, finite ones.
template <class Point>
bool is_apex_of_line(const VertexStar2& star, std::size_t count, std::span<const Point> points,
                     const Context& context) {
  constexpr std::size_t poll_step = 256;
  std::vector<std::uint32_t> others;
  for (const std::uint32_t v : star.corners) {
    if (v != changing_infinite) others.push_back(v);
  }
  if (others.size() + 1 != count) return false;
  for (std::size_t i = 2; i < others.size(); ++i) {
    if (i % poll_step == 0) context.poll();
    if (orientation(place_of(points[others[0]]), place_of(points[others[1]]), place_of(points[others[i]])) !=
        Sign::zero) {
      return false;
    }
  }
  return true;
}

/// Inserts a vertex, with places for its triangles at the end of the array, which is as it was where that fails.
template <class Predicates>
void insert_vertex(Insertion2<Predicates>& insertion, TriangleArray2& triangles, std::uint32_t v) {
  const std::size_t count = triangles.size();
  triangles.resize(count + 2);
  try {
    insertion.insert(v, static_cast<std::uint32_t>(count), WholePlane());
  } catch (...) {
    triangles.resize(count);
    throw;
  }
}

/// Triangulates all vertices of a line, in order, and one that is not on it. O(n).
template <class Predicates>
TriangleArray2 triangles_over_line(const Predicates& predicates, std::span<const Vertex2> line, Vertex2 apex,
                                   const Context& context) {
  constexpr std::size_t poll_step = 256;
  std::array<std::uint32_t, 3> corners{line[0].value, line[1].value, apex.value};
  if (predicates.turn(corners[0], corners[1], predicates.point(apex.value)) == Sign::negative) {
    std::swap(corners[0], corners[1]);
  }
  TriangleArray2 triangles(4);
  Insertion2<Predicates> insertion(predicates, triangles, changing_infinite);
  insertion.start(corners);
  for (std::size_t i = 2; i < line.size(); ++i) {
    if (i % poll_step == 2) context.poll();
    insert_vertex(insertion, triangles, line[i].value);
  }
  return triangles;
}

/// Replaces the star of a vertex by triangles of its neighbours, in its first places; how many these are. Where it
/// throws nothing has changed. Source: Devillers and Teillaud 2011.
template <class Predicates>
std::size_t fill_star(const Predicates& predicates, TriangleArray2& triangles, const VertexStar2& star,
                      const Context& context) {
  CavityFill2<Predicates> fill(predicates, triangles, changing_infinite, context);
  fill.begin(star.triangles, star.outer);
  // The hole is on the left of the first edge; the other corners go back from its source to its target.
  const std::vector<std::uint32_t> chain(star.corners.rbegin(), star.corners.rend() - 2);
  fill.fill(star.corners[0], star.corners[1], chain, true);
  return fill.end();
}

}  // namespace quoin::detail
