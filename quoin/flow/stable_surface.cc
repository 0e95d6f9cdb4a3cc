// SPDX-License-Identifier: Apache-2.0
#include "quoin/flow/stable_surface.h"

#include "quoin/base/error.h"
#include "quoin/flow/facet_crossing.h"

namespace quoin {

namespace {

/// A facet to be followed backwards, from a point on its boundary.
struct Open {
  std::uint32_t point;
  std::uint32_t edge;
  unsigned depth;
};

class Follower {
 public:
  Follower(const FlowComplex& flow, std::uint32_t polygon, FlowNumbers numbers)
      : flow_(flow), surface_{.polygon = polygon, .points = FlowPoints(flow, numbers), .triangles = {}, .sides = {}} {
    enter(surface_.points.add_centre({2, polygon}), 1);
  }

  StableSurface run(const Context& context) {
    for (std::size_t steps = 1; !open_.empty(); ++steps) {
      if (steps % 256 == 0) context.poll();
      const Open next = open_.back();
      open_.pop_back();
      follow(next);
    }
    return std::move(surface_);
  }

 private:
  /// All facets from which the flow enters the face of a point.
  void enter(std::uint32_t point, unsigned depth) {
    for (const std::uint32_t e : flow_.entering_edges(surface_.points.face(point))) open_.push_back({point, e, depth});
  }

  void follow(const Open& at) {
    const FacetExit exit = cross_backward(surface_.points, at.point, at.edge);
    for (const std::uint32_t vertex : flow_.faces().edge(at.edge)) {
      surface_.triangles.push_back({vertex, at.point, exit.point});
    }
    if (exit.kind == FacetExit::Kind::midpoint) {
      surface_.sides.push_back({at.edge, exit.point, at.depth});
      return;
    }
    surface_.has_regular_point |= exit.is_at_midpoint;
    if (exit.kind == FacetExit::Kind::vertex) {
      surface_.has_voronoi_vertex = true;
      surface_.has_solid_part |= flow_.has_entering_polygon(surface_.points.face(exit.point).index);
    }
    enter(exit.point, at.depth + 1);
  }

  const FlowComplex& flow_;
  StableSurface surface_;
  std::vector<Open> open_;
};

}  // namespace

StableSurface stable_surface(const FlowComplex& flow, std::uint32_t polygon, const Context& context,
                             FlowNumbers numbers) {
  if (polygon >= flow.faces().count(2) || !flow.is_critical({2, polygon})) {
    throw InputError("a stable surface of a polygon that is not critical");
  }
  return Follower(flow, polygon, numbers).run(context);
}

}  // namespace quoin
