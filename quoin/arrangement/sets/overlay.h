// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quoin/arrangement/sets/superposition.h"

namespace quoin {

/// A cell of a source arrangement.
struct SourceCell {
  enum class Kind : std::uint8_t { vertex, edge, face };
  Kind kind = Kind::face;
  std::uint32_t id = 0;

  friend bool operator==(const SourceCell&, const SourceCell&) = default;
};

/// The common refinement of several arrangements. Every cell of it lies in one cell of each source.
template <CurveFamily F>
class Overlay {
 public:
  Overlay(Superposition<F> superposition, std::span<const Arrangement<F>* const> sources);

  /// Curves of the sources in order: those of source i follow those of source i - 1.
  const Arrangement<F>& arrangement() const { return arrangement_; }
  std::size_t source_count() const { return first_edge_.size() - 1; }

  /// The cell of a source that holds the whole cell. O(1) for faces, O(sources of the edge), O(degree) for vertices.
  SourceCell source(dcel::FaceId f, std::size_t source) const {
    return {SourceCell::Kind::face, face_of_[f.index() * source_count() + source].value};
  }
  SourceCell source(dcel::EdgeId e, std::size_t source) const;
  SourceCell source(dcel::VertexId v, std::size_t source) const;

 private:
  Arrangement<F> arrangement_;
  CurveHistory source_edges_;
  std::vector<std::uint32_t> first_edge_;
  std::vector<std::uint32_t> first_vertex_;
  struct Coincidence {  // a vertex of the overlay and a source's vertex there, counted over all
    std::uint32_t vertex;
    std::uint32_t source_vertex;
  };
  std::vector<Coincidence> coincidences_;  // sorted
  std::vector<dcel::FaceId> face_of_;      // by face, then source
};

/// Overlays any number of arrangements by one sweep: O((n + k) log n), and for each face one label per source.
/// @throws Cancelled
template <CurveFamily F>
Overlay<F> overlay(std::span<const Arrangement<F>* const> sources, const Context& context);

/// What to do with the cells of an overlay of two: the ten ways in which a cell of the overlay comes from cells of a
/// red and a blue arrangement.
template <CurveFamily F>
class OverlayVisitor {
 public:
  virtual ~OverlayVisitor() = default;
  virtual void vertex_on_vertex(dcel::VertexId, dcel::VertexId /*red*/, dcel::VertexId /*blue*/) {}
  virtual void vertex_on_edge(dcel::VertexId, dcel::VertexId /*red*/, dcel::EdgeId /*blue*/) {}
  virtual void edge_on_vertex(dcel::VertexId, dcel::EdgeId /*red*/, dcel::VertexId /*blue*/) {}
  virtual void vertex_in_face(dcel::VertexId, dcel::VertexId /*red*/, dcel::FaceId /*blue*/) {}
  virtual void face_around_vertex(dcel::VertexId, dcel::FaceId /*red*/, dcel::VertexId /*blue*/) {}
  virtual void crossing(dcel::VertexId, dcel::EdgeId /*red*/, dcel::EdgeId /*blue*/) {}
  virtual void overlap(dcel::EdgeId, dcel::EdgeId /*red*/, dcel::EdgeId /*blue*/) {}
  virtual void edge_in_face(dcel::EdgeId, dcel::EdgeId /*red*/, dcel::FaceId /*blue*/) {}
  virtual void face_around_edge(dcel::EdgeId, dcel::FaceId /*red*/, dcel::EdgeId /*blue*/) {}
  virtual void face(dcel::FaceId, dcel::FaceId /*red*/, dcel::FaceId /*blue*/) {}
};

/// Calls the visitor once for every real vertex, edge and face of an overlay of two, in this order, each by number.
/// @throws InputError if the overlay is not of two
template <CurveFamily F>
void visit_cells(const Overlay<F>& overlay, OverlayVisitor<F>& visitor);

}  // namespace quoin
