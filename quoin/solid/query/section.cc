// SPDX-License-Identifier: Apache-2.0
//
// The plane is moved down by an infinitesimal e, so that it meets no vertex: those on it count as above. Each face then
// gives segments between edges with one end above and one below, which alternate along the line in which the face meets
// the moved plane; as e vanishes, each point goes to where the edge meets the plane itself. Slivers that vanish with e
// leave segments that run back on others: a face's segments are cut at all its vertices on the plane, and opposite
// segments cancel.
#include "quoin/solid/query/section.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "quoin/base/error.h"

namespace quoin {

namespace {

// An edge that crosses the plane, by its ends in ascending order, or a vertex on the plane, twice.
using NodeKey = std::pair<std::uint32_t, std::uint32_t>;

struct Segment {
  std::uint32_t from;
  std::uint32_t to;
  friend auto operator<=>(const Segment&, const Segment&) = default;
};

class Cutter {
 public:
  Cutter(const Brep& boundary, const SectionPlane& plane, const Context& context)
      : b_(boundary), plane_(plane), context_(context), heights_(boundary.points.point_count(), unknown) {}

  Section run() {
    for (std::uint32_t f = 0; f < b_.face_count(); ++f) {
      if (f % 1024 == 0) context_.poll();
      cut_face(f);
    }
    cancel_opposite();
    link();
    return std::move(result_);
  }

 private:
  static constexpr signed char unknown = 2;

  // Sign of the height above the plane that is not moved.
  Sign height(PointId p) {
    signed char& sign = heights_[p.index()];
    if (sign == unknown)
      sign = static_cast<signed char>(to_int((dot(plane_.normal, b_.points.exact(p)) - plane_.offset).sign()));
    return static_cast<Sign>(sign);
  }
  bool is_below(PointId p) { return height(p) == Sign::negative; }

  // A place along a face's line with the number of edges that pass through the moved plane next to it.
  struct Stop {
    Rational parameter;
    std::uint32_t node;
    unsigned crossings;
  };

  void cut_face(std::uint32_t face) {
    stops_.clear();
    for (std::uint32_t l = b_.face_first_loop[face]; l < b_.face_first_loop[face + 1]; ++l) {
      const std::span<const PointId> loop = b_.loop(l);
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const PointId p = loop[i];
        const PointId q = loop[i + 1 == loop.size() ? 0 : i + 1];
        if (height(p) == Sign::zero) stops_.push_back({{}, vertex_node(p), 0});
        if (is_below(p) != is_below(q)) stops_.push_back({{}, crossing_node(p, q), 1});
      }
    }
    if (stops_.size() < 2) return;
    const bool is_cut = std::any_of(stops_.begin(), stops_.end(), [](const Stop& s) { return s.crossings != 0; });
    if (is_cut) emit_segments(face);
  }

  // The face's outward normal m and the plane's n: material lies to the left of n x m seen from the tip of n.
  void emit_segments(std::uint32_t face) {
    const auto& plane = b_.face_planes[face];
    const RationalPoint3 a = b_.points.exact(plane[0]);
    const RationalPoint3 m = cross(b_.points.exact(plane[1]) - a, b_.points.exact(plane[2]) - a);
    const RationalPoint3 along = cross(plane_.normal, m);
    for (Stop& s : stops_) s.parameter = dot(along, result_.points[s.node]);
    std::sort(stops_.begin(), stops_.end(), [](const Stop& s, const Stop& t) { return s.parameter < t.parameter; });
    bool inside = false;
    for (std::size_t i = 0; i + 1 < stops_.size(); ++i) {
      if (stops_[i].crossings % 2 != 0) inside = !inside;
      if (inside && stops_[i].node != stops_[i + 1].node) segments_.push_back({stops_[i].node, stops_[i + 1].node});
    }
  }

  std::uint32_t vertex_node(PointId p) {
    const auto [place, is_new] = nodes_.try_emplace(NodeKey{p.value, p.value}, result_.points.size());
    if (is_new) result_.points.push_back(b_.points.exact(p));
    return place->second;
  }

  std::uint32_t crossing_node(PointId p, PointId q) {
    if (height(p) == Sign::zero) return vertex_node(p);
    if (height(q) == Sign::zero) return vertex_node(q);
    if (q < p) std::swap(p, q);
    const auto [place, is_new] = nodes_.try_emplace(NodeKey{p.value, q.value}, result_.points.size());
    if (is_new) {
      const RationalPoint3 from = b_.points.exact(p);
      const RationalPoint3 to = b_.points.exact(q);
      const Rational h = dot(plane_.normal, from) - plane_.offset;
      result_.points.push_back(from + (to - from) * (h / (h - (dot(plane_.normal, to) - plane_.offset))));
    }
    return place->second;
  }

  void cancel_opposite() {
    std::sort(segments_.begin(), segments_.end());
    std::vector<Segment> kept;
    for (std::size_t i = 0; i < segments_.size();) {
      std::size_t j = i;
      while (j < segments_.size() && segments_[j] == segments_[i]) ++j;
      const auto back =
          std::equal_range(segments_.begin(), segments_.end(), Segment{segments_[i].to, segments_[i].from});
      if (static_cast<std::ptrdiff_t>(j - i) > back.second - back.first) kept.push_back(segments_[i]);
      i = j;
    }
    segments_ = std::move(kept);
  }

  // Loops that turn as far right as possible at points with several ways on, so that each bounds one region.
  void link() {
    std::vector<bool> used(segments_.size(), false);
    for (std::size_t first = 0; first < segments_.size(); ++first) {
      if (used[first]) continue;
      std::vector<std::uint32_t> loop;
      for (std::size_t s = first; !used[s]; s = next(s)) {
        used[s] = true;
        loop.push_back(segments_[s].from);
      }
      drop_straight(loop);
      result_.loops.push_back(std::move(loop));
    }
    drop_unused_points();
  }

  std::size_t next(std::size_t s) const {
    const auto begin = std::lower_bound(segments_.begin(), segments_.end(), Segment{segments_[s].to, 0});
    auto best = begin;
    for (auto it = begin; it != segments_.end() && it->from == segments_[s].to; ++it) {
      if (it != best && is_before(*it, *best, segments_[s])) best = it;
    }
    if (best == segments_.end() || best->from != segments_[s].to) throw InternalError("a section is not closed");
    return static_cast<std::size_t>(best - segments_.begin());
  }

  // Going clockwise from the way back along `in`, whether x comes before y.
  bool is_before(const Segment& x, const Segment& y, const Segment& in) const {
    const RationalPoint3& at = result_.points[in.to];
    const RationalPoint3 back = result_.points[in.from] - at;
    const RationalPoint3 dx = result_.points[x.to] - at;
    const RationalPoint3 dy = result_.points[y.to] - at;
    const auto left = [&](const RationalPoint3& d, const RationalPoint3& e) {
      return dot(plane_.normal, cross(d, e)).sign();
    };
    const auto half = [&](const RationalPoint3& d) {  // 0: less than half a turn clockwise, 1: half a turn, 2: more
      const Sign sign = left(back, d);
      return sign == Sign::negative ? 0 : sign == Sign::positive ? 2 : 1;
    };
    if (half(dx) != half(dy)) return half(dx) < half(dy);
    return left(dx, dy) == Sign::negative;
  }

  void drop_straight(std::vector<std::uint32_t>& loop) const {
    std::vector<std::uint32_t> kept;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const RationalPoint3& p = result_.points[loop[i == 0 ? loop.size() - 1 : i - 1]];
      const RationalPoint3& q = result_.points[loop[i]];
      const RationalPoint3& r = result_.points[loop[i + 1 == loop.size() ? 0 : i + 1]];
      if (dot(plane_.normal, cross(q - p, r - q)).sign() != Sign::zero) kept.push_back(loop[i]);
    }
    loop = std::move(kept);
  }

  void drop_unused_points() {
    std::vector<std::uint32_t> number(result_.points.size(), 0xFFFFFFFFU);
    std::vector<RationalPoint3> points;
    for (auto& loop : result_.loops) {
      for (std::uint32_t& p : loop) {
        if (number[p] == 0xFFFFFFFFU) {
          number[p] = static_cast<std::uint32_t>(points.size());
          points.push_back(result_.points[p]);
        }
        p = number[p];
      }
    }
    result_.points = std::move(points);
  }

  const Brep& b_;
  const SectionPlane& plane_;
  const Context& context_;
  std::vector<signed char> heights_;  // per point
  std::map<NodeKey, std::uint32_t> nodes_;
  std::vector<Stop> stops_;
  std::vector<Segment> segments_;
  Section result_;
};

}  // namespace

Section section(const Brep& boundary, const SectionPlane& plane, const Context& context) {
  if (plane.normal == RationalPoint3{0, 0, 0}) throw InputError("the normal of a section plane is zero");
  context.progress("section", 0);
  Section result = Cutter(boundary, plane, context).run();
  result.is_unbounded = boundary.is_unbounded;
  return result;
}

RationalPoint3 area_vector(const Section& section) {
  RationalPoint3 twice{0, 0, 0};
  for (const auto& loop : section.loops) {
    const RationalPoint3& apex = section.points[loop[0]];
    for (std::size_t i = 2; i < loop.size(); ++i) {
      twice = twice + cross(section.points[loop[i - 1]] - apex, section.points[loop[i]] - apex);
    }
  }
  return twice * Rational(0.5);
}

}  // namespace quoin
