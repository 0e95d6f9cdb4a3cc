// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/flat_sphere_picture.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "quoin/arrangement/geodesic/geodesic_polygon_set.h"
#include "quoin/view/longitude_chart.h"
#include "quoin/view/sphere_arrangement_picture.h"

namespace quoin {

namespace {

using dcel::EdgeId;
using dcel::FaceId;
using dcel::HalfedgeId;
using dcel::VertexId;
using longitude_chart::half_height;
using longitude_chart::half_width;

/// The half of a meridian where longitude jumps, from pole to pole.
GeodesicArrangement cut(const Context& context) {
  GeodesicFamily family;
  PieceList<GeodesicFamily> list;
  family.add_arc(list, SphereDirection(Vector3{0, 0, -1}), SphereDirection(Vector3{0, 0, 1}),
                 SphereDirection(Vector3{0, 1, 0}));
  return arrange(std::move(family), std::move(list), context);
}

/// Boundaries of the faces of an arrangement that holds the whole cut.
class Rings {
 public:
  Rings(const GeodesicArrangement& arrangement, std::uint32_t cut_curve, const Context& context)
      : arrangement_(arrangement), is_cut_(arrangement.edge_count(), false) {
    paths_.resize(arrangement.edge_count());
    for (std::size_t i = 0; i < paths_.size(); ++i) {
      if (i % 64 == 0) context.poll();
      const EdgeId edge(i);
      if (!arrangement.cells().is_real(edge)) continue;
      paths_[i] = longitude_chart::path(arrangement, edge);
      const auto uses = arrangement.curves(edge);
      is_cut_[i] =
          std::any_of(uses.begin(), uses.end(), [&](const CurveUse& use) { return use.curve().index() == cut_curve; });
    }
  }

  void append(FaceId face, std::vector<PicturePath>& out) const {
    const dcel::Dcel& cells = arrangement_.cells();
    for (dcel::BoundaryId b = cells[face].first_boundary; !b.is_none(); b = cells[b].next) {
      if (!cells[b].halfedge.is_none()) out.push_back(ring(cells[b].halfedge));
    }
  }

 private:
  /// At a pole straight steps lead along the border, from one longitude to the next.
  PicturePath ring(HalfedgeId first) const {
    std::vector<Point2> points;
    HalfedgeId h = first;
    do {
      append(h, points);
      h = arrangement_.cells().next(h);
    } while (h != first);
    return path_of(points);
  }

  /// West of the cut, which is on the left of what leads north, is the right end of the picture.
  void append(HalfedgeId h, std::vector<Point2>& points) const {
    const std::vector<Point2>& path = paths_[h.edge().index()];
    const auto add = [&](Point2 p) {
      if (is_cut_[h.edge().index()]) p.x = h.is_forward() ? half_width : -half_width;
      points.push_back(p);
    };
    if (h.is_forward()) {
      std::for_each(path.begin(), path.end(), add);
    } else {
      std::for_each(path.rbegin(), path.rend(), add);
    }
  }

  const GeodesicArrangement& arrangement_;
  std::vector<std::vector<Point2>> paths_;
  std::vector<bool> is_cut_;
};

class FlatPicture {
 public:
  FlatPicture(const GeodesicArrangement& arrangement, const ArrangementPictureOptions& options)
      : arrangement_(arrangement),
        looks_(sphere_cells_of(arrangement.cells(), arrangement.history(), sphere_places_of(arrangement), options)) {
    picture_.title = looks_.title;
    picture_.facts = looks_.facts;
    picture_.categories = looks_.categories;
    picture_.box = PictureBox{{-half_width, -half_height}, {half_width, half_height}}.enlarged(0.02);
  }

  PlanarPicture take(const Context& context) {
    add_faces(context);
    add_border();
    add_edges(context);
    add_vertices();
    return std::move(picture_);
  }

 private:
  void add_faces(const Context& context) {
    const GeodesicArrangement meridian = cut(context);
    const std::array sources{&arrangement_, &meridian};
    const Overlay<GeodesicFamily> all = overlay<GeodesicFamily>(sources, context);
    const Rings rings(all.arrangement(), arrangement_.curve_count(), context);
    std::vector<std::size_t> number(arrangement_.face_count(), 0);
    for (std::size_t i = 0, next = 0; i < number.size(); ++i) {
      if (!arrangement_.cells().is_real(FaceId(i))) continue;
      number[i] = next;
      picture_.faces.push_back({{}, false, looks_.faces[next].fill, looks_.faces[next].text});
      ++next;
    }
    for (std::size_t i = 0; i < all.arrangement().face_count(); ++i) {
      const FaceId piece(i);
      if (!all.arrangement().cells().is_real(piece)) continue;
      rings.append(piece, picture_.faces[number[all.source(piece, 0).id]].rings);
    }
  }

  void add_border() {
    constexpr double x = half_width;
    constexpr double y = half_height;
    picture_.edges.push_back({path_of({{-x, -y}, {x, -y}, {x, y}, {-x, y}, {-x, -y}}), EdgeStyle::faint, {}, {}});
  }

  void add_edges(const Context& context) {
    std::size_t number = 0;
    for (std::size_t i = 0; i < arrangement_.edge_count(); ++i) {
      if (i % 64 == 0) context.poll();
      const EdgeId edge(i);
      if (!arrangement_.cells().is_real(edge)) continue;
      const SphereEdge& look = looks_.edges[number++];
      std::vector<Point2> path = longitude_chart::path(arrangement_, edge);
      picture_.edges.push_back({path_of(path), look.style, look.stroke, look.text});
      const bool is_on_side = path.front().x == -half_width && path.back().x == -half_width;
      if (!is_on_side) continue;
      for (Point2& p : path) p.x = half_width;
      picture_.edges.push_back({path_of(path), look.style, look.stroke, look.text});
    }
  }

  void add_vertices() {
    std::size_t number = 0;
    for (std::size_t i = 0; i < arrangement_.vertex_count(); ++i) {
      const VertexId v(i);
      if (!arrangement_.cells().is_real(v)) continue;
      const SpherePoint& look = looks_.points[number++];
      const Point2 at = longitude_chart::position(arrangement_.point(v));
      if (at.y == half_height || at.y == -half_height) {
        picture_.edges.push_back(
            {path_of({{-half_width, at.y}, {half_width, at.y}}), EdgeStyle::strong, look.fill, look.text});
        continue;
      }
      picture_.points.push_back({at, 1, look.fill, look.text});
      if (at.x == -half_width || at.x == half_width) {
        picture_.points.push_back({{-at.x, at.y}, 1, look.fill, look.text});
      }
    }
  }

  const GeodesicArrangement& arrangement_;
  SpherePicture looks_;
  PlanarPicture picture_;
};

}  // namespace

PlanarPicture flat_picture_of(const GeodesicArrangement& arrangement, const ArrangementPictureOptions& options,
                              const Context& context) {
  return FlatPicture(arrangement, options).take(context);
}

}  // namespace quoin
