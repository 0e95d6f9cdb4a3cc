// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/rational_point.h"
#include "quoin/number/rational.h"
#include "quoin/polytope/polytope.h"

namespace quoin {

enum class Proximity : std::uint8_t { apart, touching, overlapping };

/// How two polytopes lie to one another.
struct PolytopeDistance {
  Proximity relation = Proximity::apart;
  Rational squared_distance{0};             ///< of their nearest points; 0 unless they are apart
  std::array<RationalPoint3, 2> witness{};  ///< a point of the first and one of the second that are nearest; if they
                                            ///< overlap, where the first leaves the second on the shortest way
  Rational squared_penetration{0};  ///< of the shortest translation that makes them touch; 0 unless they overlap
  RationalPoint3 separation{};      ///< that translation of the first
};

/// Exact. The origin to the difference body, the sum of the first and the second reflected: outside, they are apart,
/// and its nearest point is that of the nearest facet; inside, they overlap, and the shortest way out is across the
/// nearest facet plane. Nearest is decided in doubles and then certified, in rationals where doubles leave it open: no
/// vertex of the difference body lies beyond the plane that stands on the vector to the nearest point. O(size of the
/// difference body). Source: Dobkin, Hershberger, Kirkpatrick and Suri 1993.
/// Two that are parallel to one plane, as points, segments and coplanar polygons are, never overlap.
/// @throws Cancelled
PolytopeDistance polytope_distance(const Polytope& a, const Polytope& b, const Context& context);

/// The least distance of two parallel planes with the polytope between them.
struct PolytopeWidth {
  Rational squared_width{0};
  RationalPoint3 direction{};                         ///< a normal of the planes; its length means nothing
  std::array<std::vector<std::uint32_t>, 2> faces{};  ///< vertices in the plane that it points to, and in the other
};

/// Exact: the nearest facet plane of the difference body of the polytope with itself. O(size of that body). Of what is
/// flat, 0 with a normal of it.
PolytopeWidth polytope_width(const Polytope& p, const Context& context);

/// The greatest distance of two of its points, which are vertices.
struct PolytopeDiameter {
  Rational squared_diameter{0};
  std::array<std::uint32_t, 2> vertices{};
};

/// Exact: the vertex of the difference body of the polytope with itself that is furthest from the origin. O(size of
/// that body); of a flat polytope, all pairs of vertices.
PolytopeDiameter polytope_diameter(const Polytope& p, const Context& context);

}  // namespace quoin
