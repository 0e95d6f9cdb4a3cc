// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/convex_joining.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <queue>
#include <string>
#include <utility>

#include "quoin/solid/measure.h"
#include "quoin/solid/query/section.h"

namespace quoin {

namespace {

/// Equal planes of one side have equal numbers; the opposite side has the number with the lowest bit turned.
class PlaneNumbers {
 public:
  std::uint32_t number(const SectionPlane& plane) {
    const Rational& x = plane.normal.x;
    const Rational& y = plane.normal.y;
    const Rational& lead = x.sign() != Sign::zero ? x : y.sign() != Sign::zero ? y : plane.normal.z;
    const RationalPoint3 unit = plane.normal * (Rational(1) / lead);
    const Key key{unit.x, unit.y, unit.z, plane.offset / lead};
    const auto [entry, is_new] = known_.try_emplace(key, static_cast<std::uint32_t>(known_.size()));
    return 2 * entry->second + (lead.sign() == Sign::positive ? 0U : 1U);
  }

 private:
  using Key = std::array<Rational, 4>;
  std::map<Key, std::uint32_t> known_;
};

struct Wall {
  std::uint32_t number;
  SectionPlane plane;
  double area;
};

struct Piece {
  std::vector<RationalPoint3> vertices;
  std::vector<Wall> walls;
  std::vector<Solid> parts;
  bool is_gone = false;
};

double length(const RationalPoint3& v) {
  return std::hypot(v.x.to_double(), v.y.to_double(), v.z.to_double());
}

class Joiner {
 public:
  Joiner(const std::vector<Solid>& solids, const Context& context) : context_(context) {
    for (const Solid& s : solids) add(piece_of(s));
  }

  std::vector<Solid> run() {
    while (!pairs_.empty()) {
      context_.poll();
      const Pair pair = pairs_.top();
      pairs_.pop();
      if (pieces_[pair.a].is_gone || pieces_[pair.b].is_gone) continue;
      if (are_convex_together(pieces_[pair.a], pieces_[pair.b], pair.number)) join(pair);
    }
    std::vector<Solid> result;
    for (const Piece& piece : pieces_) {
      if (piece.is_gone) continue;
      result.push_back(piece.parts.size() == 1 ? piece.parts[0] : unite(piece.parts, context_));
    }
    return result;
  }

 private:
  struct Pair {
    double area;
    std::uint32_t a;
    std::uint32_t b;
    std::uint32_t number;  // of the wall of a
    bool operator<(const Pair& other) const {
      if (area != other.area) return area < other.area;
      return std::pair(a, b) > std::pair(other.a, other.b);
    }
  };

  Piece piece_of(const Solid& solid) {
    const Brep& boundary = solid.boundary();
    Piece piece;
    piece.parts.push_back(solid);
    std::vector<bool> is_taken(boundary.points.point_count(), false);
    for (const PointId v : boundary.loop_vertices) {
      if (is_taken[v.index()]) continue;
      is_taken[v.index()] = true;
      piece.vertices.push_back(boundary.points.exact(v));
    }
    for (std::uint32_t f = 0; f < boundary.face_count(); ++f) {
      const RationalPoint3 normal = area_vector(boundary, f);
      const SectionPlane plane{normal, dot(normal, boundary.points.exact(boundary.face_planes[f][0]))};
      piece.walls.push_back({planes_.number(plane), plane, length(normal)});
    }
    return piece;
  }

  void add(Piece piece) {
    const auto number = static_cast<std::uint32_t>(pieces_.size());
    for (const Wall& wall : piece.walls) {
      for (const auto& [other, area] : by_wall_[wall.number ^ 1U]) {
        if (!pieces_[other].is_gone) pairs_.push({std::min(area, wall.area), number, other, wall.number});
      }
    }
    for (const Wall& wall : piece.walls) by_wall_[wall.number].push_back({number, wall.area});
    pieces_.push_back(std::move(piece));
  }

  static bool lies_within(const Piece& inner, const Piece& outer, std::uint32_t left_out) {
    return std::ranges::all_of(outer.walls, [&](const Wall& wall) {
      return wall.number == left_out || std::ranges::all_of(inner.vertices, [&](const RationalPoint3& v) {
               return dot(wall.plane.normal, v) <= wall.plane.offset;
             });
    });
  }

  static bool are_convex_together(const Piece& a, const Piece& b, std::uint32_t wall_of_a) {
    return lies_within(b, a, wall_of_a) && lies_within(a, b, wall_of_a ^ 1U);
  }

  void join(const Pair& pair) {
    Piece& a = pieces_[pair.a];
    Piece& b = pieces_[pair.b];
    Piece joined;
    const auto take_walls = [&](const Piece& piece, std::uint32_t left_out) {
      for (const Wall& wall : piece.walls) {
        if (wall.number == left_out) continue;
        const auto same = std::ranges::find(joined.walls, wall.number, &Wall::number);
        if (same == joined.walls.end()) {
          joined.walls.push_back(wall);
        } else {
          same->area += wall.area;
        }
      }
    };
    take_walls(a, pair.number);
    take_walls(b, pair.number ^ 1U);
    joined.vertices = std::move(a.vertices);
    for (RationalPoint3& v : b.vertices) {
      if (std::ranges::find(joined.vertices, v) == joined.vertices.end()) joined.vertices.push_back(std::move(v));
    }
    joined.parts = std::move(a.parts);
    joined.parts.insert(joined.parts.end(), b.parts.begin(), b.parts.end());
    a.is_gone = b.is_gone = true;
    add(std::move(joined));
  }

  const Context& context_;
  PlaneNumbers planes_;
  std::vector<Piece> pieces_;
  std::map<std::uint32_t, std::vector<std::pair<std::uint32_t, double>>> by_wall_;
  std::priority_queue<Pair> pairs_;
};

}  // namespace

std::vector<Solid> join_convex(const std::vector<Solid>& solids, const Context& context) {
  return Joiner(solids, context).run();
}

}  // namespace quoin
