// SPDX-License-Identifier: Apache-2.0
//
// Entities of release 12, which needs neither header nor handles.
#include <algorithm>

#include "quoin/base/error.h"
#include "quoin/io/drawing_formats.h"

namespace quoin::io {

namespace {

class DxfWriter {
 public:
  DxfWriter(std::ostream& out, DrawingNotes& notes) : out_(out), notes_(notes) {}

  void write(const DrawingElement& element) {
    check_layer(element);
    layer_ = element.layer.empty() ? "0" : element.layer;
    if (const auto* point = std::get_if<Point2>(&element.shape)) {
      begin("POINT");
      vertex(10, *point);
    } else if (const auto* circle = std::get_if<DrawingCircle>(&element.shape)) {
      begin("CIRCLE");
      vertex(10, circle->center);
      group(40, decimals(circle->radius));
    } else if (const auto* path = std::get_if<DrawingPath>(&element.shape)) {
      if (path->is_closed && can_bound(*path)) notes_.count("closed paths read back as polygons", element.name);
      polyline(*path);
    } else {
      const auto& polygon = std::get<DrawingPolygon>(element.shape);
      if (polygon.fill == FillRule::nonzero) notes_.count("the fill rule nonzero is not kept", element.name);
      if (polygon.rings.size() > 1) notes_.count("rings of one polygon become polygons each", element.name);
      for (const DrawingPath& ring : polygon.rings) polyline(ring);
    }
  }

  void group(int code, std::string_view value) { out_ << code << "\n" << value << "\n"; }

 private:
  void check_layer(const DrawingElement& element) {
    const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20; };
    const std::string& layer = element.layer;
    if (std::ranges::any_of(layer, is_control) || layer.starts_with(' ') || layer.ends_with(' '))
      throw InputError(element.name +
                       ": the name of its layer is no line of DXF (control characters, space around it)");
    if (layer == "0") notes_.count("layer 0 reads back as none", element.name);
  }

  void begin(std::string_view type) {
    group(0, type);
    group(8, layer_);
  }

  void vertex(int code, const Point2& p) {
    group(code, decimals(p.x));
    group(code + 10, decimals(p.y));
  }

  void polyline(const DrawingPath& path) {
    if (path.points.size() == 2 && !path.is_closed && path.bulge(0) == 0) {
      begin("LINE");
      vertex(10, path.points[0]);
      return vertex(11, path.points[1]);
    }
    begin("POLYLINE");
    group(66, "1");
    vertex(10, {0, 0});
    group(70, path.is_closed ? "1" : "0");
    for (std::size_t i = 0; i < path.points.size(); ++i) {
      begin("VERTEX");
      vertex(10, path.points[i]);
      if (i < path.edge_count() && path.bulge(i) != 0) group(42, decimals(path.bulge(i)));
    }
    begin("SEQEND");
  }

  std::ostream& out_;
  DrawingNotes& notes_;
  std::string layer_;
};

}  // namespace

void write_dxf(std::ostream& out, const Drawing& drawing, DrawingNotes& notes, const Context& context) {
  DxfWriter writer(out, notes);
  writer.group(0, "SECTION");
  writer.group(2, "ENTITIES");
  for (const DrawingElement& element : drawing.elements) {
    context.poll();
    writer.write(element);
  }
  writer.group(0, "ENDSEC");
  writer.group(0, "EOF");
}

}  // namespace quoin::io
