// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/drawing.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "quoin/base/error.h"
#include "quoin/io/drawing_formats.h"
#include "quoin/io/mesh_file.h"
#include "quoin/io/text_lines.h"

namespace quoin {

namespace {

// Letters, digits or signs at the begin of a text tell the format.
std::optional<DrawingFormat> format_of_content(std::string_view text) {
  const std::string nameless;
  io::TextCursor cursor(text, nameless);
  cursor.skip_space();
  if (cursor.peek() == '{') return DrawingFormat::geojson;
  if (cursor.peek() == '<') return DrawingFormat::svg;
  if (cursor.peek() >= '0' && cursor.peek() <= '9') return DrawingFormat::dxf;
  const std::string_view word = cursor.word();
  if (io::is_word(word, "autocad")) return DrawingFormat::dxf;  // the binary form, refused by its reader
  if (io::is_word(word, "m")) return DrawingFormat::svg;
  if (word.size() > 3) return DrawingFormat::wkt;
  return std::nullopt;
}

DrawingFormat format_of(std::string_view text, const std::string& name, const DrawingReadOptions& options) {
  if (options.format) return *options.format;
  if (const auto format = drawing_format_from_path(name)) return *format;
  if (const auto format = format_of_content(text)) return *format;
  throw InputError(name +
                   ":1: neither the content nor the ending tells a format that is read (WKT, GeoJSON, SVG, DXF)");
}

[[noreturn]] void refuse(const DrawingElement& element, const std::string& what) {
  throw InputError(element.name + ": " + what);
}

std::string ring_prefix(const DrawingElement& element, std::size_t ring) {
  return element.kind() == DrawingKind::polygon ? "ring " + std::to_string(ring + 1) + ", " : "";
}

bool is_finite(const Point2& p) {
  return std::isfinite(p.x) && std::isfinite(p.y);
}

void check_path_structure(const DrawingElement& element, const DrawingPath& path, const std::string& prefix) {
  if (path.points.empty()) refuse(element, prefix + "there are no vertices");
  if (!path.is_closed && path.points.size() < 2) refuse(element, prefix + "an open path has at least two vertices");
  if (!path.bulges.empty() && path.bulges.size() != path.edge_count())
    refuse(element,
           prefix + std::to_string(path.bulges.size()) + " bulges for " + std::to_string(path.edge_count()) + " edges");
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    if (!is_finite(path.points[i])) refuse(element, prefix + "vertex " + std::to_string(i + 1) + " is not finite");
  }
  for (std::size_t i = 0; i < path.bulges.size(); ++i) {
    if (!std::isfinite(path.bulges[i]))
      refuse(element, prefix + "the bulge of edge " + std::to_string(i + 1) + " is not finite");
  }
}

void check_element_structure(const DrawingElement& element) {
  if (const auto* point = std::get_if<Point2>(&element.shape)) {
    if (!is_finite(*point)) refuse(element, "it is not finite");
  } else if (const auto* path = std::get_if<DrawingPath>(&element.shape)) {
    check_path_structure(element, *path, "");
  } else if (const auto* circle = std::get_if<DrawingCircle>(&element.shape)) {
    if (!is_finite(circle->center) || !std::isfinite(circle->radius)) refuse(element, "it is not finite");
  } else if (const auto* polygon = std::get_if<DrawingPolygon>(&element.shape)) {
    if (polygon->rings.empty()) refuse(element, "there are no rings");
    for (std::size_t r = 0; r < polygon->rings.size(); ++r) {
      check_path_structure(element, polygon->rings[r], ring_prefix(element, r));
      if (!polygon->rings[r].is_closed) refuse(element, ring_prefix(element, r) + "the ring is not closed");
      if (!io::can_bound(polygon->rings[r])) refuse(element, ring_prefix(element, r) + "the ring has too few vertices");
    }
  }
}

void check_edges(const DrawingElement& element, const DrawingPath& path, const std::string& prefix) {
  for (std::size_t e = 0; e < path.edge_count(); ++e) {
    if (path.start(e) != path.end(e)) continue;
    const bool is_closing = path.is_closed && e + 1 == path.points.size() && e > 0;
    std::string what = prefix;
    what += is_closing ? "the last vertex repeats the first" : "edge " + std::to_string(e + 1) + " has zero length";
    what += " at " + io::decimals(path.start(e).x) + " " + io::decimals(path.start(e).y);
    refuse(element, what);
  }
}

}  // namespace

namespace io {

bool can_bound(const DrawingPath& path) {
  const bool has_arc = std::ranges::any_of(path.bulges, [](double bulge) { return bulge != 0; });
  return path.points.size() > 2 || (path.points.size() == 2 && has_arc);
}

void append_edge(DrawingPath& path, double bulge, const Point2& end) {
  if (bulge != 0 && path.bulges.empty()) path.bulges.resize(path.points.size() - 1, 0.0);
  if (bulge != 0 || !path.bulges.empty()) path.bulges.push_back(bulge);
  path.points.push_back(end);
}

void close_at_repeated_end(DrawingPath& path) {
  path.points.pop_back();
  path.is_closed = true;
}

void close_with_edge(DrawingPath& path, double bulge) {
  if (bulge != 0 && path.bulges.empty()) path.bulges.resize(path.points.size() - 1, 0.0);
  if (bulge != 0 || !path.bulges.empty()) path.bulges.push_back(bulge);
  path.is_closed = true;
}

std::string_view kind_name(DrawingKind kind) {
  switch (kind) {
    case DrawingKind::point:
      return "point";
    case DrawingKind::path:
      return "path";
    case DrawingKind::polygon:
      return "polygon";
    default:
      return "circle";
  }
}

void check_structure(const Drawing& drawing) {
  for (const DrawingElement& element : drawing.elements) check_element_structure(element);
}

}  // namespace io

std::optional<DrawingFormat> drawing_format_from_path(const std::filesystem::path& path) {
  const std::string ending = path.extension().string();
  if (io::is_word(ending, ".wkt")) return DrawingFormat::wkt;
  if (io::is_word(ending, ".geojson") || io::is_word(ending, ".json")) return DrawingFormat::geojson;
  if (io::is_word(ending, ".svg")) return DrawingFormat::svg;
  if (io::is_word(ending, ".dxf")) return DrawingFormat::dxf;
  return std::nullopt;
}

Drawing read_drawing(std::string_view text, const std::string& name, const DrawingReadOptions& options,
                     const Context& context) {
  context.progress("reading", 0);
  switch (format_of(text, name, options)) {
    case DrawingFormat::wkt:
      return io::read_wkt(text, name, context);
    case DrawingFormat::geojson:
      return io::read_geojson(text, name, context);
    case DrawingFormat::svg:
      return io::read_svg(text, name, options, context);
    default:
      return io::read_dxf(text, name, options, context);
  }
}

Drawing read_drawing(const std::filesystem::path& path, const DrawingReadOptions& options, const Context& context) {
  return read_drawing(read_file(path), path.string(), options, context);
}

void check_drawing(const Drawing& drawing) {
  for (const DrawingElement& element : drawing.elements) {
    check_element_structure(element);
    if (const auto* path = std::get_if<DrawingPath>(&element.shape)) {
      check_edges(element, *path, "");
    } else if (const auto* circle = std::get_if<DrawingCircle>(&element.shape)) {
      if (!(circle->radius > 0)) refuse(element, "the radius " + io::decimals(circle->radius) + " is not positive");
    } else if (const auto* polygon = std::get_if<DrawingPolygon>(&element.shape)) {
      for (std::size_t r = 0; r < polygon->rings.size(); ++r)
        check_edges(element, polygon->rings[r], ring_prefix(element, r));
    }
  }
}

std::vector<std::string> write_drawing(std::ostream& out, DrawingFormat format, const Drawing& drawing,
                                       const DrawingWriteOptions& options, const Context& context) {
  io::check_structure(drawing);
  io::DrawingNotes notes;
  switch (format) {
    case DrawingFormat::wkt:
      io::write_wkt(out, drawing, options, notes, context);
      break;
    case DrawingFormat::geojson:
      io::write_geojson(out, drawing, options, notes, context);
      break;
    case DrawingFormat::svg:
      io::write_svg(out, drawing, notes, context);
      break;
    case DrawingFormat::dxf:
      io::write_dxf(out, drawing, notes, context);
      break;
  }
  return notes.list();
}

std::vector<std::string> write_drawing(const std::filesystem::path& path, DrawingFormat format, const Drawing& drawing,
                                       const DrawingWriteOptions& options, const Context& context) {
  std::ostringstream text;  // what is refused leaves no part of a file
  std::vector<std::string> notes = write_drawing(text, format, drawing, options, context);
  std::ofstream out(path, std::ios::binary);
  if (!out) throw FileError(path.string() + ": cannot be written");
  out << text.view();
  out.close();
  if (!out) throw FileError(path.string() + ": writing failed");
  return notes;
}

}  // namespace quoin
