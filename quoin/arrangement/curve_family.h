// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <vector>

#include "quoin/arrangement/surface.h"
#include "quoin/base/id.h"
#include "quoin/base/sign.h"

namespace quoin {

/// A maximal x-monotone branch of a supporting curve: a line, the upper half of a circle, a great circle cut at the
/// identification. Ids are handed out by the family that owns the supports.
using BranchId = Id<struct BranchTag>;

/// A point where two branches meet.
template <class Point>
struct Meeting {
  Point point;
  bool crosses = true;  ///< the branches change their order there: the multiplicity is odd
};

/// Geometry of an arrangement: the pools of supporting curves, and the predicates on points and branches. It knows
/// nothing of vertices and faces, and those know nothing of it.
///
/// A *point* is a small value: its definition (a pair of supports and a root, or explicit coordinates) and doubles with
/// a certified error. An *end* of a curve on a side of the parameter rectangle (at infinity, at a pole, on the
/// identification) is a point too; `side(p)` tells which. A *piece* is a branch between two points; it holds no numbers
/// of its own, so splitting one writes two points and numbers never grow. All predicates are exact.
///
/// "Left", "right" and "before" refer to the lexicographic order: by x, then by y. On other surfaces x and y stand for
/// the parameters u and v. A vertical branch lies above all others to the right of a common point, and below all others
/// to the left of it, as the sweep meets them.
///
/// Predicates of a `const` family may be called from several threads.
template <class F>
concept CurveFamily = requires(F& family, const F& f, const typename F::Point& p, BranchId b, typename F::Point& out,
                               std::vector<Meeting<typename F::Point>>& meetings, const typename F::Shift& shift) {
  typename F::Surface;
  requires SurfaceTopology<typename F::Surface>;
  typename F::Position;  // rounded coordinates for people: Point2 or, on the sphere, a unit Vector3

  /// Total order. Zero if and only if both are the same point of the parameter rectangle.
  { f.compare_xy(p, p) } -> std::same_as<Sign>;
  /// Positive: p lies above the branch. p is in the x-range of the branch. Of a vertical branch p lies on its line:
  /// zero.
  { f.compare_y_at_x(p, b) } -> std::same_as<Sign>;
  /// Order of two branches through p, just right of p. Zero if and only if they overlap there.
  { f.compare_right(b, b, p) } -> std::same_as<Sign>;
  /// Order of two branches through p, just left of p. Zero if and only if they overlap there.
  { f.compare_left(b, b, p) } -> std::same_as<Sign>;
  { f.is_vertical(b) } -> std::same_as<bool>;
  /// Both are the same set of points, perhaps of supports that were given twice.
  { f.same_branch(b, b) } -> std::same_as<bool>;
  { f.side(p) } -> std::same_as<Side>;

  /// Two branches have one common point at most. Such a family also has a first_meeting that takes the order of the two
  /// ends instead of `after`.
  { F::meets_once } -> std::convertible_to<bool>;
  /// Branches that meet always cross: curves that go on through a common point come out in reverse order.
  { F::meets_transversally } -> std::convertible_to<bool>;
  /// first_meeting(lower, lower_end, upper, upper_end, after, out): the first common point, in lexicographic order, of
  /// the two pieces strictly after `after`, where `lower` lies below `upper` just right of `after` and the pieces end
  /// on the right at the given points. Common points that are such an end may be left out: the sweep knows them.
  { f.first_meeting(b, p, b, p, p, out) } -> std::same_as<bool>;
  /// All common points of two branches that do not overlap, in lexicographic order, appended.
  {f.meetings(b, b, meetings)};

  /// Takes over the supports of another family object; `shifted` translates what referred to the other one.
  { family.absorb(f) } -> std::same_as<typename F::Shift>;
  { F::shifted(p, shift) } -> std::same_as<typename F::Point>;
  { F::shifted(b, shift) } -> std::same_as<BranchId>;

  /// Rounded position, for pictures, grids and sorting: each coordinate within `error()` of the true one.
  { f.position(p) } -> std::same_as<typename F::Position>;
  { f.error() } -> std::same_as<double>;
  /// A key that orders like compare_xy whenever two keys differ by more than 2 key_error() and by more than 2^-44 of
  /// the larger one; ends on sides have keys of the same kind (infinite at infinity).
  { f.sweep_key(p) } -> std::same_as<double>;
  { f.key_error() } -> std::same_as<double>;
};

/// A family whose points may lie on an identified pair of sides, left and right.
template <class F>
concept IdentifiedFamily = CurveFamily<F> && requires(const F& f, const typename F::Point& p) {
  /// The copy on the left side of a point on the right side.
  { f.left_copy(p) } -> std::same_as<typename F::Point>;
};

}  // namespace quoin
