// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/arrangement_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "quoin/view/cell_rings.h"
#include "quoin/view/cell_texts.h"

namespace quoin {

namespace {

using dcel::CellState;
using dcel::Dcel;
using dcel::EdgeId;
using dcel::FaceId;
using dcel::HalfedgeId;
using dcel::VertexId;

constexpr std::size_t few_vertices = 8;
constexpr std::size_t few_colors = 5;

/// Where most values are: the quartiles and three times as much around them, as far as there are values.
std::pair<double, double> bulk(std::vector<double> values) {
  std::ranges::sort(values);
  const double low = values[values.size() / 4];
  const double high = values[values.size() - 1 - values.size() / 4];
  const double margin = 1.5 * (high - low);
  return {std::max(values.front(), low - margin), std::min(values.back(), high + margin)};
}

void take(PictureText& text, PictureText own, const PictureText& callers) {
  text = std::move(own);
  if (!callers.name.empty()) text.name = callers.name;
  text.label = callers.label;
  text.facts.insert(text.facts.begin(), callers.facts.begin(), callers.facts.end());
}

class ArrangementPicture {
 public:
  ArrangementPicture(const Dcel& cells, const CurveHistory& history, const CellPlaces& places,
                     const ArrangementPictureOptions& options)
      : cells_(cells), places_(places), options_(options), texts_(cells, history, options.curve_name) {}

  PlanarPicture take_picture() {
    picture_.title = options_.title;
    picture_.box = places_.view;
    picture_.facts = texts_.of_whole();
    add_faces();
    add_edges();
    add_vertices();
    return std::move(picture_);
  }

 private:
  void add_faces() {
    const std::vector<std::uint32_t> colors =
        options_.face ? std::vector<std::uint32_t>() : colors_by_neighbours(cells_);
    for (std::size_t i = 0; i < cells_.faces.size(); ++i) {
      const FaceId f(i);
      if (!cells_.is_real(f)) continue;
      PictureFace face;
      CellLook look;
      if (options_.face)
        look = options_.face(f);
      else if (!cells_[f].is_unbounded)
        look.fill.category = colors[i];
      face.fill = look.fill;
      take(face.text, texts_.of(f), look.text);
      if (face.text.label.empty() && options_.number_faces) face.text.label = std::to_string(i);
      face.rings = face_rings(cells_, f, places_.edges, places_.reach);
      face.is_outside = cells_[f].is_unbounded && !has_outer_boundary(f);
      picture_.faces.push_back(std::move(face));
    }
  }

  void add_edges() {
    for (std::size_t i = 0; i < cells_.edges.size(); ++i) {
      const EdgeId e(i);
      if (!cells_.is_real(e)) continue;
      const CellLook look = options_.edge ? options_.edge(e) : CellLook{};
      PictureEdge edge{places_.edges[i], look.style, look.fill, {}};
      take(edge.text, texts_.of(e), look.text);
      if (edge.text.label.empty() && options_.number_edges) edge.text.label = std::to_string(i);
      picture_.edges.push_back(std::move(edge));
    }
  }

  void add_vertices() {
    for (std::size_t i = 0; i < cells_.vertices.size(); ++i) {
      const VertexId v(i);
      if (!places_.vertices[i]) continue;
      const CellLook look = options_.vertex ? options_.vertex(v) : CellLook{};
      PicturePoint point{*places_.vertices[i], 1, look.fill, {}};
      take(point.text, texts_.of(v, point.at), look.text);
      if (point.text.label.empty() && options_.number_vertices) point.text.label = std::to_string(i);
      picture_.points.push_back(std::move(point));
    }
  }

  bool has_outer_boundary(FaceId f) const {
    for (dcel::BoundaryId b = cells_[f].first_boundary; !b.is_none(); b = cells_[b].next) {
      if (cells_[b].is_outer) return true;
    }
    return false;
  }

  const Dcel& cells_;
  const CellPlaces& places_;
  const ArrangementPictureOptions& options_;
  CellTexts texts_;
  PlanarPicture picture_;
};

}  // namespace

void choose_boxes(CellPlaces& places, const std::optional<PictureBox>& box) {
  std::vector<double> xs;
  std::vector<double> ys;
  PictureBox all;
  const auto add = [&](const Point2& p) {
    xs.push_back(p.x);
    ys.push_back(p.y);
    all.add(p);
  };
  for (const auto& vertex : places.vertices) {
    if (vertex) add(*vertex);
  }
  if (xs.size() < few_vertices) std::ranges::for_each(places.anchors, add);
  if (box && !box->is_empty()) {
    places.view = *box;
  } else if (places.has_unbounded_edges && !xs.empty()) {
    const auto [left, right] = bulk(xs);
    const auto [bottom, top] = bulk(ys);
    places.view = PictureBox{{left, bottom}, {right, top}}.enlarged(0.2);
  }
  for (const Point2& p : {places.view.low, places.view.high}) {
    if (!places.view.is_empty()) all.add(p);
  }
  places.reach = all.enlarged(4);
}

PlanarPicture picture_of_cells(const Dcel& cells, const CurveHistory& history, const CellPlaces& places,
                               const ArrangementPictureOptions& options) {
  PlanarPicture picture = ArrangementPicture(cells, history, places, options).take_picture();
  if (picture.box->is_empty()) picture.box.reset();
  if (!picture.box) {
    PictureBox box;
    for (const PictureEdge& edge : picture.edges) add_to(box, edge.path);
    for (const PicturePoint& point : picture.points) box.add(point.at);
    picture.box = box.enlarged(0.06);
  }
  return picture;
}

std::vector<std::uint32_t> colors_by_neighbours(const Dcel& cells) {
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::vector<FaceId>> neighbours(cells.faces.size());
  for (std::size_t i = 0; i < cells.edges.size(); ++i) {
    if (cells.edges[i] != CellState::real) continue;
    const HalfedgeId h(EdgeId(i), false);
    const FaceId a = cells.face(h);
    const FaceId b = cells.face(h.twin());
    if (a == b || cells[a].is_unbounded || cells[b].is_unbounded) continue;
    neighbours[a.index()].push_back(b);
    neighbours[b.index()].push_back(a);
  }
  std::vector<std::uint32_t> colors(cells.faces.size(), none);
  std::vector<std::size_t> uses(few_colors);
  std::vector<bool> is_taken;
  for (std::size_t f = 0; f < colors.size(); ++f) {
    is_taken.assign(uses.size() + 1, false);
    for (const FaceId other : neighbours[f]) {
      if (colors[other.index()] != none) is_taken[colors[other.index()]] = true;
    }
    std::size_t best = uses.size();
    for (std::size_t c = 0; c < uses.size(); ++c) {
      if (!is_taken[c] && (best == uses.size() || uses[c] < uses[best])) best = c;
    }
    if (best == uses.size()) uses.push_back(0);
    ++uses[best];
    colors[f] = static_cast<std::uint32_t>(best);
  }
  return colors;
}

}  // namespace quoin
