// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <numeric>
#include <vector>

#include "quoin/arrangement/geodesic/geodesic_family.h"
#include "quoin/arrangement/sweep/crossing_list.h"

namespace quoin {

static_assert(PairwiseFamily<GeodesicFamily>);

/// Finds crossings by pairs of pieces whose ranges of longitudes overlap, which come from a sweep over these.
class GeodesicPairs {
 public:
  using Point = GeodesicFamily::Point;

  GeodesicPairs(const GeodesicFamily& family, const PieceList<GeodesicFamily>& list, const Context& context,
                CrossingList<Point>& out)
      : family_(family), list_(list), context_(context), out_(out) {}

  bool find() {
    std::vector<std::uint32_t> order(list_.pieces.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      const double x = left(a).longitude_key;
      const double y = left(b).longitude_key;
      return x != y ? x < y : a < b;
    });
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (i % 64 == 0) context_.poll();
      if (!meet_active(order[i])) return false;
    }
    return true;
  }

 private:
  /// Pairs may be tried in vain this many times for each piece and crossing: that costs a fraction of what the
  /// sweep would spend on it.
  static constexpr std::size_t most_trials = 2;

  const Point& left(std::uint32_t piece) const { return list_.points[list_.pieces[piece].left]; }
  const Point& right(std::uint32_t piece) const { return list_.points[list_.pieces[piece].right]; }
  BranchId branch(std::uint32_t piece) const { return list_.pieces[piece].branch; }
  bool is_before(const Point& p, const Point& q) const { return family_.compare_xy(p, q) == Sign::negative; }

  bool meet_active(std::uint32_t added) {
    const double start = left(added).longitude_key - 2 * family_.key_error();
    std::size_t kept = 0;
    for (const std::uint32_t other : active_) {
      if (right(other).longitude_key < start) continue;
      active_[kept++] = other;
      if (!meet(other, added)) return false;
    }
    trials_ += active_.size();
    active_.resize(kept);
    active_.push_back(added);
    return trials_ <= most_trials * (list_.pieces.size() + out_.points.size()) + 512;
  }

  bool meet(std::uint32_t a, std::uint32_t b) {
    const Point& start = is_before(left(a), left(b)) ? left(b) : left(a);
    const Point& end = is_before(right(a), right(b)) ? right(a) : right(b);
    if (!is_before(start, end)) return true;
    if (branch(a) == branch(b)) return false;
    if (family_.same_plane(branch(a), branch(b))) return true;
    if (family_.is_vertical(branch(a)) || family_.is_vertical(branch(b))) {
      meetings_.clear();
      family_.meetings(branch(a), branch(b), meetings_);
      for (const Meeting<Point>& meeting : meetings_) add_between(start, meeting.point, end, {a, b, true});
      return true;
    }
    // Less than half a turn holds one crossing at most, and the order at both ends tells.
    if (end.longitude_key - start.longitude_key < 2 - 4 * family_.key_error()) {
      const Sign before = order_at(start, &start == &left(a), a, b);
      const Sign after = order_at(end, &end == &right(a), a, b);
      if (before == Sign::zero || after == Sign::zero || before == after) return true;
      // What is above before the crossing comes first.
      out_.add(before == Sign::positive ? family_.crossing(support(a), support(b))
                                        : family_.crossing(support(b), support(a)),
               {a, b, true});
      return true;
    }
    const Point p = family_.crossing(support(a), support(b));
    add_between(start, p, end, {a, b, true});
    add_between(start, GeodesicFamily::antipode(p), end, {a, b, true});
    return true;
  }
  std::uint32_t support(std::uint32_t piece) const { return GeodesicFamily::support(branch(piece)); }

  /// Positive: a is above b. p is an end of a, or of b.
  Sign order_at(const Point& p, bool is_of_a, std::uint32_t a, std::uint32_t b) const {
    return is_of_a ? family_.compare_y_at_x(p, branch(b)) : -family_.compare_y_at_x(p, branch(a));
  }

  void add_between(const Point& start, const Point& p, const Point& end, const PiecePair& pair) {
    if (is_before(start, p) && is_before(p, end)) out_.add(p, pair);
  }

  const GeodesicFamily& family_;
  const PieceList<GeodesicFamily>& list_;
  const Context& context_;
  CrossingList<Point>& out_;
  std::vector<std::uint32_t> active_;
  std::vector<Meeting<Point>> meetings_;
  std::size_t trials_ = 0;
};

bool GeodesicFamily::find_crossings(const PieceList<GeodesicFamily>& list, const Context& context,
                                    CrossingList<Point>& out) const {
  return GeodesicPairs(*this, list, context, out).find();
}

}  // namespace quoin
