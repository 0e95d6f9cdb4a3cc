// SPDX-License-Identifier: Apache-2.0
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
    if (!element.layer.empty()) notes_.count("layers are not kept", element.name);
    if (const auto* point = std::get_if<Point2>(&element.shape)) {
      out_ << "POINT (";
      vertex(*point);
      out_ << ")";
    } else if (const auto* path = std::get_if<DrawingPath>(&element.shape)) {
      note_open_end(*path, element.name, notes_);
      curve(*path, element.name, "LINESTRING ");
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
      polygon(std::get<DrawingPolygon>(element.shape), element.name);
    }
    out_ << "\n";
  }

 private:
  void polygon(const DrawingPolygon& polygon, const std::string& element) {
    if (polygon.fill == FillRule::nonzero) notes_.count("the fill rule nonzero is not kept", element);
    bool has_arcs = false;
    for (const DrawingPath& ring : polygon.rings) has_arcs |= !ring.bulges.empty();
    out_ << (has_arcs ? "CURVEPOLYGON (" : "POLYGON (");
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

void write_wkt(std::ostream& out, const Drawing& drawing, DrawingNotes& notes, const Context& context) {
  WktWriter writer(out, notes);
  for (const DrawingElement& element : drawing.elements) {
    context.poll();
    writer.write(element);
  }
}

}  // namespace quoin::io
