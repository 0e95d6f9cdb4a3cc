// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/weld.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <unordered_map>

#include "quoin/base/error.h"

namespace quoin::io {

namespace {

constexpr std::uint32_t none = 0xFFFFFFFFU;

std::size_t hash_of(const Point3& p) {
  std::uint64_t h = std::bit_cast<std::uint64_t>(p.x) * 0x9E3779B97F4A7C15U;
  h = (h ^ (h >> 29) ^ std::bit_cast<std::uint64_t>(p.y)) * 0xBF58476D1CE4E5B9U;
  h = (h ^ (h >> 32) ^ std::bit_cast<std::uint64_t>(p.z)) * 0x94D049BB133111EBU;
  return h ^ (h >> 31);
}

// The first vertex of equal coordinates, per vertex.
std::vector<std::uint32_t> exact_representatives(const std::vector<Point3>& points, const Context& context) {
  const std::size_t mask = std::bit_ceil(points.size() + points.size() / 2 + 1) - 1;
  std::vector<std::uint32_t> slots(mask + 1, none);
  std::vector<std::uint32_t> first(points.size());
  for (std::uint32_t v = 0; v < points.size(); ++v) {
    if (v % 65536 == 0) context.poll();
    std::size_t slot = hash_of(points[v]) & mask;
    while (slots[slot] != none && points[slots[slot]] != points[v]) slot = (slot + 1) & mask;
    if (slots[slot] == none) slots[slot] = v;
    first[v] = slots[slot];
  }
  return first;
}

struct Cell {
  std::int64_t x;
  std::int64_t y;
  std::int64_t z;
  friend bool operator==(const Cell&, const Cell&) = default;
};

struct CellHash {
  std::size_t operator()(const Cell& c) const {
    return static_cast<std::size_t>(c.x * 73856093 ^ c.y * 19349663 ^ c.z * 83492791);
  }
};

// Joins vertices within the tolerance through a grid of cells of that size.
class ToleranceWelder {
 public:
  ToleranceWelder(const std::vector<Point3>& points, double tolerance, const Context& context)
      : points_(points), tolerance_(tolerance), context_(context) {}

  std::vector<std::uint32_t> run() {
    parent_.resize(points_.size());
    for (std::uint32_t v = 0; v < points_.size(); ++v) {
      if (v % 4096 == 0) context_.poll();
      parent_[v] = v;
      join_near(v);
      cells_[cell(points_[v])].push_back(v);
    }
    for (std::uint32_t v = 0; v < points_.size(); ++v) parent_[v] = find(v);
    return std::move(parent_);
  }

 private:
  Cell cell(const Point3& p) const {
    const auto index = [&](double x) {
      const double i = std::floor(x / tolerance_);
      if (std::fabs(i) > 1e18) throw InputError("the weld tolerance is too small for these coordinates");
      return static_cast<std::int64_t>(i);
    };
    return {index(p.x), index(p.y), index(p.z)};
  }

  void join_near(std::uint32_t v) {
    const Cell c = cell(points_[v]);
    for (std::int64_t x = c.x - 1; x <= c.x + 1; ++x) {
      for (std::int64_t y = c.y - 1; y <= c.y + 1; ++y) {
        for (std::int64_t z = c.z - 1; z <= c.z + 1; ++z) {
          const auto found = cells_.find({x, y, z});
          if (found == cells_.end()) continue;
          for (const std::uint32_t w : found->second) {
            if (std::hypot(points_[v].x - points_[w].x, points_[v].y - points_[w].y, points_[v].z - points_[w].z) <=
                tolerance_) {
              join(v, w);
            }
          }
        }
      }
    }
  }

  std::uint32_t find(std::uint32_t v) {
    while (parent_[v] != v) v = parent_[v] = parent_[parent_[v]];
    return v;
  }

  void join(std::uint32_t v, std::uint32_t w) {
    v = find(v);
    w = find(w);
    parent_[std::max(v, w)] = std::min(v, w);
  }

  const std::vector<Point3>& points_;
  double tolerance_;
  const Context& context_;
  std::vector<std::uint32_t> parent_;
  std::unordered_map<Cell, std::vector<std::uint32_t>, CellHash> cells_;
};

void apply(Mesh& mesh, const std::vector<std::uint32_t>& first, ReadReport& report) {
  std::vector<std::uint32_t> number(first.size());
  std::vector<Point3> kept;
  for (std::uint32_t v = 0; v < first.size(); ++v) {
    if (first[v] == v) {
      number[v] = static_cast<std::uint32_t>(kept.size());
      kept.push_back(mesh.vertices[v]);
      continue;
    }
    number[v] = number[first[v]];
    for (std::size_t k = 0; k < 3; ++k) {
      const double move = std::fabs(mesh.vertices[v][k] - mesh.vertices[first[v]][k]);
      report.weld_displacement = std::max(report.weld_displacement, move);
    }
  }
  report.welded += first.size() - kept.size();
  mesh.vertices = std::move(kept);
  for (std::uint32_t& v : mesh.corners) v = number[v];
}

}  // namespace

void weld(Mesh& mesh, const ReadOptions& options, ReadReport& report, const Context& context) {
  for (Point3& p : mesh.vertices) p = {p.x + 0.0, p.y + 0.0, p.z + 0.0};
  if (options.weld || options.weld_tolerance) apply(mesh, exact_representatives(mesh.vertices, context), report);
  if (!options.weld_tolerance) return;
  if (!(*options.weld_tolerance > 0) || !std::isfinite(*options.weld_tolerance)) {
    throw InputError("the weld tolerance must be a positive number");
  }
  apply(mesh, ToleranceWelder(mesh.vertices, *options.weld_tolerance, context).run(), report);
}

}  // namespace quoin::io
