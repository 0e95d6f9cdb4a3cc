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

/// Points that are sums of doubles: what doubles are nearest to them, and what these leave.
struct Sums {
  std::vector<Point3> nearest;
  std::vector<Point3> tails;
  bool are_doubles = true;
};

/// If the corners are doubles and no sum leaves their range or comes near its end.
std::optional<Sums> sums_of_doubles(std::span<const PairMesh::Corner> corners, const TiledSurface& a,
                                    const TiledSurface& b, const Context& context) {
  if (!a.has_doubles() || !b.has_doubles()) return std::nullopt;
  Sums sums;
  sums.nearest.resize(corners.size());
  sums.tails.resize(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (i % 16384 == 0) context.poll();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const TwoDoubles exact = two_sum(a.point(corners[i].a)[axis], b.point(corners[i].b)[axis]);
      // Near the largest double what is left may overflow though the sum does not.
      if (!std::isfinite(exact.value) || !std::isfinite(exact.tail)) return std::nullopt;
      sums.nearest[i][axis] = exact.value + 0.0;
      sums.tails[i][axis] = exact.tail;
      sums.are_doubles = sums.are_doubles && exact.tail == 0;
    }
  }
  return sums;
}

/// For each of `count` points, by number, the first in the order of coordinates that is equal.
template <class IsLess>
std::vector<std::uint32_t> first_equal(std::size_t count, const IsLess& is_less, const Context& context) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0U);
  std::size_t comparisons = 0;
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    if (++comparisons % 4096 == 0) context.poll();
    if (is_less(i, j)) return true;
    return !is_less(j, i) && i < j;
  });
  std::vector<std::uint32_t> first(count);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_new = i == 0 || is_less(order[i - 1], order[i]);
    first[order[i]] = is_new ? order[i] : first[order[i - 1]];
  }
  return first;
}

/// Rounding keeps the order, so what is left counts where the nearest doubles are equal.
bool comes_before(const Sums& sums, std::uint32_t i, std::uint32_t j) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (sums.nearest[i][axis] != sums.nearest[j][axis]) return sums.nearest[i][axis] < sums.nearest[j][axis];
    if (sums.tails[i][axis] != sums.tails[j][axis]) return sums.tails[i][axis] < sums.tails[j][axis];
  }
  return false;
}

bool comes_before(const RationalPoint3& p, const RationalPoint3& q) {
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
  std::optional<Sums> sums = sums_of_doubles(vertices_, a, b, context);
  if (!sums || !sums->are_doubles) {
    for (const Corner& c : vertices_) {
      if (exact.size() % 256 == 0) context.poll();
      exact.push_back(a.exact(c.a) + b.exact(c.b));
    }
  }
  if (sums) {
    first = first_equal(
        vertices_.size(), [&](std::uint32_t i, std::uint32_t j) { return comes_before(*sums, i, j); }, context);
    mesh.vertices = std::move(sums->nearest);
  } else {
    for (const RationalPoint3& p : exact) mesh.vertices.push_back({p.x.to_double(), p.y.to_double(), p.z.to_double()});
    first = first_equal(
        vertices_.size(), [&](std::uint32_t i, std::uint32_t j) { return comes_before(exact[i], exact[j]); }, context);
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
