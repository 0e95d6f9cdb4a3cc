// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "quoin/arrangement/envelope.h"

namespace quoin {

/// Which of two points over the same x an envelope shows.
enum class EnvelopeSide : std::uint8_t { lower, upper };

/// Sets of members that grow by unions of disjoint ones, each in constant time; the numbers of a set are written out
/// when it is asked for. Zero is the empty set.
class EnvelopeSets {
 public:
  std::uint32_t single(std::uint32_t member) { return push({member, 0, 0}); }
  /// The union, represented by what represents `a`.
  std::uint32_t unite(std::uint32_t a, std::uint32_t b) {
    if (a == 0 || b == 0) return a + b;
    return push({nodes_[a].member, a, b});
  }
  /// Some member of a set that is not empty.
  std::uint32_t representative(std::uint32_t set) const { return nodes_[set].member; }
  /// Appends the members in ascending order.
  void write(std::uint32_t set, std::vector<std::uint32_t>& out) {
    if (set == 0) return;
    const auto begin = static_cast<std::ptrdiff_t>(out.size());
    stack_.assign(1, set);
    while (!stack_.empty()) {
      const Node node = nodes_[stack_.back()];
      stack_.pop_back();
      if (node.first == 0) {
        out.push_back(node.member);
      } else {
        stack_.push_back(node.first);
        stack_.push_back(node.second);
      }
    }
    std::sort(out.begin() + begin, out.end());
  }

 private:
  struct Node {
    std::uint32_t member = 0;
    std::uint32_t first = 0;  // zero: the member alone
    std::uint32_t second = 0;
  };
  std::uint32_t push(const Node& node) {
    nodes_.push_back(node);
    return static_cast<std::uint32_t>(nodes_.size() - 1);
  }

  std::vector<Node> nodes_{Node{}};
  std::vector<std::uint32_t> stack_;
};

/// An envelope in the making: as Envelope, with sets for members.
template <class Point>
struct EnvelopeDraft {
  struct Breakpoint {
    Point point;
    std::uint32_t set = 0;
  };
  std::vector<Breakpoint> breakpoints;
  std::vector<std::uint32_t> intervals{0};  // one more than breakpoints
};

/// Appends breakpoints and intervals to a draft, in turn, each given by the sets of the two envelopes that are merged.
/// A breakpoint at which nothing changes is left out. Neighbours with the same members get the same set, so that sets
/// of neighbours differ if their members do.
template <class Point>
class EnvelopeWriter {
 public:
  using Sets = std::pair<std::uint32_t, std::uint32_t>;

  EnvelopeWriter(EnvelopeSets& sets, EnvelopeDraft<Point>& out) : sets_(sets), out_(out) { out_.intervals.clear(); }

  void add_interval(const Sets& pair) {
    if (!out_.intervals.empty() && pair == interval_pair_ && pair == point_pair_) {
      pending_ = false;
      return;
    }
    flush();
    const bool same = !out_.breakpoints.empty() && pair == point_pair_;
    out_.intervals.push_back(same ? out_.breakpoints.back().set : sets_.unite(pair.first, pair.second));
    interval_pair_ = pair;
  }
  void add_breakpoint(const Point& point, const Sets& pair) {
    point_ = point;
    point_pair_ = pair;
    pending_ = true;
  }

 private:
  void flush() {
    if (!pending_) return;
    pending_ = false;
    const bool same = point_pair_ == interval_pair_;
    out_.breakpoints.push_back(
        {point_, same ? out_.intervals.back() : sets_.unite(point_pair_.first, point_pair_.second)});
  }

  EnvelopeSets& sets_;
  EnvelopeDraft<Point>& out_;
  Point point_{};
  Sets interval_pair_{};
  Sets point_pair_{};
  bool pending_ = false;
};

/// Divides pieces and lone points and merges their envelopes. Words are those of lower envelopes.
template <class F>
class EnvelopeBuilder {
 public:
  using Point = typename F::Point;
  using Draft = EnvelopeDraft<Point>;

  EnvelopeBuilder(const F& family, const PieceList<F>& list, EnvelopeSide side, const Context& context)
      : family_(family), list_(list), is_upper_(side == EnvelopeSide::upper), context_(context) {}

  Envelope<F> run() {
    const std::size_t count = list_.pieces.size() + list_.lone_points.size();
    if (count == 0) return {};
    return written(of_range(0, static_cast<std::uint32_t>(count)));
  }

 private:
  /// How far the pass over x has come in one of two drafts.
  struct Cursor {
    const Draft& draft;
    std::size_t next = 0;  // breakpoint

    bool at_end() const { return next == draft.breakpoints.size(); }
    const Point& point() const { return draft.breakpoints[next].point; }
    std::uint32_t set() const { return draft.breakpoints[next].set; }
    std::uint32_t interval() const { return draft.intervals[next]; }
  };
  using Writer = EnvelopeWriter<Point>;

  /// Recursion as deep as the logarithm of the number.
  Draft of_range(std::uint32_t begin, std::uint32_t end) {
    if (end - begin == 1) return of_member(begin);
    const std::uint32_t middle = begin + (end - begin) / 2;
    const Draft first = of_range(begin, middle);
    const Draft second = of_range(middle, end);
    return merged(first, second);
  }

  Draft of_member(std::uint32_t member) {
    Draft draft;
    const std::uint32_t set = sets_.single(member);
    if (member >= list_.pieces.size()) {
      const LonePoint& lone = list_.lone_points[member - list_.pieces.size()];
      draft.breakpoints.push_back({list_.points[lone.point], set});
      draft.intervals.push_back(0);
      return draft;
    }
    const Piece& piece = list_.pieces[member];
    const Point& left = list_.points[piece.left];
    const Point& right = list_.points[piece.right];
    if (family_.is_vertical(piece.branch)) {
      draft.breakpoints.push_back({is_upper_ ? right : left, set});
      draft.intervals.push_back(0);
      return draft;
    }
    if (family_.side(left) == Side::left) {
      draft.intervals.back() = set;
    } else {
      draft.breakpoints.push_back({left, set});
      draft.intervals.push_back(set);
    }
    if (family_.side(right) != Side::right) {
      draft.breakpoints.push_back({right, set});
      draft.intervals.push_back(0);
    }
    return draft;
  }

  Draft merged(const Draft& first, const Draft& second) {
    Draft result;
    result.breakpoints.reserve(first.breakpoints.size() + second.breakpoints.size());
    result.intervals.reserve(first.intervals.size() + second.intervals.size());
    Writer writer(sets_, result);
    Cursor a{first};
    Cursor b{second};
    const Point* left = nullptr;
    for (;;) {
      if ((++steps_ & 255U) == 0) context_.poll();
      const Sign order = order_of_next(a, b);
      const bool is_last = a.at_end() && b.at_end();
      const Point* right = is_last ? nullptr : order == Sign::positive ? &b.point() : &a.point();
      add_between(a.interval(), b.interval(), left, right, writer);
      if (is_last) return result;
      add_at(a, b, order, writer);
      if (order != Sign::positive) ++a.next;
      if (order != Sign::negative) ++b.next;
      left = right;
    }
  }

  /// Which of the next breakpoints comes first.
  Sign order_of_next(const Cursor& a, const Cursor& b) const {
    if (a.at_end()) return Sign::positive;
    if (b.at_end()) return Sign::negative;
    return family_.compare_x(a.point(), b.point());
  }

  /// Negative: the envelope shows the first of two.
  Sign shown(Sign height) const { return is_upper_ ? -height : height; }

  static typename Writer::Sets chosen(Sign order, std::uint32_t a, std::uint32_t b) {
    return {order == Sign::positive ? 0 : a, order == Sign::negative ? 0 : b};
  }

  /// The breakpoint of `a`, or of `b`, or of both, which comes next.
  void add_at(const Cursor& a, const Cursor& b, Sign order, Writer& writer) const {
    if (order == Sign::zero) {
      const Sign height = shown(family_.compare_xy(a.point(), b.point()));
      writer.add_breakpoint(height == Sign::positive ? b.point() : a.point(), chosen(height, a.set(), b.set()));
      return;
    }
    const bool is_first = order == Sign::negative;
    const Cursor& one = is_first ? a : b;
    const std::uint32_t other = is_first ? b.interval() : a.interval();
    if (other == 0) {
      writer.add_breakpoint(one.point(), {is_first ? one.set() : 0, is_first ? 0 : one.set()});
      return;
    }
    const Sign height = shown(family_.compare_y_at_x(one.point(), branch_of(other)));
    const Sign from_a = is_first ? height : -height;
    // Where the other one is lower, its point has no name; but nothing changes there then.
    writer.add_breakpoint(one.point(), is_first ? chosen(from_a, one.set(), other) : chosen(from_a, other, one.set()));
  }

  const Piece& piece_of(std::uint32_t set) const { return list_.pieces[sets_.representative(set)]; }
  BranchId branch_of(std::uint32_t set) const { return piece_of(set).branch; }

  /// What is lowest between two x where neither envelope changes; null is infinity.
  void add_between(std::uint32_t a, std::uint32_t b, const Point* left, const Point* right, Writer& writer) {
    if (a == 0 || b == 0 || family_.same_branch(branch_of(a), branch_of(b))) {
      writer.add_interval({a, b});
      return;
    }
    meetings_.clear();
    family_.meetings(branch_of(a), branch_of(b), meetings_);
    std::size_t next = 0;
    while (left != nullptr && next < meetings_.size() &&
           family_.compare_x(meetings_[next].point, *left) != Sign::positive) {
      ++next;
    }
    for (;; ++next) {
      writer.add_interval(chosen(shown(order_between(a, b, next)), a, b));
      if (next == meetings_.size()) return;
      const Point& point = meetings_[next].point;
      if (right != nullptr && family_.compare_x(point, *right) != Sign::negative) return;
      writer.add_breakpoint(point, {a, b});
    }
  }

  /// Order of two branches between their meetings `next` - 1 and `next`: it is the same on all of the way. Where they
  /// do not meet, the end of one that the other passes tells it.
  Sign order_between(std::uint32_t a, std::uint32_t b, std::size_t next) const {
    const Piece& first = piece_of(a);
    const Piece& second = piece_of(b);
    if (next > 0) return family_.compare_right(first.branch, second.branch, meetings_[next - 1].point);
    if (next < meetings_.size()) return family_.compare_left(first.branch, second.branch, meetings_[next].point);
    const Point& p = list_.points[first.left];
    const Point& q = list_.points[second.left];
    const bool takes_first =
        family_.side(q) == Side::left || (family_.side(p) != Side::left && family_.compare_x(p, q) != Sign::negative);
    return takes_first ? family_.compare_y_at_x(p, second.branch) : -family_.compare_y_at_x(q, first.branch);
  }

  Envelope<F> written(const Draft& draft) {
    Envelope<F> result;
    result.intervals_.clear();
    std::uint32_t last = 0;
    typename Envelope<F>::Range range;
    const auto members = [&](std::uint32_t set) {
      if (set == last) return range;
      last = set;
      range.first = result.members_.size();
      sets_.write(set, result.members_);
      range.count = static_cast<std::uint32_t>(result.members_.size() - range.first);
      return range;
    };
    for (std::size_t i = 0; i < draft.intervals.size(); ++i) {
      if (i % 256 == 0) context_.poll();
      if (i > 0) result.breakpoints_.push_back({draft.breakpoints[i - 1].point, members(draft.breakpoints[i - 1].set)});
      const auto over = members(draft.intervals[i]);
      const bool is_gap = over.count == 0;
      result.intervals_.push_back({is_gap ? BranchId() : list_.pieces[result.members_[over.first]].branch, over});
      if (!is_gap) ++result.arc_count_;
    }
    return result;
  }

  const F& family_;
  const PieceList<F>& list_;
  const bool is_upper_;
  const Context& context_;
  EnvelopeSets sets_;
  std::vector<Meeting<Point>> meetings_;
  std::uint32_t steps_ = 0;
};

template <VerticalFamily F>
Envelope<F> lower_envelope(const F& family, const PieceList<F>& list, const Context& context) {
  return EnvelopeBuilder<F>(family, list, EnvelopeSide::lower, context).run();
}

template <VerticalFamily F>
Envelope<F> upper_envelope(const F& family, const PieceList<F>& list, const Context& context) {
  return EnvelopeBuilder<F>(family, list, EnvelopeSide::upper, context).run();
}

}  // namespace quoin
