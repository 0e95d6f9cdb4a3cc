// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/hull_facets.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace quoin {

namespace {

class FacetJoiner {
 public:
  FacetJoiner(const HullBuilder& builder, std::span<const std::uint32_t> names, const Context& context)
      : builder_(builder),
        triangles_(builder.triangles()),
        names_(names),
        context_(context),
        edges_(triangles_.size(), 0),
        rims_(names.size(), 0) {}

  ConvexHull join() {
    find_flat_edges();
    ConvexHull hull;
    hull.dimension = 3;
    hull.corners.reserve(3 * triangles_.size());
    hull.facet_begin.reserve(triangles_.size() + 1);
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      if (t % 4096 == 0) context_.poll();
      if (triangles_[t].is_free()) continue;
      for (unsigned k = 0; k < 3; ++k) {
        if ((edges_[t] & (flat(k) | done(k))) == 0) add_facet(hull, t, k);
      }
    }
    return hull;
  }

 private:
  static std::uint8_t flat(unsigned k) { return static_cast<std::uint8_t>(1U << k); }
  static std::uint8_t done(unsigned k) { return static_cast<std::uint8_t>(8U << k); }
  static unsigned next(unsigned k) { return k == 2 ? 0 : k + 1; }
  unsigned index_in(std::uint32_t triangle, std::uint32_t neighbour) const {
    const auto& across = triangles_[triangle].across;
    return across[0] == neighbour ? 0 : across[1] == neighbour ? 1 : 2;
  }

  /// And counts, for each point, the edges that are not flat.
  void find_flat_edges() {
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      if (t % 4096 == 0) context_.poll();
      const HullBuilder::Triangle& triangle = triangles_[t];
      if (triangle.is_free()) continue;
      for (unsigned k = 0; k < 3; ++k) {
        const std::uint32_t across = triangle.across[k];
        if (across < t) continue;
        const unsigned back = index_in(across, t);
        const std::uint32_t opposite = triangles_[across].corners[next(next(back))];
        if (builder_.side(t, opposite) == Sign::zero) {
          edges_[t] |= flat(k);
          edges_[across] |= flat(back);
        } else {
          ++rims_[triangle.corners[k]];
          ++rims_[triangle.corners[next(k)]];
        }
      }
    }
  }

  /// Around the facet from one of its edges. Where only two edges meet, one goes straight on.
  void add_facet(ConvexHull& hull, std::uint32_t t, unsigned k) {
    while ((edges_[t] & done(k)) == 0) {
      edges_[t] |= done(k);
      const std::uint32_t corner = triangles_[t].corners[k];
      if (rims_[corner] > 2) hull.corners.push_back(names_[corner]);
      k = next(k);
      while ((edges_[t] & flat(k)) != 0) {
        const std::uint32_t across = triangles_[t].across[k];
        k = next(index_in(across, t));
        t = across;
      }
    }
    hull.facet_begin.push_back(hull.corners.size());
  }

  const HullBuilder& builder_;
  const LargeVector<HullBuilder::Triangle>& triangles_;
  std::span<const std::uint32_t> names_;
  const Context& context_;
  std::vector<std::uint8_t> edges_;  // by triangle: which are flat, which belong to a facet already
  std::vector<std::uint32_t> rims_;
};

}  // namespace

ConvexHull join_facets(const HullBuilder& builder, std::span<const std::uint32_t> names, const Context& context) {
  return FacetJoiner(builder, names, context).join();
}

void put_in_order(ConvexHull& hull, std::size_t name_count) {
  const std::size_t count = hull.facet_count();
  // Facets by their smallest corner, by counting.
  std::vector<std::uint32_t> begin(name_count + 1, 0);
  for (std::size_t f = 0; f < count; ++f) {
    const auto first = hull.corners.begin() + static_cast<std::ptrdiff_t>(hull.facet_begin[f]);
    const auto last = hull.corners.begin() + static_cast<std::ptrdiff_t>(hull.facet_begin[f + 1]);
    std::rotate(first, std::min_element(first, last), last);
    ++begin[*first + 1];
  }
  std::vector<bool> is_vertex(name_count, false);
  for (const std::uint32_t corner : hull.corners) is_vertex[corner] = true;
  for (std::uint32_t v = 0; v < name_count; ++v) {
    if (is_vertex[v]) hull.vertices.push_back(v);
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  // And then by the next one: an edge runs along one facet in one direction.
  struct Entry {
    std::uint32_t second;
    std::uint32_t facet;
  };
  std::vector<Entry> order(count);
  std::vector<std::uint32_t> end(begin);
  for (std::size_t f = 0; f < count; ++f) {
    const auto facet = hull.facet(f);
    order[end[facet[0]]++] = {facet[1], static_cast<std::uint32_t>(f)};
  }
  for (const std::uint32_t v : hull.vertices) {
    if (begin[v + 1] - begin[v] < 2) continue;
    std::sort(order.begin() + begin[v], order.begin() + begin[v + 1],
              [](const Entry& a, const Entry& b) { return a.second < b.second; });
  }
  std::vector<std::uint32_t> corners;
  corners.reserve(hull.corners.size());
  std::vector<std::size_t> facet_begin{0};
  facet_begin.reserve(count + 1);
  for (const Entry& entry : order) {
    const auto facet = hull.facet(entry.facet);
    corners.insert(corners.end(), facet.begin(), facet.end());
    facet_begin.push_back(corners.size());
  }
  hull.corners = std::move(corners);
  hull.facet_begin = std::move(facet_begin);
}

}  // namespace quoin
