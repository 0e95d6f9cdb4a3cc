// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/boundary_crossings.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <tuple>

#include "quoin/solid/query/face_place.h"
#include "quoin/solid/query/point_location.h"

namespace quoin {

namespace {

struct BoundaryEdge {
  PointId a;  // smaller
  PointId b;
  friend auto operator<=>(const BoundaryEdge&, const BoundaryEdge&) = default;
};

class CrossingFinder {
 public:
  CrossingFinder(const Brep& boundary, std::size_t max_listed, const Context& context)
      : b_(boundary), max_listed_(max_listed), context_(context), locator_(boundary, context) {}

  std::vector<std::string> run() {
    gather_edges();
    check_vertices_on_edges();
    check_edges_against_edges();
    check_edges_against_faces();
    check_vertices_in_faces();
    if (!check_slits()) return std::move(violations_);  // such a face need not have an inside at its outermost vertex
    check_sides();
    check_shells();
    return std::move(violations_);
  }

 private:
  struct EdgeUse {
    BoundaryEdge edge;
    std::uint32_t face;
    friend auto operator<=>(const EdgeUse&, const EdgeUse&) = default;
  };

  struct VertexOfFace {
    std::uint32_t face;
    PointId vertex;
    friend auto operator<=>(const VertexOfFace&, const VertexOfFace&) = default;
  };

  void say(std::string violation) {
    if (violations_.size() < max_listed_) violations_.push_back(std::move(violation));
  }

  static std::string name(const BoundaryEdge& e) {
    return "edge " + std::to_string(e.a.value) + "-" + std::to_string(e.b.value);
  }
  static std::string name(std::uint32_t face) { return "face " + std::to_string(face); }

  template <class Visit>
  void for_each_edge(std::uint32_t face, const Visit& visit) const {
    for (std::uint32_t l = b_.face_first_loop[face]; l < b_.face_first_loop[face + 1]; ++l) {
      const std::span<const PointId> loop = b_.loop(l);
      if (loop.size() == 1) continue;
      for (std::size_t i = 0; i < loop.size(); ++i) visit(loop[i], loop[i + 1 == loop.size() ? 0 : i + 1]);
    }
  }

  void gather_edges() {
    for (std::uint32_t f = 0; f < b_.face_count(); ++f) {
      for_each_edge(f, [&](PointId p, PointId q) {
        uses_.push_back({{std::min(p, q), std::max(p, q)}, f});
        vertices_.push_back(p);
        names_.push_back({f, p});
      });
    }
    std::sort(names_.begin(), names_.end());
    std::sort(uses_.begin(), uses_.end());
    for (const EdgeUse& use : uses_) {
      if (edges_.empty() || edges_.back() != use.edge) edges_.push_back(use.edge);
    }
    std::sort(vertices_.begin(), vertices_.end());
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
    std::vector<FloatBox> boxes;
    for (const BoundaryEdge& e : edges_) {
      boxes.push_back(box_of(b_.points.rounded(e.a)));
      extend(boxes.back(), box_of(b_.points.rounded(e.b)));
    }
    edge_tree_ = BoxTree(boxes, context_);
  }

  bool bounds(const BoundaryEdge& edge, std::uint32_t face) const {
    return std::binary_search(uses_.begin(), uses_.end(), EdgeUse{edge, face});
  }

  PlacedPoint placed(PointId p) const { return {b_.points, b_.points.exact(p)}; }

  static bool is_between(const PlacedPoint& p, const BoundaryEdge& e) {
    for (unsigned axis = 0; axis < 3; ++axis) {
      if (p.compare(e.a, axis) * p.compare(e.b, axis) == Sign::positive) return false;
    }
    return true;
  }

  static bool is_on_line(const PlacedPoint& p, const BoundaryEdge& e) {
    for (unsigned axis = 0; axis < 3; ++axis) {
      if (p.turn(e.a, e.b, axis) != Sign::zero) return false;
    }
    return true;
  }

  void check_vertices_on_edges() {
    std::vector<std::uint32_t> near;
    for (const PointId v : vertices_) {
      poll();
      const Point3& at = b_.points.rounded(v);
      near.clear();
      edge_tree_.tiles_in_box(at, at, near);
      std::optional<PlacedPoint> point;
      for (const std::uint32_t n : near) {
        const BoundaryEdge& e = edges_[n];
        if (e.a == v || e.b == v) continue;
        if (!point) point = placed(v);
        if (is_between(*point, e) && is_on_line(*point, e)) {
          say("vertex " + std::to_string(v.value) + " lies on " + name(e) + ", which it does not end");
        }
      }
    }
  }

  // Edges without a common end; those whose ends lie on one another were found above.
  void check_edges_against_edges() {
    std::vector<Tile> ends;
    for (const BoundaryEdge& e : edges_) ends.push_back({e.a.value, e.b.value, BoxTree::no_label});
    const auto all = [](const TilePair&) { return true; };
    for (const TilePair& pair : edge_tree_.self_pairs({ends, {}}, all, context_)) {
      poll();
      if (cross(edges_[pair.a], edges_[pair.b])) say(name(edges_[pair.a]) + " crosses " + name(edges_[pair.b]));
    }
  }

  bool cross(const BoundaryEdge& e, const BoundaryEdge& f) const {
    const PlacedPoint fa = placed(f.a);
    const PlacedPoint fb = placed(f.b);
    if (placed(e.a).side(e.b, f.a, f.b) != Sign::zero) return false;
    for (unsigned axis = 0; axis < 3; ++axis) {
      const Sign a_side = fa.turn(e.a, e.b, axis);
      const Sign b_side = fb.turn(e.a, e.b, axis);
      if (a_side == Sign::zero && b_side == Sign::zero) continue;  // nothing is seen along this axis
      return a_side * b_side == Sign::negative &&
             placed(e.a).turn(f.a, f.b, axis) * placed(e.b).turn(f.a, f.b, axis) == Sign::negative;
    }
    return false;
  }

  void check_edges_against_faces() {
    std::vector<std::uint32_t> near;
    for (const BoundaryEdge& e : edges_) {
      poll();
      const Point3& a = b_.points.rounded(e.a);
      const Point3& b = b_.points.rounded(e.b);
      near.clear();
      locator_.tree().tiles_in_box({std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)},
                                   {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}, near);
      for (const std::uint32_t face : near) {
        if (!bounds(e, face)) check_edge_against_face(e, face);
      }
    }
  }

  void check_edge_against_face(const BoundaryEdge& e, std::uint32_t face) {
    const PlacedPoint from = placed(e.a);
    const PlacedPoint to = placed(e.b);
    const Sign from_side = side_of_face(b_, face, from);
    const Sign to_side = side_of_face(b_, face, to);
    if (from_side * to_side == Sign::negative) {
      if (is_inside(meet(from.exact(), to.exact(), face), face)) say(name(e) + " pierces " + name(face));
    } else if (from_side == Sign::zero && to_side == Sign::zero) {
      // No vertex inside an edge and no crossing of edges: all of it is inside or nothing.
      if (is_inside((from.exact() + to.exact()) * Rational(0.5), face))
        say(name(e) + " runs inside " + name(face) + ", which it does not bound");
    }
  }

  // What touches a face inside is one of its loops, and such a loop is nothing else.
  void check_vertices_in_faces() {
    std::vector<VertexOfFace> touching;
    for (std::uint32_t f = 0; f < b_.face_count(); ++f) {
      for (std::uint32_t l = b_.face_first_loop[f]; l < b_.face_first_loop[f + 1]; ++l) {
        if (b_.loop(l).size() == 1) touching.push_back({f, b_.loop(l)[0]});
      }
    }
    std::sort(touching.begin(), touching.end());
    std::vector<VertexOfFace> found = find_vertices_in_faces();
    std::sort(found.begin(), found.end());
    const auto report = [&](const std::vector<VertexOfFace>& some, const std::vector<VertexOfFace>& others,
                            const std::string& what) {
      std::vector<VertexOfFace> rest;
      std::set_difference(some.begin(), some.end(), others.begin(), others.end(), std::back_inserter(rest));
      for (const VertexOfFace& v : rest) say("vertex " + std::to_string(v.vertex.value) + what + name(v.face));
    };
    report(found, touching, " touches what does not name it: ");
    report(touching, found, " does not touch what names it: ");
  }

  // Vertices of loops of two and more, strictly inside faces that no such loop of theirs names.
  std::vector<VertexOfFace> find_vertices_in_faces() {
    std::vector<VertexOfFace> found;
    std::vector<std::uint32_t> near;
    for (const PointId v : vertices_) {
      poll();
      const Point3& at = b_.points.rounded(v);
      near.clear();
      locator_.tree().tiles_in_box(at, at, near);
      std::optional<PlacedPoint> point;
      for (const std::uint32_t face : near) {
        if (std::binary_search(names_.begin(), names_.end(), VertexOfFace{face, v})) continue;
        if (!point) point = placed(v);
        if (side_of_face(b_, face, *point) != Sign::zero) continue;
        if (place_in_face(b_, face, *point, projection_axis(b_, face)).is_inside_when_moved) found.push_back({face, v});
      }
    }
    return found;
  }

  // An edge that a face passes in both directions has the face on both sides, or bounds nothing.
  bool check_slits() {
    bool is_sound = true;
    for (std::size_t i = 0; i + 1 < uses_.size(); ++i) {
      if (uses_[i] != uses_[i + 1]) continue;
      const auto& [edge, face] = uses_[i];
      const PlacedPoint middle(b_.points, (b_.points.exact(edge.a) + b_.points.exact(edge.b)) * Rational(0.5));
      if (place_in_face(b_, face, middle, projection_axis(b_, face)).is_inside_when_moved) continue;
      is_sound = false;
      say(name(edge) + " dangles from " + name(face));
    }
    return is_sound;
  }

  RationalPoint3 meet(const RationalPoint3& p, const RationalPoint3& q, std::uint32_t face) const {
    const auto& plane = b_.face_planes[face];
    const RationalPoint3 a = b_.points.exact(plane[0]);
    const RationalPoint3 normal = quoin::cross(b_.points.exact(plane[1]) - a, b_.points.exact(plane[2]) - a);
    const Rational before = dot(normal, p - a);
    return p + (q - p) * (before / (before - dot(normal, q - a)));
  }

  bool is_inside(const RationalPoint3& point, std::uint32_t face) const {
    return place_in_face(b_, face, PlacedPoint(b_.points, point), projection_axis(b_, face)).kind ==
           FacePlace::Kind::inside;
  }

  // A point inside each face: no other face holds it, and a line from it outward counts what surrounds it.
  void check_sides() {
    around_.assign(b_.shells.size(), {});
    for (std::uint32_t f = 0; f < b_.face_count(); ++f) {
      poll();
      check_side(f);
    }
  }

  // A vertex of other faces may touch the face in the very point; nearer to a corner of the face there is another one.
  void check_side(std::uint32_t face) {
    const unsigned axis = projection_axis(b_, face);
    RationalPoint3 point = interior_point(b_, face);
    const auto loop = b_.loop(b_.face_first_loop[face]);
    for (int attempt = 0; attempt < 8; ++attempt) {
      if (check_side_at(face, PlacedPoint(b_.points, point), axis)) return;
      point = nearer_inside(face, point, loop[static_cast<std::size_t>(attempt) % loop.size()], axis);
    }
    say("another face lies on " + name(face));
  }

  // Halfway to a corner, or as often halved as it takes to be inside.
  RationalPoint3 nearer_inside(std::uint32_t face, const RationalPoint3& point, PointId corner, unsigned axis) const {
    Rational part(0.5);
    const RationalPoint3 towards = b_.points.exact(corner) - point;
    while (true) {
      RationalPoint3 moved = point + towards * part;
      if (place_in_face(b_, face, PlacedPoint(b_.points, moved), axis).kind == FacePlace::Kind::inside) return moved;
      part *= Rational(0.5);
    }
  }

  // False if another face holds the point.
  bool check_side_at(std::uint32_t face, const PlacedPoint& point, unsigned axis) {
    const auto& plane = b_.face_planes[face];
    const Sign up = b_.points.turn(plane[0], plane[1], plane[2], axis);
    const std::array<double, 2> at{point.rounded()[(axis + 1) % 3], point.rounded()[(axis + 2) % 3]};
    std::vector<std::uint32_t> near;
    locator_.tree().tiles_on_line(axis, at, at, near);
    std::size_t ahead = 0;   // faces in the direction of the outward normal
    std::size_t others = 0;  // of them, those of other shells
    for (const std::uint32_t f : near) {
      if (f == face) continue;
      const Sign side = side_of_face(b_, f, point);
      if (side == Sign::zero && place_in_face(b_, f, point, projection_axis(b_, f)).kind != FacePlace::Kind::outside) {
        return false;
      }
      if (!place_in_face(b_, f, point, axis).is_inside_when_moved) continue;
      const auto& other = b_.face_planes[f];
      const Sign other_up = b_.points.turn(other[0], other[1], other[2], axis);
      if (other_up * side * up != Sign::negative) continue;
      ++ahead;
      if (b_.face_shells[f] != b_.face_shells[face]) ++others;
    }
    if ((ahead % 2 != 0) != b_.is_unbounded) say(name(face) + " has the solid on its outward side");
    around_[b_.face_shells[face]] = others % 2 != 0;
    return true;
  }

  // A void lies inside an odd number of other shells, an outer shell inside an even number; the other way round in
  // unbounded solids.
  void check_shells() {
    std::uint32_t outer = 0;
    for (std::size_t s = 0; s < b_.shells.size(); ++s) {
      if (!around_[s]) {
        say("shell " + std::to_string(s) + " has no faces");
      } else if (b_.shells[s].is_void != (*around_[s] != b_.is_unbounded)) {
        say("shell " + std::to_string(s) + " is declared " + (b_.shells[s].is_void ? "a void" : "an outer one") +
            " and is not");
      }
      outer += b_.shells[s].is_void ? 0 : 1;
    }
    const std::uint32_t components = outer + (b_.is_unbounded ? 1 : 0);
    if (components != b_.component_count) {
      say(std::to_string(b_.component_count) + " components are declared, and there are " + std::to_string(components));
    }
  }

  void poll() {
    if (++polls_ % 64 == 0) context_.poll();
  }

  const Brep& b_;
  std::size_t max_listed_;
  const Context& context_;
  SolidLocator locator_;
  std::vector<EdgeUse> uses_;  // sorted
  std::vector<BoundaryEdge> edges_;
  std::vector<PointId> vertices_;    // of loops of two and more
  std::vector<VertexOfFace> names_;  // of the same, sorted
  BoxTree edge_tree_;
  std::vector<std::optional<bool>> around_;  // per shell: an odd number of other shells is around it
  std::size_t polls_ = 0;
  std::vector<std::string> violations_;
};

}  // namespace

std::vector<std::string> find_boundary_crossings(const Brep& boundary, std::size_t max_listed, const Context& context) {
  return CrossingFinder(boundary, max_listed, context).run();
}

}  // namespace quoin
