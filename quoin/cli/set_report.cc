// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/set_report.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "quoin/arrangement/circular/circular_shapes.h"
#include "quoin/arrangement/sets/planar_area.h"
#include "quoin/cli/exact_targets.h"
#include "quoin/cli/planar.h"
#include "quoin/cli/targets.h"
#include "quoin/io/set_drawing.h"

namespace quoin::cli {

using Json = nlohmann::ordered_json;

namespace {

constexpr std::size_t short_boundary = 2000;  // edges up to which the exact area is worked out
constexpr std::size_t short_number = 60;      // digits up to which it is printed

}  // namespace

void add_area(const LinearPolygonSet& set, Json& json) {
  json["area"] = rounded_area(set);
  if (set.arrangement().edge_count() > short_boundary) return;
  const std::string exact = area(set).to_string();
  if (exact.size() <= short_number) json["exact_area"] = exact;
}

void add_area(const CircularPolygonSet& set, Json& json) {
  const CircularArrangement& arrangement = set.arrangement();
  double sum = 0;
  double error = 0;
  for (std::size_t e = 0; e < arrangement.edge_count(); ++e) {
    const dcel::EdgeId id(e);
    const bool above = set.contains(arrangement.cells().face(dcel::HalfedgeId(id, false)));
    const bool below = set.contains(arrangement.cells().face(dcel::HalfedgeId(id, true)));
    if (above == below) continue;
    const CertifiedDouble part = area_under(arrangement.family(), arrangement.branch(id), arrangement.left_point(id),
                                            arrangement.right_point(id));
    sum += below ? part.value : -part.value;
    error += part.error + 0x1p-52 * std::fabs(sum);
  }
  json["area"] = sum;
  json["area_error"] = error;
}

template <class F>
void describe_set(const PolygonSet<F>& set, SetReport& report) {
  const std::size_t polygons = set.is_unbounded() ? 0 : polygons_of(set).size();
  const dcel::Counts counts = set.arrangement().counts();
  Json& json = report.json;
  json["unbounded"] = set.is_unbounded();
  json["polygons"] = polygons;
  json["vertices"] = counts.vertices;
  json["edges"] = counts.edges;
  json["isolated_vertices"] = counts.isolated_vertices;
  std::ostringstream text;
  text << polygons << (polygons == 1 ? " polygon, " : " polygons, ") << counts.vertices << " vertices";
  if (!set.is_unbounded()) {
    add_area(set, json);
    text << ", area " << json["area"].template get<double>();
  }
  report.text += text.str();
  if (set.is_empty()) report.warnings.emplace_back("the result is empty");
  if (!set.is_regular())
    report.warnings.emplace_back("edges and points without area are shown in pictures and kept in .qarr only");
}

template <class F>
void write_set(const PolygonSet<F>& set, SetReport& report, const Options& options, const Context& context) {
  write_exact_targets(set, {}, options);
  const std::vector<Target> targets = targets_of(options);
  if (std::none_of(targets.begin(), targets.end(),
                   [](const Target& target) { return target.kind == Target::Kind::planar; })) {
    return;
  }
  const SetDrawing drawn = draw_set(set, context);
  report.json["rounding"] = {
      {"max_displacement", drawn.max_displacement}, {"rounds", drawn.rounds}, {"vanished_rings", drawn.vanished_rings}};
  if (drawn.vanished_rings == 1) report.warnings.emplace_back("a ring is too thin to be written in doubles");
  if (drawn.vanished_rings > 1) {
    report.warnings.push_back(std::to_string(drawn.vanished_rings) + " rings are too thin to be written in doubles");
  }
  write_drawings(drawn.drawing, options, report.warnings, context);
}

template void describe_set(const LinearPolygonSet&, SetReport&);
template void describe_set(const CircularPolygonSet&, SetReport&);
template void write_set(const LinearPolygonSet&, SetReport&, const Options&, const Context&);
template void write_set(const CircularPolygonSet&, SetReport&, const Options&, const Context&);

}  // namespace quoin::cli
