// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "quoin/arrangement/circular/circular_family.h"
#include "quoin/arrangement/sweep/crossing_list.h"

namespace quoin {

static_assert(PairwiseFamily<CircularFamily>);

/// Finds crossings by pairs of supports, whose numbers serve all halves and arcs. Supports whose boxes overlap in x
/// come from a sweep over these.
class CircularPairs {
 public:
  using Point = CircularFamily::Point;
  using Pieces = CircularFamily::Pieces;

  CircularPairs(const CircularFamily& family, const Pieces& list, const Context& context, CrossingList<Point>& out)
      : family_(family), list_(list), context_(context), out_(out), slack_(4 * family.error()) {}

  bool find() {
    group_pieces();
    for (const Group& group : groups_) {
      if (group.end - group.begin > most_pieces || overlaps_itself(group)) return false;
    }
    std::sort(groups_.begin(), groups_.end(), [](const Group& a, const Group& b) { return a.box.min_x < b.box.min_x; });
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      context_.poll();
      if (!meet_active(i)) return false;
    }
    return true;
  }

 private:
  struct Box {
    double min_x = std::numeric_limits<double>::infinity();
    double max_x = -std::numeric_limits<double>::infinity();
    double min_y = std::numeric_limits<double>::infinity();
    double max_y = -std::numeric_limits<double>::infinity();
    void add_y(double y) {
      min_y = std::fmin(min_y, y);
      max_y = std::fmax(max_y, y);
    }
  };
  /// The pieces of one support.
  struct Group {
    std::uint32_t support;
    std::uint32_t begin;
    std::uint32_t end;
    Box box;
  };

  static constexpr std::uint32_t most_pieces = 8;
  /// Pairs may be tried in vain this many times for each piece and crossing: that costs a fraction of what the
  /// sweep would spend on it.
  static constexpr std::size_t most_trials = 2;

  static std::uint32_t support_of(const Piece& piece) {
    return static_cast<std::uint32_t>(CircularFamily::support(piece.branch).index());
  }

  void group_pieces() {
    std::vector<std::uint32_t> begin(family_.support_count() + 1, 0);
    for (const Piece& piece : list_.pieces) ++begin[support_of(piece) + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    for (std::uint32_t s = 0; s + 1 < begin.size(); ++s) {
      if (begin[s] < begin[s + 1]) groups_.push_back({s, begin[s], begin[s + 1], {}});
    }
    pieces_.resize(list_.pieces.size());
    for (std::uint32_t i = 0; i < list_.pieces.size(); ++i) pieces_[begin[support_of(list_.pieces[i])]++] = i;
    for (Group& group : groups_) {
      for (std::uint32_t k = group.begin; k < group.end; ++k) extend(group.box, list_.pieces[pieces_[k]]);
    }
  }

  /// By the piece. Ends without doubles make it unbounded.
  void extend(Box& box, const Piece& piece) const {
    for (const std::uint32_t end : {piece.left, piece.right}) {
      const Point& p = list_.points[end];
      if (std::isnan(p.x) || std::isnan(p.y)) {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        box = {-infinity, infinity, -infinity, infinity};
        return;
      }
      box.min_x = std::fmin(box.min_x, p.x - slack_);
      box.max_x = std::fmax(box.max_x, p.x + slack_);
      box.add_y(p.y - slack_);
      box.add_y(p.y + slack_);
    }
    if (family_.is_line(piece.branch)) return;
    const CircularSupport& circle = family_.rounded(CircularFamily::support(piece.branch));
    box.add_y(CircularFamily::is_upper(piece.branch) ? circle.y + circle.radius + slack_
                                                     : circle.y - circle.radius - slack_);
  }

  /// Two pieces of one branch have more than an end in common.
  bool overlaps_itself(const Group& group) const {
    for (std::uint32_t i = group.begin; i < group.end; ++i) {
      for (std::uint32_t k = group.begin; k < i; ++k) {
        const Piece& one = list_.pieces[pieces_[i]];
        const Piece& two = list_.pieces[pieces_[k]];
        if (one.branch == two.branch && is_before(one.left, two.right) && is_before(two.left, one.right)) return true;
      }
    }
    return false;
  }
  bool is_before(std::uint32_t p, std::uint32_t q) const {
    return family_.compare_xy(list_.points[p], list_.points[q]) == Sign::negative;
  }

  bool meet_active(std::size_t added) {
    const Group& group = groups_[added];
    std::size_t kept = 0;
    for (const std::uint32_t index : active_) {
      const Group& other = groups_[index];
      if (other.box.max_x < group.box.min_x) continue;
      active_[kept++] = index;
      if (other.box.max_y < group.box.min_y || group.box.max_y < other.box.min_y) continue;
      if (!meet(other, group)) return false;
    }
    trials_ += active_.size();
    active_.resize(kept);
    active_.push_back(static_cast<std::uint32_t>(added));
    return trials_ <= most_trials * (list_.pieces.size() + out_.points.size()) + 512;
  }

  bool meet(const Group& one, const Group& two) {
    const Group& a = one.support < two.support ? one : two;
    const Group& b = one.support < two.support ? two : one;
    const bool are_lines = is_line(a) && is_line(b);
    CircularFamily::RoundedCrossing numbers;
    const auto certainty = family_.cross(a.support, b.support, numbers);
    if (certainty == CircularFamily::Certainty::none) return true;
    if (certainty == CircularFamily::Certainty::certified) {
      const int last = are_lines ? 0 : 1;
      for (int root = -last; root <= last; root += 2) {
        const double x = numbers.middle_x + root * numbers.half_x;
        if (x < std::fmax(a.box.min_x, b.box.min_x) || x > std::fmin(a.box.max_x, b.box.max_x)) continue;
        add(family_.crossing_point(a.support, b.support, root, numbers), a, b, true);
        if (are_lines) break;
      }
      return true;
    }
    if (family_.same_support(a.support, b.support)) return false;
    std::array<Point, 2> common;
    const int count = family_.crossings(CircularSupportId(a.support), CircularSupportId(b.support), common.data());
    for (int i = 0; i < count; ++i) add(common[static_cast<std::size_t>(i)], a, b, are_lines || count == 2);
    return true;
  }
  bool is_line(const Group& group) const { return family_.is_line(CircularSupportId(group.support)); }

  void add(const Point& p, const Group& a, const Group& b, bool crosses) {
    const std::uint32_t one = piece_around(p, a, p.half_first);
    if (one == Point::none) return;
    const std::uint32_t two = piece_around(p, b, p.half_second);
    if (two != Point::none) out_.add(p, {one, two, crosses});
  }

  /// The piece of the support that p lies inside. The extremes of a circle are inside none.
  std::uint32_t piece_around(const Point& p, const Group& group, int half) const {
    const bool on_line = is_line(group);
    if (!on_line && half == 0) return Point::none;
    for (std::uint32_t k = group.begin; k < group.end; ++k) {
      const Piece& piece = list_.pieces[pieces_[k]];
      if (!on_line && CircularFamily::is_upper(piece.branch) != (half > 0)) continue;
      if (family_.compare_xy(list_.points[piece.left], p) == Sign::negative &&
          family_.compare_xy(p, list_.points[piece.right]) == Sign::negative) {
        return pieces_[k];
      }
    }
    return Point::none;
  }

  const CircularFamily& family_;
  const Pieces& list_;
  const Context& context_;
  CrossingList<Point>& out_;
  double slack_;
  std::vector<std::uint32_t> pieces_;  // by support
  std::vector<Group> groups_;
  std::vector<std::uint32_t> active_;
  std::size_t trials_ = 0;
};

bool CircularFamily::find_crossings(const Pieces& list, const Context& context, CrossingList<Point>& out) const {
  return CircularPairs(*this, list, context, out).find();
}

}  // namespace quoin
