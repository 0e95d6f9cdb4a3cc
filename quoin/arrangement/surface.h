// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <cstdint>

namespace quoin {

/// Where a point lies in the parameter rectangle of a surface.
enum class Side : std::uint8_t { interior, left, right, bottom, top };

/// What a side of the parameter rectangle is on the surface.
enum class SideKind : std::uint8_t {
  unreached,   ///< no curve reaches it
  infinite,    ///< at infinity: curves end there at distinct places
  contracted,  ///< the whole side is one point: a pole
  identified   ///< glued to the opposite side
};

/// The sides of the parameter rectangle.
struct SideKinds {
  SideKind left = SideKind::unreached;
  SideKind right = SideKind::unreached;
  SideKind bottom = SideKind::unreached;
  SideKind top = SideKind::unreached;
};

/// The topology of a surface is all in the kinds of the sides of its parameter rectangle; curves are the family's.
template <class S>
concept SurfaceTopology = requires {
  { S::sides } -> std::convertible_to<SideKinds>;
  { S::has_unbounded_face } -> std::convertible_to<bool>;
};

/// The plane, with curves that stay bounded.
struct BoundedPlane {
  static constexpr SideKinds sides{};
  static constexpr bool has_unbounded_face = true;
};

/// The plane, with curves that may go to infinity. A frame of fictitious edges joins the ends of curves at infinity; it
/// is not shown to users.
struct UnboundedPlane {
  static constexpr SideKinds sides{SideKind::infinite, SideKind::infinite, SideKind::infinite, SideKind::infinite};
  static constexpr bool has_unbounded_face = true;
};

/// The sphere by longitude u in [-pi, pi] and latitude v in [-pi/2, pi/2]: the poles are contracted sides, and the half
/// meridian through (-1, 0, 0) is the image of both the left and the right side.
struct Sphere {
  static constexpr SideKinds sides{SideKind::identified, SideKind::identified, SideKind::contracted,
                                   SideKind::contracted};
  static constexpr bool has_unbounded_face = false;
};

}  // namespace quoin
