// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/constrained_inputs.h"

#include <algorithm>
#include <variant>

#include "quoin/base/error.h"
#include "quoin/cli/inputs.h"
#include "quoin/cli/planar.h"
#include "quoin/io/drawing_formats.h"
#include "quoin/io/point_file.h"

namespace quoin::cli {

namespace {

class SegmentReader {
 public:
  SegmentReader(SegmentInput& input, const Options& options, io::DrawingNotes& notes)
      : input_(input), options_(options), notes_(notes) {}

  void add(const DrawingElement& element) {
    if (const auto* point = std::get_if<Point2>(&element.shape)) input_.points.push_back(*point);
    if (const auto* path = std::get_if<DrawingPath>(&element.shape)) add(*path, element.name);
    if (const auto* polygon = std::get_if<DrawingPolygon>(&element.shape)) {
      for (const DrawingPath& ring : polygon->rings) add(ring, element.name);
    }
    if (const auto* circle = std::get_if<DrawingCircle>(&element.shape)) {
      if (!options_.flatten) refuse_arc(element.name);
      add(io::circle_path(*circle, notes_, element.name), element.name);
    }
  }

 private:
  [[noreturn]] static void refuse_arc(const std::string& element) {
    throw InputError(element + ": edges of triangles are straight, and it has arcs; --flatten makes chords of them");
  }

  void add(const DrawingPath& path, const std::string& element) {
    const bool has_arcs = std::ranges::any_of(path.bulges, [](double bulge) { return bulge != 0; });
    if (has_arcs && !options_.flatten) refuse_arc(element);
    const DrawingPath chain = has_arcs ? io::flattened(path, *options_.flatten, element) : path;
    const auto first = static_cast<std::uint32_t>(input_.points.size());
    const auto count = static_cast<std::uint32_t>(chain.points.size());
    input_.points.insert(input_.points.end(), chain.points.begin(), chain.points.end());
    for (std::uint32_t e = 0; e < chain.edge_count(); ++e)
      input_.segments.push_back({first + e, first + (e + 1 == count ? 0 : e + 1)});
  }

  SegmentInput& input_;
  const Options& options_;
  io::DrawingNotes& notes_;
};

void add_drawing(const PlanarInput& read, SegmentInput& input, const Options& options,
                 std::vector<std::string>& warnings) {
  if (read.exact)
    throw InputError(read.name + ": exact arrangements are not taken, whose vertices may be no doubles; drawings are");
  io::DrawingNotes notes;
  try {
    check_drawing(read.drawing);
    SegmentReader reader(input, options, notes);
    for (const DrawingElement& element : read.drawing.elements) reader.add(element);
  } catch (const InputError& error) {
    throw InputError(read.name + ": " + error.what());
  }
  for (const std::string& note : notes.list()) warnings.push_back(read.name + ": " + note);
}

void add_point_file(SegmentInput& input, const Options& options, std::vector<std::string>& warnings,
                    const Context& context) {
  const std::string& name = options.points_file;
  const PointFile file = read_points(read_all(name), shown(name), {}, context);
  for (const std::string& warning : file.report.warnings) warnings.push_back(shown(name) + ": " + warning);
  if (file.dimension == 3) warnings.push_back(shown(name) + ": x and y count, the third coordinate does not");
  for (const Point3& p : file.points) input.points.push_back({p.x, p.y});
}

}  // namespace

SegmentInput read_segments(const Options& options, std::vector<std::string>& warnings, const Context& context) {
  SegmentInput input;
  for (const PlanarInput& read : read_drawings(options, warnings, context)) add_drawing(read, input, options, warnings);
  if (!options.points_file.empty()) add_point_file(input, options, warnings, context);
  return input;
}

}  // namespace quoin::cli
