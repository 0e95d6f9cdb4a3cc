// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/weld.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <unordered_map>

#include "quoin/base/disjoint_sets.h"
#include "quoin/base/error.h"
#include "quoin/kernel/point_hash.h"

namespace quoin::io {

namespace {

constexpr std::uint32_t none = 0xFFFFFFFFU;

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
      : points_(points), tolerance_(tolerance), context_(context), sets_(points.size()) {}

  std::vector<std::uint32_t> run() {
    for (std::uint32_t v = 0; v < points_.size(); ++v) {
      if (v % 4096 == 0) context_.poll();
      join_near(v);
      cells_[cell(points_[v])].push_back(v);
    }
    std::vector<std::uint32_t> first(points_.size());
    for (std::uint32_t v = 0; v < points_.size(); ++v) first[v] = sets_.find(v);
    return first;
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
              sets_.unite(v, w);
            }
          }
        }
      }
    }
  }

  const std::vector<Point3>& points_;
  double tolerance_;
  const Context& context_;
  DisjointSets sets_;
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
