// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/arc_crossings.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "quoin/base/parallel.h"

namespace quoin {

namespace {

/// A unit vector and the cosine and sine of an angle below a right one: a cap of the sphere that holds an arc. The
/// values here make one that is apart from none.
struct Cap {
  double x = 0;
  double y = 0;
  double z = 0;
  double cosine = 0;
  double sine = 1;
};

double length(const Vector3& v) {
  return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

/// Where its rounding may turn the normal by less than 2^-20 or so, and nothing leaves the range of doubles.
std::optional<Vector3> unit_normal(const RoundedNormal& normal) {
  const double l = length(normal.vector);
  if (!(l > 0x1p-30 * normal.size) || !(l > 0x1p-400) || !(l < 0x1p500)) return std::nullopt;
  return Vector3{normal.vector.x / l, normal.vector.y / l, normal.vector.z / l};
}

/// The smallest cap about both normals, larger by 2^-10: far more than all roundings here. Normals that are nearly
/// opposite, or not known well enough, give none.
Cap cap_of(const TiledSurface& surface, const TiledSurface::Edge& edge) {
  const auto m = unit_normal(surface.normal(TiledSurface::tile_of(edge.halfedge)));
  const auto n = unit_normal(surface.normal(TiledSurface::tile_of(edge.twin)));
  if (!m || !n) return {};
  const Vector3 sum{m->x + n->x, m->y + n->y, m->z + n->z};
  const double l = length(sum);
  if (l < 0x1p-4) return {};
  const Vector3 difference{m->x - n->x, m->y - n->y, m->z - n->z};
  const double half = std::asin(std::min(1.0, length(difference) / 2)) + 0x1p-10;
  return {sum.x / l, sum.y / l, sum.z / l, std::cos(half), std::sin(half)};
}

std::vector<Cap> caps_of(const TiledSurface& surface) {
  std::vector<Cap> caps;
  for (const TiledSurface::Edge& e : surface.edges()) caps.push_back(cap_of(surface, e));
  return caps;
}

/// The angle between the centres is more than both radii together.
bool are_apart(const Cap& a, const Cap& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z < a.cosine * b.cosine - a.sine * b.sine;
}

/// ArcCrossing::along_a, or 0. The arcs of e and f cross where they pass each other's planes, both at e x f or both at
/// its opposite.
int crossing_along(const SurfaceSigns& signs, const TiledSurface::Edge& e, const TiledSurface::Edge& f) {
  const Sign left_of_e = signs.of_fixed_normal(TiledSurface::tile_of(e.halfedge), f.tail, f.head, f.vector);
  const Sign left_of_f = signs.of_turned_normal(TiledSurface::tile_of(f.halfedge), e.tail, e.head, e.vector);
  if (e.sign * to_int(left_of_e) != -f.sign * to_int(left_of_f)) return 0;
  if (signs.of_fixed_normal(TiledSurface::tile_of(e.twin), f.tail, f.head, f.vector) == left_of_e) return 0;
  if (signs.of_turned_normal(TiledSurface::tile_of(f.twin), e.tail, e.head, e.vector) == left_of_f) return 0;
  return -to_int(left_of_e);
}

}  // namespace

std::vector<ArcCrossing> arc_crossings(const TiledSurface& a, const TiledSurface& b, const SurfaceSigns& signs,
                                       const Context& context) {
  const std::vector<Cap> caps_a = caps_of(a);
  const std::vector<Cap> caps_b = caps_of(b);
  constexpr std::size_t grain = 64;
  std::vector<std::vector<ArcCrossing>> found(chunk_count(a.edges().size(), grain));
  for_each_chunk(context, a.edges().size(), grain, [&](const Chunk& chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      context.poll();
      const TiledSurface::Edge& e = a.edges()[i];
      if (e.sign == 0) continue;
      for (std::size_t j = 0; j < caps_b.size(); ++j) {
        if (are_apart(caps_a[i], caps_b[j]) || b.edges()[j].sign == 0) continue;
        const int along = crossing_along(signs, e, b.edges()[j]);
        if (along != 0)
          found[chunk.index].push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j), along});
      }
    }
  });
  std::vector<ArcCrossing> all;
  for (const auto& part : found) all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace quoin
