// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/arrangement/cells/dcel.h"
#include "quoin/arrangement/edit/observer.h"

namespace quoin::dcel {

/// What edits of links must know of geometry.
class CycleGeometry {
 public:
  virtual ~CycleGeometry() = default;
  /// In the plane: the face on the left of the cycle lies inside it. A cycle with fictitious edges is outer.
  virtual bool is_outer(HalfedgeId on_cycle) const = 0;
  /// A face was split and this cycle bounds the new part: does a vertex of the old face, which is not on the cycle, lie
  /// in the new part?
  virtual bool contains(HalfedgeId on_cycle, VertexId v) const = 0;
};

/// A place in the ring around a vertex where a new edge can leave: it follows the arriving halfedge on its boundary.
/// An isolated vertex has one place and no arriving halfedge.
struct RingPlace {
  VertexId vertex;
  HalfedgeId arriving;
};

/// What happens to ends that a removed edge leaves without edges.
struct RemoveEdgeOptions {
  bool removes_left_end = true;   ///< else it stays as an isolated vertex
  bool removes_right_end = true;  ///< else it stays as an isolated vertex
};

/// Edits of a subdivision that move no more than a few links, told to observers. Ids of other cells stay; removed cells
/// are left dead, new ones are appended.
///
/// Where an edge closes a new face in the plane, the parts are told apart by `geometry`. Not for the points where
/// surfaces are glued or contracted, but for removal, which needs no geometry there.
class LocalEditor {
 public:
  /// `is_planar`: the surface has an unbounded face, boundaries are inner or outer.
  LocalEditor(Dcel& dcel, const CycleGeometry& geometry, const ObserverList& observers, bool is_planar)
      : dcel_(dcel), geometry_(geometry), observers_(observers), is_planar_(is_planar) {}

  VertexId add_isolated_vertex(FaceId face, CellState state = CellState::real);
  /// @throws InputError if it has edges
  void remove_isolated_vertex(VertexId v);

  FaceId face_of(const RingPlace& place) const {
    return place.arriving.is_none() ? dcel_[place.vertex].face : dcel_.face(place.arriving);
  }
  /// @throws InputError if no edge can run between the places: they are in different faces
  void check_places(const RingPlace& left, const RingPlace& right) const;
  /// A new edge between two places of one face. O(1) if a new component or an antenna arises; if two components are
  /// joined or the face is split, linear in the boundary that gets a new name and in the boundaries of the face.
  EdgeId insert_edge(const RingPlace& left, const RingPlace& right);
  /// O(1) but for a split component (linear in one of the parts) or merged faces (linear in one of the boundaries).
  void remove_edge(EdgeId e, const RemoveEdgeOptions& options = {});

  /// Cuts an edge in two; the left part keeps its id.
  VertexId split_edge(EdgeId e);
  /// Joins the two edges at a vertex of degree two, one to the left and one to the right; the left one keeps its id.
  /// @throws InputError if the vertex is not like that
  EdgeId merge_edges(VertexId v);

  // The frame of the unbounded plane.

  bool has_frame() const { return !frame_corner().is_none(); }
  /// A corner of the frame, the bottom left one; none without frame. O(vertices) after edits, else O(1).
  VertexId frame_corner() const;
  /// Closes the plane by a frame without ends of curves. @throws InputError if there is one
  void add_frame();
  /// Takes away an end of a curve at infinity whose edge was removed, and the frame itself if no end is left.
  void remove_frame_end(VertexId v);

 private:
  EdgeId new_edge(VertexId left, VertexId right, CellState state);
  void open_component(HalfedgeId h, FaceId face);
  void hang_antenna(HalfedgeId out, HalfedgeId arriving);
  void join_boundaries(HalfedgeId h, const RingPlace& left, const RingPlace& right);
  void split_face(HalfedgeId h, const RingPlace& left, const RingPlace& right);
  HalfedgeId link_between(HalfedgeId h, const RingPlace& left, const RingPlace& right);
  void move_into_new_face(FaceId from, FaceId to, HalfedgeId cycle);
  void relabel(HalfedgeId start, BoundaryId boundary);
  bool has_fictitious_edge(HalfedgeId start) const;
  void list(BoundaryId boundary, FaceId face);
  void unlist(BoundaryId boundary);
  void isolate(VertexId v, FaceId face);
  void unisolate(VertexId v);
  BoundaryId new_boundary(HalfedgeId h, FaceId face, bool is_outer);
  void kill(BoundaryId boundary);
  void unlink(HalfedgeId h);
  void remove_between_faces(HalfedgeId h, const RemoveEdgeOptions& options);
  void remove_in_face(HalfedgeId h, const RemoveEdgeOptions& options);
  void split_boundary(HalfedgeId first, HalfedgeId second, BoundaryId boundary);
  void empty_into(FaceId from, FaceId to);
  bool is_bare_frame(HalfedgeId start) const;
  void remove_frame(HalfedgeId start);

  Dcel& dcel_;
  const CycleGeometry& geometry_;
  const ObserverList& observers_;
  bool is_planar_;
};

}  // namespace quoin::dcel
