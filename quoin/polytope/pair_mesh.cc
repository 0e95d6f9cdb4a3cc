// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/pair_mesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "quoin/base/error.h"
#include "quoin/number/error_free.h"

namespace quoin {

namespace {

/// The sums as doubles, if all are.
std::optional<std::vector<Point3>> sums_in_doubles(std::span<const PairMesh::Corner> corners, const TiledSurface& a,
                                                   const TiledSurface& b) {
  if (!a.has_doubles() || !b.has_doubles()) return std::nullopt;
  std::vector<Point3> sums;
  sums.reserve(corners.size());
  for (const PairMesh::Corner& c : corners) {
    Point3 sum;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const TwoDoubles exact = two_sum(a.point(c.a)[axis], b.point(c.b)[axis]);
      if (!std::isfinite(exact.value) || exact.tail != 0) return std::nullopt;
      sum[axis] = exact.value + 0.0;
    }
    sums.push_back(sum);
  }
  return sums;
}

/// For each point the first in the order of coordinates that is equal; `is_less` is that order.
template <class Point, class IsLess>
std::vector<std::uint32_t> first_equal(const std::vector<Point>& points, const IsLess& is_less,
                                       const Context& context) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  std::size_t comparisons = 0;
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    if (++comparisons % 4096 == 0) context.poll();
    if (is_less(points[i], points[j])) return true;
    return !is_less(points[j], points[i]) && i < j;
  });
  std::vector<std::uint32_t> first(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_new = i == 0 || is_less(points[order[i - 1]], points[order[i]]);
    first[order[i]] = is_new ? order[i] : first[order[i - 1]];
  }
  return first;
}

template <class Point>
bool comes_before(const Point& p, const Point& q) {
  if (p.x != q.x) return p.x < q.x;
  if (p.y != q.y) return p.y < q.y;
  return p.z < q.z;
}

}  // namespace

void PairMesh::add(const std::array<Corner, 3>& corners, int count) {
  Tile tile{vertex(corners[0]), vertex(corners[1]), vertex(corners[2])};
  if (count < 0) std::swap(tile[1], tile[2]);
  for (int i = 0; i < std::abs(count); ++i) triangles_.push_back(tile);
}

std::uint32_t PairMesh::vertex(const Corner& corner) {
  const std::uint64_t key = (std::uint64_t{corner.a} << 32U) | corner.b;
  const auto [entry, is_new] = number_.try_emplace(key, static_cast<std::uint32_t>(vertices_.size()));
  if (is_new) vertices_.push_back(corner);
  return entry->second;
}

std::shared_ptr<const Leaf> PairMesh::leaf(const TiledSurface& a, const TiledSurface& b, const Context& context) {
  Mesh mesh;
  mesh.name = "sum";
  std::vector<RationalPoint3> exact;
  std::vector<std::uint32_t> first;
  if (auto sums = sums_in_doubles(vertices_, a, b)) {
    mesh.vertices = std::move(*sums);
    first = first_equal(mesh.vertices, comes_before<Point3>, context);
  } else {
    for (const Corner& c : vertices_) {
      if (exact.size() % 256 == 0) context.poll();
      exact.push_back(a.exact(c.a) + b.exact(c.b));
      const RationalPoint3& p = exact.back();
      mesh.vertices.push_back({p.x.to_double(), p.y.to_double(), p.z.to_double()});
    }
    first = first_equal(exact, comes_before<RationalPoint3>, context);
  }
  for (const Tile& t : triangles_) mesh.add_face(Tile{first[t[0]], first[t[1]], first[t[2]]});
  LeafOptions options;
  options.find_crossings = false;
  LeafResult result = make_leaf(mesh, std::move(exact), options, context);
  if (result.diagnosis.not_finite.count != 0) throw InputError("sums of coordinates leave the range of doubles");
  if (!result.leaf) throw InternalError("a convolution is not closed");
  return result.leaf;
}

}  // namespace quoin
