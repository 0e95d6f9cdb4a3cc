// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/drawing_curves.h"

#include <algorithm>

#include "quoin/base/error.h"

namespace quoin {

namespace {

/// All pieces from `first` on become one curve.
template <class F>
void join_as_one_curve(PieceList<F>& list, std::size_t first, std::uint32_t curve) {
  for (std::size_t i = first; i < list.pieces.size(); ++i) list.pieces[i].curve = CurveId(std::size_t{curve});
  list.curve_count = curve + 1;
}

void add_path(LinearFamily& family, PieceList<LinearFamily>& list, const DrawingPath& path, const std::string& name) {
  for (std::size_t e = 0; e < path.edge_count(); ++e) {
    if (path.bulge(e) != 0) throw InputError(name + ": it has arcs");
  }
  family.add_polyline(list, path.points, path.is_closed, name);
}

void add_path(CircularFamily& family, PieceList<CircularFamily>& list, const DrawingPath& path,
              const std::string& name) {
  if (path.edge_count() == 0) throw InputError(name + ": a path needs an edge");
  const std::size_t first = list.pieces.size();
  const std::uint32_t curve = list.curve_count;
  for (std::size_t e = 0; e < path.edge_count(); ++e) {
    family.add_bulge_arc(list, path.start(e), path.end(e), path.bulge(e), name + ", edge " + std::to_string(e));
  }
  join_as_one_curve(list, first, curve);
}

void add_circle(LinearFamily&, PieceList<LinearFamily>&, const DrawingCircle&, const std::string& name) {
  throw InputError(name + ": a circle among lines");
}
void add_circle(CircularFamily& family, PieceList<CircularFamily>& list, const DrawingCircle& circle,
                const std::string& name) {
  family.add_circle(list, circle.center, circle.radius, name);
}

template <class F>
void add_all_curves(F& family, PieceList<F>& list, const Drawing& drawing, std::vector<std::string>& names) {
  check_drawing(drawing);
  for (const DrawingElement& element : drawing.elements) {
    switch (element.kind()) {
      case DrawingKind::point:
        family.add_point(list, std::get<Point2>(element.shape), element.name);
        break;
      case DrawingKind::path:
        add_path(family, list, std::get<DrawingPath>(element.shape), element.name);
        break;
      case DrawingKind::circle:
        add_circle(family, list, std::get<DrawingCircle>(element.shape), element.name);
        break;
      case DrawingKind::polygon: {
        const auto& rings = std::get<DrawingPolygon>(element.shape).rings;
        for (std::size_t r = 0; r < rings.size(); ++r) {
          names.push_back(element.name + ", ring " + std::to_string(r + 1));
          add_path(family, list, rings[r], names.back());
        }
        continue;
      }
    }
    names.push_back(element.name);
  }
}

template <class F>
void add_all_regions(F& family, PieceList<F>& list, const Drawing& drawing, RegionCurves& curves) {
  check_drawing(drawing);
  const auto add = [&](const std::string& name, std::size_t element, bool is_hole) {
    curves.names.push_back(name);
    curves.elements.push_back(static_cast<std::uint32_t>(element));
    curves.is_hole.push_back(is_hole);
  };
  for (std::size_t i = 0; i < drawing.elements.size(); ++i) {
    const DrawingElement& element = drawing.elements[i];
    const auto* polygon = std::get_if<DrawingPolygon>(&element.shape);
    curves.rules.push_back(polygon == nullptr ? FillRule::even_odd : polygon->fill);
    if (element.kind() == DrawingKind::circle) {
      add_circle(family, list, std::get<DrawingCircle>(element.shape), element.name);
      add(element.name, i, false);
    } else if (polygon != nullptr) {
      for (std::size_t r = 0; r < polygon->rings.size(); ++r) {
        const std::string name = element.name + ", ring " + std::to_string(r + 1);
        add_path(family, list, polygon->rings[r], name);
        add(name, i, r > 0);
      }
    } else if (element.kind() == DrawingKind::path && std::get<DrawingPath>(element.shape).is_closed) {
      add_path(family, list, std::get<DrawingPath>(element.shape), element.name);
      add(element.name, i, false);
    } else {
      curves.ignored.push_back(element.name);
    }
  }
}

}  // namespace

bool has_arcs(const Drawing& drawing) {
  const auto is_curved = [](const DrawingPath& path) {
    return std::any_of(path.bulges.begin(), path.bulges.end(), [](double bulge) { return bulge != 0; });
  };
  return std::any_of(drawing.elements.begin(), drawing.elements.end(), [&](const DrawingElement& element) {
    if (element.kind() == DrawingKind::circle) return true;
    if (element.kind() == DrawingKind::path) return is_curved(std::get<DrawingPath>(element.shape));
    if (element.kind() != DrawingKind::polygon) return false;
    const auto& rings = std::get<DrawingPolygon>(element.shape).rings;
    return std::any_of(rings.begin(), rings.end(), is_curved);
  });
}

void add_curves(LinearFamily& family, PieceList<LinearFamily>& list, const Drawing& drawing,
                std::vector<std::string>& names) {
  add_all_curves(family, list, drawing, names);
}
void add_curves(CircularFamily& family, PieceList<CircularFamily>& list, const Drawing& drawing,
                std::vector<std::string>& names) {
  add_all_curves(family, list, drawing, names);
}

void add_regions(LinearFamily& family, PieceList<LinearFamily>& list, const Drawing& drawing, RegionCurves& curves) {
  add_all_regions(family, list, drawing, curves);
}
void add_regions(CircularFamily& family, PieceList<CircularFamily>& list, const Drawing& drawing,
                 RegionCurves& curves) {
  add_all_regions(family, list, drawing, curves);
}

}  // namespace quoin
