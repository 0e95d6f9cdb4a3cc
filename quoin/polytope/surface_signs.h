// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/polytope/tiled_surface.h"

namespace quoin {

/// Signs between the tiles of one surface and the edges of another, which is turned against the first by an
/// infinitesimal rotation, so that none is zero: by the vector (1, h, h^2) e for h, and e beyond all powers of h,
/// infinitesimal. All answers belong to that one rotated pair. Exact.
class SurfaceSigns {
 public:
  /// `fixed` stays, `turned` is rotated. Both must outlive this.
  SurfaceSigns(const TiledSurface& fixed, const TiledSurface& turned) : fixed_(fixed), turned_(turned) {}

  /// n.d for the normal of a tile of the fixed surface and a vector of the turned one. To first order the rotation
  /// adds w.(d x n).
  Sign of_fixed_normal(std::uint32_t tile, std::uint32_t tail, std::uint32_t head, const Vector3& vector) const {
    const Sign sign = side(fixed_.normal(tile), vector, [&] { return exact(fixed_, tile, turned_, tail, head); });
    return sign != Sign::zero ? sign : -first_of_double_cross(fixed_, tile, turned_, tail, head);
  }
  /// n.d for the normal of a tile of the turned surface and a vector of the fixed one. The rotation adds w.(n x d).
  Sign of_turned_normal(std::uint32_t tile, std::uint32_t tail, std::uint32_t head, const Vector3& vector) const {
    const Sign sign = side(turned_.normal(tile), vector, [&] { return exact(turned_, tile, fixed_, tail, head); });
    return sign != Sign::zero ? sign : first_of_double_cross(turned_, tile, fixed_, tail, head);
  }

 private:
  static Sign exact(const TiledSurface& of_tile, std::uint32_t tile, const TiledSurface& of_edge, std::uint32_t tail,
                    std::uint32_t head);
  static Sign first_of_double_cross(const TiledSurface& of_tile, std::uint32_t tile, const TiledSurface& of_edge,
                                    std::uint32_t tail, std::uint32_t head);

  const TiledSurface& fixed_;
  const TiledSurface& turned_;
};

}  // namespace quoin
