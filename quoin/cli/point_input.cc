// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/point_input.h"

#include "quoin/cli/inputs.h"

namespace quoin::cli {

PointFile read_point_input(const Options& options, std::vector<std::string>& warnings, const Context& context) {
  PointReadOptions how;
  how.weights = options.weighted;
  if (!options.input_format.empty()) how.format = point_format_named(options.input_format);
  const std::string& name = options.inputs[0];
  PointFile file = read_points(read_all(name), shown(name), how, context);
  for (const std::string& w : file.report.warnings) warnings.push_back(shown(name) + ": " + w);
  if (options.weld_tolerance) warnings.push_back(shown(name) + ": points are not welded; equal ones are one vertex");
  return file;
}

bool is_of_plane(const PointFile& file, const Options& options) {
  return file.dimension == 2 || options.onto_plane;
}

std::vector<Point2> plane_points(const PointFile& file) {
  std::vector<Point2> points;
  points.reserve(file.points.size());
  for (const Point3& p : file.points) points.push_back({p.x, p.y});
  return points;
}

nlohmann::ordered_json describe(const PointFile& file, const Options& options) {
  nlohmann::ordered_json json{{"format", name_of(file.report.format)},
                              {"points", file.points.size()},
                              {"coordinates", is_of_plane(file, options) ? 2 : 3}};
  if (file.report.missing > 0) json["missing"] = file.report.missing;
  return json;
}

}  // namespace quoin::cli
