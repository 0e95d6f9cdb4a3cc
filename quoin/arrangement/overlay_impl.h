// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <utility>

#include "quoin/arrangement/face_walk.h"
#include "quoin/arrangement/overlay.h"
#include "quoin/arrangement/superposition_impl.h"
#include "quoin/base/error.h"

/// Bodies of overlay.h, for the one source file per family that instantiates it.
namespace quoin {

template <CurveFamily F>
Overlay<F>::Overlay(Superposition<F> superposition, std::span<const Arrangement<F>* const> sources)
    : first_edge_(superposition.first_edge), first_vertex_(superposition.first_vertex) {
  const Arrangement<F>& drawn = superposition.arrangement;
  const std::size_t count = sources.size();
  std::vector<dcel::FaceId> label(count);
  for (std::size_t i = 0; i < count; ++i) label[i] = sources[i]->cells().base_face;
  face_of_.resize(drawn.face_count() * count);
  dcel::walk_faces(
      drawn.cells(),
      [&](dcel::HalfedgeId h) {  // into the face of the twin
        for (const CurveUse use : drawn.curves(h.edge())) {
          const auto [source, edge] = superposition.source_of(use);
          label[source] = sources[source]->cells().face(dcel::HalfedgeId(edge, h.is_forward()));
        }
      },
      [&](dcel::FaceId f) {
        std::copy(label.begin(), label.end(), face_of_.begin() + static_cast<std::ptrdiff_t>(f.index() * count));
      });
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
