// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/cli/commands.h"
#include "quoin/cli/inputs.h"
#include "quoin/cli/planar.h"
#include "quoin/cli/planar_pictures.h"
#include "quoin/cli/polytope_inputs.h"
#include "quoin/cli/sphere_pictures.h"
#include "quoin/cli/summary.h"
#include "quoin/polytope/cubical_map.h"
#include "quoin/polytope/gaussian_map.h"
#include "quoin/view/cube_picture.h"

namespace quoin::cli {

namespace {

using Json = nlohmann::ordered_json;

std::string name_of(const Polytope& p, std::uint32_t v) {
  return "vertex " + std::to_string(v) + " at " + Json{p.vertex(v).x, p.vertex(v).y, p.vertex(v).z}.dump();
}

Json counts_of(const Polytope& p) {
  return {{"vertices", p.vertex_count()}, {"edges", p.edge_count()}, {"facets", p.facet_count()}};
}

Json as_json(const CubicalMap::Counts& counts) {
  return {{"vertices", counts.vertices}, {"edges", counts.edges}, {"faces", counts.faces}};
}

int report_on_sphere(const Polytope& p, const std::vector<std::string>& warnings, const Options& options,
                     const Context& context) {
  const GaussianMap map = gaussian_map(p, context);
  ArrangementPictureOptions how;
  how.face = [&](dcel::FaceId face) {
    const std::uint32_t v = map.vertex_of_face[face.index()];
    CellLook look;
    look.fill.category = v;
    look.text.name = name_of(p, v);
    if (options.labels) look.text.label = std::to_string(v);
    return look;
  };
  how.curve_name = [&](CurveId curve) {
    const MapArc& arc = map.arcs[curve.index()];
    return "edge " + std::to_string(arc.tail) + " - " + std::to_string(arc.head);
  };
  write_sphere_pictures(map.arrangement, how, options, context);
  const dcel::Counts found = map.arrangement.counts();
  Json report{{"vertices", found.vertices}, {"edges", found.edges}, {"faces", found.faces}};
  report["polytope"] = counts_of(p);
  const std::string text = as_text(report);
  print_report(std::move(report), text, warnings, options);
  return 0;
}

int report_on_cube(const Polytope& p, const std::vector<std::string>& warnings, const Options& options,
                   const Context& context) {
  const CubicalMap map = cubical_map(p, context);
  if (!options.outputs.empty()) {
    CubePictureOptions how;
    how.title = planar_title(options);
    how.vertex_name = [&](std::uint32_t v) { return name_of(p, v); };
    how.has_labels = options.labels;
    write_picture(cube_picture_of(map, how), options);
  }
  Json report = as_json(map.counts());
  Json squares = Json::array();
  std::string lines;
  for (std::size_t s = 0; s < cube::square_count; ++s) {
    const std::string name = cube_square_name(s);
    Json square = as_json(map.counts(s));
    lines += "square " + name + std::string(15 - name.size(), ' ');
    for (const auto& [key, value] : square.items()) lines += value.dump() + " " + key + (key == "faces" ? "\n" : ", ");
    square["square"] = name;
    squares.push_back(std::move(square));
  }
  report["polytope"] = counts_of(p);
  const std::string text = as_text(report) + lines;
  report["squares"] = std::move(squares);
  print_report(std::move(report), text, warnings, options);
  return 0;
}

}  // namespace

int run_gaussian_map(const Options& options, const Context& context) {
  require_pictures(options);
  std::vector<std::string> warnings;
  const std::string& name = options.inputs[0];
  const Polytope p = read_polytope(name, options, warnings, context);
  if (options.cube && p.dimension() < 2)
    throw InputError(shown(name) + ": a point or a segment has no map on the cube");
  return options.cube ? report_on_cube(p, warnings, options, context) : report_on_sphere(p, warnings, options, context);
}

}  // namespace quoin::cli
