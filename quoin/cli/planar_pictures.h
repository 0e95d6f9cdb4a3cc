// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "quoin/arrangement/linear/linear_polygon_set.h"
#include "quoin/base/context.h"
#include "quoin/cli/options.h"
#include "quoin/cli/planar.h"
#include "quoin/view/arrangement_picture.h"
#include "quoin/view/circular_picture.h"

namespace quoin::cli {

/// Writes a picture to the outputs that show one: SVG and pages.
void write_picture(const PlanarPicture& picture, const Options& options);

/// The same of an arrangement, with the names of its curves and perhaps labels of its faces.
template <class F>
void write_pictures(const Arrangement<F>& arrangement, const std::vector<std::string>& names,
                    const std::function<std::string(dcel::FaceId)>& face_label, const Options& options) {
  if (options.outputs.empty()) return;
  ArrangementPictureOptions how;
  how.title = planar_title(options);
  how.number_faces = options.labels && !face_label;
  how.number_edges = how.number_vertices = options.labels;
  how.curve_name = [&](CurveId curve) { return curve.index() < names.size() ? names[curve.index()] : std::string(); };
  if (face_label) {
    const std::vector<std::uint32_t> colors = colors_by_neighbours(arrangement.cells());
    how.face = [&, colors](dcel::FaceId f) {
      CellLook look;
      if (!arrangement.cells()[f].is_unbounded) look.fill.category = colors[f.index()];
      if (options.labels) look.text.label = face_label(f);
      look.text.facts.emplace_back("Source faces", face_label(f));
      return look;
    };
  }
  write_picture(picture_of(arrangement, how), options);
}

/// A point set: its members filled.
template <class F>
void write_set_picture(const PolygonSet<F>& set, const Options& options) {
  if (options.outputs.empty()) return;
  ArrangementPictureOptions how;
  how.title = planar_title(options);
  how.number_vertices = options.labels;
  how.face = [&](dcel::FaceId f) {
    CellLook look;
    if (set.contains(f)) look.fill.category = 0;
    look.text.facts.emplace_back("Member", set.contains(f) ? "yes" : "no");
    return look;
  };
  how.edge = [&](dcel::EdgeId e) {
    CellLook look;
    if (!set.contains(e)) look.style = EdgeStyle::dashed;
    return look;
  };
  write_picture(picture_of(set.arrangement(), how), options);
}

/// A sum with its tight places inside.
void write_sum_picture(const LinearPolygonSet& sum, const LinearPolygonSet& tight, const Options& options,
                       const Context& context);

}  // namespace quoin::cli
