// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "quoin/arrangement/sets/fill_rule.h"
#include "quoin/base/context.h"
#include "quoin/kernel/point.h"

namespace quoin {

/// A chain of straight edges and circular arcs through its vertices.
///
/// Edge e goes from vertex e to the next one; a closed path has one more, from the last vertex to the first, which is
/// not repeated. The bulge of an edge is the tangent of a quarter of the angle it turns through: 0 is straight, 1 half
/// a circle, positive counterclockwise from start to end (where y points up), as in DXF. The arc that a bulge and two
/// vertices stand for is exact: its top is bulge times half the chord away from the chord's middle.
struct DrawingPath {
  std::vector<Point2> points;
  std::vector<double> bulges;  ///< empty where all edges are straight, else one for each edge
  bool is_closed = false;

  std::size_t edge_count() const { return is_closed || points.empty() ? points.size() : points.size() - 1; }
  double bulge(std::size_t edge) const { return bulges.empty() ? 0 : bulges[edge]; }
  const Point2& start(std::size_t edge) const { return points[edge]; }
  const Point2& end(std::size_t edge) const { return points[edge + 1 == points.size() ? 0 : edge + 1]; }
  friend bool operator==(const DrawingPath&, const DrawingPath&) = default;
};

/// The region that closed paths enclose together. In WKT and GeoJSON the first ring is the outer one and the others
/// are holes; in SVG rings come in any order.
struct DrawingPolygon {
  std::vector<DrawingPath> rings;
  FillRule fill = FillRule::even_odd;
  friend bool operator==(const DrawingPolygon&, const DrawingPolygon&) = default;
};

/// A whole circle, as a curve.
struct DrawingCircle {
  Point2 center;
  double radius = 0;
  friend bool operator==(const DrawingCircle&, const DrawingCircle&) = default;
};

/// In the order of the alternatives of DrawingElement::shape.
enum class DrawingKind : std::uint8_t { point, path, polygon, circle };

struct DrawingElement {
  std::variant<Point2, DrawingPath, DrawingPolygon, DrawingCircle> shape;
  std::string name;   ///< what errors call it: "polygon 3", "feature 2", "path 1", "layer WALLS entity 14"
  std::string layer;  ///< empty: none (DXF's layer 0)

  DrawingKind kind() const { return static_cast<DrawingKind>(shape.index()); }
  friend bool operator==(const DrawingElement&, const DrawingElement&) = default;
};

/// A drawing of the plane as a file holds it: elements in the file's order, coordinates the nearest doubles of the
/// file's decimals, in the file's own unit and with its own axes (those of SVG files have y pointing down).
struct Drawing {
  std::vector<DrawingElement> elements;
  std::vector<std::string> notes;  ///< what was rounded, with a bound of how far it moved, and what was left out
  /// Rings of polygons come in any order, and their fill rule alone says what they enclose, as in SVG. Else, as in WKT
  /// and GeoJSON, the first ring of a polygon is its outline and the others are holes in it.
  bool has_rings_by_rule = false;
};

enum class DrawingFormat : std::uint8_t { wkt, geojson, svg, dxf };

/// The format that a file name's ending stands for (.wkt, .geojson, .json, .svg, .dxf, in any case), or nothing.
std::optional<DrawingFormat> drawing_format_from_path(const std::filesystem::path& path);

struct DrawingReadOptions {
  std::optional<DrawingFormat> format;  ///< else that of the ending, else told by content
  /// Closed paths of DXF (flag of the polyline) and SVG (Z, polygon, rect) are polygons: in DXF one each, in SVG one of
  /// all closed subpaths of a path element. Else they stay paths with `is_closed`. In either case those that cannot
  /// bound anything (fewer than three vertices, two with an arc) stay paths.
  bool closed_paths_are_polygons = true;
};

/// Reads a drawing: WKT (also with SRID and curves), GeoJSON, SVG (also bare path data) or ASCII DXF; docs/formats.md
/// says what each holds.
///
/// Arcs become bulges. Where the bulge or an end of the arc is not a double the nearest one is taken, and a note gives
/// a certified bound of the distance between the two curves. Shapes are kept as they are, with edges of zero length and
/// crossings; see check_drawing. O(text size).
/// @throws FileError   the file cannot be opened or read
/// @throws InputError  the text is refused; the message names file, line and element
Drawing read_drawing(const std::filesystem::path& path, const DrawingReadOptions& options, const Context& context);

/// The same from text in memory; `name` stands for the file in messages, its ending is a hint.
Drawing read_drawing(std::string_view text, const std::string& name, const DrawingReadOptions& options,
                     const Context& context);

/// Refuses what has no extent where it should: edges of zero length (equal vertices one after the other, a ring that
/// repeats its first vertex) and circles without a positive radius; and what cannot come from a reader: no vertices,
/// rings not closed or too short to bound anything, bulges of another number than edges, coordinates not finite.
/// O(size). @throws InputError naming the element
void check_drawing(const Drawing& drawing);

struct DrawingWriteOptions {
  /// Arcs in formats without arcs (GeoJSON) become chains of chords no further than this from them; else they are
  /// refused.
  std::optional<double> flatten_tolerance;
  /// WKT: all elements as one geometry, so that programs that read one geometry get everything. Polygons become a
  /// MULTIPOLYGON, or a MULTISURFACE where some have arcs, and likewise paths and points; elements of several kinds a
  /// GEOMETRYCOLLECTION; one element stays as it is; none are a POLYGON EMPTY.
  bool as_one_geometry = false;
};

/// Writes a drawing with the shortest decimals that read back to the same doubles, and returns notes of what the format
/// cannot hold, with bounds for what was rounded. Where there is none, reading with default options gives the same
/// shapes and layers (GeoJSON: and names) again, exactly.
/// @throws FileError   the file cannot be written
/// @throws InputError  an element is not well formed (see check_drawing; edges of zero length are written), or the
///                     format cannot hold it
std::vector<std::string> write_drawing(const std::filesystem::path& path, DrawingFormat format, const Drawing& drawing,
                                       const DrawingWriteOptions& options, const Context& context);
std::vector<std::string> write_drawing(std::ostream& out, DrawingFormat format, const Drawing& drawing,
                                       const DrawingWriteOptions& options, const Context& context);

}  // namespace quoin
