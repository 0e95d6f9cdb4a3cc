// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/cells/dcel_filter.h"

#include <utility>

#include "quoin/base/disjoint_sets.h"

namespace quoin::dcel {

namespace {

class FilterRun {
 public:
  FilterRun(const Dcel& from, const Filter& what) : from_(from), what_(what), classes_(from.faces.size()) {
    for (const Face& face : from.faces) is_plane_ = is_plane_ || face.is_unbounded;
  }

  Filtered run() {
    number_vertices();
    number_edges();
    link_vertices();
    unite_faces();
    trace_boundaries();
    hang_isolated_vertices();
    return std::move(result_);
  }

 private:
  bool keeps(EdgeId e) const {
    if (from_.edges[e.index()] == CellState::fictitious) return true;
    return from_.edges[e.index()] == CellState::real && what_.keep_edge[e.index()];
  }
  bool dissolves(VertexId v) const { return !what_.dissolve_vertex.empty() && what_.dissolve_vertex[v.index()]; }

  /// The next kept halfedge out of the same vertex, clockwise; perhaps the same.
  HalfedgeId kept_clockwise(HalfedgeId out) const {
    HalfedgeId h = from_.clockwise(out);
    while (h != out && !keeps(h.edge())) h = from_.clockwise(h);
    return h;
  }
  HalfedgeId any_kept(VertexId v) const {
    const HalfedgeId first = from_[v].out;
    if (first.is_none() || keeps(first.edge())) return first;
    const HalfedgeId h = kept_clockwise(first);
    return h == first ? HalfedgeId() : h;
  }

  void number_vertices() {
    new_vertex_.resize(from_.vertices.size());
    for (std::size_t i = 0; i < from_.vertices.size(); ++i) {
      const VertexId v(i);
      if (from_[v].state == CellState::dead || dissolves(v)) continue;
      const bool stays = from_[v].state == CellState::fictitious || !any_kept(v).is_none() ||
                         (what_.keep_vertex.size() > i && what_.keep_vertex[i]);
      if (!stays) continue;
      new_vertex_[i] = VertexId(result_.dcel.vertices.size());
      result_.dcel.vertices.emplace_back().state = from_[v].state;
      result_.source_of_vertex.push_back(v);
    }
  }

  /// A chain of edges through dissolved vertices is numbered by its leftmost edge.
  void number_edges() {
    new_edge_.resize(from_.edges.size());
    for (std::size_t i = 0; i < from_.edges.size(); ++i) {
      const EdgeId e(i);
      if (!keeps(e) || dissolves(from_.origin(HalfedgeId(e, false)))) continue;
      EdgeId last = e;
      new_edge_[i] = EdgeId(result_.dcel.edges.size());
      while (dissolves(from_.origin(HalfedgeId(last, true)))) {
        last = kept_clockwise(HalfedgeId(last, true)).edge();
        new_edge_[last.index()] = new_edge_[i];
      }
      result_.dcel.edges.push_back(from_.edges[i]);
      result_.first_source_of_edge.push_back(e);
      result_.last_source_of_edge.push_back(last);
      result_.dcel.halfedges.emplace_back().origin = new_vertex_[from_.origin(HalfedgeId(e, false)).index()];
      result_.dcel.halfedges.emplace_back().origin = new_vertex_[from_.origin(HalfedgeId(last, true)).index()];
    }
  }

  HalfedgeId new_halfedge(HalfedgeId h) const { return {new_edge_[h.edge().index()], !h.is_forward()}; }

  void link_vertices() {
    for (std::size_t i = 0; i < result_.source_of_vertex.size(); ++i) {
      const HalfedgeId first = any_kept(result_.source_of_vertex[i]);
      if (first.is_none()) continue;
      result_.dcel.vertices[i].out = new_halfedge(first);
      HalfedgeId out = first;
      do {
        const HalfedgeId following = kept_clockwise(out);
        result_.dcel.link(new_halfedge(out).twin(), new_halfedge(following));
        out = following;
      } while (out != first);
    }
  }

  void unite_faces() {
    for (std::size_t i = 0; i < from_.edges.size(); ++i) {
      const EdgeId e(i);
      if (from_.edges[i] == CellState::dead || keeps(e)) continue;
      classes_.unite(from_.face(HalfedgeId(e, false)).value, from_.face(HalfedgeId(e, true)).value);
    }
    std::vector<FaceId> new_face(from_.faces.size());
    result_.face_of_source.resize(from_.faces.size());
    for (std::uint32_t f = 0; f < from_.faces.size(); ++f) {
      if (from_.faces[f].state == CellState::dead) continue;
      FaceId& face = new_face[classes_.find(f)];
      if (face.is_none()) {
        face = FaceId(result_.dcel.faces.size());
        result_.dcel.faces.emplace_back().state = from_.faces[f].state;
      }
      result_.face_of_source[f] = face;
      Face& to = result_.dcel[face];
      to.is_unbounded = to.is_unbounded || from_.faces[f].is_unbounded;
    }
    result_.dcel.base_face = result_.face_of_source[from_.base_face.index()];
  }

  void trace_boundaries() {
    Dcel& to = result_.dcel;
    std::vector<BoundaryId> last(to.faces.size());
    for (std::size_t i = 0; i < to.halfedges.size(); ++i) {
      if (!to.halfedges[i].boundary.is_none()) continue;
      const HalfedgeId first(i);
      const BoundaryId id(to.boundaries.size());
      const EdgeId source = result_.first_source_of_edge[first.edge().index()];
      const FaceId face = result_.face_of_source[from_.face(HalfedgeId(source, !first.is_forward())).index()];
      to.boundaries.push_back({first, face, BoundaryId(), is_outer(first, id)});
      (last[face.index()].is_none() ? to[face].first_boundary : to[last[face.index()]].next) = id;
      last[face.index()] = id;
    }
  }

  /// Traces the boundary. Outer, by the rule of DcelBuilder: decided at its smallest vertex, which has the smallest
  /// number.
  bool is_outer(HalfedgeId first, BoundaryId id) {
    Dcel& to = result_.dcel;
    std::uint32_t least = 0xFFFFFFFFU;
    bool is_inner = false;
    bool is_frame = false;
    HalfedgeId h = first;
    do {
      to[h].boundary = id;
      is_frame = is_frame || to.edges[h.edge().index()] == CellState::fictitious;
      const HalfedgeId before = to.previous(h);
      if (h.is_forward() && !before.is_forward() && to.origin(h).value <= least) {
        is_inner = before.twin() <= h || (is_inner && to.origin(h).value == least);
        least = to.origin(h).value;
      }
      h = to.next(h);
    } while (h != first);
    return is_frame || !is_plane_ || !is_inner;
  }

  void hang_isolated_vertices() {
    Dcel& to = result_.dcel;
    for (std::size_t i = to.vertices.size(); i-- > 0;) {
      if (!to.vertices[i].out.is_none()) continue;
      const VertexId source = result_.source_of_vertex[i];
      const HalfedgeId out = from_[source].out;
      const FaceId old_face = out.is_none() ? from_[source].face : from_.face(out);
      to.vertices[i].face = result_.face_of_source[old_face.index()];
      to.vertices[i].next_isolated = to[to.vertices[i].face].first_isolated;
      to[to.vertices[i].face].first_isolated = VertexId(i);
    }
  }

  const Dcel& from_;
  const Filter& what_;
  DisjointSets classes_;
  bool is_plane_ = false;
  Filtered result_;
  std::vector<VertexId> new_vertex_;
  std::vector<EdgeId> new_edge_;
};

}  // namespace

Filtered filter(const Dcel& dcel, const Filter& what) {
  return FilterRun(dcel, what).run();
}

}  // namespace quoin::dcel
