// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/cli/cell_outputs.h"
#include "quoin/cli/commands.h"
#include "quoin/cli/constrained_domains.h"
#include "quoin/cli/constrained_inputs.h"
#include "quoin/cli/flow_report.h"
#include "quoin/cli/planar.h"
#include "quoin/cli/planar_pictures.h"
#include "quoin/cli/reporting.h"
#include "quoin/cli/summary.h"
#include "quoin/cli/targets.h"

namespace quoin::cli {

namespace {

using Json = nlohmann::ordered_json;

Json report_of(const SegmentInput& input, const ConstrainedDelaunay2& made, const ConstrainedDomains& domains) {
  return {{"points", input.points.size()},
          {"distinct", made.given_count()},
          {"constructed_points", made.vertex_count() - made.given_count()},
          {"segments", input.segments.size()},
          {"pieces", made.pieces().size()},
          {"dimension", made.dimension()},
          {"triangles", domains.triangle_count()},
          {"inside_triangles", domains.inside_count()},
          {"domains", domains.domain_count()},
          {"largest_depth", domains.largest_depth()}};
}

/// Of all outputs but exact ones.
void tell_rounding(const ConstrainedDomains& domains, Json& report, std::vector<std::string>& warnings,
                   const Options& options, const Context& context) {
  const std::vector<Target> targets = targets_of(options);
  if (std::ranges::all_of(targets, [](const Target& target) { return target.kind == Target::Kind::cells; })) return;
  const RoundedCrossings rounding = domains.rounding(context);
  report["rounding"] = {{"points", rounding.points},
                        {"max_displacement", rounding.max_displacement},
                        {"turned_triangles", rounding.turned_triangles}};
  if (rounding.points > 0) {
    warnings.push_back(std::to_string(rounding.points) + " constructed points are no doubles: rounded by up to " +
                       Json(rounding.max_displacement).dump());
  }
  if (rounding.turned_triangles > 0) {
    warnings.push_back(std::to_string(rounding.turned_triangles) +
                       " triangles are flat or inside out by that: .qcells holds them as they are");
  }
}

void write_pictures(const ConstrainedDomains& domains, const Options& options) {
  if (!writes(options, Target::Kind::picture) && !writes(options, Target::Kind::planar_page)) return;
  PlanarPicture picture = domains.picture(options.labels);
  picture.title = planar_title(options);
  write_picture(picture, options);
}

}  // namespace

int run_constrained(const Options& options, const Context& context) {
  std::vector<std::string> warnings;
  const SegmentInput input = read_segments(options, warnings, context);
  if (input.points.empty()) throw InputError("there is nothing to triangulate");
  context.progress("triangulation", 0);
  const ConstrainedDelaunay2 made(input.points, input.segments, context);
  const ConstrainedDomains domains(made, options.inside, context);
  Json report = report_of(input, made, domains);
  if (made.dimension() < 2) warnings.emplace_back("all points lie on one line: there are no triangles");
  if (options.inside && domains.inside_count() == 0 && made.dimension() == 2)
    warnings.emplace_back("the segments enclose nothing: no triangle is inside");
  tell_rounding(domains, report, warnings, options, context);
  write_cells({.grid = [&] { return domains.grid(); },
               .mesh = [&] { return domains.mesh(); },
               .cells = [&] { return domains.exact_cells(context); }},
              options, warnings, context);
  write_pictures(domains, options);
  Json lines = report;
  lines.erase("rounding");
  const std::string text = as_text(lines);
  print_report(std::move(report), text, warnings, options);
  return 0;
}

}  // namespace quoin::cli
