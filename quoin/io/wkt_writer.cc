// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/io/drawing_arcs.h"
#include "quoin/io/drawing_formats.h"

namespace quoin::io {

namespace {

class WktWriter {
 public:
  WktWriter(std::ostream& out, DrawingNotes& notes) : out_(out), notes_(notes) {}

  void write(const DrawingElement& element) {
    geometry(element, true);
    out_ << "\n";
  }

  void write_as_one(const std::vector<DrawingElement>& elements, const Context& context) {
    if (elements.empty()) {
      out_ << "POLYGON EMPTY\n";
      return;
    }
    if (elements.size() == 1) return write(elements.front());
    const std::string_view keyword = keyword_of(elements);
    out_ << keyword << " (";
    for (std::size_t i = 0; i < elements.size(); ++i) {
      context.poll();
      if (i > 0) out_ << ", ";
      geometry(elements[i], keyword == collection);
    }
    out_ << ")\n";
  }

 private:
  static constexpr std::string_view collection = "GEOMETRYCOLLECTION";

  static bool has_arcs(const DrawingPolygon& polygon) {
    return std::any_of(polygon.rings.begin(), polygon.rings.end(),
                       [](const DrawingPath& ring) { return !ring.bulges.empty(); });
  }

  static bool has_arcs(const DrawingElement& element) {
    if (const auto* path = std::get_if<DrawingPath>(&element.shape)) return !path->bulges.empty();
    if (const auto* polygon = std::get_if<DrawingPolygon>(&element.shape)) return has_arcs(*polygon);
    return element.kind() == DrawingKind::circle;
  }

  // What holds all of them.
  static std::string_view keyword_of(const std::vector<DrawingElement>& elements) {
    const auto kind = [](const DrawingElement& element) {  // a circle is a curve, as a path is
      return element.kind() == DrawingKind::circle ? DrawingKind::path : element.kind();
    };
    bool is_curved = false;
    for (const DrawingElement& element : elements) {
      if (kind(element) != kind(elements.front())) return collection;
      is_curved = is_curved || has_arcs(element);
    }
    switch (kind(elements.front())) {
      case DrawingKind::point:
        return "MULTIPOINT";
      case DrawingKind::polygon:
        return is_curved ? "MULTISURFACE" : "MULTIPOLYGON";
      default:
        return is_curved ? "MULTICURVE" : "MULTILINESTRING";
    }
  }

  // Members of a MULTI... that are as plain as its name says have no keyword of their own.
  void geometry(const DrawingElement& element, bool has_keyword) {
    if (!element.layer.empty()) notes_.count("layers are not kept", element.name);
    if (const auto* point = std::get_if<Point2>(&element.shape)) {
      out_ << (has_keyword ? "POINT (" : "(");
      vertex(*point);
      out_ << ")";
    } else if (const auto* path = std::get_if<DrawingPath>(&element.shape)) {
      note_open_end(*path, element.name, notes_);
      curve(*path, element.name, has_keyword ? "LINESTRING " : "");
    } else if (const auto* circle = std::get_if<DrawingCircle>(&element.shape)) {
      const DrawingPath halves = circle_path(*circle, notes_, element.name);
      out_ << "CIRCULARSTRING (";
      for (const std::size_t i : {0U, 1U, 0U}) {
        if (i == 1) out_ << ", ";
        vertex(halves.points[i]);
        if (i == 1) out_ << ", ";
      }
      out_ << ")";
    } else {
      polygon(std::get<DrawingPolygon>(element.shape), element.name, has_keyword);
    }
  }

  void polygon(const DrawingPolygon& polygon, const std::string& element, bool has_keyword) {
    if (polygon.fill == FillRule::nonzero) notes_.count("the fill rule nonzero is not kept", element);
    out_ << (has_arcs(polygon) ? "CURVEPOLYGON (" : has_keyword ? "POLYGON (" : "(");
    for (std::size_t r = 0; r < polygon.rings.size(); ++r) {
      if (r > 0) out_ << ", ";
      curve(polygon.rings[r], element, "");
    }
    out_ << ")";
  }

  void vertex(const Point2& p) { out_ << decimals(p.x) << " " << decimals(p.y); }

  // A vertex that the arc of an edge goes through and from which a reader finds its bulge again; nothing for a straight
  // edge and an arc that is too flat to have one.
  std::optional<Point2> middle(const DrawingPath& path, std::size_t e, const std::string& element) {
    const double bulge = path.bulge(e);
    const Point2& a = path.start(e);
    const Point2& b = path.end(e);
    if (bulge == 0) return std::nullopt;
    if (a == b) {
      notes_.count("arcs over edges of zero length are not kept", element);
      return std::nullopt;
    }
    const auto top = top_of_arc(a, b, bulge);
    if (!top) throw InputError(element + ": the top of an arc is beyond the largest double");
    const auto read = bulge_through(a, top->point, b);
    const double kept = read ? read->bulge : 0;
    if (kept != bulge) notes_.moved("arcs are rounded", element, distance_of_bulges(a, b, bulge, kept));
    return kept != 0 ? std::optional(top->point) : std::nullopt;
  }

  void curve(const DrawingPath& path, const std::string& element, std::string_view line_keyword) {
    const std::size_t edges = path.edge_count();
    std::vector<std::optional<Point2>> middles;
    for (std::size_t e = 0; e < edges; ++e) middles.push_back(middle(path, e, element));
    std::size_t changes = 0;
    for (std::size_t e = 1; e < edges; ++e) changes += middles[e].has_value() != middles[e - 1].has_value() ? 1 : 0;
    if (changes > 0) out_ << "COMPOUNDCURVE (";
    for (std::size_t e = 0; e < edges;) {
      const bool is_arc = middles[e].has_value();
      if (e > 0) out_ << ", ";
      out_ << (is_arc ? "CIRCULARSTRING (" : std::string(changes > 0 ? "" : line_keyword) + "(");
      vertex(path.start(e));
      for (; e < edges && middles[e].has_value() == is_arc; ++e) {
        out_ << ", ";
        if (is_arc) {
          vertex(*middles[e]);
          out_ << ", ";
        }
        vertex(path.end(e));
      }
      out_ << ")";
    }
    if (changes > 0) out_ << ")";
  }

  std::ostream& out_;
  DrawingNotes& notes_;
};

}  // namespace

void write_wkt(std::ostream& out, const Drawing& drawing, const DrawingWriteOptions& options, DrawingNotes& notes,
               const Context& context) {
  WktWriter writer(out, notes);
  if (options.as_one_geometry) return writer.write_as_one(drawing.elements, context);
  for (const DrawingElement& element : drawing.elements) {
    context.poll();
    writer.write(element);
  }
}

}  // namespace quoin::io
