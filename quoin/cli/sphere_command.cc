// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/geodesic/geodesic_arrangement.h"
#include "quoin/cli/commands.h"
#include "quoin/cli/inputs.h"
#include "quoin/cli/planar.h"
#include "quoin/cli/reporting.h"
#include "quoin/cli/sphere_pictures.h"
#include "quoin/io/sphere_curves.h"

namespace quoin::cli {

int run_arrange_on_sphere(const Options& options, const Context& context) {
  require_pictures(options);
  GeodesicFamily family;
  PieceList<GeodesicFamily> list;
  std::vector<std::string> names;
  for (const std::string& input : options.inputs) {
    read_sphere_curves(read_all(input), shown(input), family, list, names);
  }
  const GeodesicArrangement arrangement = arrange(std::move(family), std::move(list), context);
  const dcel::Counts counts = arrangement.counts();
  ArrangementPictureOptions how;
  how.curve_name = [&](CurveId curve) { return names[curve.index()]; };
  write_sphere_pictures(arrangement, how, options, context);
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
