// SPDX-License-Identifier: Apache-2.0
#include "quoin/assembly/projection.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "quoin/number/error_free.h"
#include "quoin/polytope/edge_predicates.h"

namespace quoin {

namespace {

/// A directed edge of the sum by its vertices, and the facet on its left.
struct FacetSide {
  std::uint32_t tail;
  std::uint32_t head;
  std::uint32_t facet;
};

/// One sum, seen from the origin. A vertex of the sum is p - (-q), a vector between two points.
class Projector {
 public:
  Projector(const PolytopeSum& sum, const Polytope& p, const Polytope& q) : sum_(sum), p_(p), q_(q) {}

  Projection run() {
    classify_facets();
    if (seen_ > 0) return {OriginPlace::separated, silhouette()};
    if (on_.empty()) return {OriginPlace::inside, {}};
    if (on_.size() == 1) return {OriginPlace::facet, hemisphere()};
    if (on_.size() == 2) return {OriginPlace::edge, lune()};
    return {OriginPlace::vertex, cone()};
  }

 private:
  bool has_rationals() const { return p_.is_rational() || q_.is_rational(); }
  RationalPoint3 exact(std::uint32_t vertex) const {
    const auto& [i, j] = sum_.vertices[vertex];
    return p_.exact_vertex(i) + q_.exact_vertex(j);
  }
  /// Of doubles.
  EdgeVector vector_of(std::uint32_t vertex) const {
    const auto& [i, j] = sum_.vertices[vertex];
    const Point3& q = q_.vertex(j);
    return {{-q.x, -q.y, -q.z}, p_.vertex(i)};
  }
  bool is_origin(std::uint32_t vertex) const {
    if (has_rationals()) return exact(vertex) == RationalPoint3{};
    const EdgeVector v = vector_of(vertex);
    return v.from.x == v.to.x && v.from.y == v.to.y && v.from.z == v.to.z;
  }
  RegionDirection direction_of(std::uint32_t vertex) const {
    if (has_rationals()) {
      RationalPoint3 p = exact(vertex);
      return SphereDirection(std::array{std::move(p.x), std::move(p.y), std::move(p.z)});
    }
    const EdgeVector v = vector_of(vertex);
    const Vector3 difference = rounded(v);
    bool is_exact = true;
    for (unsigned axis = 0; axis < 3; ++axis) {
      is_exact = is_exact && two_difference(v.to[axis], v.from[axis]).tail == 0;
    }
    if (is_exact) return SphereDirection(difference);
    return SphereDirection(std::array{Rational(v.to.x) - Rational(v.from.x), Rational(v.to.y) - Rational(v.from.y),
                                      Rational(v.to.z) - Rational(v.from.z)});
  }
  /// Of det(a, b, c), positive where the origin is on the inner side of the plane of a, b, c.
  Sign determinant_of(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    if (has_rationals()) return dot(cross(exact(a), exact(b)), exact(c)).sign();
    const EdgeVector u = vector_of(a);
    const EdgeVector v = vector_of(b);
    const EdgeVector w = vector_of(c);
    return determinant(rounded(u), rounded(v), rounded(w), [&] { return exact_determinant(u, v, w); });
  }

  void classify_facets() {
    is_seen_.resize(sum_.facet_count());
    for (std::uint32_t f = 0; f < sum_.facet_count(); ++f) {
      const auto corners = sum_.facet(f);
      const Sign side = determinant_of(corners[0], corners[1], corners[2]);
      is_seen_[f] = side == Sign::negative;
      seen_ += is_seen_[f] ? 1 : 0;
      if (side == Sign::zero) on_.push_back(f);
    }
  }

  /// Around the origin inside the facet, two corners in a row are less than half a turn apart.
  ConvexRegion hemisphere() const {
    const auto corners = sum_.facet(on_[0]);
    return {{inward(direction_of(corners[0]), direction_of(corners[1]))}, {}};
  }
  /// The inward normal of a facet whose plane contains the origin, from two of its points in counterclockwise order.
  static RegionDirection inward(const RegionDirection& first, const RegionDirection& second) {
    return cross(second, first);
  }

  /// The origin is inside the edge that the two facets share: each gives the half circle from the edge's tail to its
  /// head, and its normal by the corner after the head.
  ConvexRegion lune() const {
    ConvexRegion region;
    const auto first = sum_.facet(on_[0]);
    const auto second = sum_.facet(on_[1]);
    for (std::size_t i = 0; i < first.size(); ++i) {
      const std::uint32_t tail = first[i];
      const std::uint32_t head = first[(i + 1) % first.size()];
      for (std::size_t k = 0; k < second.size(); ++k) {
        if (second[k] != head || second[(k + 1) % second.size()] != tail) continue;
        region.corners = {direction_of(tail), direction_of(head)};
        region.normals = {inward(region.corners[1], direction_of(first[(i + 2) % first.size()])),
                          inward(region.corners[0], direction_of(second[(k + 2) % second.size()]))};
      }
    }
    return region;
  }

  /// The origin is the vertex that the facets share: each gives the arc from the corner before it to the one after it.
  ConvexRegion cone() const {
    std::map<std::uint32_t, std::uint32_t> next;
    for (const std::uint32_t f : on_) {
      const auto corners = sum_.facet(f);
      for (std::size_t i = 0; i < corners.size(); ++i) {
        if (!is_origin(corners[i])) continue;
        next[corners[(i + corners.size() - 1) % corners.size()]] = corners[(i + 1) % corners.size()];
      }
    }
    return region_of(chain(next));
  }

  /// Along its boundary the seen part has itself on the left, the region on the right.
  ConvexRegion silhouette() const {
    std::vector<FacetSide> sides;
    sides.reserve(sum_.corners.size());
    for (std::uint32_t f = 0; f < sum_.facet_count(); ++f) {
      const auto corners = sum_.facet(f);
      for (std::size_t i = 0; i < corners.size(); ++i) {
        sides.push_back({corners[i], corners[(i + 1) % corners.size()], f});
      }
    }
    const auto by_ends = [](const FacetSide& a, const FacetSide& b) {
      return std::pair(a.tail, a.head) < std::pair(b.tail, b.head);
    };
    std::ranges::sort(sides, by_ends);
    std::map<std::uint32_t, std::uint32_t> next;
    for (const FacetSide& side : sides) {
      if (!is_seen_[side.facet]) continue;
      const auto twin = std::ranges::lower_bound(sides, FacetSide{side.head, side.tail, 0}, by_ends);
      if (!is_seen_[twin->facet]) next[side.head] = side.tail;
    }
    const std::vector<std::uint32_t> ring = chain(next);
    std::vector<std::uint32_t> kept;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::uint32_t before = ring[(i + ring.size() - 1) % ring.size()];
      if (determinant_of(before, ring[i], ring[(i + 1) % ring.size()]) != Sign::zero) kept.push_back(ring[i]);
    }
    return region_of(kept);
  }

  static std::vector<std::uint32_t> chain(const std::map<std::uint32_t, std::uint32_t>& next) {
    std::vector<std::uint32_t> ring;
    const std::uint32_t first = next.begin()->first;
    std::uint32_t at = first;
    do {
      ring.push_back(at);
      at = next.at(at);
    } while (at != first && ring.size() <= next.size());
    return ring;
  }
  ConvexRegion region_of(const std::vector<std::uint32_t>& ring) const {
    ConvexRegion region;
    for (const std::uint32_t v : ring) region.corners.push_back(direction_of(v));
    for (std::size_t i = 0; i < ring.size(); ++i) {
      region.normals.push_back(cross(region.corners[i], region.corners[(i + 1) % ring.size()]));
    }
    return region;
  }

  const PolytopeSum& sum_;
  const Polytope& p_;
  const Polytope& q_;
  std::vector<bool> is_seen_;      // from the origin, by facet
  std::vector<std::uint32_t> on_;  // facets whose planes contain the origin
  std::size_t seen_ = 0;
};

}  // namespace

bool ConvexRegion::contains(const RegionDirection& direction) const {
  return std::ranges::all_of(normals,
                             [&](const RegionDirection& n) { return dot_sign(n, direction) == Sign::positive; });
}

Projection project(const PolytopeSum& sum, const Polytope& p, const Polytope& q) {
  return Projector(sum, p, q).run();
}

}  // namespace quoin
