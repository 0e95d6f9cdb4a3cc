// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/check2.h"

#include <vector>

#include "quoin/kernel/predicates2.h"

namespace quoin {

namespace {

std::string defect_of_inputs(const Delaunay2& delaunay, std::span<const Point2> inputs) {
  if (delaunay.input_count() != inputs.size()) return "points are missing";
  std::vector<bool> is_found(inputs.size(), false);
  for (std::size_t v = 0; v < delaunay.vertex_count(); ++v) {
    if (delaunay.inputs(Vertex2(v)).empty()) return "vertex " + std::to_string(v) + " is no given point";
    for (const std::uint32_t i : delaunay.inputs(Vertex2(v))) {
      if (i >= inputs.size() || is_found[i]) return "vertex " + std::to_string(v) + " names a point once too often";
      is_found[i] = true;
      if (inputs[i] != delaunay.point(Vertex2(v))) return "point " + std::to_string(i) + " is not at its vertex";
    }
  }
  return {};
}

std::string defect_of_line(const Delaunay2& delaunay) {
  const std::span<const Vertex2> line = delaunay.line();
  if (line.size() != delaunay.vertex_count()) return "the line does not have all vertices";
  if (delaunay.dimension() != (line.size() < 2 ? static_cast<int>(line.size()) - 1 : 1)) return "wrong dimension";
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (!lexicographically_less(delaunay.point(line[i - 1]), delaunay.point(line[i]))) return "the line is unsorted";
    if (orientation(delaunay.point(line[0]), delaunay.point(line[1]), delaunay.point(line[i])) != Sign::zero) {
      return "points are not on a line";
    }
  }
  return {};
}

// Of a finite triangle, or of the hull at an infinite one.
bool is_convex_at(const Delaunay2& delaunay, Triangle2 t) {
  const Triangulation2& links = delaunay.links();
  std::array<Vertex2, 3> v = links.corners(t);
  for (unsigned slot = 0; slot < 3; ++slot) {
    if (!links.is_infinite(v[slot])) continue;
    // The hull runs clockwise along the infinite triangles.
    const Edge2 hull(t, slot);
    const Edge2 further = Triangulation2::next(links.twin(Triangulation2::next(hull)));
    const Vertex2 from = links.source(hull);
    const Vertex2 to = links.target(hull);
    const Vertex2 beyond = links.target(further);
    return orientation(delaunay.point(from), delaunay.point(to), delaunay.point(beyond)) != Sign::positive;
  }
  return orientation(delaunay.point(v[0]), delaunay.point(v[1]), delaunay.point(v[2])) == Sign::positive;
}

bool is_locally_delaunay(const Delaunay2& delaunay, Edge2 e) {
  const Triangulation2& links = delaunay.links();
  const Vertex2 here = links.apex(e);
  const Vertex2 there = links.apex(links.twin(e));
  if (links.is_infinite(e) || links.is_infinite(here) || links.is_infinite(there)) return true;
  return in_circle(delaunay.point(here), delaunay.point(links.source(e)), delaunay.point(links.target(e)),
                   delaunay.point(there)) != Sign::positive;
}

}  // namespace

std::string defect(const Delaunay2& delaunay, std::span<const Point2> inputs, const Context& context) {
  context.poll();
  if (std::string found = defect_of_inputs(delaunay, inputs); !found.empty()) return found;
  if (delaunay.dimension() < 2) return defect_of_line(delaunay);
  const Triangulation2& links = delaunay.links();
  if (const char* found = links.defect()) return found;
  for (std::uint32_t t = 0; t < links.triangle_count(); ++t) {
    if (t % 1024 == 0) context.poll();
    if (!is_convex_at(delaunay, Triangle2(t))) return "triangle " + std::to_string(t) + " turns the wrong way";
    for (unsigned slot = 0; slot < 3; ++slot) {
      if (!is_locally_delaunay(delaunay, Edge2(Triangle2(t), slot))) {
        return "the circle of triangle " + std::to_string(t) + " is not empty";
      }
    }
  }
  return {};
}

}  // namespace quoin
