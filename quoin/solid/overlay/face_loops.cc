// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/overlay/face_loops.h"

#include <algorithm>
#include <cmath>

#include "quoin/base/error.h"

namespace quoin::overlay {

namespace {

const Rational& coordinate(const RationalPoint3& p, unsigned axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

class LoopChainer {
 public:
  LoopChainer(const Constructions& table, std::span<const DirectedEdge> edges, unsigned axis, bool positive)
      : table_(table),
        edges_(edges),
        u_((axis + 1) % 3),
        v_((axis + 2) % 3),
        positive_(positive),
        used_(edges.size(), false) {}

  void run(std::vector<PointId>& vertices, std::vector<std::uint32_t>& loop_ends) {
    for (std::size_t first = 0; first < edges_.size(); ++first) {
      if (used_[first]) continue;
      std::size_t e = first;
      do {
        used_[e] = true;
        vertices.push_back(edges_[e].from);
        e = next(e);
        if (used_[e] && e != first) throw InternalError("the boundary of a face is not a set of loops");
      } while (e != first);
      loop_ends.push_back(static_cast<std::uint32_t>(vertices.size()));
    }
  }

 private:
  // At a vertex that loops touch, the edge taken by one arrival is taken by no other, so every chain closes.
  std::size_t next(std::size_t e) const {
    const PointId at = edges_[e].to;
    const auto less = [](const DirectedEdge& d, PointId p) { return d.from < p; };
    const auto first =
        static_cast<std::size_t>(std::lower_bound(edges_.begin(), edges_.end(), at, less) - edges_.begin());
    if (first == edges_.size() || edges_[first].from != at) throw InternalError("the boundary of a face is open");
    std::size_t best = first;
    for (std::size_t i = first + 1; i < edges_.size() && edges_[i].from == at; ++i) {
      if (is_clockwise_before(at, edges_[e].from, edges_[i].to, edges_[best].to)) best = i;
    }
    return best;
  }

  // Turning clockwise about `at` from `start`, whether p comes before q. A way back along the start comes last.
  bool is_clockwise_before(PointId at, PointId start, PointId p, PointId q) const {
    const int half_p = clockwise_half(at, start, p);
    const int half_q = clockwise_half(at, start, q);
    if (half_p != half_q) return half_p < half_q;
    return turn(at, p, q) == Sign::negative;
  }

  // 0: less than half a turn clockwise, 1: opposite, 2: more, 3: a full turn.
  int clockwise_half(PointId at, PointId start, PointId p) const {
    if (p == start) return 3;
    const Sign sign = turn(at, start, p);
    if (sign == Sign::negative) return 0;
    return sign == Sign::zero ? 1 : 2;
  }

  // Turn from direction a -> b to direction a -> c, seen against the outward normal.
  Sign turn(PointId a, PointId b, PointId c) const {
    const Point3& p = table_.rounded(a);
    const Point3& q = table_.rounded(b);
    const Point3& r = table_.rounded(c);
    const double bu = q[u_] - p[u_];
    const double bv = q[v_] - p[v_];
    const double cu = r[u_] - p[u_];
    const double cv = r[v_] - p[v_];
    const double area = bu * cv - bv * cu;
    // Rounded coordinates are off by 2^-53 * size, differences by 4 times that; see left_of in winding.cc.
    const double size = std::max(
        {std::fabs(p[u_]), std::fabs(p[v_]), std::fabs(q[u_]), std::fabs(q[v_]), std::fabs(r[u_]), std::fabs(r[v_])});
    const double reach = std::max({std::fabs(bu), std::fabs(bv), std::fabs(cu), std::fabs(cv)}) + 0x1p-51 * size;
    Sign sign = Sign::zero;
    if (size > 1e-60 && size < 1e90 && std::fabs(area) > 0x1p-48 * size * reach) {
      sign = sign_of(area);
    } else {
      sign = exact_turn(a, b, c);
    }
    return positive_ ? sign : -sign;
  }

  Sign exact_turn(PointId a, PointId b, PointId c) const {
    const RationalPoint3 p = table_.exact(a);
    const RationalPoint3 q = table_.exact(b);
    const RationalPoint3 r = table_.exact(c);
    const Rational area = (coordinate(q, u_) - coordinate(p, u_)) * (coordinate(r, v_) - coordinate(p, v_)) -
                          (coordinate(q, v_) - coordinate(p, v_)) * (coordinate(r, u_) - coordinate(p, u_));
    return area.sign();
  }

  const Constructions& table_;
  std::span<const DirectedEdge> edges_;
  unsigned u_;
  unsigned v_;
  bool positive_;
  std::vector<bool> used_;
};

}  // namespace

void chain_loops(const Constructions& table, std::span<const DirectedEdge> edges, unsigned axis, bool positive,
                 std::vector<PointId>& vertices, std::vector<std::uint32_t>& loop_ends) {
  LoopChainer(table, edges, axis, positive).run(vertices, loop_ends);
}

}  // namespace quoin::overlay
