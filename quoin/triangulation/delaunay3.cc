// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/delaunay3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <new>
#include <string>

#include "quoin/base/error.h"
#include "quoin/kernel/predicates2.h"
#include "quoin/kernel/predicates3.h"
#include "quoin/triangulation/affine_basis.h"
#include "quoin/triangulation/canonical_cells.h"
#include "quoin/triangulation/incremental3.h"
#include "quoin/triangulation/spatial_order.h"

namespace quoin {

namespace {

constexpr std::size_t most_points = 150'000'000;  // 2^30 cells
constexpr std::size_t cells_per_point = 8;        // somewhat more than in a volume; only what is used takes memory

/// Of a coordinate; refuses what is not finite.
double largest_magnitude(std::span<const Point3> points) {
  double largest = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double size = std::fabs(points[i][axis]);
      if (!(size <= std::numeric_limits<double>::max())) {
        throw InputError("point " + std::to_string(i) + " of the triangulation is not finite");
      }
      largest = std::max(largest, size);
    }
  }
  return largest;
}

/// A power of two that brings coordinates into the range of the filters, without changing any of them by a rounding; 1
/// where none does.
double scale_of(std::span<const Point3> points, double largest) {
  if (largest == 0 || (largest < 0x1p130 && largest > 0x1p-100)) return 1;
  int exponent = 0;
  std::frexp(largest, &exponent);
  const double scale = std::ldexp(1.0, std::clamp(-exponent, -1000, 1000));
  for (const Point3& p : points) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (p[axis] * scale / scale != p[axis]) return 1;
    }
  }
  return scale;
}

Point3 scaled(const Point3& p, double scale) {
  return {p.x * scale + 0.0, p.y * scale + 0.0, p.z * scale + 0.0};  // -0 becomes 0
}

}  // namespace

Delaunay3::Delaunay3(std::span<const Point3> points, const Context& context, const DelaunayOptions& options) {
  if (points.empty()) throw InputError("a triangulation of no points");
  if (points.size() > most_points) {
    throw InputError("a triangulation takes at most " + std::to_string(most_points) + " points, not " +
                     std::to_string(points.size()));
  }
  try {
    take_points(points, context);
    build(context);
    if (options.is_canonical) make_canonical();
  } catch (const std::bad_alloc&) {
    throw InputError("too little memory for the triangulation of " + std::to_string(points.size()) +
                     " points, which needs about " + std::to_string(points.size() / 4000 + 1) + " MB");
  }
}

void Delaunay3::take_points(std::span<const Point3> points, const Context& context) {
  const double scale = scale_of(points, largest_magnitude(points));
  unscale_ = 1 / scale;
  inputs_ = hilbert_order(points, context);
  points_.reserve(points.size() + 1);
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    const Point3 p = scaled(points[inputs_[i]], scale);
    const bool is_new = points_.empty() || !(points_.back() == p);
    if (!is_new && input_begin_.empty()) {
      input_begin_.resize(points_.size());
      for (std::size_t v = 0; v < points_.size(); ++v) input_begin_[v] = static_cast<std::uint32_t>(v);
    }
    if (!is_new) continue;
    if (!input_begin_.empty()) input_begin_.push_back(static_cast<std::uint32_t>(i));
    points_.push_back(p);
  }
  vertex_count_ = points_.size();
  if (!input_begin_.empty()) input_begin_.push_back(static_cast<std::uint32_t>(inputs_.size()));
}

void Delaunay3::build(const Context& context) {
  const AffineBasis basis = affine_basis({points_.data(), points_.size()}, context);
  dimension_ = static_cast<int>(basis.vertices.size()) - 1;
  if (dimension_ < 2) return build_chain();
  std::vector<std::uint32_t> simplex = basis.vertices;
  if (dimension_ == 2) {
    points_.push_back(point_off_plane({points_.data(), points_.size()}, basis));
    simplex.push_back(static_cast<std::uint32_t>(vertex_count_));
  }
  insert_all(simplex, context);
  if (dimension_ == 2) drop_apex();
}

void Delaunay3::insert_all(std::span<const std::uint32_t> simplex, const Context& context) {
  const DelaunaySigns own_signs = signs();
  cells_.reserve(points_.size() * cells_per_point + 64);
  IncrementalTriangulation<DelaunaySigns> engine(own_signs, points_.size(), cells_);
  engine.start({simplex[0], simplex[1], simplex[2], simplex[3]});
  std::size_t done = 0;
  for (unsigned round = insertion_rounds; round-- > 0;) {
    for (std::uint32_t v = 0; v < vertex_count_; ++v) {
      if (insertion_round(v) != round || std::find(simplex.begin(), simplex.end(), v) != simplex.end()) continue;
      if (++done % 1024 == 0) {
        context.progress("triangulate", static_cast<double>(done) / static_cast<double>(vertex_count_));
      }
      engine.insert(v, [](std::uint32_t) {});
    }
  }
  engine.compact();
}

void Delaunay3::drop_apex() {
  const auto apex = static_cast<std::uint32_t>(vertex_count_);
  CellArray flat;
  std::vector<std::uint32_t> number(cells_.size(), no_vertex);
  std::vector<std::array<std::uint32_t, 4>> place(cells_.size());  // slot here of each slot there
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    const std::array<std::uint32_t, 4>& v = cells_[c].vertices;
    const auto at = static_cast<unsigned>(std::find(v.begin(), v.end(), apex) - v.begin());
    if (at == 4) continue;
    // The apex last, infinity before it; the first two so that the permutation is even.
    const unsigned third = v[3] == vertex_at_infinity ? 3 : at == 3 ? 2 : 3;
    std::array<unsigned, 4> from{4, 4, third, at};
    for (unsigned i = 0; i < 4; ++i) {
      if (i != third && i != at) from[from[0] == 4 ? 0 : 1] = i;
    }
    unsigned inversions = 0;
    for (unsigned i = 0; i < 4; ++i) {
      for (unsigned j = 0; j < i; ++j) inversions += from[j] > from[i] ? 1 : 0;
    }
    if (inversions % 2 == 1) std::swap(from[0], from[1]);
    number[c] = static_cast<std::uint32_t>(flat.size());
    TriangulationCell cell{};
    for (unsigned i = 0; i < 4; ++i) {
      cell.vertices[i] = v[from[i]];
      cell.neighbours[i] = cells_[c].neighbours[from[i]];
      place[c][from[i]] = i;
    }
    flat.push_back(cell);
  }
  for (TriangulationCell& cell : flat) {
    for (unsigned i = 0; i < 3; ++i) {
      const std::uint32_t mate = cell.neighbours[i];
      cell.neighbours[i] = number[mate >> 2] * 4 + place[mate >> 2][mate & 3];
    }
    cell.vertices[3] = no_vertex;
    cell.neighbours[3] = no_vertex;
  }
  cells_ = std::move(flat);
}

void Delaunay3::build_chain() {
  std::vector<std::uint32_t> chain(vertex_count_);
  for (std::uint32_t v = 0; v < vertex_count_; ++v) chain[v] = v;
  std::sort(chain.begin(), chain.end(),
            [this](std::uint32_t a, std::uint32_t b) { return lexicographically_less(points_[a], points_[b]); });
  constexpr std::uint32_t none = no_vertex;
  const auto segments = static_cast<std::uint32_t>(vertex_count_ - 1);
  if (segments == 0) {
    cells_.push_back({{0, none, none, none}, {4, none, none, none}});
    cells_.push_back({{vertex_at_infinity, none, none, none}, {0, none, none, none}});
    return;
  }
  // Two ghosts close the circle; each faces its segment with the slot of infinity.
  const std::uint32_t left = segments;
  const std::uint32_t right = segments + 1;
  for (std::uint32_t i = 0; i < segments; ++i) {
    const std::uint32_t next = i + 1 < segments ? (i + 1) * 4 + 1 : right * 4 + 1;
    const std::uint32_t previous = i > 0 ? (i - 1) * 4 : left * 4 + 1;
    cells_.push_back({{chain[i], chain[i + 1], none, none}, {next, previous, none, none}});
  }
  cells_.push_back({{chain.front(), vertex_at_infinity, none, none}, {right * 4, 1, none, none}});
  cells_.push_back({{chain.back(), vertex_at_infinity, none, none}, {left * 4, (segments - 1) * 4, none, none}});
}

void Delaunay3::make_canonical() {
  sort_cells(cells_, dimension_);
}

std::size_t Delaunay3::finite_cell_count() const {
  std::size_t count = 0;
  for (std::size_t c = 0; c < cells_.size(); ++c) count += is_ghost(c) ? 0 : 1;
  return count;
}

int Delaunay3::in_sphere(const DelaunaySigns& signs, std::size_t cell, std::uint32_t vertex) const {
  const std::array<std::uint32_t, 4>& v = cells_[cell].vertices;
  if (dimension_ == 3) return signs.in_sphere(v[0], v[1], v[2], v[3], vertex);
  if (dimension_ == 2) return signs.in_sphere(v[0], v[1], v[2], static_cast<std::uint32_t>(vertex_count_), vertex);
  for (unsigned i = 0; i <= static_cast<unsigned>(dimension_); ++i) {
    if (v[i] == vertex) return 0;
  }
  if (dimension_ == 0) return -1;
  // On a line the order of coordinates is that along it.
  const bool is_after = lexicographically_less(points_[v[0]], points_[vertex]);
  return is_after == lexicographically_less(points_[vertex], points_[v[1]]) ? 1 : -1;
}

}  // namespace quoin
