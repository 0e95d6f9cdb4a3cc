// SPDX-License-Identifier: Apache-2.0
#include "quoin/topology/manifold.h"

#include <algorithm>

#include "quoin/topology/homology.h"

namespace quoin {

namespace {

class ManifoldCheck {
 public:
  ManifoldCheck(const SimplicialComplex& complex, const Context& context)
      : complex_(complex), context_(context), d_(complex.dimension()) {}

  ManifoldReport run() {
    find_impure();
    if (d_ > 0) find_branching();
    for (int k = d_ - 2; k >= 0 && report_.is_manifold(); --k) {
      if (k == d_ - 2) {
        find_broken_fans();
      } else if (d_ == 3) {
        find_bad_surfaces();
      } else {
        find_bad_links(k);
      }
    }
    return report_;
  }

 private:
  void find_impure() {
    for (int k = 0; k < d_ && !report_.impure; ++k) {
      context_.poll();
      std::vector<bool> has_cofacet(complex_.count(k), false);
      for (const std::uint32_t facet : complex_.facets(k + 1)) has_cofacet[facet] = true;
      const auto lonely = std::find(has_cofacet.begin(), has_cofacet.end(), false);
      if (lonely != has_cofacet.end())
        report_.impure = SimplexId{k, static_cast<std::uint32_t>(lonely - has_cofacet.begin())};
    }
  }

  void find_branching() {
    cells_at_wall_ = complex_.cofacets(d_ - 1);
    for (std::uint32_t wall = 0; wall < complex_.count(d_ - 1); ++wall) {
      const std::size_t cells = cells_at_wall_[wall].size();
      if (cells == 1) ++report_.boundary_facets;
      if (cells > 2 && !report_.branching) report_.branching = SimplexId{d_ - 1, wall};
    }
  }

  // The walls (of dimension d - 1) and cells around a simplex of dimension d - 2 are to be one path or one cycle.
  void find_broken_fans() {
    const SimplexIncidence walls_at = complex_.cofacets(d_ - 2);
    for (std::uint32_t i = 0; i < complex_.count(d_ - 2); ++i) {
      if (i % 1024 == 0) context_.poll();
      if (reached_from_first(i, walls_at[i]) == walls_at[i].size()) continue;
      report_.pinched = SimplexId{d_ - 2, i};
      return;
    }
  }

  std::size_t reached_from_first(std::uint32_t center, std::span<const std::uint32_t> walls) {
    if (walls.empty()) return 0;
    is_reached_.assign(walls.size(), false);
    is_reached_[0] = true;
    std::size_t count = 1;
    stack_.assign(1, walls[0]);
    while (!stack_.empty()) {
      const std::uint32_t wall = stack_.back();
      stack_.pop_back();
      for (const std::uint32_t cell : cells_at_wall_[wall]) {
        const std::uint32_t next = other_wall(cell, wall, center);
        const auto at = std::lower_bound(walls.begin(), walls.end(), next) - walls.begin();
        if (is_reached_[at]) continue;
        is_reached_[at] = true;
        stack_.push_back(next);
        ++count;
      }
    }
    return count;
  }

  // A cell has two walls at each simplex of dimension d - 2.
  std::uint32_t other_wall(std::uint32_t cell, std::uint32_t wall, std::uint32_t center) const {
    const auto walls = complex_.facets({d_, cell});
    return *std::find_if(walls.begin(), walls.end(), [&](std::uint32_t other) {
      if (other == wall) return false;
      const auto facets = complex_.facets({d_ - 1, other});
      return std::find(facets.begin(), facets.end(), center) != facets.end();
    });
  }

  // In space, links of vertices are surfaces by now: connected, and of the characteristic of a sphere, or with boundary
  // and that of a disk.
  void find_bad_surfaces() {
    context_.poll();
    std::vector<int> characteristic(complex_.count(0), 0);
    std::vector<bool> has_boundary(complex_.count(0), false);
    for (int k = 1; k <= 3; ++k)
      for (std::uint32_t i = 0; i < complex_.count(k); ++i)
        for (const std::uint32_t v : complex_.vertices({k, i})) characteristic[v] += k == 2 ? -1 : 1;
    for (std::uint32_t wall = 0; wall < complex_.count(2); ++wall)
      if (cells_at_wall_[wall].size() == 1)
        for (const std::uint32_t v : complex_.vertices({2, wall})) has_boundary[v] = true;
    const std::vector<std::size_t> pieces = pieces_of_links();
    for (std::uint32_t v = 0; v < complex_.count(0); ++v) {
      if (pieces[v] == 1 && characteristic[v] == (has_boundary[v] ? 1 : 2)) continue;
      report_.pinched = SimplexId{0, v};
      return;
    }
  }

  // Components of the links of vertices: tetrahedra of a vertex joined across triangles at it.
  std::vector<std::size_t> pieces_of_links() {
    SimplexIncidence star;
    star.begin.assign(complex_.count(0) + 1, 0);
    for (std::uint32_t i = 0; i < complex_.count(3); ++i)
      for (const std::uint32_t v : complex_.vertices({3, i})) ++star.begin[v + 1];
    for (std::size_t v = 1; v < star.begin.size(); ++v) star.begin[v] += star.begin[v - 1];
    star.items.resize(star.begin.back());
    std::vector<std::size_t> next(star.begin.begin(), star.begin.end() - 1);
    for (std::uint32_t i = 0; i < complex_.count(3); ++i)
      for (const std::uint32_t v : complex_.vertices({3, i})) star.items[next[v]++] = i;
    std::vector<std::size_t> pieces(complex_.count(0), 0);
    for (std::uint32_t v = 0; v < complex_.count(0); ++v) {
      if (v % 256 == 0) context_.poll();
      pieces[v] = pieces_of_star(v, star[v]);
    }
    return pieces;
  }

  std::size_t pieces_of_star(std::uint32_t v, std::span<const std::uint32_t> cells) {
    is_reached_.assign(cells.size(), false);
    std::size_t pieces = 0;
    for (std::size_t start = 0; start < cells.size(); ++start) {
      if (is_reached_[start]) continue;
      ++pieces;
      is_reached_[start] = true;
      stack_.assign(1, cells[start]);
      while (!stack_.empty()) {
        const std::uint32_t cell = stack_.back();
        stack_.pop_back();
        for (const std::uint32_t wall : complex_.facets({3, cell})) {
          const auto corners = complex_.vertices({2, wall});
          if (std::find(corners.begin(), corners.end(), v) == corners.end()) continue;
          for (const std::uint32_t other : cells_at_wall_[wall]) {
            const auto at = std::lower_bound(cells.begin(), cells.end(), other) - cells.begin();
            if (is_reached_[at]) continue;
            is_reached_[at] = true;
            stack_.push_back(other);
          }
        }
      }
    }
    return pieces;
  }

  // A link of dimension n is to have the homology of a sphere of that dimension, or of a point.
  void find_bad_links(int k) {
    for (std::uint32_t i = 0; i < complex_.count(k); ++i) {
      const IntegerHomology homology = integer_homology(link(complex_, {k, i}, context_), context_);
      std::size_t sum = 0;
      for (std::size_t j = 0; j < homology.betti.size(); ++j) sum += homology.betti[j] + homology.torsion[j].size();
      const bool is_point = sum == 1 && homology.betti[0] == 1;
      const bool is_sphere = sum == 2 && homology.betti[0] == 1 && homology.betti.back() == 1;
      if (is_point || is_sphere) continue;
      report_.pinched = SimplexId{k, i};
      return;
    }
  }

  const SimplicialComplex& complex_;
  const Context& context_;
  int d_;
  ManifoldReport report_;
  SimplexIncidence cells_at_wall_;
  std::vector<bool> is_reached_;
  std::vector<std::uint32_t> stack_;
};

}  // namespace

ManifoldReport check_manifold(const SimplicialComplex& complex, const Context& context) {
  return ManifoldCheck(complex, context).run();
}

SimplicialComplex link(const SimplicialComplex& complex, SimplexId s, const Context& context) {
  const auto center = complex.vertices(s);
  SimplexList list;
  std::vector<std::uint32_t> opposite;
  for (int k = s.dimension + 1; k <= complex.dimension(); ++k) {
    context.poll();
    for (std::uint32_t i = 0; i < complex.count(k); ++i) {
      const auto vertices = complex.vertices({k, i});
      if (!std::includes(vertices.begin(), vertices.end(), center.begin(), center.end())) continue;
      opposite.clear();
      for (const std::uint32_t v : vertices)
        if (!std::binary_search(center.begin(), center.end(), v)) opposite.push_back(complex.label(v));
      list.add(opposite);
    }
  }
  return SimplicialComplex::closure_of(list, context);
}

}  // namespace quoin
