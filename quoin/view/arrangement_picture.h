// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "quoin/arrangement/arrangement.h"
#include "quoin/view/picture_traits.h"
#include "quoin/view/planar_picture.h"

namespace quoin {

/// What a caller says of a cell; a label or name that is empty, and facts, go with what the picture says by itself.
struct CellLook {
  PictureFill fill{};
  PictureText text{};
  EdgeStyle style = EdgeStyle::plain;  ///< of an edge
};

/// How an arrangement becomes a picture.
struct ArrangementPictureOptions {
  std::string title{};
  /// By default neighbours get different colours and unbounded faces none.
  std::function<CellLook(dcel::FaceId)> face{};
  std::function<CellLook(dcel::EdgeId)> edge{};
  std::function<CellLook(dcel::VertexId)> vertex{};
  std::function<std::string(CurveId)> curve_name{};  ///< by default "3" is the name of curve 3
  bool number_faces = false;                         ///< where there is no label: the number of the face
  bool number_edges = false;
  bool number_vertices = false;
  std::optional<PictureBox> box{};  ///< what is shown; by default all vertices, but for stray crossings of lines
};

/// Where the cells of an arrangement are.
struct CellPlaces {
  std::vector<std::optional<Point2>> vertices;  ///< none: at infinity, or dead
  std::vector<PicturePath> edges;               ///< from left to right; empty where not real
  std::vector<Point2> anchors;                  ///< points of unbounded edges to look at where there are few vertices
  bool has_unbounded_edges = false;
  PictureBox view;   ///< what is shown
  PictureBox reach;  ///< holds all vertices; edges to infinity end on its border
};

/// Chooses `view` and `reach` for the vertices and anchors.
void choose_boxes(CellPlaces& places, const std::optional<PictureBox>& box);

/// The picture of cells whose places are known. Dead and fictitious cells are left out.
PlanarPicture picture_of_cells(const dcel::Dcel& cells, const CurveHistory& history, const CellPlaces& places,
                               const ArrangementPictureOptions& options);

/// Colours for the faces such that bounded faces with a common edge differ: of five, or more where it takes more, the
/// least used one that no neighbour of smaller number has.
std::vector<std::uint32_t> colors_by_neighbours(const dcel::Dcel& cells);

/// Where the cells of an arrangement in the plane are, and what of it is shown. O(size).
template <CurveFamily F>
CellPlaces places_of(const Arrangement<F>& arrangement, const ArrangementPictureOptions& options) {
  using Traits = PictureTraits<F>;
  const dcel::Dcel& cells = arrangement.cells();
  const F& family = arrangement.family();
  const auto is_infinite = [&](dcel::VertexId v) {
    return !arrangement.has_point(v) || family.side(arrangement.point(v)) != Side::interior;
  };
  CellPlaces places;
  places.vertices.resize(cells.vertices.size());
  for (std::size_t i = 0; i < cells.vertices.size(); ++i) {
    const dcel::VertexId v(i);
    if (cells.is_real(v) && !is_infinite(v)) places.vertices[i] = family.position(arrangement.point(v));
  }
  if constexpr (F::Surface::sides.left == SideKind::infinite) {
    for (std::size_t i = 0; i < cells.edges.size(); ++i) {
      const dcel::EdgeId e(i);
      if (!cells.is_real(e) || !(is_infinite(arrangement.left(e)) || is_infinite(arrangement.right(e)))) continue;
      places.has_unbounded_edges = true;
      for (const Point2& p : Traits::anchors(family, arrangement.branch(e))) places.anchors.push_back(p);
    }
  }
  choose_boxes(places, options.box);
  places.edges.resize(cells.edges.size());
  for (std::size_t i = 0; i < cells.edges.size(); ++i) {
    const dcel::EdgeId e(i);
    if (!cells.is_real(e)) continue;
    places.edges[i] = Traits::piece(family, arrangement.branch(e), arrangement.left_point(e),
                                    arrangement.right_point(e), places.reach);
  }
  return places;
}

/// The picture of an arrangement in the plane: every real face, edge and vertex, with what is known of it.
///
/// Positions are rounded to the family's error. Unbounded faces and edges go as far as the picture does. O(size).
template <CurveFamily F>
PlanarPicture picture_of(const Arrangement<F>& arrangement, const ArrangementPictureOptions& options = {}) {
  return picture_of_cells(arrangement.cells(), arrangement.history(), places_of(arrangement, options), options);
}

}  // namespace quoin
