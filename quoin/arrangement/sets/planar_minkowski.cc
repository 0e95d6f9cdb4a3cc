// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/sets/planar_minkowski.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <span>

#include "quoin/arrangement/cells/face_walk.h"
#include "quoin/arrangement/sets/planar_convolution.h"
#include "quoin/arrangement/sweep/build_visitor.h"

namespace quoin {

namespace {

using dcel::EdgeId;
using dcel::FaceId;
using dcel::HalfedgeId;
using dcel::VertexId;

/// The convolution drawn, with the winding number of each face.
struct Drawing {
  LinearArrangement arrangement;
  std::vector<VertexId> vertex_of_corner;
  std::vector<std::int64_t> winding;  // by face

  const dcel::Dcel& cells() const { return arrangement.cells(); }
  bool is_inside(HalfedgeId h) const { return winding[cells().face(h).index()] > 0; }
  bool is_all_inside(VertexId v) const {
    const HalfedgeId first = cells()[v].out;
    HalfedgeId out = first;
    do {
      if (!is_inside(out)) return false;
      out = cells().clockwise(out);
    } while (out != first);
    return true;
  }
};

Drawing draw(const planar::Convolution& convolution, const Context& context) {
  LinearFamily family;
  PieceList<LinearFamily> list;
  std::vector<planar::PlanarPoint> points;
  for (const auto& [p, q] : convolution.corners) {
    points.push_back(sum(convolution.a.points[p], convolution.b.points[q]));
    list.add_point(add_point(family, points.back()));
  }
  for (const planar::Convolution::Edge& edge : convolution.edges) {
    const BranchId line = add_line(family, points[edge.from], points[edge.to]);
    const CurveId curve(std::size_t{list.curve_count++});
    list.pieces.push_back({line, edge.is_backwards ? edge.to : edge.from, edge.is_backwards ? edge.from : edge.to,
                           curve, edge.is_backwards});
  }
  BuildVisitor<LinearFamily> visitor(family, list);
  Sweep<LinearFamily>(family, list, {}, {}, visitor, context).run();
  Drawing result{visitor.finish(std::move(family)), visitor.vertex_of_point(), {}};
  result.winding.assign(result.arrangement.face_count(), 0);
  std::int64_t here = 0;
  dcel::walk_faces(
      result.cells(),
      [&](HalfedgeId h) {
        for (const CurveUse use : result.arrangement.curves(h.edge())) {
          const std::int64_t sign = convolution.edges[use.curve().index()].sign;
          here += h.is_forward() != use.is_reversed() ? -sign : sign;
        }
      },
      [&](FaceId f) { result.winding[f.index()] = here; });
  return result;
}

LinearPolygonSet closed_sum(const Drawing& drawing) {
  const dcel::Dcel& cells = drawing.cells();
  std::vector<bool> faces(cells.faces.size(), false);
  std::vector<bool> edges(cells.edges.size(), false);
  std::vector<bool> vertices(cells.vertices.size(), false);
  for (std::size_t f = 0; f < faces.size(); ++f) faces[f] = cells.is_real(FaceId(f)) && drawing.winding[f] > 0;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const HalfedgeId h(EdgeId(e), false);
    if (!cells.is_real(EdgeId(e)) || (!drawing.is_inside(h) && !drawing.is_inside(h.twin()))) continue;
    edges[e] = true;
    vertices[cells.origin(h).index()] = true;
    vertices[cells.target(h).index()] = true;
  }
  return {drawing.arrangement, std::move(vertices), std::move(edges), std::move(faces)};
}

/// Which holes the sum has and where they come from.
void count_holes(const planar::Convolution& convolution, const Drawing& drawing, PlanarMinkowskiSum& out) {
  const dcel::Dcel& cells = drawing.cells();
  std::vector<bool> is_inherited(cells.faces.size(), false);
  std::array<std::vector<bool>, 2> bounds_hole{std::vector<bool>(convolution.a.is_hole.size(), false),
                                               std::vector<bool>(convolution.b.is_hole.size(), false)};
  for (std::size_t e = 0; e < cells.edges.size(); ++e) {
    HalfedgeId h(EdgeId(e), false);
    if (!cells.is_real(EdgeId(e)) || drawing.is_inside(h) == drawing.is_inside(h.twin())) continue;
    if (drawing.is_inside(h)) h = h.twin();
    if (cells[cells.face(h)].is_unbounded) continue;
    for (const CurveUse use : drawing.arrangement.curves(EdgeId(e))) {
      const planar::Convolution::Edge& edge = convolution.edges[use.curve().index()];
      const bool of_a = convolution.a.is_hole[edge.ring_of_a];
      const bool of_b = convolution.b.is_hole[edge.ring_of_b];
      if (of_a) bounds_hole[0][edge.ring_of_a] = true;
      if (of_b) bounds_hole[1][edge.ring_of_b] = true;
      if (of_a || of_b) is_inherited[cells.face(h).index()] = true;
    }
  }
  for (std::size_t f = 0; f < cells.faces.size(); ++f) {
    if (!cells.is_real(FaceId(f)) || cells.faces[f].is_unbounded || drawing.winding[f] > 0) continue;
    ++out.holes;
    if (!is_inherited[f]) ++out.new_holes;
  }
  for (std::size_t r = 0; r < bounds_hole[0].size(); ++r) {
    if (convolution.a.is_hole[r] && !bounds_hole[0][r]) ++out.vanished_holes;
  }
  for (std::size_t r = 0; r < bounds_hole[1].size(); ++r) {
    if (convolution.b.is_hole[r] && !bounds_hole[1][r]) ++out.vanished_holes;
  }
}

/// Separates the inner edges and vertices of a sum into those of the open sum and tight ones.
class TightPassages {
 public:
  TightPassages(const LinearPolygonSet& a, const LinearPolygonSet& b, const planar::Convolution& convolution,
                const Drawing& drawing, const Context& context)
      : a_(a), b_(b), convolution_(convolution), drawing_(drawing), cells_(drawing.cells()), context_(context) {}

  void run(PlanarMinkowskiSum& out) {
    find_edges();
    list_corners();
    for (std::size_t v = 0; v < cells_.vertices.size(); ++v) {
      if (!cells_.is_real(VertexId(v)) || !drawing_.is_all_inside(VertexId(v))) continue;
      (is_tight(VertexId(v)) ? tight_vertices_ : open_vertices_)[v] = true;
    }
    std::vector<bool> faces(cells_.faces.size(), false);
    for (std::size_t f = 0; f < faces.size(); ++f) faces[f] = drawing_.winding[f] > 0;
    out.open_sum = LinearPolygonSet(drawing_.arrangement, open_vertices_, open_edges_, faces);
    out.tight =
        LinearPolygonSet(drawing_.arrangement, tight_vertices_, tight_edges_, std::vector<bool>(faces.size(), false));
    const dcel::Counts counts = out.tight.arrangement().counts();
    out.slits = counts.edges;
    out.isolated_points = counts.isolated_vertices;
  }

 private:
  /// In how many parts the open sets meet on an edge: as many as on the right of all curves along it.
  std::int64_t parts_on(EdgeId e) const {
    std::int64_t parts = drawing_.winding[cells_.face(HalfedgeId(e, false)).index()];
    for (const CurveUse use : drawing_.arrangement.curves(e)) {
      if (!use.is_reversed()) parts -= convolution_.edges[use.curve().index()].sign;
    }
    return parts;
  }
  void find_edges() {
    tight_edges_.assign(cells_.edges.size(), false);
    open_edges_.assign(cells_.edges.size(), false);
    tight_vertices_.assign(cells_.vertices.size(), false);
    open_vertices_.assign(cells_.vertices.size(), false);
    for (std::size_t e = 0; e < cells_.edges.size(); ++e) {
      const HalfedgeId h(EdgeId(e), false);
      if (!cells_.is_real(EdgeId(e)) || !drawing_.is_inside(h) || !drawing_.is_inside(h.twin())) continue;
      (parts_on(EdgeId(e)) > 0 ? open_edges_ : tight_edges_)[e] = true;
    }
  }
  void list_corners() {
    first_corner_.assign(cells_.vertices.size() + 1, 0);
    for (const VertexId v : drawing_.vertex_of_corner) ++first_corner_[v.index() + 1];
    std::partial_sum(first_corner_.begin(), first_corner_.end(), first_corner_.begin());
    std::vector<std::uint32_t> next = first_corner_;
    corners_.resize(drawing_.vertex_of_corner.size());
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      corners_[next[drawing_.vertex_of_corner[i].index()]++] = static_cast<std::uint32_t>(i);
    }
  }
  /// Of a vertex with the sum all around. What is not in the open sum is closed there. Otherwise, if nothing ends at
  /// the vertex, it lies right next to all curves as on an edge. If something does, every part in which the sets meet
  /// nearby starts at a contact, so that there are no more parts than curves that leave, and the cones at no corner
  /// meet. What passes all that is asked exactly.
  bool is_tight(VertexId v) {
    const HalfedgeId first = cells_[v].out;
    std::int64_t fewest = std::numeric_limits<std::int64_t>::max();
    std::int64_t leaving = 0;
    HalfedgeId out = first;
    do {
      if (tight_edges_[out.edge().index()]) return true;
      fewest = std::min(fewest, drawing_.winding[cells_.face(out).index()]);
      leaving += static_cast<std::int64_t>(drawing_.arrangement.curves(out.edge()).size());
      out = cells_.clockwise(out);
    } while (out != first);
    if (cells_.degree(v) < 3) return false;
    const std::span<const std::uint32_t> corners(corners_.data() + first_corner_[v.index()],
                                                 corners_.data() + first_corner_[v.index() + 1]);
    if (corners.empty()) return parts_between_passing_curves(v) <= 0;
    if (fewest > leaving) return false;
    for (const std::uint32_t corner : corners) {
      if (convolution_.meet_at(convolution_.corners[corner])) return false;
    }
    return is_kept_apart(v);
  }
  /// As many as in one face next to the vertex, less those of the curves that have it on their left: going around
  /// counterclockwise from it, these are met first where they arrive.
  std::int64_t parts_between_passing_curves(VertexId v) const {
    const HalfedgeId first = cells_[v].out;
    std::int64_t parts = drawing_.winding[cells_.face(first).index()];
    std::vector<CurveId> seen;
    HalfedgeId out = first;
    do {
      out = cells_.counterclockwise(out);
      for (const CurveUse use : drawing_.arrangement.curves(out.edge())) {
        if (std::find(seen.begin(), seen.end(), use.curve()) != seen.end()) continue;
        seen.push_back(use.curve());
        const bool arrives = out.is_forward() == use.is_reversed();
        if (arrives) parts -= convolution_.edges[use.curve().index()].sign;
      }
    } while (out != first);
    return parts;
  }
  /// The insides of A and v - B do not meet.
  bool is_kept_apart(VertexId v) {
    const RationalPoint2 place = drawing_.arrangement.family().exact(drawing_.arrangement.point(v));
    const LinearPolygonSet moved = reflected(b_, place, context_);
    const std::array<const LinearPolygonSet*, 2> pair{&a_, &moved};
    return combine<LinearFamily>(pair, SetOperation::intersect, Regularity::regularized, context_).is_empty();
  }

  const LinearPolygonSet& a_;
  const LinearPolygonSet& b_;
  const planar::Convolution& convolution_;
  const Drawing& drawing_;
  const dcel::Dcel& cells_;
  const Context& context_;
  std::vector<bool> tight_edges_;
  std::vector<bool> open_edges_;
  std::vector<bool> tight_vertices_;
  std::vector<bool> open_vertices_;
  std::vector<std::uint32_t> first_corner_;  // by vertex, and the number of all
  std::vector<std::uint32_t> corners_;
};

}  // namespace

PlanarMinkowskiSum minkowski_sum(const LinearPolygonSet& a, const LinearPolygonSet& b,
                                 const PlanarMinkowskiOptions& options, const Context& context) {
  const planar::Convolution convolution = planar::convolve(a, b, context);
  const Drawing drawing = draw(convolution, context);
  PlanarMinkowskiSum result;
  result.sum = closed_sum(drawing);
  count_holes(convolution, drawing, result);
  if (options.find_tight_passages) TightPassages(a, b, convolution, drawing, context).run(result);
  return result;
}

}  // namespace quoin
