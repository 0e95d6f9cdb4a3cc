// SPDX-License-Identifier: Apache-2.0
#include "quoin/flow/flow_complex.h"

#include <algorithm>

#include "quoin/flow/face_formulas.h"

namespace quoin {

namespace {

std::vector<Point3> points_of(const Delaunay3& triangulation) {
  std::vector<Point3> points;
  for (std::uint32_t v = 0; v < triangulation.vertex_count(); ++v) points.push_back(triangulation.point(v));
  return points;
}

FlowKind kind_at(Sign least) {
  return least == Sign::positive ? FlowKind::critical : FlowKind::regular;
}

}  // namespace

FlowComplex::FlowComplex(const Delaunay3& triangulation, const Context& context)
    : faces_(triangulation, context), points_(points_of(triangulation)), signs_(faces_, points_, context) {
  kinds_[0].assign(faces_.count(0), FlowKind::critical);
  classify_edges();
  classify_polygons();
  classify_cells(context);
}

// The midpoint is on the dual if no apex around the edge is in the closed ball over it: those of one polygon are in it
// together, and the duals of polygons bound that of the edge.
void FlowComplex::classify_edges() {
  kinds_[1].assign(faces_.count(1), FlowKind::critical);
  for (std::uint32_t f = 0; f < faces_.count(2); ++f) {
    const std::span<const std::uint32_t> sides = faces_.sides(f);
    for (std::size_t i = 0; i < sides.size(); ++i) {
      if (signs_.at_side(faces_, f, i) != Sign::positive) kinds_[1][sides[i]] = FlowKind::passing;
    }
  }
}

void FlowComplex::classify_polygons() {
  for (std::uint32_t f = 0; f < faces_.count(2); ++f) {
    DeloneFace crossed{2, f};
    Sign least = Sign::positive;
    const std::span<const std::uint32_t> sides = faces_.sides(f);
    for (std::size_t i = 0; i < sides.size(); ++i) {
      const Sign sign = signs_.at_side(faces_, f, i);
      least = std::min(least, sign);
      if (sign == Sign::negative) crossed = {1, sides[i]};
    }
    const bool is_on_dual = signs_.at_polygon(f, 0) == Sign::positive && signs_.at_polygon(f, 1) == Sign::positive;
    crossed_by_polygons_.push_back(crossed);
    kinds_[2].push_back(least != Sign::negative && is_on_dual ? kind_at(least) : FlowKind::passing);
  }
}

// Around an edge of the cell, the nearest point of the cell to its centre is the midpoint if all other vertices see the
// edge under an obtuse angle; those of the two polygons at the edge decide, since the cell is in the wedge of them.
std::uint32_t FlowComplex::edge_that_separates(std::uint32_t cell) const {
  for (const std::uint32_t f : faces_.polygons_of_cell(cell)) {
    const std::span<const std::uint32_t> sides = faces_.sides(f);
    for (std::size_t i = 0; i < sides.size(); ++i) {
      if (signs_.at_side(faces_, f, i) != Sign::negative) continue;
      const std::array<std::uint32_t, 2> pair = faces_.polygons_at_edge(cell, sides[i]);
      const std::uint32_t other = pair[0] == f ? pair[1] : pair[0];
      if (signs_.at_side(faces_, other, faces_.side_of(other, sides[i])) == Sign::negative) return sides[i];
    }
  }
  return DeloneFaces::outside;
}

void FlowComplex::classify_cells(const Context& context) {
  for (std::uint32_t c = 0; c < faces_.count(3); ++c) {
    if (c % 1024 == 0) context.poll();
    Sign least = Sign::positive;
    DeloneFace crossed{3, c};
    for (const std::uint32_t f : faces_.polygons_of_cell(c)) {
      const Sign sign = signs_.at_polygon(f, faces_.cells_of_polygon(f)[0] == c ? 0 : 1);
      least = std::min(least, sign);
      // The nearest point is the circle's centre where that is in the polygon.
      if (sign == Sign::negative && crossed_by_polygons_[f].dimension == 2) crossed = {2, f};
    }
    if (least == Sign::negative && crossed.dimension == 3) crossed = {1, edge_that_separates(c)};
    crossed_by_cells_.push_back(crossed);
    kinds_[3].push_back(least == Sign::negative ? FlowKind::passing : kind_at(least));
  }
}

FlowKind FlowComplex::kind(DeloneFace face) const {
  return kinds_[face.dimension][face.index];
}

DeloneFace FlowComplex::crossed(DeloneFace face) const {
  if (face.dimension == 3) return crossed_by_cells_[face.index];
  if (face.dimension == 2) return crossed_by_polygons_[face.index];
  return face;
}

std::vector<std::uint32_t> FlowComplex::entering_edges(DeloneFace face) const {
  std::vector<std::uint32_t> edges;
  if (face.dimension == 2) {
    const std::span<const std::uint32_t> sides = faces_.sides(face.index);
    for (std::size_t i = 0; i < sides.size(); ++i) {
      if (signs_.at_side(faces_, face.index, i) == Sign::positive) edges.push_back(sides[i]);
    }
  }
  if (face.dimension == 3) {
    for (const std::uint32_t f : faces_.polygons_of_cell(face.index)) {
      const std::span<const std::uint32_t> sides = faces_.sides(f);
      for (std::size_t i = 0; i < sides.size(); ++i) {
        const std::array<std::uint32_t, 2> pair = faces_.polygons_at_edge(face.index, sides[i]);
        const std::uint32_t other = pair[0] == f ? pair[1] : pair[0];
        if (other > f && signs_.at_side(faces_, f, i) == Sign::positive &&
            signs_.at_side(faces_, other, faces_.side_of(other, sides[i])) == Sign::positive) {
          edges.push_back(sides[i]);
        }
      }
    }
    std::sort(edges.begin(), edges.end());
  }
  return edges;
}

bool FlowComplex::has_entering_polygon(std::uint32_t cell) const {
  for (const std::uint32_t f : faces_.polygons_of_cell(cell)) {
    const std::size_t side = faces_.cells_of_polygon(f)[0] == cell ? 0 : 1;
    if (crossed_by_polygons_[f].dimension == 2 && signs_.at_polygon(f, side) == Sign::positive) return true;
  }
  return false;
}

std::vector<DeloneFace> FlowComplex::faces_of_kind(FlowKind kind) const {
  std::vector<DeloneFace> found;
  for (unsigned d = 0; d < 4; ++d) {
    for (std::uint32_t i = 0; i < kinds_[d].size(); ++i) {
      if (kinds_[d][i] == kind) found.push_back({d, i});
    }
  }
  return found;
}

std::array<std::size_t, 4> FlowComplex::counts() const {
  std::array<std::size_t, 4> counts{};
  for (unsigned d = 0; d < 4; ++d) {
    counts[d] = static_cast<std::size_t>(std::count(kinds_[d].begin(), kinds_[d].end(), FlowKind::critical));
  }
  return counts;
}

}  // namespace quoin
