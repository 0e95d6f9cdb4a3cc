// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <nlohmann/json.hpp>

#include "quoin/base/error.h"
#include "quoin/io/drawing_formats.h"

namespace quoin::io {

namespace {

class GeoJsonWriter {
 public:
  GeoJsonWriter(std::ostream& out, const DrawingWriteOptions& options, DrawingNotes& notes)
      : out_(out), tolerance_(options.flatten_tolerance), notes_(notes) {
    if (tolerance_ && !(*tolerance_ > 0 && std::isfinite(*tolerance_)))
      throw InputError("the tolerance " + decimals(*tolerance_) + " is no positive number");
  }

  void write(const DrawingElement& element) {
    out_ << R"({"type":"Feature","properties":{"name":)" << text(element.name, element);
    if (!element.layer.empty()) out_ << R"(,"layer":)" << text(element.layer, element);
    out_ << R"(},"geometry":{"type":)";
    if (const auto* point = std::get_if<Point2>(&element.shape)) {
      out_ << R"("Point","coordinates":)";
      position(*point);
    } else if (const auto* path = std::get_if<DrawingPath>(&element.shape)) {
      note_open_end(*path, element.name, notes_);
      line(*path, element.name);
    } else if (const auto* circle = std::get_if<DrawingCircle>(&element.shape)) {
      line(circle_path(*circle, notes_, element.name), element.name);
    } else {
      polygon(std::get<DrawingPolygon>(element.shape), element.name);
    }
    out_ << "}}";
  }

 private:
  static std::string text(const std::string& value, const DrawingElement& element) {
    try {
      return nlohmann::json(value).dump();
    } catch (const nlohmann::json::exception&) {
      throw InputError(element.name + ": its name or layer is not UTF-8, which GeoJSON needs");
    }
  }

  void position(const Point2& p) { out_ << "[" << decimals(p.x) << "," << decimals(p.y) << "]"; }

  void line(const DrawingPath& path, const std::string& element) {
    out_ << R"("LineString","coordinates":)";
    positions(path, element);
  }

  void polygon(const DrawingPolygon& polygon, const std::string& element) {
    if (polygon.fill == FillRule::nonzero) notes_.count("the fill rule nonzero is not kept", element);
    out_ << R"("Polygon","coordinates":[)";
    for (std::size_t r = 0; r < polygon.rings.size(); ++r) {
      if (r > 0) out_ << ",";
      positions(polygon.rings[r], element);
    }
    out_ << "]";
  }

  void positions(const DrawingPath& path, const std::string& element) {
    if (path.bulges.empty()) return straight(path);
    if (!tolerance_) throw InputError(element + ": GeoJSON has no arcs; they can be flattened within a tolerance");
    notes_.moved("paths with arcs are flattened", element, *tolerance_);
    straight(flattened(path, *tolerance_, element));
  }

  void straight(const DrawingPath& path) {
    out_ << "[";
    for (std::size_t i = 0; i < path.points.size(); ++i) {
      if (i > 0) out_ << ",";
      position(path.points[i]);
    }
    if (path.is_closed) {
      out_ << ",";
      position(path.points[0]);
    }
    out_ << "]";
  }

  std::ostream& out_;
  std::optional<double> tolerance_;
  DrawingNotes& notes_;
};

}  // namespace

void write_geojson(std::ostream& out, const Drawing& drawing, const DrawingWriteOptions& options, DrawingNotes& notes,
                   const Context& context) {
  GeoJsonWriter writer(out, options, notes);
  out << R"({"type":"FeatureCollection","features":[)";
  for (std::size_t i = 0; i < drawing.elements.size(); ++i) {
    context.poll();
    out << (i > 0 ? ",\n" : "\n");
    writer.write(drawing.elements[i]);
  }
  out << "\n]}\n";
}

}  // namespace quoin::io
