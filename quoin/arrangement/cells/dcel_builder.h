// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "quoin/arrangement/cells/dcel.h"
#include "quoin/arrangement/surface.h"
#include "quoin/base/disjoint_sets.h"

namespace quoin::dcel {

/// What the sweep meets at one point, without geometry.
struct LinkEvent {
  Side side = Side::interior;
  std::span<const std::uint32_t> left;    ///< edges that end there, bottom to top
  std::span<const std::uint32_t> right;   ///< edges that start there, bottom to top
  std::uint32_t below = 0xFFFFFFFFU;      ///< edge just below, or none
  std::uint32_t left_copy = 0xFFFFFFFFU;  ///< on an identified right side: the event of the same point on the left side
};

/// Links the edges that a sweep reports into a subdivision of a surface.
///
/// Rings around vertices come with the events. Faces are found by union and find: at every vertex without edges to the
/// left, the boundary of the wedge to its left and the one just above the edge below belong to one face. No
/// orientation is tested, so the same holds on every surface; its sides add what follows from their kinds:
///   - infinite sides get a frame of fictitious edges through the ends of curves;
///   - a contracted side is one vertex, its ring ordered along the side;
///   - the two copies of a point on an identified pair are one vertex, and between vertices that follow each other on
///   the
///     identification with no edge between them the face is the same on both sides.
/// Linear but for the inverse of Ackermann's function.
class DcelBuilder {
 public:
  static constexpr std::uint32_t none = 0xFFFFFFFFU;

  void reserve(std::size_t events, std::size_t edges);
  /// Events come in lexicographic order and are numbered from 0; edges are numbered as they start.
  void add_event(const LinkEvent& event);

  struct Result {
    Dcel dcel;
    /// By event; empty where every event is the vertex of its number, as without curves that reach a side.
    std::vector<VertexId> vertex_of_event;
  };
  /// The builder is empty afterwards.
  Result finish(SideKinds kinds, bool has_unbounded_face);

 private:
  struct Extreme {  // an event without edges to the left
    std::uint32_t event;
    std::uint32_t below;
    std::uint32_t bottom_count;  // events with edges on the bottom side that came before
  };
  struct SideEvent {
    std::uint32_t event;
    Side side;
    std::uint32_t left_copy;
    std::vector<HalfedgeId> up;          // out of the vertex to the right, bottom to top
    std::vector<HalfedgeId> down;        // out of the vertex to the left, top to bottom
    std::vector<HalfedgeId> after_copy;  // of a left copy: what the right copy adds
  };

  void start_edges(std::uint32_t event, std::span<const std::uint32_t> edges);
  void link_ring(std::uint32_t vertex, std::span<const HalfedgeId> outgoing);
  std::uint32_t class_below(const Extreme& extreme) const;

  void join_infinite_sides();
  struct FramePlace {  // a vertex of the frame and the halfedge that leaves it inwards, if any
    std::uint32_t vertex;
    HalfedgeId inwards;
  };
  void link_frame(std::span<const FramePlace> frame);
  std::uint32_t add_corner();
  void join_contracted_side(Side side);
  void join_identified_sides();
  void set_origins(std::uint32_t vertex, std::span<const HalfedgeId> outgoing);

  void trace_boundaries();
  void unite_faces();
  void unite_across_identification();
  std::uint32_t boundary_class(HalfedgeId h) const { return dcel_[h].boundary.value; }
  void number_faces();
  FaceId add_face(std::uint32_t root);
  void hang_boundaries();
  void mark_outer_boundaries();
  void hang_isolated_vertices();
  Result number_vertices();

  Dcel dcel_;
  SideKinds kinds_{};
  bool has_unbounded_face_ = true;
  std::uint32_t event_count_ = 0;
  std::vector<Extreme> extremes_;
  std::vector<SideEvent> sides_;
  std::vector<HalfedgeId> ring_;  // scratch
  std::uint32_t bottom_count_ = 0;
  std::vector<HalfedgeId> bottom_edges_;                           // out of the bottom side, in order
  std::vector<HalfedgeId> top_edges_;                              // out of the top side, in order
  std::vector<HalfedgeId> frame_bottom_;                           // fictitious edges along the bottom, in order
  std::vector<std::uint32_t> merged_into_;                         // by event; itself if not merged
  std::vector<std::pair<std::uint32_t, std::uint32_t>> isolated_;  // vertex and class
  std::vector<std::pair<std::uint32_t, Side>> lone_poles_;
  std::vector<FaceId> face_of_class_;
  std::optional<DisjointSets> classes_;  // of boundaries, and of two places that no boundary stands for
  std::uint32_t low_class_ = 0;          // the face at the bottom where no edge is: outside, or around the south pole
  std::uint32_t high_class_ = 0;         // around the north pole
};

}  // namespace quoin::dcel
