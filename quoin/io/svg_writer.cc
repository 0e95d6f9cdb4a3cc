// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include "quoin/base/error.h"
#include "quoin/io/drawing_arcs.h"
#include "quoin/io/drawing_formats.h"
#include "quoin/io/xml_tags.h"

namespace quoin::io {

namespace {

// Of vertices and circles: enough for a view.
struct Extent {
  Point2 least{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Point2 most{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  void include(double x, double y) {
    least = {std::min(least.x, x), std::min(least.y, y)};
    most = {std::max(most.x, x), std::max(most.y, y)};
  }
  void include(const DrawingPath& path) {
    for (const Point2& p : path.points) include(p.x, p.y);
  }
  void include(const DrawingElement& element) {
    if (const auto* path = std::get_if<DrawingPath>(&element.shape)) include(*path);
    if (const auto* polygon = std::get_if<DrawingPolygon>(&element.shape)) {
      for (const DrawingPath& ring : polygon->rings) include(ring);
    }
    if (const auto* circle = std::get_if<DrawingCircle>(&element.shape)) {
      include(circle->center.x - circle->radius, circle->center.y - circle->radius);
      include(circle->center.x + circle->radius, circle->center.y + circle->radius);
    }
  }
};

class SvgWriter {
 public:
  SvgWriter(std::ostream& out, DrawingNotes& notes) : out_(out), notes_(notes) {}

  void begin(const Drawing& drawing) {
    Extent extent;
    bool has_layers = false;
    for (const DrawingElement& element : drawing.elements) {
      extent.include(element);
      has_layers |= !element.layer.empty();
    }
    out_ << R"(<svg xmlns="http://www.w3.org/2000/svg")";
    if (has_layers) out_ << R"( xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape")";
    const double width = extent.most.x - extent.least.x;
    const double height = extent.most.y - extent.least.y;
    if (std::isfinite(width) && std::isfinite(height)) {
      out_ << " viewBox=\"" << decimals(extent.least.x) << " " << decimals(extent.least.y) << " " << decimals(width)
           << " " << decimals(height) << "\"";
    }
    out_ << " fill=\"none\" stroke=\"black\">\n";
  }

  void write(const DrawingElement& element) {
    if (element.kind() == DrawingKind::point) return notes_.count("points are not kept", element.name);
    if (!element.layer.empty()) {
      if (std::ranges::any_of(element.layer, [](char c) { return static_cast<unsigned char>(c) < 0x20; }))
        throw InputError(element.name + ": the name of its layer has control characters, which SVG cannot hold");
      out_ << R"(<g inkscape:groupmode="layer" inkscape:label=")" << xml_encoded(element.layer) << "\">";
    }
    if (const auto* circle = std::get_if<DrawingCircle>(&element.shape)) {
      out_ << "<circle cx=\"" << decimals(circle->center.x) << "\" cy=\"" << decimals(circle->center.y) << "\" r=\""
           << decimals(circle->radius) << "\"/>";
    } else if (const auto* path = std::get_if<DrawingPath>(&element.shape)) {
      if (path->is_closed && can_bound(*path)) notes_.count("closed paths read back as polygons", element.name);
      out_ << "<path d=\"";
      subpath(*path, element.name);
      out_ << "\"/>";
    } else {
      const auto& polygon = std::get<DrawingPolygon>(element.shape);
      out_ << "<path fill-rule=\"" << (polygon.fill == FillRule::nonzero ? "nonzero" : "evenodd") << "\" d=\"";
      for (const DrawingPath& ring : polygon.rings) subpath(ring, element.name);
      out_ << "\"/>";
    }
    out_ << (element.layer.empty() ? "\n" : "</g>\n");
  }

 private:
  void vertex(char command, const Point2& p) { out_ << command << decimals(p.x) << " " << decimals(p.y); }

  // A closed path ends with Z, which draws the last edge if it is straight and has a length.
  void subpath(const DrawingPath& path, const std::string& element) {
    vertex('M', path.points[0]);
    for (std::size_t e = 0; e < path.edge_count(); ++e) {
      const bool is_last = path.is_closed && e + 1 == path.points.size();
      const bool has_length = path.start(e) != path.end(e);
      const bool is_drawn_by_z = is_last && path.bulge(e) == 0 && (has_length || path.points.size() == 1);
      if (!is_drawn_by_z) edge(path.start(e), path.end(e), path.bulge(e), element);
    }
    if (path.is_closed) out_ << "Z";
  }

  void edge(const Point2& a, const Point2& b, double bulge, const std::string& element) {
    if (bulge == 0) return vertex('L', b);
    if (a == b) {
      notes_.count("arcs over edges of zero length are not kept", element);
      return vertex('L', b);
    }
    const auto radius = radius_of_bulge(a, b, bulge);
    if (!radius) {
      if (std::fabs(bulge) >= 1) throw InputError(element + ": the radius of an arc is beyond the largest double");
      notes_.moved("arcs are rounded", element, distance_of_bulges(a, b, bulge, 0));
      return vertex('L', b);
    }
    if (radius->distance > 0) notes_.moved("arcs are rounded", element, radius->distance);
    const std::string r = decimals(radius->radius);
    out_ << "A" << r << " " << r << " 0 " << (std::fabs(bulge) > 1 ? 1 : 0) << " " << (bulge > 0 ? 1 : 0);
    vertex(' ', b);
  }

  std::ostream& out_;
  DrawingNotes& notes_;
};

}  // namespace

void write_svg(std::ostream& out, const Drawing& drawing, DrawingNotes& notes, const Context& context) {
  SvgWriter writer(out, notes);
  writer.begin(drawing);
  for (const DrawingElement& element : drawing.elements) {
    context.poll();
    writer.write(element);
  }
  out << "</svg>\n";
}

}  // namespace quoin::io
