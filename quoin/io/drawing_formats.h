// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>
#include <string_view>

#include "quoin/base/context.h"
#include "quoin/io/drawing.h"
#include "quoin/io/drawing_text.h"

namespace quoin::io {

/// One reader per format. @throws InputError
Drawing read_wkt(std::string_view text, const std::string& name, const Context& context);
Drawing read_geojson(std::string_view text, const std::string& name, const Context& context);
/// A document or bare path data.
Drawing read_svg(std::string_view text, const std::string& name, const DrawingReadOptions& options,
                 const Context& context);
Drawing read_dxf(std::string_view text, const std::string& name, const DrawingReadOptions& options,
                 const Context& context);

/// One writer per format, for elements that check_structure has let pass. @throws InputError
void write_wkt(std::ostream& out, const Drawing& drawing, const DrawingWriteOptions& options, DrawingNotes& notes,
               const Context& context);
void write_geojson(std::ostream& out, const Drawing& drawing, const DrawingWriteOptions& options, DrawingNotes& notes,
                   const Context& context);
void write_svg(std::ostream& out, const Drawing& drawing, DrawingNotes& notes, const Context& context);
void write_dxf(std::ostream& out, const Drawing& drawing, DrawingNotes& notes, const Context& context);

/// Refuses elements without vertices, with open or too short rings, bulges of another number than edges, coordinates
/// that are not finite. @throws InputError
void check_structure(const Drawing& drawing);

/// Whether a closed path could bound something: three vertices, or two and an arc.
bool can_bound(const DrawingPath& path);

/// Adds an edge to the end: its bulge belongs to the last vertex, the new vertex has none yet. Keeps bulges empty while
/// all edges are straight.
void append_edge(DrawingPath& path, double bulge, const Point2& end);
/// Closes a path whose last vertex repeats the first: takes the vertex away, and its edge becomes the closing one.
void close_at_repeated_end(DrawingPath& path);
/// Closes a path by an edge of this bulge from the last vertex to the first.
void close_with_edge(DrawingPath& path, double bulge);

/// "polygon", "path" and so on.
std::string_view kind_name(DrawingKind kind);

/// The path with its arcs as chains of chords that are no further than the tolerance from them, up to the rounding of
/// their vertices. @throws InputError  naming the element: more than a million chords in an arc
DrawingPath flattened(const DrawingPath& path, double tolerance, const std::string& element);
/// Two half circles between the ends of the horizontal diameter. @throws InputError  the radius is not positive
DrawingPath circle_path(const DrawingCircle& circle, DrawingNotes& notes, const std::string& element);
/// Notes where formats without a flag for closed paths (WKT, GeoJSON) read back another flag.
void note_open_end(const DrawingPath& path, const std::string& element, DrawingNotes& notes);

}  // namespace quoin::io
