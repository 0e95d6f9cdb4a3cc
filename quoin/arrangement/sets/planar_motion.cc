// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/sets/planar_motion.h"

#include "quoin/arrangement/cells/face_walk.h"
#include "quoin/arrangement/sets/planar_rings.h"
#include "quoin/arrangement/sweep/build_visitor.h"

namespace quoin {

namespace {

using dcel::EdgeId;
using dcel::HalfedgeId;
using dcel::VertexId;

/// Draws every edge and vertex of a set anew, moved, and carries the memberships over.
class Mover {
 public:
  Mover(const LinearPolygonSet& set, bool is_reflected, const RationalPoint2& vector)
      : set_(set), from_(set.arrangement()), is_reflected_(is_reflected), vector_(planar::planar_point(vector)) {}

  LinearPolygonSet run(const Context& context) {
    point_of_.assign(from_.vertex_count(), none);
    for (std::size_t e = 0; e < from_.edge_count(); ++e) {
      if (from_.cells().is_real(EdgeId(e))) add_edge(EdgeId(e));
    }
    list_.curve_count = static_cast<std::uint32_t>(from_.edge_count());
    for (std::size_t v = 0; v < from_.vertex_count(); ++v) {
      if (!from_.cells().is_real(VertexId(v)) || !from_.cells().is_isolated(VertexId(v))) continue;
      list_.lone_points.push_back({end_point(VertexId(v), BranchId()), CurveId(std::size_t{list_.curve_count++})});
    }
    BuildVisitor<LinearFamily> visitor(family_, list_);
    Sweep<LinearFamily>(family_, list_, {}, {}, visitor, context).run();
    const LinearArrangement drawn = visitor.finish(std::move(family_));
    return labelled(drawn, visitor.vertex_of_point());
  }

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFFU;

  planar::PlanarPoint moved(const RationalPoint2& p) const {
    if (is_reflected_) return sum(planar::planar_point({-p.x, -p.y}), vector_);
    return sum(planar::planar_point(p), vector_);
  }
  void add_edge(EdgeId e) {
    const BranchId branch = from_.branch(e);
    const BranchId line = add_line(family_, moved(from_.family().first_support_point(branch)),
                                   moved(from_.family().second_support_point(branch)));
    std::uint32_t left = end_point(from_.left(e), line);
    std::uint32_t right = end_point(from_.right(e), line);
    if (is_reflected_) std::swap(left, right);
    list_.pieces.push_back({line, left, right, CurveId(e.index()), false});
  }
  /// Ends at infinity are those of the new line.
  std::uint32_t end_point(VertexId v, BranchId line) {
    std::uint32_t& place = point_of_[v.index()];
    if (place != none) return place;
    const LinearPoint& point = from_.point(v);
    if (!point.is_end()) return place = list_.add_point(add_point(family_, moved(from_.family().exact(point))));
    const bool is_first = point.second == LinearPoint::left_tag || point.second == LinearPoint::bottom_tag;
    return place = list_.add_point(is_first != is_reflected_ ? family_.first_end(line) : family_.last_end(line));
  }
  LinearPolygonSet labelled(const LinearArrangement& drawn, const std::vector<VertexId>& vertex_of_point) const {
    const dcel::Dcel& cells = drawn.cells();
    std::vector<bool> vertices(drawn.vertex_count(), false);
    std::vector<bool> edges(drawn.edge_count(), false);
    std::vector<bool> faces(drawn.face_count(), false);
    for (std::size_t v = 0; v < from_.vertex_count(); ++v) {
      if (point_of_[v] != none && set_.contains(VertexId(v))) vertices[vertex_of_point[point_of_[v]].index()] = true;
    }
    if (drawn.edge_count() == 0) return with_one_face(drawn, std::move(vertices));
    for (std::size_t e = 0; e < drawn.edge_count(); ++e) {
      if (!cells.is_real(EdgeId(e))) continue;
      const EdgeId source(drawn.curves(EdgeId(e))[0].curve().index());
      edges[e] = set_.contains(source);
      for (const bool back : {false, true}) {
        const dcel::FaceId face = from_.cells().face(HalfedgeId(source, back != is_reflected_));
        faces[cells.face(HalfedgeId(EdgeId(e), back)).index()] = set_.contains(face);
      }
    }
    return {drawn, std::move(vertices), std::move(edges), std::move(faces)};
  }
  /// Nothing but lone points.
  LinearPolygonSet with_one_face(const LinearArrangement& drawn, std::vector<bool> vertices) const {
    std::vector<bool> faces(drawn.face_count(), false);
    faces[drawn.cells().base_face.index()] = set_.contains(from_.cells().base_face);
    return {drawn, std::move(vertices), std::vector<bool>(drawn.edge_count(), false), std::move(faces)};
  }

  const LinearPolygonSet& set_;
  const LinearArrangement& from_;
  bool is_reflected_;
  planar::PlanarPoint vector_;
  LinearFamily family_;
  PieceList<LinearFamily> list_;
  std::vector<std::uint32_t> point_of_;  // by vertex
};

}  // namespace

LinearPolygonSet translated(const LinearPolygonSet& set, const RationalPoint2& vector, const Context& context) {
  return Mover(set, false, vector).run(context);
}

LinearPolygonSet reflected(const LinearPolygonSet& set, const Context& context) {
  return reflected(set, {}, context);
}

LinearPolygonSet reflected(const LinearPolygonSet& set, const RationalPoint2& c, const Context& context) {
  return Mover(set, true, c).run(context);
}

}  // namespace quoin
