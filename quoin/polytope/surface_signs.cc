// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/surface_signs.h"

namespace quoin {

namespace {

RationalPoint3 exact_normal(const TiledSurface& surface, std::uint32_t tile) {
  const Tile& t = surface.tiles()[tile];
  const RationalPoint3 a = surface.exact(t[0]);
  return cross(surface.exact(t[1]) - a, surface.exact(t[2]) - a);
}

}  // namespace

Sign SurfaceSigns::exact(const TiledSurface& of_tile, std::uint32_t tile, const TiledSurface& of_edge,
                         std::uint32_t tail, std::uint32_t head) {
  if (of_tile.has_doubles() && of_edge.has_doubles()) {
    const Tile& t = of_tile.tiles()[tile];
    const Point3& a = of_tile.point(t[0]);
    return exact_determinant({a, of_tile.point(t[1])}, {a, of_tile.point(t[2])},
                             {of_edge.point(tail), of_edge.point(head)});
  }
  return dot(exact_normal(of_tile, tile), of_edge.exact(head) - of_edge.exact(tail)).sign();
}

Sign SurfaceSigns::first_of_double_cross(const TiledSurface& of_tile, std::uint32_t tile, const TiledSurface& of_edge,
                                         std::uint32_t tail, std::uint32_t head) {
  if (of_tile.has_doubles() && of_edge.has_doubles()) {
    const Tile& t = of_tile.tiles()[tile];
    const Point3& a = of_tile.point(t[0]);
    return first_sign_of_double_cross({a, of_tile.point(t[1])}, {a, of_tile.point(t[2])},
                                      {of_edge.point(tail), of_edge.point(head)});
  }
  const RationalPoint3 v = cross(exact_normal(of_tile, tile), of_edge.exact(head) - of_edge.exact(tail));
  for (unsigned axis = 0; axis < 3; ++axis) {
    if (v[axis].sign() != Sign::zero) return v[axis].sign();
  }
  return Sign::zero;
}

}  // namespace quoin
