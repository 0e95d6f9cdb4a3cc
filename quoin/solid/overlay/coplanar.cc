// SPDX-License-Identifier: Apache-2.0
//
// Two facets in one plane, projected along an axis that the plane is not parallel to. Signs are taken as if both
// facets turned counterclockwise, so that positive always means inside.
#include <utility>

#include "quoin/base/error.h"
#include "quoin/kernel/projection.h"
#include "quoin/solid/overlay/contacts.h"

namespace quoin::overlay {

namespace {

constexpr std::size_t next(std::size_t k) {
  return k == 2 ? 0 : k + 1;
}

// inside[j][i]: side of corner i of one facet with respect to edge j of the other.
using Sides = std::array<std::array<Sign, 3>, 3>;

class CoplanarPair {
 public:
  CoplanarPair(const Constructions& table, const Corners& s, const Corners& t, FacetPair pair, Contacts& out)
      : table_(table), pair_(pair), s_(s), t_(t), out_(out) {
    axis_ = projection_axis(table_, s_[0], s_[1], s_[2]);
  }

  void run() {
    t_in_s_ = sides(s_, t_);
    if (apart(t_in_s_)) return;
    s_in_t_ = sides(t_, s_);
    if (apart(s_in_t_)) return;
    out_.adjoining.push_back(pair_);
    if (!touching(t_in_s_) && !touching(s_in_t_)) out_.overlapping.push_back(pair_);
    post_vertices(t_, t_in_s_, s_);
    post_vertices(s_, s_in_t_, t_);
    post_crossings();
  }

 private:
  Sides sides(const Corners& facet, const Corners& corners) const {
    const Sign orientation = table_.turn(facet[0], facet[1], facet[2], axis_);
    Sides result;
    for (std::size_t j = 0; j < 3; ++j) {
      const PointId a = facet[j];
      const PointId b = facet[next(j)];
      for (std::size_t i = 0; i < 3; ++i) {
        const PointId p = corners[i];
        result[j][i] = p == a || p == b ? Sign::zero : table_.turn(a, b, p, axis_) * orientation;
      }
    }
    return result;
  }

  static bool apart(const Sides& sides) {
    for (const auto& edge : sides) {
      if (edge[0] == Sign::negative && edge[1] == Sign::negative && edge[2] == Sign::negative) return true;
    }
    return false;
  }

  // Triangles share no area exactly if the line through an edge of one has the other on its outer side.
  static bool touching(const Sides& sides) {
    for (const auto& edge : sides) {
      if (edge[0] != Sign::positive && edge[1] != Sign::positive && edge[2] != Sign::positive) return true;
    }
    return false;
  }

  static bool outside(const Sides& sides, std::size_t i) {
    return sides[0][i] == Sign::negative || sides[1][i] == Sign::negative || sides[2][i] == Sign::negative;
  }

  // The edge of the facet in whose interior corner i lies, 3 for the facet's interior, 4 for a corner or outside.
  static std::size_t place(const Sides& sides, std::size_t i) {
    if (outside(sides, i)) return 4;
    std::size_t zeros = 0;
    std::size_t edge = 3;
    for (std::size_t j = 0; j < 3; ++j) {
      if (sides[j][i] != Sign::zero) continue;
      ++zeros;
      edge = j;
    }
    return zeros == 2 ? 4 : edge;
  }

  // Corners in the interior of a facet need no mention: the facets share area and are subdivided together.
  void post_vertices(const Corners& corners, const Sides& sides, const Corners& facet) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t where = place(sides, i);
      if (where < 3) out_.edge_points.push_back({edge_between(facet[where], facet[next(where)]), corners[i]});
    }
  }

  void post_crossings() {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t i = 0; i < 3; ++i) {
        const Sign across_s = t_in_s_[j][i] * t_in_s_[j][next(i)];
        const Sign across_t = s_in_t_[i][j] * s_in_t_[i][next(j)];
        if (across_s != Sign::negative || across_t != Sign::negative) continue;
        Edge e = edge_between(s_[j], s_[next(j)]);
        Edge f = edge_between(t_[i], t_[next(i)]);
        if (f < e) std::swap(e, f);
        out_.keys.push_back({e.a, e.b, f.a, f.b});
      }
    }
  }

  const Constructions& table_;
  FacetPair pair_;
  const Corners& s_;
  const Corners& t_;
  Contacts& out_;
  unsigned axis_ = 0;
  Sides t_in_s_{};
  Sides s_in_t_{};
};

}  // namespace

void find_coplanar_contacts(const Constructions& table, const Corners& a, const Corners& b, FacetPair pair,
                            Contacts& out) {
  CoplanarPair(table, a, b, pair, out).run();
}

}  // namespace quoin::overlay
