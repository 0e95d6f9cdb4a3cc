// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quoin/arrangement/pieces.h"
#include "quoin/arrangement/sweep/crossing_list.h"
#include "quoin/arrangement/sweep/sweep_heap.h"
#include "quoin/arrangement/sweep/sweep_points.h"
#include "quoin/arrangement/sweep/sweep_status.h"
#include "quoin/base/context.h"
#include "quoin/base/error.h"

namespace quoin {

/// What several pieces that lie on one another share: each piece names the next one, the longest comes first.
using BundleLinks = std::vector<std::uint32_t>;

/// What the sweep meets at one point.
template <class Point>
struct SweepEvent {
  static constexpr std::uint32_t none = SweepStatus::none;

  const Point& point;
  std::uint32_t vertex;                    ///< number of the event; events that are only queries have none
  std::span<const std::uint32_t> known;    ///< input points and queries that are this point
  std::span<const std::uint32_t> left;     ///< edges that end here, bottom to top; of a query: that pass through it
  std::span<const std::uint32_t> right;    ///< edges that start here, bottom to top, consecutive numbers
  std::span<const std::uint32_t> bundles;  ///< for each edge in `right`, the first piece of its bundle
  std::uint32_t below;                     ///< edge just below, or none
  std::uint32_t above;                     ///< edge just above, or none
  const BundleLinks& next_in_bundle;
};

/// Drives an algorithm through the events of a sweep.
template <class Point>
class SweepVisitor {
 public:
  virtual ~SweepVisitor() = default;
  /// Called in lexicographic order. The sweep stops when it returns false.
  virtual bool at_event(const SweepEvent<Point>& event) = 0;
};

struct SweepOptions {
  /// Colour of each piece, or empty. Pieces of one colour are known not to cross or overlap.
  std::span<const std::uint32_t> colours{};
};

/// Sweeps a vertical line over pieces of curves, in lexicographic order of points, and tells a visitor what it meets.
///
/// Departs from Bentley and Ottmann 1979: every active curve keeps at most one pending crossing, the first with its
/// upper neighbour, in a heap keyed by the curve; curves that overlap share one place in the status (a bundle, the one
/// that ends last first), so overlaps cost no more than single curves; a point through which many curves pass is one
/// event. Ends at infinity, at poles and on identified sides are points like others, ordered by the family.
/// Exact. O((n + k) log n) predicates for n pieces and k vertices on edges counted once each, O(n) memory besides the
/// visitor's.
template <CurveFamily F>
class Sweep {
 public:
  using Point = typename F::Point;
  static constexpr std::uint32_t none = SweepStatus::none;

  /// `queries` are points that the visitor is told of but that split nothing; their numbers follow those of the list's
  /// points in `known`.
  Sweep(const F& family, const PieceList<F>& list, std::span<const Point> queries, const SweepOptions& options,
        SweepVisitor<Point>& visitor, const Context& context);

  /// Seeks no crossings: these are all. They outlive the sweep; no two pieces of the list overlap.
  void take_crossings(const CrossingList<Point>& crossings);

  /// @throws Cancelled
  void run();

 private:
  using Node = SweepStatus::Node;

  const Point& point_of(std::uint32_t index) const {
    if (index < list_.points.size()) return list_.points[index];
    const std::size_t rest = index - list_.points.size();
    return rest < queries_.size() ? queries_[rest] : copies_[rest - queries_.size()];
  }
  bool is_query(std::uint32_t index) const {
    return index >= list_.points.size() && index - list_.points.size() < queries_.size();
  }
  void order_points();
  void rank_points();
  bool take_next_event();
  bool has_next_crossing() const {
    return crossings_ == nullptr ? !heap_.is_empty() : next_crossing_ < crossing_order_.size();
  }
  const Point& next_crossing() const {
    return crossings_ == nullptr ? heap_.point(heap_.top()) : crossings_->points[crossing_order_[next_crossing_]];
  }
  void take_crossing();
  void read_incidences();
  void find_run();
  void take_crossing_pair();
  void extend_run_through_known_point();
  void extend_run_through_crossings();
  bool passes(std::uint32_t node) const {
    return node != none && family_.compare_y_at_x(event_point_, status_[node].branch) == Sign::zero;
  }
  bool report_query();
  void close_run();
  void drop_ended(std::uint32_t head);
  void order_to_right();
  void add_starting(std::uint32_t piece);
  void join(std::uint32_t& head, std::uint32_t piece);
  bool ends_later(std::uint32_t a, std::uint32_t b) const {
    const Piece& p = list_.pieces[a];
    const Piece& q = list_.pieces[b];
    return rank_[p.right] > rank_[q.right];
  }
  BranchId branch_of(std::uint32_t piece) const { return list_.pieces[piece].branch; }
  void write_run();
  void find_crossing(std::uint32_t node);

  const F& family_;
  const PieceList<F>& list_;
  std::span<const Point> queries_;
  SweepOptions options_;
  SweepVisitor<Point>& visitor_;
  const Context& context_;
  std::vector<Point> copies_;  // left copies of points on an identified right side
  PointIncidences incidences_;
  std::vector<std::uint32_t> order_;
  std::vector<std::uint32_t> rank_;  // by point: equal points have equal ranks
  std::size_t next_known_ = 0;
  SweepStatus status_;
  SweepHeap<F> heap_;
  std::vector<std::uint32_t> node_of_;  // by piece; right for first pieces of bundles
  BundleLinks next_in_bundle_;
  std::vector<std::uint8_t> is_ended_;
  const CrossingList<Point>* crossings_ = nullptr;
  std::vector<std::uint32_t> crossing_order_;
  std::size_t next_crossing_ = 0;

  // The current event.
  Point event_point_{};
  std::span<const std::uint32_t> known_;
  bool only_queries_ = false;
  std::uint32_t popped_ = none;           // a node that crosses its upper neighbour here
  const PiecePair* only_pair_ = nullptr;  // the two pieces of a crossing of two
  std::vector<std::uint32_t> starting_;
  bool has_ending_ = false;
  std::uint32_t hint_ = none;
  std::uint32_t run_below_ = none;
  std::uint32_t run_above_ = none;
  std::vector<std::uint32_t> run_;    // nodes through the point, bottom to top
  std::vector<std::uint32_t> left_;   // edges
  std::vector<std::uint32_t> right_;  // edges
  std::vector<std::uint32_t> heads_;  // bundles to the right, bottom to top
  std::uint32_t vertex_count_ = 0;
  std::uint32_t edge_count_ = 0;
};

}  // namespace quoin
