// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/point_input.h"

#include <algorithm>

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

std::vector<WeightedPoint2> weighted_plane_points(const PointFile& file) {
  std::vector<WeightedPoint2> points;
  points.reserve(file.points.size());
  for (std::size_t i = 0; i < file.points.size(); ++i)
    points.push_back({{file.points[i].x, file.points[i].y}, file.weights[i]});
  return points;
}

std::size_t distinct_places(const PointFile& file) {
  std::vector<Point2> places = plane_points(file);
  std::ranges::sort(places, [](const Point2& a, const Point2& b) { return lexicographically_less(a, b); });
  return static_cast<std::size_t>(std::unique(places.begin(), places.end()) - places.begin());
}

void warn_of_points(std::size_t heights_lost, int dimension, const Options& options, bool of_plane,
                    std::vector<std::string>& warnings) {
  if (heights_lost > 0) {
    warnings.push_back(shown(options.inputs[0]) + ": " + std::to_string(heights_lost) +
                       " points have the x and y of others and another third coordinate: the first one's is kept");
  }
  if (dimension >= (of_plane ? 2 : 3)) return;
  static constexpr const char* flats[] = {"are all equal", "lie on one line: cells are edges",
                                          "lie in one plane: cells are triangles"};
  warnings.push_back(shown(options.inputs[0]) + ": the points " + flats[dimension]);
}

nlohmann::ordered_json describe(const PointFile& file, const Options& options) {
  nlohmann::ordered_json json{{"format", name_of(file.report.format)},
                              {"points", file.points.size()},
                              {"coordinates", is_of_plane(file, options) ? 2 : 3}};
  if (file.report.missing > 0) json["missing"] = file.report.missing;
  return json;
}

}  // namespace quoin::cli
