// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "quoin/arrangement/arrangement.h"
#include "quoin/arrangement/cells/dcel_builder.h"
#include "quoin/arrangement/sweep/sweep.h"

namespace quoin {

/// Makes an arrangement of what a sweep meets.
template <CurveFamily F>
class BuildVisitor : public SweepVisitor<typename F::Point> {
 public:
  using Point = typename F::Point;
  static constexpr bool has_glued_sides = F::Surface::sides.left == SideKind::identified;

  /// `follows_points`: vertex_of_point will be asked for.
  BuildVisitor(const F& family, const PieceList<F>& list, bool follows_points = true)
      : family_(family),
        list_(list),
        curve_count_(list.curve_count),
        vertex_of_point_(follows_points ? list.points.size() : 0) {
    if constexpr (has_glued_sides) number_copies();
  }

  /// For as many events and edges, if their numbers are known.
  void reserve(std::size_t events, std::size_t edges) {
    builder_.reserve(events, edges);
    points_.reserve(events);
    branches_.reserve(edges);
    history_.reserve(edges);
  }

  bool at_event(const SweepEvent<Point>& event) override {
    dcel::LinkEvent link{family_.side(event.point), event.left, event.right, event.below, dcel::DcelBuilder::none};
    if constexpr (has_glued_sides) follow_copies(event, link);
    builder_.add_event(link);
    points_.push_back(event.point);
    for (const std::uint32_t index : event.known) {
      if (index < vertex_of_point_.size()) vertex_of_point_[index] = dcel::VertexId(std::size_t{event.vertex});
    }
    for (const std::uint32_t head : event.bundles) {
      const Piece& first = list_.pieces[head];
      branches_.push_back(first.branch);
      if (event.next_in_bundle[head] == event.none) {
        history_.append_single(CurveUse(first.curve, first.reversed));
      } else {
        append_bundle(event, head);
      }
    }
    return true;
  }

  /// By point of the list, once finished.
  const std::vector<dcel::VertexId>& vertex_of_point() const { return vertex_of_point_; }

  /// The list and the family given to the constructor are not read any more.
  Arrangement<F> finish(F family) {
    auto built = builder_.finish(F::Surface::sides, F::Surface::has_unbounded_face);
    const std::size_t edges = built.dcel.edges.size();
    if (!built.vertex_of_event.empty()) number_points(built);
    branches_.resize(edges);
    while (history_.edge_count() < edges) history_.append({});
    Arrangement<F> result(std::move(family), std::move(built.dcel), std::move(points_), std::move(branches_),
                          std::move(history_), curve_count_);
    if constexpr (has_glued_sides) result.set_edge_ends(edge_ends(result));
    return result;
  }

 private:
  void append_bundle(const SweepEvent<Point>& event, std::uint32_t head) {
    uses_.clear();
    for (std::uint32_t piece = head; piece != event.none; piece = event.next_in_bundle[piece]) {
      uses_.emplace_back(list_.pieces[piece].curve, list_.pieces[piece].reversed);
    }
    std::sort(uses_.begin(), uses_.end());
    history_.append(uses_);
  }
  /// From events to vertices.
  void number_points(const dcel::DcelBuilder::Result& built) {
    std::vector<Point> points(built.dcel.vertices.size());
    std::size_t with_point = 0;
    for (std::size_t event = built.vertex_of_event.size(); event-- > 0;) {
      const std::size_t vertex = built.vertex_of_event[event].index();
      points[vertex] = points_[event];
      with_point = std::max(with_point, vertex + 1);
    }
    points.resize(with_point);
    points_ = std::move(points);
    for (dcel::VertexId& vertex : vertex_of_point_) vertex = built.vertex_of_event[vertex.index()];
  }
  std::vector<EdgeEnds<Point>> edge_ends(const Arrangement<F>& made) {
    std::sort(ends_.begin(), ends_.end(), [](const End& a, const End& b) { return a.edge < b.edge; });
    std::vector<EdgeEnds<Point>> result;
    for (const End& end : ends_) {
      const dcel::EdgeId edge(std::size_t{end.edge});
      if (result.empty() || result.back().edge != edge) {
        result.push_back({edge, made.point(made.left(edge)), made.point(made.right(edge))});
      }
      (end.is_right ? result.back().right : result.back().left) = end.point;
    }
    return result;
  }
  void number_copies() {
    copy_of_point_.resize(list_.points.size(), 0);
    std::uint32_t copies = 0;
    for (std::size_t i = 0; i < list_.points.size(); ++i) {
      if (family_.side(list_.points[i]) == Side::right) copy_of_point_[i] = copies++;
    }
    event_of_copy_.resize(copies);
  }
  void follow_copies(const SweepEvent<Point>& event, dcel::LinkEvent& link) {
    for (const std::uint32_t index : event.known) {
      if (index >= list_.points.size()) event_of_copy_[index - list_.points.size()] = event.vertex;
    }
    if (link.side == Side::right) link.left_copy = event_of_copy_[copy_of_point_[event.known[0]]];
    if (link.side == Side::interior) return;
    for (const std::uint32_t edge : event.right) ends_.push_back({edge, false, event.point});
    for (const std::uint32_t edge : event.left) ends_.push_back({edge, true, event.point});
  }

  const F& family_;
  const PieceList<F>& list_;
  std::uint32_t curve_count_;
  dcel::DcelBuilder builder_;
  std::vector<dcel::VertexId> vertex_of_point_;
  std::vector<Point> points_;  // by event
  std::vector<BranchId> branches_;
  CurveHistory history_;
  std::vector<CurveUse> uses_;
  struct End {  // of an edge on a side
    std::uint32_t edge;
    bool is_right;
    Point point;
  };
  std::vector<End> ends_;
  std::vector<std::uint32_t> copy_of_point_;
  std::vector<std::uint32_t> event_of_copy_;
};

}  // namespace quoin
