// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "quoin/arrangement/pieces.h"
#include "quoin/base/context.h"

/// What a sweep tells of curves without making an arrangement of them.
namespace quoin {

/// Whether any two pieces meet at a point that is inside one of them, or a lone point lies inside a piece. Shared ends
/// do not count. O((n + k) log n) for the k points swept before the first such one.
/// @throws Cancelled
template <CurveFamily F>
bool crosses_anything(const F& family, const PieceList<F>& list, const Context& context);

/// A point and the pieces through it.
template <class Point>
struct Intersection {
  Point point;
  std::vector<std::uint32_t> pieces;       ///< of the list, ascending
  std::vector<std::uint32_t> lone_points;  ///< of the list, ascending
};

struct IntersectionOptions {
  bool includes_common_ends = false;  ///< points too where all pieces end
};

/// All points where two pieces or more meet, or a lone point meets one, in lexicographic order. Where pieces run along
/// one another, these are the ends of the common parts and what happens inside. O((n + k) log n + size of the result).
/// @throws Cancelled
template <CurveFamily F>
std::vector<Intersection<typename F::Point>> report_intersections(const F& family, const PieceList<F>& list,
                                                                  const Context& context,
                                                                  const IntersectionOptions& options = {});

/// A part of one or several pieces between neighbouring intersections.
template <class Point>
struct SubCurve {
  BranchId branch;
  Point left;
  Point right;
  std::vector<std::uint32_t> pieces;  ///< that run along it, ascending
};

/// The pieces cut at all points where they meet: they meet in ends only, and cover what the pieces cover, once. In the
/// order of edges of an arrangement: by left end, then from bottom to top. O((n + k) log n + size of the result).
/// @throws Cancelled
template <CurveFamily F>
std::vector<SubCurve<typename F::Point>> sub_curves(const F& family, const PieceList<F>& list, const Context& context);

}  // namespace quoin
