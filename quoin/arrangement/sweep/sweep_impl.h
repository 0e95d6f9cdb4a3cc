// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <utility>

#include "quoin/arrangement/sweep/sweep.h"

/// Bodies of Sweep, for the one source file per family that instantiates it.
namespace quoin {

template <CurveFamily F>
Sweep<F>::Sweep(const F& family, const PieceList<F>& list, std::span<const Point> queries, const SweepOptions& options,
                SweepVisitor<Point>& visitor, const Context& context)
    : family_(family),
      list_(list),
      queries_(queries),
      options_(options),
      visitor_(visitor),
      context_(context),
      incidences_(list.points.size(), list.pieces),
      heap_(family, status_),
      node_of_(list.pieces.size(), none),
      next_in_bundle_(list.pieces.size(), none),
      is_ended_(list.pieces.size(), 0) {}

template <CurveFamily F>
void Sweep<F>::order_points() {
  if constexpr (IdentifiedFamily<F>) {
    for (const Point& point : list_.points) {
      if (family_.side(point) == Side::right) copies_.push_back(family_.left_copy(point));
    }
  }
  if (queries_.empty() && copies_.empty()) {
    order_ = sorted_points(context_, family_, std::span<const Point>(list_.points));
    return;
  }
  std::vector<Point> all(list_.points);
  all.insert(all.end(), queries_.begin(), queries_.end());
  all.insert(all.end(), copies_.begin(), copies_.end());
  order_ = sorted_points(context_, family_, std::span<const Point>(all));
}

template <CurveFamily F>
void Sweep<F>::take_crossings(const CrossingList<Point>& crossings) {
  crossings_ = &crossings;
  crossing_order_ = sorted_points(context_, family_, std::span<const Point>(crossings.points));
}

template <CurveFamily F>
void Sweep<F>::rank_points() {
  rank_.resize(order_.size());
  std::uint32_t rank = 0;
  for (std::size_t i = 0; i < order_.size(); ++i) {
    if (i > 0 && family_.compare_xy(point_of(order_[i - 1]), point_of(order_[i])) != Sign::zero) ++rank;
    rank_[order_[i]] = rank;
  }
}

template <CurveFamily F>
void Sweep<F>::run() {
  order_points();
  rank_points();
  for (std::size_t count = 0; take_next_event(); ++count) {
    if (count % 256 == 0) context_.poll();
    read_incidences();
    find_run();
    if (only_queries_) {
      if (!report_query()) return;
      continue;
    }
    close_run();
    order_to_right();
    write_run();
    const SweepEvent<Point> event{event_point_,
                                  vertex_count_++,
                                  known_,
                                  left_,
                                  right_,
                                  heads_,
                                  run_below_ == none ? none : status_[run_below_].edge,
                                  run_above_ == none ? none : status_[run_above_].edge,
                                  next_in_bundle_};
    if (!visitor_.at_event(event)) return;
  }
  if (!status_.is_empty()) throw InternalError("sweep: a curve never ended");
}

/// The next point, and which input points are there: the known one, the first crossing, or both if they are equal.
template <CurveFamily F>
bool Sweep<F>::take_next_event() {
  const bool has_known = next_known_ < order_.size();
  const bool has_crossing = has_next_crossing();
  if (!has_known && !has_crossing) return false;
  Sign order = has_known ? Sign::negative : Sign::positive;
  if (has_known && has_crossing) order = family_.compare_xy(point_of(order_[next_known_]), next_crossing());
  popped_ = none;
  only_pair_ = nullptr;
  if (order != Sign::negative) take_crossing();
  known_ = {};
  if (order == Sign::positive) return true;
  event_point_ = point_of(order_[next_known_]);
  std::size_t end = next_known_ + 1;
  while (end < order_.size() && rank_[order_[end]] == rank_[order_[next_known_]]) ++end;
  known_ = {order_.data() + next_known_, end - next_known_};
  next_known_ = end;
  return true;
}

template <CurveFamily F>
void Sweep<F>::take_crossing() {
  event_point_ = next_crossing();
  if (crossings_ == nullptr) {
    popped_ = heap_.top();
    return;
  }
  // They come in the order of pairs, so that those soon needed are far apart in memory.
  if (next_crossing_ + 8 < crossing_order_.size()) {
    const std::uint32_t soon = crossing_order_[next_crossing_ + 8];
    __builtin_prefetch(&crossings_->points[soon]);
    __builtin_prefetch(&crossings_->pairs[soon]);
  }
  const PiecePair& pair = crossings_->pairs[crossing_order_[next_crossing_]];
  popped_ = node_of_[pair.one];
  only_pair_ = &pair;
  while (++next_crossing_ < crossing_order_.size() && family_.compare_xy(next_crossing(), event_point_) == Sign::zero) {
    only_pair_ = nullptr;
  }
}

template <CurveFamily F>
void Sweep<F>::read_incidences() {
  starting_.clear();
  has_ending_ = false;
  hint_ = popped_;
  only_queries_ = popped_ == none;
  for (const std::uint32_t index : known_) {
    if (is_query(index)) continue;
    only_queries_ = false;
    if (index >= list_.points.size()) continue;
    for (const std::uint32_t entry : incidences_.at(index)) {
      const std::uint32_t piece = entry / 2;
      if (entry % 2 == 0) {
        starting_.push_back(piece);
        continue;
      }
      has_ending_ = true;
      is_ended_[piece] = 1;
      const std::uint32_t node = node_of_[piece];
      if (hint_ == none && node != none && status_[node].head == piece) hint_ = node;
    }
  }
}

template <CurveFamily F>
void Sweep<F>::find_run() {
  run_.clear();
  if (hint_ == none) {
    const std::uint32_t node = status_.lowest_not_below(
        [&](BranchId branch) { return family_.compare_y_at_x(event_point_, branch) == Sign::positive; });
    run_below_ = node == none ? status_.highest() : status_[node].below;
    run_above_ = node;
    if (passes(node)) {
      run_.push_back(node);
      extend_run_through_known_point();
    }
    return;
  }
  if (known_.empty() && only_pair_ != nullptr) {
    take_crossing_pair();
    return;
  }
  run_.push_back(hint_);
  if (known_.empty() && crossings_ == nullptr) {
    extend_run_through_crossings();
  } else {
    extend_run_through_known_point();
  }
}

/// No other piece passes, or there would be more pairs.
template <CurveFamily F>
void Sweep<F>::take_crossing_pair() {
  std::uint32_t lower = node_of_[only_pair_->one];
  std::uint32_t upper = node_of_[only_pair_->two];
  if (status_[upper].above == lower) std::swap(lower, upper);
  if (status_[lower].above != upper) throw InternalError("sweep: two pieces cross that are not neighbours");
  run_.push_back(lower);
  run_.push_back(upper);
  run_below_ = status_[lower].below;
  run_above_ = status_[upper].above;
}

template <CurveFamily F>
void Sweep<F>::extend_run_through_known_point() {
  std::uint32_t lowest = run_[0];
  while (passes(status_[lowest].below)) lowest = status_[lowest].below;
  std::uint32_t above = status_[run_[0]].above;
  while (passes(above)) above = status_[above].above;
  run_.clear();
  for (std::uint32_t node = lowest; node != above; node = status_[node].above) run_.push_back(node);
  run_below_ = status_[lowest].below;
  run_above_ = above;
}

/// Neighbours that pass through a crossing have it as their pending crossing: it is the first point of all.
template <CurveFamily F>
void Sweep<F>::extend_run_through_crossings() {
  const auto crosses_upper_here = [&](std::uint32_t node) {
    return node != none && heap_.has(node) && family_.compare_xy(heap_.point(node), event_point_) == Sign::zero;
  };
  std::uint32_t lowest = run_[0];
  while (crosses_upper_here(status_[lowest].below)) lowest = status_[lowest].below;
  std::uint32_t highest = status_[run_[0]].above;
  while (crosses_upper_here(highest)) highest = status_[highest].above;
  run_below_ = status_[lowest].below;
  run_above_ = status_[highest].above;
  run_.clear();
  for (std::uint32_t node = lowest; node != run_above_; node = status_[node].above) run_.push_back(node);
}

template <CurveFamily F>
bool Sweep<F>::report_query() {
  left_.clear();
  for (const std::uint32_t node : run_) left_.push_back(status_[node].edge);
  const SweepEvent<Point> event{event_point_,
                                none,
                                known_,
                                left_,
                                {},
                                {},
                                run_below_ == none ? none : status_[run_below_].edge,
                                run_above_ == none ? none : status_[run_above_].edge,
                                next_in_bundle_};
  return visitor_.at_event(event);
}

/// Edges of the run end; what goes on to the right is left in `heads_`, in the order on the left.
template <CurveFamily F>
void Sweep<F>::close_run() {
  left_.clear();
  heads_.clear();
  if (run_below_ != none) heap_.remove(run_below_);
  for (const std::uint32_t node : run_) {
    heap_.remove(node);
    left_.push_back(status_[node].edge);
    const std::uint32_t head = status_[node].head;
    if (has_ending_) {
      drop_ended(head);
    } else {
      heads_.push_back(head);
    }
  }
}

/// Pushes the bundle without its ended pieces, if any are left. The first piece ends last: if it ends, all do.
template <CurveFamily F>
void Sweep<F>::drop_ended(std::uint32_t head) {
  if (is_ended_[head] != 0) return;
  std::uint32_t previous = head;
  for (std::uint32_t piece = next_in_bundle_[head]; piece != none; piece = next_in_bundle_[piece]) {
    if (is_ended_[piece] != 0) {
      next_in_bundle_[previous] = next_in_bundle_[piece];
    } else {
      previous = piece;
    }
  }
  heads_.push_back(head);
}

template <CurveFamily F>
void Sweep<F>::order_to_right() {
  if constexpr (F::meets_transversally) {
    std::reverse(heads_.begin(), heads_.end());
  } else if (known_.empty() && only_pair_ != nullptr) {
    if (only_pair_->crosses) std::swap(heads_[0], heads_[1]);
  } else if (heads_.size() > 1) {
    std::sort(heads_.begin(), heads_.end(), [&](std::uint32_t a, std::uint32_t b) {
      return family_.compare_right(branch_of(a), branch_of(b), event_point_) == Sign::negative;
    });
  }
  for (const std::uint32_t piece : starting_) add_starting(piece);
}

/// By bisection, so that a point where many curves start costs n log n comparisons.
template <CurveFamily F>
void Sweep<F>::add_starting(std::uint32_t piece) {
  std::size_t low = 0;
  std::size_t high = heads_.size();
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    const Sign order = family_.compare_right(branch_of(piece), branch_of(heads_[middle]), event_point_);
    if (order == Sign::zero) {
      join(heads_[middle], piece);
      return;
    }
    if (order == Sign::positive) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  heads_.insert(heads_.begin() + static_cast<std::ptrdiff_t>(low), piece);
}

template <CurveFamily F>
void Sweep<F>::join(std::uint32_t& head, std::uint32_t piece) {
  if (ends_later(piece, head)) {
    next_in_bundle_[piece] = head;
    head = piece;
  } else {
    next_in_bundle_[piece] = next_in_bundle_[head];
    next_in_bundle_[head] = piece;
  }
}

/// Puts the bundles to the right into the places of the run, opens their edges and looks for new crossings.
template <CurveFamily F>
void Sweep<F>::write_run() {
  while (run_.size() > heads_.size()) {
    status_.erase(run_.back());
    run_.pop_back();
  }
  while (run_.size() < heads_.size()) run_.push_back(status_.insert_above(run_.empty() ? run_below_ : run_.back()));
  right_.clear();
  for (std::size_t i = 0; i < run_.size(); ++i) {
    Node& node = status_[run_[i]];
    node.head = heads_[i];
    node.branch = branch_of(heads_[i]);
    node.edge = edge_count_++;
    node_of_[heads_[i]] = run_[i];
    right_.push_back(node.edge);
  }
  if (crossings_ != nullptr) return;
  find_crossing(run_below_);
  if constexpr (F::meets_once) {
    if (!run_.empty()) find_crossing(run_.back());
  } else {
    for (const std::uint32_t node : run_) find_crossing(node);  // curves through one point may meet again
  }
}

template <CurveFamily F>
void Sweep<F>::find_crossing(std::uint32_t node) {
  if (node == none || status_[node].above == none) return;
  const Node& lower = status_[node];
  const Node& upper = status_[lower.above];
  if (!options_.colours.empty() && options_.colours[lower.head] == options_.colours[upper.head]) return;
  const std::uint32_t lower_end = list_.pieces[lower.head].right;
  const std::uint32_t upper_end = list_.pieces[upper.head].right;
  Point point;
  bool meet;
  if constexpr (F::meets_once) {
    const Sign ends = sign_of(static_cast<std::int64_t>(rank_[lower_end]) - rank_[upper_end]);
    meet = family_.first_meeting(lower.branch, list_.points[lower_end], upper.branch, list_.points[upper_end], ends,
                                 point);
  } else {
    meet = family_.first_meeting(lower.branch, list_.points[lower_end], upper.branch, list_.points[upper_end],
                                 event_point_, point);
  }
  if (meet) heap_.push(node, point);
}

}  // namespace quoin
