// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <utility>

#include "quoin/arrangement/location/edge_pieces.h"
#include "quoin/arrangement/location/outer_faces.h"
#include "quoin/arrangement/location/vertical_decomposition.h"

/// Bodies of decompose_vertically, for the one source file per family that instantiates it.
namespace quoin {

/// Makes cells in the gaps between neighbours of the status. A gap is named by the edge below it.
template <CurveFamily F>
class DecompositionVisitor : public SweepVisitor<typename F::Point> {
 public:
  using Point = typename F::Point;
  using Event = SweepEvent<Point>;

  DecompositionVisitor(const Arrangement<F>& arrangement, const EdgePieces<F>& pieces,
                       const DecompositionOptions& options)
      : arrangement_(arrangement), options_(options), outer_(arrangement), names_(pieces) {
    result_.views.resize(arrangement.vertex_count());
    cells_.emplace_back();
    lowest_gap_ = 0;
  }

  bool at_event(const Event& event) override {
    names_.follow(event);
    gaps_.resize(gaps_.size() + event.right.size(), none);
    const Side side = arrangement_.family().side(event.point);
    if (side == Side::right) return true;  // cells stay open to the side
    const dcel::VertexId vertex = names_.vertex(event, 0);
    look(event, vertex);
    if (side == Side::left) {
      pass_left_side(event);
    } else if (!options_.walls_at_crossings && is_crossing(event)) {
      pass_crossing(event, vertex);
    } else {
      build_walls(event, vertex);
    }
    return true;
  }

  VerticalDecomposition finish() {
    for (auto& cell : cells_) {
      if (cell.right.is_none()) set_face(cell, nullptr);
    }
    std::sort(dead_.begin(), dead_.end());
    std::vector<std::uint32_t> number(cells_.size(), none);
    for (std::uint32_t i = 0; i < cells_.size(); ++i) {
      if (is_dead(i)) continue;
      number[i] = static_cast<std::uint32_t>(result_.trapezoids.size());
      result_.trapezoids.push_back(cells_[i]);
    }
    for (PseudoTrapezoid& cell : result_.trapezoids) {
      for (std::uint32_t* link : {&cell.upper_left, &cell.lower_left, &cell.upper_right, &cell.lower_right}) {
        if (*link != none) *link = number[*link];
      }
    }
    return std::move(result_);
  }

 private:
  static constexpr std::uint32_t none = PseudoTrapezoid::none;

  std::uint32_t& gap(std::uint32_t edge) { return edge == none ? lowest_gap_ : gaps_[edge]; }
  bool is_dead(std::uint32_t cell) const { return std::binary_search(dead_.begin(), dead_.end(), cell); }
  void set_face(PseudoTrapezoid& cell, const Point* right_wall) const {
    if (!cell.bottom.is_none()) {
      cell.face = face_above(arrangement_, cell.bottom);
    } else if (!cell.top.is_none()) {
      cell.face = face_below(arrangement_, cell.top);
    } else {
      cell.face =
          right_wall == nullptr ? outer_.rightmost_bottom(arrangement_) : outer_.bottom(arrangement_, *right_wall);
    }
  }
  std::uint32_t open(dcel::VertexId left, std::uint32_t bottom, std::uint32_t top) {
    PseudoTrapezoid& cell = cells_.emplace_back();
    left_points_.resize(cells_.size());
    cell.left = left;
    cell.bottom = names_[bottom];
    cell.top = names_[top];
    return static_cast<std::uint32_t>(cells_.size() - 1);
  }
  void close(std::uint32_t index, dcel::VertexId right, const Point& point) {
    PseudoTrapezoid& cell = cells_[index];
    cell.right = right;
    set_face(cell, &point);
    if constexpr (VerticalFamily<F>) {
      if (cell.left.is_none()) return;
      cell.has_width = arrangement_.family().compare_x(left_points_[index], point) != Sign::zero;
    }
  }

  /// Ends at the left side and on an identification build no walls; cells without width there are dropped.
  void pass_left_side(const Event& event) {
    std::uint32_t last = none;
    for (const std::uint32_t edge : event.left) {
      if (last != none) dead_.push_back(last);
      last = gap(edge);
    }
    const std::size_t count = event.right.size();
    cells_[gap(event.below)].top = names_[count == 0 ? event.above : event.right[0]];
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t above = i + 1 < count ? event.right[i + 1] : event.above;
      gap(event.right[i]) = open(dcel::VertexId(), event.right[i], above);
    }
    if (last != none) dead_.push_back(last);
  }

  /// The cells below and above the curves go on.
  void pass_crossing(const Event& event, dcel::VertexId vertex) {
    for (std::size_t i = 0; i + 1 < event.left.size(); ++i) close(gap(event.left[i]), vertex, event.point);
    for (std::size_t i = 0; i + 1 < event.right.size(); ++i) {
      gap(event.right[i]) = open(vertex, event.right[i], event.right[i + 1]);
      left_points_.back() = event.point;
    }
    gap(event.right.back()) = gap(event.left.back());
  }

  void build_walls(const Event& event, dcel::VertexId vertex) {
    const std::uint32_t lower = gap(event.below);
    const std::uint32_t upper = event.left.empty() ? lower : gap(event.left.back());
    close(lower, vertex, event.point);
    for (const std::uint32_t edge : event.left) close(gap(edge), vertex, event.point);
    std::uint32_t bottom = event.below;
    for (std::size_t i = 0; i <= event.right.size(); ++i) {
      const std::uint32_t top = i < event.right.size() ? event.right[i] : event.above;
      gap(bottom) = open(vertex, bottom, top);
      left_points_.back() = event.point;
      bottom = top;
    }
    const std::uint32_t next_lower = gap(event.below);
    const std::uint32_t next_upper = event.right.empty() ? next_lower : gap(event.right.back());
    const Side side = arrangement_.family().side(event.point);
    if (side != Side::bottom) {  // below such an end there is no wall to look across
      cells_[lower].lower_right = next_lower;
      cells_[next_lower].lower_left = lower;
    }
    if (side != Side::top) {
      cells_[upper].upper_right = next_upper;
      cells_[next_upper].upper_left = upper;
    }
  }

  /// Every curve that comes from the left goes on to the right.
  bool is_crossing(const Event& event) {
    if (event.left.empty() || event.right.empty()) return false;
    const auto collect = [&](std::span<const std::uint32_t> edges, std::vector<CurveId>& curves) {
      curves.clear();
      for (const std::uint32_t edge : edges) {
        for (const CurveUse use : arrangement_.curves(names_[edge])) curves.push_back(use.curve());
      }
      std::sort(curves.begin(), curves.end());
    };
    collect(event.left, curves_[0]);
    collect(event.right, curves_[1]);
    return curves_[0] == curves_[1];
  }

  /// What the vertex of the event sees; it may also be what the one before it sees above.
  void look(const Event& event, dcel::VertexId vertex) {
    if (!arrangement_.cells().is_real(vertex)) return;
    VerticalView& view = result_.views[vertex.index()];
    const dcel::EdgeId below = names_[event.below];
    const dcel::EdgeId above = names_[event.above];
    view.below = below.is_none() ? Location(outer_.bottom(arrangement_, event.point)) : Location(below);
    view.above = above.is_none() ? Location(outer_.top(arrangement_, event.point)) : Location(above);
    if constexpr (VerticalFamily<F>) {
      const dcel::VertexId before = std::exchange(last_seen_, vertex);
      const bool is_stacked =
          !before.is_none() && arrangement_.family().compare_x(last_point_, event.point) == Sign::zero;
      last_point_ = event.point;
      if (!is_stacked) return;
      Location& above_before = result_.views[before.index()].above;
      above_before = first_met(arrangement_, Direction::up, above_before.edge(), vertex);
      view.below = first_met(arrangement_, Direction::down, view.below.edge(), before);
    }
  }

  const Arrangement<F>& arrangement_;
  DecompositionOptions options_;
  OuterFaces<F> outer_;
  EdgeNames<F> names_;
  VerticalDecomposition result_;
  std::vector<PseudoTrapezoid> cells_;
  std::vector<Point> left_points_{1};  // by cell, where it has a left wall
  std::vector<std::uint32_t> gaps_;    // cell above each edge of the sweep
  std::uint32_t lowest_gap_ = none;    // cell below all edges
  std::vector<std::uint32_t> dead_;
  std::vector<CurveId> curves_[2];
  dcel::VertexId last_seen_;
  Point last_point_{};
};

template <CurveFamily F>
VerticalDecomposition decompose_vertically(const Arrangement<F>& arrangement, const DecompositionOptions& options,
                                           const Context& context) {
  const EdgePieces<F> pieces = pieces_of(arrangement);
  DecompositionVisitor<F> visitor(arrangement, pieces, options);
  Sweep<F>(arrangement.family(), pieces.list, {}, {pieces.one_colour}, visitor, context).run();
  return visitor.finish();
}

}  // namespace quoin
