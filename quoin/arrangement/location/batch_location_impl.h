// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "quoin/arrangement/location/batch_location.h"
#include "quoin/arrangement/location/edge_pieces.h"
#include "quoin/arrangement/location/outer_faces.h"

/// Bodies of locate_batch, for the one source file per family that instantiates it.
namespace quoin {

/// Writes down where the queries of a sweep over edges lie.
template <CurveFamily F>
class BatchVisitor : public SweepVisitor<typename F::Point> {
 public:
  using Point = typename F::Point;

  BatchVisitor(const Arrangement<F>& arrangement, const EdgePieces<F>& pieces, std::size_t query_count)
      : arrangement_(arrangement),
        outer_(arrangement),
        names_(pieces),
        first_query_(static_cast<std::uint32_t>(pieces.list.points.size())),
        result_(query_count) {}

  bool at_event(const SweepEvent<Point>& event) override {
    names_.follow(event);
    Location place;
    bool is_placed = false;
    for (const std::uint32_t index : event.known) {
      if (index < first_query_ || index - first_query_ >= result_.size()) continue;
      if (!is_placed) place = place_of(event);
      is_placed = true;
      result_[index - first_query_] = place;
    }
    return true;
  }
  std::vector<Location> take() { return std::move(result_); }
  const OuterFaces<F>& outer() const { return outer_; }

 private:
  Location place_of(const SweepEvent<Point>& event) const {
    if (event.vertex != event.none) return names_.vertex(event, result_.size());
    if (!event.left.empty()) return names_[event.left[0]];
    const dcel::EdgeId below = names_[event.below];
    return below.is_none() ? outer_.bottom(arrangement_, event.point) : face_above(arrangement_, below);
  }

  const Arrangement<F>& arrangement_;
  OuterFaces<F> outer_;
  EdgeNames<F> names_;
  std::uint32_t first_query_;
  std::vector<Location> result_;
};

template <CurveFamily F>
std::vector<Location> locate_batch(const Arrangement<F>& arrangement, std::span<const typename F::Point> points,
                                   const Context& context) {
  using Point = typename F::Point;
  const F& family = arrangement.family();
  std::vector<Point> copies;
  if constexpr (F::Surface::sides.left == SideKind::identified) {
    for (const Point& p : points) copies.push_back(left_copy_of(family, p));
    points = copies;
  }
  const EdgePieces<F> pieces = pieces_of(arrangement);
  BatchVisitor<F> visitor(arrangement, pieces, points.size());
  Sweep<F>(family, pieces.list, points, {pieces.one_colour}, visitor, context).run();
  std::vector<Location> result = visitor.take();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (is_pole(family, points[i])) result[i] = visitor.outer().pole(arrangement, family.side(points[i]));
  }
  return result;
}

}  // namespace quoin
