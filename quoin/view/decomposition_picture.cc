// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/decomposition_picture.h"

#include <map>
#include <string>

namespace quoin {

namespace {

using dcel::Dcel;
using dcel::EdgeId;
using dcel::HalfedgeId;

class DecompositionPicture {
 public:
  DecompositionPicture(const Dcel& cells, const CellPlaces& places) : cells_(cells), places_(places) {}

  PictureFace cell(const PseudoTrapezoid& t) const {
    PictureFace face;
    face.rings.push_back(ring_between(bottom(t), top(t)));
    return face;
  }

  /// From the bottom of the cell to its top at the wall's vertex.
  PicturePath left_wall(const PseudoTrapezoid& t) const { return path_of({bottom(t).start, top(t).start}); }
  PicturePath right_wall(const PseudoTrapezoid& t) const { return path_of({bottom(t).end(), top(t).end()}); }
  bool has_wall(dcel::VertexId v) const { return !v.is_none() && places_.vertices[v.index()].has_value(); }

 private:
  double x_of(dcel::VertexId v, double otherwise) const {
    if (v.is_none()) return otherwise;
    if (has_wall(v)) return places_.vertices[v.index()]->x;
    // The end of a vertical line at infinity.
    HalfedgeId h = cells_[v].out;
    while (!cells_.is_real(h.edge())) {
      h = cells_.clockwise(h);
      if (h == cells_[v].out) return otherwise;
    }
    return places_.edges[h.edge().index()].start.x;
  }
  double left(const PseudoTrapezoid& t) const { return x_of(t.left, places_.reach.low.x); }
  double right(const PseudoTrapezoid& t) const { return x_of(t.right, places_.reach.high.x); }

  PicturePath top(const PseudoTrapezoid& t) const {
    if (t.top.is_none()) return path_of({{left(t), places_.reach.high.y}, {right(t), places_.reach.high.y}});
    return chain(t, HalfedgeId(t.top, true));
  }
  PicturePath bottom(const PseudoTrapezoid& t) const {
    if (t.bottom.is_none()) return path_of({{left(t), places_.reach.low.y}, {right(t), places_.reach.low.y}});
    return chain(t, HalfedgeId(t.bottom, false));
  }

  /// Edges from the left wall to the right one. The cell lies on the left of the halfedge: at the top it runs back, and
  /// what comes before it is further right.
  PicturePath chain(const PseudoTrapezoid& t, HalfedgeId h) const {
    const bool is_forward = h.is_forward();
    PicturePath path = places_.edges[h.edge().index()];
    while (path.end().x < right(t)) {
      h = is_forward ? cells_.next(h) : cells_.previous(h);
      if (h.is_forward() != is_forward || !cells_.is_real(h.edge())) break;
      append(path, places_.edges[h.edge().index()]);
    }
    // A line that leaves the top or the bottom of what is drawn goes on along it.
    PicturePath part = between_x(path, left(t), right(t));
    if (part.end().x < right(t)) part.steps.push_back(line_to({right(t), part.end().y}));
    if (part.start.x <= left(t)) return part;
    PicturePath whole{{left(t), part.start.y}, {}};
    append(whole, part);
    return whole;
  }

  const Dcel& cells_;
  const CellPlaces& places_;
};

}  // namespace

void show_decomposition(PlanarPicture& picture, const Dcel& cells, const CellPlaces& places,
                        const VerticalDecomposition& decomposition) {
  const DecompositionPicture parts(cells, places);
  std::map<std::uint32_t, PictureFill> fills;  // by face
  std::uint32_t place = 0;
  for (std::uint32_t f = 0; f < cells.faces.size(); ++f) {
    if (cells.is_real(dcel::FaceId(f))) fills[f] = picture.faces[place++].fill;
  }
  picture.faces.clear();
  for (std::size_t i = 0; i < decomposition.trapezoids.size(); ++i) {
    const PseudoTrapezoid& t = decomposition.trapezoids[i];
    if (!t.has_width) continue;
    PictureFace face = parts.cell(t);
    face.fill = fills[t.face.value];
    const auto edge = [](EdgeId e) { return e.is_none() ? std::string("none") : std::to_string(e.index()); };
    face.text = {
        "Cell " + std::to_string(i),
        "",
        {{"Of face", std::to_string(t.face.index())}, {"Edge above", edge(t.top)}, {"Edge below", edge(t.bottom)}}};
    picture.faces.push_back(std::move(face));
    const auto add_wall = [&](dcel::VertexId v, PicturePath wall) {
      if (!parts.has_wall(v) || wall.start == wall.end()) return;
      picture.edges.push_back(
          {std::move(wall), EdgeStyle::dashed, {}, {"Wall", "", {{"Through vertex", std::to_string(v.index())}}}});
    };
    add_wall(t.left, parts.left_wall(t));
    add_wall(t.right, parts.right_wall(t));
  }
}

}  // namespace quoin
