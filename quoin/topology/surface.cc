// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "quoin/base/error.h"
#include "quoin/topology/manifold.h"

namespace quoin {

namespace {

constexpr std::uint32_t unseen = 0xFFFFFFFFU;

// Walks over the simplices of the highest dimension, breadth first.
class Orienting {
 public:
  Orienting(const SimplicialComplex& complex, const Context& context)
      : complex_(complex),
        context_(context),
        d_(complex.dimension()),
        cofacets_(complex.cofacets(d_ - 1)),
        parent_(complex.count(d_), unseen) {
    report_.is_reversed.assign(complex.count(d_), false);
  }

  OrientationReport run() {
    if (d_ < 1) return report_;
    for (std::uint32_t first = 0; first < parent_.size(); ++first) {
      if (parent_[first] != unseen) continue;
      parent_[first] = first;
      queue_.assign(1, first);
      // The queue grows on the way.
      for (std::size_t next = 0; next < queue_.size(); ++next) {  // NOLINT(modernize-loop-convert)
        if (!spread(queue_[next])) return report_;
      }
    }
    return report_;
  }

 private:
  // Whether the neighbours agree.
  bool spread(std::uint32_t cell) {
    if ((++steps_ & 1023U) == 0) context_.poll();
    const auto facets = complex_.facets({d_, cell});
    for (std::size_t j = 0; j < facets.size(); ++j) {
      const auto both = cofacets_[facets[j]];
      if (both.size() != 2) continue;
      const std::uint32_t other = both[0] == cell ? both[1] : both[0];
      const auto of_other = complex_.facets({d_, other});
      const auto place = std::find(of_other.begin(), of_other.end(), facets[j]) - of_other.begin();
      const bool same_sign = j % 2 == static_cast<std::size_t>(place) % 2;
      const bool is_reversed = report_.is_reversed[cell] != same_sign;
      if (parent_[other] == unseen) {
        parent_[other] = cell;
        report_.is_reversed[other] = is_reversed;
        queue_.push_back(other);
      } else if (report_.is_reversed[other] != is_reversed) {
        close_loop(cell, other);
        return false;
      }
    }
    return true;
  }

  // Up from one to the nearest that is above both, and down to the other.
  void close_loop(std::uint32_t a, std::uint32_t b) {
    const std::vector<std::uint32_t> up = path_to_root(a);
    const std::vector<std::uint32_t> down = path_to_root(b);
    std::size_t common = 0;
    while (common < std::min(up.size(), down.size()) && up[up.size() - 1 - common] == down[down.size() - 1 - common])
      ++common;
    report_.reversing_loop.assign(up.begin(), up.end() - static_cast<std::ptrdiff_t>(common) + 1);
    for (std::size_t i = down.size() - common; i > 0; --i) report_.reversing_loop.push_back(down[i - 1]);
  }

  std::vector<std::uint32_t> path_to_root(std::uint32_t cell) const {
    std::vector<std::uint32_t> path{cell};
    while (parent_[path.back()] != path.back()) path.push_back(parent_[path.back()]);
    return path;
  }

  const SimplicialComplex& complex_;
  const Context& context_;
  int d_;
  SimplexIncidence cofacets_;
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint32_t> queue_;
  OrientationReport report_;
  std::size_t steps_ = 0;
};

// The facets in one simplex alone, as a complex: loops of edges.
SimplicialComplex boundary_of_surface(const SimplicialComplex& complex, const Context& context) {
  const SimplexIncidence triangles = complex.cofacets(1);
  SimplexList list;
  for (std::uint32_t e = 0; e < complex.count(1); ++e)
    if (triangles[e].size() == 1) list.add(complex.labels({1, e}));
  return SimplicialComplex::closure_of(list, context);
}

// A component by itself.
SimplicialComplex part_of(const SimplicialComplex& complex, const std::vector<std::uint32_t>& triangles,
                          const Context& context) {
  SimplexList list;
  for (const std::uint32_t t : triangles) list.add(complex.labels({2, t}));
  return SimplicialComplex::closure_of(list, context);
}

SurfaceClass class_of_connected(const SimplicialComplex& surface, const Context& context) {
  SurfaceClass result;
  result.is_orientable = orient(surface, context).is_orientable();
  result.euler_characteristic = surface.euler_characteristic();
  result.boundary_loops = connected_components(boundary_of_surface(surface, context)).count;
  const std::int64_t twice = 2 - result.euler_characteristic - static_cast<std::int64_t>(result.boundary_loops);
  result.genus = static_cast<std::size_t>(result.is_orientable ? twice / 2 : twice);
  return result;
}

}  // namespace

OrientationReport orient(const SimplicialComplex& complex, const Context& context) {
  return Orienting(complex, context).run();
}

std::vector<SurfaceClass> classify_surface(const SimplicialComplex& complex, const Context& context) {
  return classify_surface(complex, check_manifold(complex, context), context);
}

std::vector<SurfaceClass> classify_surface(const SimplicialComplex& complex, const ManifoldReport& report,
                                           const Context& context) {
  if (complex.dimension() != 2 || !report.is_manifold()) throw InputError("the complex is not a surface");
  const ComplexComponents components = connected_components(complex);
  std::vector<std::vector<std::uint32_t>> triangles(components.count);
  for (std::uint32_t t = 0; t < complex.count(2); ++t)
    triangles[components.of_vertex[complex.vertices({2, t})[0]]].push_back(t);
  std::vector<SurfaceClass> classes;
  for (const std::vector<std::uint32_t>& part : triangles)
    classes.push_back(class_of_connected(part_of(complex, part, context), context));
  return classes;
}

}  // namespace quoin
