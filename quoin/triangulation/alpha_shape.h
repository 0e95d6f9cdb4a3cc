// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/triangulation/alpha_complex.h"

namespace quoin {

/// Where a simplex is in an alpha complex: not in it; in it and a face of no other simplex; a face of others, on the
/// boundary; in the interior of the simplices of full dimension.
enum class AlphaPlace : std::uint8_t { outside, singular, regular, interior };

/// The grades with which a simplex changes its place. Grade g is in the complex of n grades if g < n.
struct AlphaInterval {
  static constexpr std::uint32_t never = 0xFFFFFFFFU;
  std::uint32_t singular = never;
  std::uint32_t regular = never;   ///< the least of its proper cofaces; of full dimension the same as `interior`
  std::uint32_t interior = never;  ///< the largest of them; never on the hull. Of full dimension that of itself

  AlphaPlace place(std::uint32_t grades) const {
    return grades > interior   ? AlphaPlace::interior
           : grades > regular  ? AlphaPlace::regular
           : grades > singular ? AlphaPlace::singular
                               : AlphaPlace::outside;
  }
};

/// The intervals of all simplices of an alpha complex, which must outlive this. Full dimension is that of the affine
/// hull of the points: of points of a plane in space triangles are interior. O(n), 8 bytes for each simplex.
/// Source: Edelsbrunner and Mücke 1994.
class AlphaIntervals {
 public:
  /// @throws Cancelled
  AlphaIntervals(const AlphaComplex& alpha, const Context& context);

  AlphaInterval of(SimplexId s) const {
    return {alpha_.grade_of(s), regular_[s.dimension][s.index], interior_[s.dimension][s.index]};
  }

 private:
  const AlphaComplex& alpha_;
  std::vector<std::vector<std::uint32_t>> regular_;
  std::vector<std::vector<std::uint32_t>> interior_;
};

/// The simplices of the alpha complex of so many grades at each place, by dimension, then by vertices. The boundary of
/// the alpha shape is what is singular or regular. O(n) @throws Cancelled
struct AlphaShape {
  std::vector<SimplexId> singular;
  std::vector<SimplexId> regular;
  std::vector<SimplexId> interior;
};
AlphaShape alpha_shape(const AlphaComplex& alpha, const AlphaIntervals& intervals, std::uint32_t grades,
                       const Context& context);

/// The alpha complex of so many grades as a complex of its own, for homology; labels are vertices of the whole one.
/// @throws Cancelled
SimplicialComplex alpha_subcomplex(const AlphaComplex& alpha, std::uint32_t grades, const Context& context);

}  // namespace quoin
