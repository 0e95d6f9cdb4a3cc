// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/exit_snapping.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <utility>

#include "quoin/solid/leaf.h"
#include "quoin/solid/overlay/overlay.h"

namespace quoin {

namespace {

// A uniform grid of cells whose size is a power of two.
class SnapGrid {
 public:
  SnapGrid(std::span<const Point3> points, int bits) {
    double largest = 0;
    for (const Point3& p : points) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    int exponent = 0;
    std::frexp(largest, &exponent);
    cell_ = std::ldexp(1.0, std::max(exponent - bits, -1070));
  }

  double snap(double x) const { return std::nearbyint(x / cell_) * cell_; }
  Point3 snap(const Point3& p) const { return {snap(p.x), snap(p.y), snap(p.z)}; }

 private:
  double cell_;
};

struct PointLess {
  bool operator()(const Point3& a, const Point3& b) const { return lexicographically_less(a, b); }
};

}  // namespace

double snap_crossing(std::vector<Point3>& points, std::span<const Tile> triangles, std::span<const TilePair> crossings,
                     int bits) {
  const SnapGrid grid(points, bits);
  std::set<Point3, PointLess> cells;
  for (const TilePair& pair : crossings) {
    for (const std::uint32_t t : {pair.a, pair.b}) {
      for (const std::uint32_t v : triangles[t]) cells.insert(grid.snap(points[v]));
    }
  }
  double displacement = 0;
  for (Point3& p : points) {
    const Point3 snapped = grid.snap(p);
    if (!cells.contains(snapped)) continue;
    for (std::size_t k = 0; k < 3; ++k) displacement = std::max(displacement, std::fabs(snapped[k] - p[k]));
    p = snapped;
  }
  return displacement;
}

std::optional<Brep> resolve(const std::vector<Point3>& points, std::span<const Tile> triangles, bool is_unbounded,
                            const Context& context) {
  Mesh mesh;
  std::vector<std::uint32_t> representative(points.size());
  std::vector<std::uint32_t> order(points.size());
  for (std::uint32_t v = 0; v < order.size(); ++v) order[v] = v;
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    if (points[a] != points[b]) return lexicographically_less(points[a], points[b]);
    return a < b;
  });
  for (const std::uint32_t v : order) {
    if (mesh.vertices.empty() || mesh.vertices.back() != points[v]) mesh.vertices.push_back(points[v]);
    representative[v] = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
  }
  for (const Tile& t : triangles) {
    Tile corners{representative[t[0]], representative[t[1]], representative[t[2]]};
    if (is_unbounded) std::swap(corners[1], corners[2]);
    mesh.add_face(corners);
  }
  const LeafResult leaf = make_leaf(mesh, {.max_listed = 0, .find_crossings = false}, context);
  if (!leaf.leaf) return std::nullopt;
  const std::shared_ptr<const Leaf> leaves[] = {leaf.leaf};
  const Expression inside = Expression::leaf(0);
  return overlay_boundary(leaves, is_unbounded ? Expression::complement(inside) : inside, context);
}

}  // namespace quoin
