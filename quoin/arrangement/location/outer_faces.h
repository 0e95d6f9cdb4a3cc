// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

#include "quoin/arrangement/location/edge_order.h"

namespace quoin {

/// The faces at the bottom and at the top of the parameter rectangle, where no edge lies below or above a point; the
/// poles of a sphere.
///
/// Between edges that reach the bottom side lie different faces; elsewhere the face is below the edge that starts
/// first, and above the one that ends last. O(edges) to make, O(log) of the edges at a side to ask.
template <CurveFamily F>
class OuterFaces {
 public:
  using Point = typename F::Point;

  explicit OuterFaces(const Arrangement<F>& arrangement) {
    const Arrangement<F>& a = arrangement;
    for (std::size_t i = 0; i < a.edge_count(); ++i) {
      const dcel::EdgeId e(i);
      if (!a.cells().is_real(e)) continue;
      if (a.family().side(a.left_point(e)) == Side::bottom) bottom_.push_back(e);
      if (a.family().side(a.right_point(e)) == Side::top) top_.push_back(e);
      if (first_.is_none() || starts_before(a, e, first_)) first_ = e;
      if (last_.is_none() || ends_after(a, e, last_)) last_ = e;
    }
    const auto is_before = [&](const Point& p, const Point& q) {
      return a.family().compare_xy(p, q) == Sign::negative;
    };
    std::sort(bottom_.begin(), bottom_.end(),
              [&](auto e, auto f) { return is_before(a.left_point(e), a.left_point(f)); });
    std::sort(top_.begin(), top_.end(), [&](auto e, auto f) { return is_before(a.right_point(e), a.right_point(f)); });
    for (std::size_t i = 0; i < a.face_count() && only_.is_none(); ++i) {
      if (a.cells().is_real(dcel::FaceId(i))) only_ = dcel::FaceId(i);
    }
    find_poles(a);
  }

  /// The face below everything where the leaning line through p arrives; no edge lies below p.
  dcel::FaceId bottom(const Arrangement<F>& a, const Point& p) const {
    const auto after = std::partition_point(bottom_.begin(), bottom_.end(), [&](auto e) {
      return a.family().compare_xy(a.left_point(e), p) == Sign::negative;
    });
    if (after != bottom_.begin()) return face_below(a, *(after - 1));
    return leftmost_bottom(a);
  }
  /// The face at the bottom before everything.
  dcel::FaceId leftmost_bottom(const Arrangement<F>& a) const {
    if (first_.is_none()) return only_;
    return a.family().side(a.left_point(first_)) == Side::bottom ? face_above(a, first_) : face_below(a, first_);
  }
  /// The face at the bottom after everything.
  dcel::FaceId rightmost_bottom(const Arrangement<F>& a) const {
    return bottom_.empty() ? leftmost_bottom(a) : face_below(a, bottom_.back());
  }
  /// The face above everything where the leaning line through p arrives; no edge lies above p.
  dcel::FaceId top(const Arrangement<F>& a, const Point& p) const {
    const auto after = std::partition_point(
        top_.begin(), top_.end(), [&](auto e) { return a.family().compare_xy(a.right_point(e), p) == Sign::negative; });
    if (after != top_.end()) return face_above(a, *after);
    if (last_.is_none()) return only_;
    return a.family().side(a.right_point(last_)) == Side::top ? face_below(a, last_) : face_above(a, last_);
  }
  /// What lies at a contracted side.
  Location pole(const Arrangement<F>& a, Side side) const {
    const dcel::VertexId v = side == Side::bottom ? bottom_pole_ : top_pole_;
    if (!v.is_none()) return v;
    if (first_.is_none()) return only_;
    return side == Side::bottom ? face_below(a, first_) : face_above(a, last_);
  }

 private:
  static bool starts_before(const Arrangement<F>& a, dcel::EdgeId e, dcel::EdgeId f) {
    const Sign order = a.family().compare_xy(a.left_point(e), a.left_point(f));
    if (order != Sign::zero) return order == Sign::negative;
    return a.family().compare_right(a.branch(e), a.branch(f), a.left_point(e)) == Sign::negative;
  }
  static bool ends_after(const Arrangement<F>& a, dcel::EdgeId e, dcel::EdgeId f) {
    const Sign order = a.family().compare_xy(a.right_point(e), a.right_point(f));
    if (order != Sign::zero) return order == Sign::positive;
    return a.family().compare_left(a.branch(e), a.branch(f), a.right_point(e)) == Sign::positive;
  }
  void find_poles(const Arrangement<F>& a) {
    if constexpr (F::Surface::sides.bottom == SideKind::contracted) {
      for (std::size_t i = 0; i < a.vertex_count(); ++i) {
        const dcel::VertexId v(i);
        if (!is_point_vertex(a, v)) continue;
        if (a.family().side(a.point(v)) == Side::bottom) bottom_pole_ = v;
        if (a.family().side(a.point(v)) == Side::top) top_pole_ = v;
      }
    }
  }

  std::vector<dcel::EdgeId> bottom_;  // that start on the bottom side, by x
  std::vector<dcel::EdgeId> top_;     // that end on the top side, by x
  dcel::EdgeId first_;                // that starts first, the lowest of those
  dcel::EdgeId last_;                 // that ends last, the highest of those
  dcel::FaceId only_;                 // of an arrangement without edges
  dcel::VertexId bottom_pole_;
  dcel::VertexId top_pole_;
};

/// The copy of a point that locators ask about: the left one of two.
template <CurveFamily F>
typename F::Point left_copy_of(const F& family, const typename F::Point& p) {
  if constexpr (IdentifiedFamily<F>) {
    if (family.side(p) == Side::right) return family.left_copy(p);
  }
  return p;
}

/// Whether the point is a pole.
template <CurveFamily F>
bool is_pole(const F& family, const typename F::Point& p) {
  if constexpr (F::Surface::sides.bottom == SideKind::contracted) {
    const Side side = family.side(p);
    return side == Side::bottom || side == Side::top;
  }
  return false;
}

}  // namespace quoin
