// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

/// The six squares of the cube [-1, 1]^3 and how they meet.
///
/// Square s lies in the plane where coordinate s % 3 is -1 (s < 3) or 1. Its points have two coordinates of their own,
/// X and Y, such that X x Y points outward; so counterclockwise is the same on all squares, seen from outside. Corner
/// number c of a square is at X = -1 or 1 (c / 2) and Y = -1 or 1 (c % 2).
/// Source: Fogel, Minkowski sum construction and other applications of arrangements of geodesic arcs on the sphere
/// (2009), table 3.1.
namespace quoin::cube {

inline constexpr std::size_t square_count = 6;
inline constexpr std::size_t corner_count = 4;  ///< of a square

constexpr unsigned axis(std::size_t square) {
  return static_cast<unsigned>(square % 3);
}
constexpr int sign(std::size_t square) {
  return square < 3 ? -1 : 1;
}
/// The axis of space along which X grows.
constexpr unsigned x_axis(std::size_t square) {
  return (axis(square) + (square < 3 ? 2U : 1U)) % 3;
}
/// The axis of space along which Y grows.
constexpr unsigned y_axis(std::size_t square) {
  return (axis(square) + (square < 3 ? 1U : 2U)) % 3;
}

/// A corner of a square.
struct Corner {
  std::uint8_t square;
  std::uint8_t corner;
  friend constexpr bool operator==(const Corner&, const Corner&) = default;
};

/// The same corner of the cube on the next square about it, clockwise seen from outside: three steps lead back.
constexpr Corner clockwise(const Corner& c) {
  constexpr std::array<std::array<Corner, corner_count>, square_count> next{{{{{1, 0}, {2, 2}, {5, 0}, {4, 2}}},
                                                                             {{{2, 0}, {0, 2}, {3, 0}, {5, 2}}},
                                                                             {{{0, 0}, {1, 2}, {4, 0}, {3, 2}}},
                                                                             {{{2, 1}, {1, 3}, {4, 1}, {5, 3}}},
                                                                             {{{0, 1}, {2, 3}, {5, 1}, {3, 3}}},
                                                                             {{{1, 1}, {0, 3}, {3, 1}, {4, 3}}}}};
  return next[c.square][c.corner];
}

/// Where a corner is in space.
constexpr std::array<int, 3> position(const Corner& c) {
  std::array<int, 3> p{};
  p[axis(c.square)] = sign(c.square);
  p[x_axis(c.square)] = c.corner / 2 == 0 ? -1 : 1;
  p[y_axis(c.square)] = c.corner % 2 == 0 ? -1 : 1;
  return p;
}

}  // namespace quoin::cube
