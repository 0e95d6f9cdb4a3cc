// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/polytope.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "quoin/base/error.h"

namespace quoin {

namespace {

constexpr std::uint32_t none = 0xFFFFFFFFU;

/// A polygon gets its back.
void add_back(ConvexHull& hull) {
  std::vector<std::uint32_t> back(hull.corners.rbegin(), hull.corners.rend());
  hull.corners.insert(hull.corners.end(), back.begin(), back.end());
  hull.facet_begin.push_back(hull.corners.size());
}

/// Halfedges in the order of facets, as the hull has them.
struct Ring {
  std::vector<std::uint32_t> tail;
  std::vector<std::uint32_t> next;
  std::vector<std::uint32_t> facet;
  std::vector<std::uint32_t> twin;
};

Ring ring_of(const ConvexHull& hull, std::span<const std::uint32_t> place, std::size_t vertex_count) {
  Ring ring;
  for (std::size_t f = 0; f < hull.facet_count(); ++f) {
    const auto facet = hull.facet(f);
    const auto first = static_cast<std::uint32_t>(ring.tail.size());
    for (std::uint32_t i = 0; i < facet.size(); ++i) {
      ring.tail.push_back(place[facet[i]]);
      ring.next.push_back(i + 1 < facet.size() ? first + i + 1 : first);
      ring.facet.push_back(static_cast<std::uint32_t>(f));
    }
  }
  // By tail, then each looks for its twin among those that leave its head: few.
  std::vector<std::uint32_t> begin(vertex_count + 1, 0);
  for (const std::uint32_t v : ring.tail) ++begin[v + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<std::uint32_t> out(ring.tail.size());
  std::vector<std::uint32_t> end(begin);
  for (std::uint32_t h = 0; h < ring.tail.size(); ++h) out[end[ring.tail[h]]++] = h;
  for (std::uint32_t v = 0; v < vertex_count; ++v) {
    std::sort(out.begin() + begin[v], out.begin() + begin[v + 1],
              [&](std::uint32_t a, std::uint32_t b) { return ring.tail[ring.next[a]] < ring.tail[ring.next[b]]; });
  }
  ring.twin.resize(ring.tail.size());
  for (std::uint32_t h = 0; h < ring.tail.size(); ++h) {
    const std::uint32_t head = ring.tail[ring.next[h]];
    ring.twin[h] = *std::lower_bound(out.begin() + begin[head], out.begin() + begin[head + 1], ring.tail[h],
                                     [&](std::uint32_t a, std::uint32_t v) { return ring.tail[ring.next[a]] < v; });
  }
  return ring;
}

}  // namespace

Polytope Polytope::hull_of(std::span<const Point3> points, const Context& context) {
  ConvexHull hull = convex_hull(points, context);
  if (hull.dimension < 2) throw InputError("the points are on a line: their hull is no polytope");
  Polytope result;
  result.dimension_ = hull.dimension;
  if (hull.dimension == 2) add_back(hull);
  std::vector<std::uint32_t> place(points.size(), none);
  for (const std::uint32_t v : hull.vertices) {
    place[v] = static_cast<std::uint32_t>(result.vertices_.size());
    result.vertices_.push_back(points[v]);
  }
  result.sources_ = hull.vertices;
  result.link(hull, place);
  return result;
}

/// Halfedges are numbered about the vertices: from one, through its predecessor in its facet, to that one's twin, which
/// is the next counterclockwise.
void Polytope::link(const ConvexHull& hull, std::span<const std::uint32_t> place) {
  const Ring ring = ring_of(hull, place, vertices_.size());
  const auto count = static_cast<std::uint32_t>(ring.tail.size());
  std::vector<std::uint32_t> previous(count);
  std::vector<std::uint32_t> any_out(vertices_.size());
  for (std::uint32_t h = 0; h < count; ++h) {
    previous[ring.next[h]] = h;
    any_out[ring.tail[h]] = h;
  }
  std::vector<std::uint32_t> number(count);
  std::vector<std::uint32_t> order;
  order.reserve(count);
  for (const std::uint32_t first : any_out) {
    first_out_.push_back(static_cast<std::uint32_t>(order.size()));
    std::uint32_t h = first;
    do {
      number[h] = static_cast<std::uint32_t>(order.size());
      order.push_back(h);
      h = ring.twin[previous[h]];
    } while (h != first);
  }
  first_out_.push_back(count);
  halfedges_.resize(count);
  facet_halfedge_.resize(hull.facet_count());
  for (std::uint32_t h = 0; h < count; ++h) {
    const std::uint32_t head = ring.tail[ring.next[h]];
    halfedges_[number[h]] = {rounded({vertices_[ring.tail[h]], vertices_[head]}),
                             ring.tail[h],
                             head,
                             number[ring.twin[h]],
                             ring.facet[h],
                             number[ring.next[h]]};
    facet_halfedge_[ring.facet[h]] = number[h];
  }
  for (const std::uint32_t h : facet_halfedge_) {
    normals_.push_back(rounded_normal(halfedges_[h].vector, halfedges_[halfedges_[h].next].vector));
  }
}

}  // namespace quoin
