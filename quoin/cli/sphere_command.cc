// SPDX-License-Identifier: Apache-2.0
#include <fstream>

#include "quoin/arrangement/geodesic/geodesic_arrangement.h"
#include "quoin/cli/commands.h"
#include "quoin/cli/failure.h"
#include "quoin/cli/inputs.h"
#include "quoin/cli/planar.h"
#include "quoin/cli/reporting.h"
#include "quoin/cli/streams.h"
#include "quoin/cli/targets.h"
#include "quoin/io/sphere_curves.h"
#include "quoin/view/sphere_arrangement_picture.h"
#include "quoin/view/sphere_page.h"

namespace quoin::cli {

namespace {

void write_page(const GeodesicArrangement& arrangement, const std::vector<std::string>& names, const Target& target,
                const Options& options) {
  ArrangementPictureOptions how;
  how.title = planar_title(options);
  how.number_faces = how.number_edges = how.number_vertices = options.labels;
  how.curve_name = [&](CurveId curve) { return names[curve.index()]; };
  const SpherePicture picture = sphere_picture_of(arrangement, how);
  if (target.is_stream()) {
    write_sphere_page(data_stream(), picture);
    flush_standard_output();
    return;
  }
  std::ofstream file(target.name);
  if (!file) throw FileError(target.name + ": cannot be opened for writing");
  write_sphere_page(file, picture);
  if (!file.flush()) throw FileError(target.name + ": cannot be written");
}

}  // namespace

int run_arrange_on_sphere(const Options& options, const Context& context) {
  const std::vector<Target> targets = targets_of(options);
  for (const Target& target : targets) {
    if (target.kind != Target::Kind::planar_page) {
      throw UsageError(target.name + ": arrangements on the sphere are written as pages (html)");
    }
  }
  GeodesicFamily family;
  PieceList<GeodesicFamily> list;
  std::vector<std::string> names;
  for (const std::string& input : options.inputs) {
    read_sphere_curves(read_all(input), shown(input), family, list, names);
  }
  const GeodesicArrangement arrangement = arrange(std::move(family), std::move(list), context);
  const dcel::Counts counts = arrangement.counts();
  for (const Target& target : targets) write_page(arrangement, names, target, options);
  nlohmann::ordered_json json{{"vertices", counts.vertices},
                              {"edges", counts.edges},
                              {"faces", counts.faces},
                              {"components", counts.components},
                              {"isolated_vertices", counts.isolated_vertices},
                              {"curves", arrangement.curve_count()}};
  const std::string text = std::to_string(counts.vertices) + " vertices, " + std::to_string(counts.edges) + " edges, " +
                           std::to_string(counts.faces) + " faces on the sphere\n";
  print_report(std::move(json), text, {}, options);
  return 0;
}

}  // namespace quoin::cli
