// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <utility>

#include "quoin/arrangement/sets/overlay.h"
#include "quoin/arrangement/sets/superposition_impl.h"
#include "quoin/base/error.h"

/// Bodies of overlay.h, for the one source file per family that instantiates it.
namespace quoin {

namespace overlay_detail {

/// For each face and source, the source's face around it. Edges tell those of the faces beside them; from there labels
/// spread over edges of other sources, on both sides of which they are the same.
template <CurveFamily F>
class SourceFaces {
 public:
  SourceFaces(const Superposition<F>& drawn, std::span<const Arrangement<F>* const> sources)
      : drawn_(drawn),
        cells_(drawn.arrangement.cells()),
        sources_(sources),
        labels_(cells_.faces.size() * sources.size()) {}

  std::vector<dcel::FaceId> run() {
    for (std::size_t c = 0; c < sources_.size(); ++c) label(cells_.base_face, c) = sources_[c]->cells().base_face;
    read_edges();
    // Faces that lack a label ask their neighbours, and give what they get on to others that lack it.
    for (std::size_t f = 0; f < cells_.faces.size(); ++f) {
      const dcel::FaceId face(f);
      if (!cells_.is_real(face)) continue;
      if (take_from_neighbours(face)) spread_from(face);
    }
    return std::move(labels_);
  }

 private:
  dcel::FaceId& label(dcel::FaceId f, std::size_t source) { return labels_[f.index() * sources_.size() + source]; }

  void read_edges() {
    for (std::size_t e = 0; e < cells_.edges.size(); ++e) {
      if (cells_.edges[e] != dcel::CellState::real) continue;
      const dcel::HalfedgeId above(dcel::EdgeId(e), false);
      for (const CurveUse use : drawn_.arrangement.curves(dcel::EdgeId(e))) {
        const auto [source, edge] = drawn_.source_of(use);
        const dcel::Dcel& own = sources_[source]->cells();
        label(cells_.face(above), source) = own.face(dcel::HalfedgeId(edge, false));
        label(cells_.face(above.twin()), source) = own.face(dcel::HalfedgeId(edge, true));
      }
    }
  }
  template <class Call>
  void for_each_neighbour(dcel::FaceId face, const Call& call) {
    for (dcel::BoundaryId b = cells_[face].first_boundary; !b.is_none(); b = cells_[b].next) {
      const dcel::HalfedgeId first = cells_[b].halfedge;
      dcel::HalfedgeId h = first;
      do {
        if (cells_.is_real(h.edge())) call(cells_.face(h.twin()));
        h = cells_.next(h);
      } while (h != first);
    }
  }
  bool is_complete(dcel::FaceId face) {
    for (std::size_t c = 0; c < sources_.size(); ++c) {
      if (label(face, c).is_none()) return false;
    }
    return true;
  }
  bool copy_missing(dcel::FaceId from, dcel::FaceId to) {
    bool any = false;
    for (std::size_t c = 0; c < sources_.size(); ++c) {
      if (!label(to, c).is_none() || label(from, c).is_none()) continue;
      label(to, c) = label(from, c);
      any = true;
    }
    return any;
  }
  bool take_from_neighbours(dcel::FaceId face) {
    if (is_complete(face)) return false;
    bool any = false;
    for_each_neighbour(face, [&](dcel::FaceId neighbour) { any = copy_missing(neighbour, face) || any; });
    return any;
  }
  void spread_from(dcel::FaceId start) {
    pending_.assign(1, start);
    while (!pending_.empty()) {
      const dcel::FaceId face = pending_.back();
      pending_.pop_back();
      for_each_neighbour(face, [&](dcel::FaceId neighbour) {
        if (copy_missing(face, neighbour)) pending_.push_back(neighbour);
      });
    }
  }

  const Superposition<F>& drawn_;
  const dcel::Dcel& cells_;
  std::span<const Arrangement<F>* const> sources_;
  std::vector<dcel::FaceId> labels_;
  std::vector<dcel::FaceId> pending_;
};

template <CurveFamily F>
std::vector<dcel::FaceId> source_faces(const Superposition<F>& drawn, std::span<const Arrangement<F>* const> sources) {
  return SourceFaces<F>(drawn, sources).run();
}

}  // namespace overlay_detail

template <CurveFamily F>
Overlay<F>::Overlay(Superposition<F> superposition, std::span<const Arrangement<F>* const> sources)
    : first_edge_(superposition.first_edge), first_vertex_(superposition.first_vertex) {
  const Arrangement<F>& drawn = superposition.arrangement;
  face_of_ = overlay_detail::source_faces(superposition, sources);
  for (std::size_t v = 0; v < superposition.vertex_of_source.size(); ++v) {
    const dcel::VertexId vertex = superposition.vertex_of_source[v];
    if (!vertex.is_none()) coincidences_.push_back({vertex.value, static_cast<std::uint32_t>(v)});
  }
  std::sort(coincidences_.begin(), coincidences_.end(), [](const Coincidence& a, const Coincidence& b) {
    return std::pair(a.vertex, a.source_vertex) < std::pair(b.vertex, b.source_vertex);
  });
  std::vector<std::uint32_t> first_curve{0};
  for (const Arrangement<F>* source : sources) first_curve.push_back(first_curve.back() + source->curve_count());
  CurveHistory history;
  std::vector<CurveUse> uses;
  for (std::size_t e = 0; e < drawn.edge_count(); ++e) {
    uses.clear();
    for (const CurveUse use : drawn.curves(dcel::EdgeId(e))) {
      const auto [source, edge] = superposition.source_of(use);
      for (const CurveUse original : sources[source]->curves(edge)) {
        uses.emplace_back(CurveId(std::size_t{first_curve[source]} + original.curve().index()), original.is_reversed());
      }
    }
    std::sort(uses.begin(), uses.end());
    history.append(uses);
  }
  source_edges_ = drawn.history();
  arrangement_ = std::move(superposition.arrangement);
  arrangement_.set_history(std::move(history), first_curve.back());
}

template <CurveFamily F>
SourceCell Overlay<F>::source(dcel::EdgeId e, std::size_t source) const {
  for (const CurveUse use : source_edges_.of(e)) {
    const std::uint32_t global = use.curve().value;
    if (first_edge_[source] <= global && global < first_edge_[source + 1]) {
      return {SourceCell::Kind::edge, global - first_edge_[source]};
    }
  }
  return this->source(arrangement_.cells().face(dcel::HalfedgeId(e, false)), source);
}

template <CurveFamily F>
SourceCell Overlay<F>::source(dcel::VertexId v, std::size_t source) const {
  const auto first =
      std::lower_bound(coincidences_.begin(), coincidences_.end(), std::pair(v.value, first_vertex_[source]),
                       [](const Coincidence& c, const std::pair<std::uint32_t, std::uint32_t>& key) {
                         return std::pair(c.vertex, c.source_vertex) < key;
                       });
  if (first != coincidences_.end() && first->vertex == v.value && first->source_vertex < first_vertex_[source + 1]) {
    return {SourceCell::Kind::vertex, first->source_vertex - first_vertex_[source]};
  }
  const dcel::Dcel& cells = arrangement_.cells();
  if (cells.is_isolated(v)) return this->source(cells[v].face, source);
  dcel::HalfedgeId out = cells[v].out;
  do {
    if (cells.is_real(out.edge())) {
      const SourceCell cell = this->source(out.edge(), source);
      if (cell.kind == SourceCell::Kind::edge) return cell;
    }
    out = cells.clockwise(out);
  } while (out != cells[v].out);
  return this->source(cells.face(out), source);
}

template <CurveFamily F>
Overlay<F> overlay(std::span<const Arrangement<F>* const> sources, const Context& context) {
  return Overlay<F>(superpose(sources, context), sources);
}

namespace overlay_detail {

using Kind = SourceCell::Kind;

inline dcel::VertexId vertex(const SourceCell& cell) {
  return dcel::VertexId(std::size_t{cell.id});
}
inline dcel::EdgeId edge(const SourceCell& cell) {
  return dcel::EdgeId(std::size_t{cell.id});
}
inline dcel::FaceId face(const SourceCell& cell) {
  return dcel::FaceId(std::size_t{cell.id});
}

template <CurveFamily F>
void visit_vertex(OverlayVisitor<F>& visitor, dcel::VertexId v, const SourceCell& red, const SourceCell& blue) {
  if (red.kind == Kind::vertex) {
    if (blue.kind == Kind::vertex) return visitor.vertex_on_vertex(v, vertex(red), vertex(blue));
    if (blue.kind == Kind::edge) return visitor.vertex_on_edge(v, vertex(red), edge(blue));
    return visitor.vertex_in_face(v, vertex(red), face(blue));
  }
  if (blue.kind == Kind::edge) return visitor.crossing(v, edge(red), edge(blue));
  if (red.kind == Kind::edge) return visitor.edge_on_vertex(v, edge(red), vertex(blue));
  visitor.face_around_vertex(v, face(red), vertex(blue));
}

template <CurveFamily F>
void visit_edge(OverlayVisitor<F>& visitor, dcel::EdgeId e, const SourceCell& red, const SourceCell& blue) {
  if (red.kind == Kind::face) return visitor.face_around_edge(e, face(red), edge(blue));
  if (blue.kind == Kind::face) return visitor.edge_in_face(e, edge(red), face(blue));
  visitor.overlap(e, edge(red), edge(blue));
}

}  // namespace overlay_detail

template <CurveFamily F>
void visit_cells(const Overlay<F>& overlay, OverlayVisitor<F>& visitor) {
  if (overlay.source_count() != 2) throw InputError("an overlay of two arrangements is needed");
  const dcel::Dcel& cells = overlay.arrangement().cells();
  for (std::size_t i = 0; i < cells.vertices.size(); ++i) {
    const dcel::VertexId v(i);
    if (cells.is_real(v)) overlay_detail::visit_vertex(visitor, v, overlay.source(v, 0), overlay.source(v, 1));
  }
  for (std::size_t i = 0; i < cells.edges.size(); ++i) {
    const dcel::EdgeId e(i);
    if (cells.is_real(e)) overlay_detail::visit_edge(visitor, e, overlay.source(e, 0), overlay.source(e, 1));
  }
  for (std::size_t i = 0; i < cells.faces.size(); ++i) {
    const dcel::FaceId f(i);
    if (!cells.is_real(f)) continue;
    visitor.face(f, overlay_detail::face(overlay.source(f, 0)), overlay_detail::face(overlay.source(f, 1)));
  }
}

}  // namespace quoin
