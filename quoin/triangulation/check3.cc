// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/check3.h"

#include <algorithm>
#include <array>
#include <vector>

#include "quoin/kernel/predicates2.h"
#include "quoin/kernel/predicates3.h"

namespace quoin {

namespace {

constexpr std::size_t poll_step = 1024;

Point2 projected(const Point3& p, std::size_t axis) {
  return {p[(axis + 1) % 3], p[(axis + 2) % 3]};
}

class CellCheck {
 public:
  CellCheck(std::span<const TriangulationCell> cells, int dimension, std::span<const Point3> points,
            const Context& context)
      : cells_(cells), d_(static_cast<unsigned>(dimension)), points_(points), context_(context) {}

  std::string run() {
    if (points_.empty() || d_ > 3) return "wrong dimension";
    if (std::string found = defect_of_links(); !found.empty()) return found;
    if (d_ < 2) return defect_of_line();
    if (d_ == 2 && !lie_in_one_plane()) return "points do not lie in one plane";
    for (std::uint32_t c = 0; c < cells_.size(); ++c) {
      if (c % poll_step == 0) context_.poll();
      if (std::string found = defect_of_cell(c); !found.empty()) return "cell " + std::to_string(c) + found;
    }
    return defect_of_counts();
  }

 private:
  const Point3& at(std::uint32_t vertex) const { return points_[vertex]; }
  bool is_ghost(std::uint32_t c) const { return cells_[c].vertices[d_] == vertex_at_infinity; }

  std::string defect_of_links() const {
    for (std::uint32_t c = 0; c < cells_.size(); ++c) {
      if (c % poll_step == 0) context_.poll();
      for (unsigned i = 0; i <= d_; ++i) {
        const std::uint32_t v = cells_[c].vertices[i];
        if (v >= points_.size() && !(v == vertex_at_infinity && i == d_))
          return "cell " + std::to_string(c) + " names a vertex that is not there";
      }
    }
    for (std::uint32_t c = 0; c < cells_.size(); ++c) {
      if (c % poll_step == 0) context_.poll();
      for (unsigned i = 0; i <= d_; ++i) {
        if (!is_mutual(c, i)) return "cell " + std::to_string(c) + " and its neighbour do not share a facet";
      }
    }
    return {};
  }

  std::array<std::uint32_t, 4> facet(std::uint32_t c, unsigned slot) const {
    std::array<std::uint32_t, 4> sorted = cells_[c].vertices;
    sorted[slot] = no_vertex;
    for (unsigned i = d_ + 1; i < 4; ++i) sorted[i] = no_vertex;
    std::sort(sorted.begin(), sorted.end());
    return sorted;
  }

  bool is_mutual(std::uint32_t c, unsigned slot) const {
    const std::uint32_t mate = cells_[c].neighbours[slot];
    if ((mate >> 2) >= cells_.size() || (mate & 3) > d_) return false;
    return cells_[mate >> 2].neighbours[mate & 3] == c * 4 + slot && facet(c, slot) == facet(mate >> 2, mate & 3);
  }

  std::string defect_of_line() const {
    std::vector<std::uint32_t> order(points_.size());
    for (std::uint32_t v = 0; v < order.size(); ++v) order[v] = v;
    std::sort(order.begin(), order.end(),
              [this](std::uint32_t a, std::uint32_t b) { return lexicographically_less(at(a), at(b)); });
    if (d_ != (points_.size() > 1 ? 1U : 0U)) return "wrong dimension";
    std::vector<std::uint32_t> place(order.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) {
      place[order[i]] = i;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (orientation(projected(at(order.front()), axis), projected(at(order.back()), axis),
                        projected(at(order[i]), axis)) != Sign::zero)
          return "points do not lie on one line";
      }
    }
    std::size_t finite = 0;
    for (std::uint32_t c = 0; c < cells_.size(); ++c) {
      if (is_ghost(c)) continue;
      ++finite;
      const auto& v = cells_[c].vertices;
      if (d_ == 1 && std::max(place[v[0]], place[v[1]]) - std::min(place[v[0]], place[v[1]]) != 1)
        return "cell " + std::to_string(c) + " has points between its ends";
    }
    return finite == std::max<std::size_t>(points_.size() - 1, 1) ? "" : "cells are missing";
  }

  /// Of the first finite cell. Finds the axis along which the plane can be projected.
  bool lie_in_one_plane() {
    std::uint32_t first = 0;
    while (first < cells_.size() && is_ghost(first)) ++first;
    if (first == cells_.size()) return false;
    const auto& v = cells_[first].vertices;
    Sign turn = Sign::zero;
    for (axis_ = 0; axis_ < 3 && turn == Sign::zero; ++axis_) turn = flat_turn(v[0], v[1], v[2], axis_);
    if (turn == Sign::zero) return false;
    --axis_;
    turn_ = turn;
    return std::ranges::all_of(
        points_, [&](const Point3& p) { return orientation(at(v[0]), at(v[1]), at(v[2]), p) == Sign::zero; });
  }

  Sign flat_turn(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::size_t axis) const {
    return orientation(projected(at(a), axis), projected(at(b), axis), projected(at(c), axis));
  }

  std::string defect_of_cell(std::uint32_t c) const {
    if (is_ghost(c)) return is_convex_at(c) ? "" : " makes the hull concave";
    const auto& v = cells_[c].vertices;
    const bool is_positive = d_ == 3 ? orientation(at(v[0]), at(v[1]), at(v[2]), at(v[3])) == Sign::positive
                                     : flat_turn(v[0], v[1], v[2], axis_) == turn_;
    if (!is_positive) return " turns the wrong way";
    for (unsigned i = 0; i <= d_; ++i) {
      const std::uint32_t mate = cells_[c].neighbours[i];
      const std::uint32_t there = cells_[mate >> 2].vertices[mate & 3];
      if (there == vertex_at_infinity || is_ghost(mate >> 2)) continue;
      if (is_inside(v, there)) return " has a vertex in its sphere";
    }
    return {};
  }

  bool is_inside(const std::array<std::uint32_t, 4>& v, std::uint32_t vertex) const {
    if (d_ == 3) return in_sphere(at(v[0]), at(v[1]), at(v[2]), at(v[3]), at(vertex)) == Sign::positive;
    // The circle is where the plane meets any sphere through it, also that through a point off the plane.
    Point3 apex = at(v[0]);
    apex[axis_] = apex[axis_] == 0 ? 1 : 0;
    const Sign side = orientation(at(v[0]), at(v[1]), at(v[2]), apex);
    const Sign inside = in_sphere(at(v[0]), at(v[1]), at(v[2]), apex, at(vertex));
    return inside != Sign::zero && inside == side;
  }

  /// The hull across each side of a ghost does not rise above it.
  bool is_convex_at(std::uint32_t ghost) const {
    const auto& v = cells_[ghost].vertices;
    for (unsigned i = 0; i < d_; ++i) {
      const std::uint32_t mate = cells_[ghost].neighbours[i];
      const std::uint32_t beyond = cells_[mate >> 2].vertices[mate & 3];
      if (!is_ghost(mate >> 2) || beyond == vertex_at_infinity) return false;
      if (d_ == 3) {
        if (orientation(at(v[0]), at(v[1]), at(v[2]), at(beyond)) == Sign::positive) return false;
      } else {
        // The apex of the triangle below the side says where inside is.
        const std::uint32_t below = cells_[ghost].neighbours[d_];
        const Sign inside = flat_turn(v[0], v[1], cells_[below >> 2].vertices[below & 3], axis_);
        const Sign there = flat_turn(v[0], v[1], beyond, axis_);
        if (inside == Sign::zero || (there != Sign::zero && there != inside)) return false;
      }
    }
    return true;
  }

  /// Every vertex is one of a cell, and the hull is a sphere or a circle.
  std::string defect_of_counts() const {
    std::vector<bool> is_used(points_.size());
    std::vector<bool> is_on_hull(points_.size());
    std::size_t ghosts = 0;
    for (std::uint32_t c = 0; c < cells_.size(); ++c) {
      ghosts += is_ghost(c) ? 1 : 0;
      for (unsigned i = 0; i <= d_; ++i) {
        const std::uint32_t v = cells_[c].vertices[i];
        if (v == vertex_at_infinity) continue;
        (is_ghost(c) ? is_on_hull : is_used)[v] = true;
      }
    }
    if (std::ranges::count(is_used, false) > 0) return "a vertex is one of no cell";
    const auto hull = static_cast<std::size_t>(std::ranges::count(is_on_hull, true));
    return ghosts == (d_ == 3 ? 2 * hull - 4 : hull) ? "" : "the hull is not one surface";
  }

  std::span<const TriangulationCell> cells_;
  unsigned d_;
  std::span<const Point3> points_;
  const Context& context_;
  std::size_t axis_ = 2;        ///< of a plane: along which it is projected
  Sign turn_ = Sign::positive;  ///< of its triangles in that projection
};

}  // namespace

std::string defect_of_cells(std::span<const TriangulationCell> cells, int dimension, std::span<const Point3> points,
                            const Context& context) {
  return CellCheck(cells, dimension, points, context).run();
}

std::string defect(const Delaunay3& delaunay, std::span<const Point3> inputs, const Context& context) {
  std::vector<Point3> points(delaunay.vertex_count());
  std::vector<bool> is_found(inputs.size(), false);
  std::size_t found = 0;
  for (std::uint32_t v = 0; v < points.size(); ++v) {
    if (v % poll_step == 0) context.poll();
    points[v] = delaunay.point(v);
    for (const std::uint32_t i : delaunay.inputs(v)) {
      if (i >= inputs.size() || is_found[i]) return "vertex " + std::to_string(v) + " names a point once too often";
      is_found[i] = true;
      ++found;
      if (!(inputs[i] == points[v])) return "point " + std::to_string(i) + " is not at its vertex";
    }
  }
  if (found != inputs.size()) return "points are missing";
  return defect_of_cells(delaunay.cells(), delaunay.dimension(), points, context);
}

}  // namespace quoin
