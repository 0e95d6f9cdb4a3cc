// SPDX-License-Identifier: Apache-2.0
//
// ASCII DXF: pairs of lines, a group code and its value (AutoCAD DXF reference, "ENTITIES section").
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "quoin/io/drawing_arcs.h"
#include "quoin/io/drawing_formats.h"
#include "quoin/io/dxf_groups.h"
#include "quoin/io/text_lines.h"

namespace quoin::io {

namespace {

// The groups of one entity that are read.
struct Entity {
  std::string type;
  std::string element;
  std::string layer;
  std::size_t line = 0;
  std::vector<Point2> points;                // groups 10 and 20, and for a LINE 11 and 21
  std::vector<double> bulges;                // group 42 behind each point
  double radius = 0;                         // 40
  double start = 0;                          // 50
  double end = 0;                            // 51
  std::int64_t flags = 0;                    // 70
  std::int64_t count = -1;                   // 90
  std::array<double, 3> extrusion{0, 0, 1};  // 210, 220, 230
  bool has_height = false;
  bool is_on_paper = false;  // 67
  bool has_radius = false;
  bool has_end_x = false;
  bool has_end_y = false;
  bool has_x = false;  // an x whose y is still to come
};

class DxfReader {
 public:
  DxfReader(std::string_view text, const std::string& name, const DrawingReadOptions& options, const Context& context)
      : groups_(text, name), options_(options), context_(context) {}

  Drawing run() {
    groups_.next();
    while (!groups_.is(0, "EOF")) {
      if (!groups_.is(0, "SECTION")) groups_.fail("", "a SECTION or EOF should stand here");
      groups_.next();
      if (groups_.code() != 2) groups_.fail("", "the name of a section should stand here");
      const std::string section(groups_.value());
      groups_.next();
      if (section == "HEADER") {
        header();
      } else if (section == "ENTITIES") {
        entities();
      } else {
        skip(section);
      }
      if (!groups_.is(0, "ENDSEC")) groups_.fail("", "ENDSEC should stand here");
      groups_.next();
    }
    groups_.expect_end();
    drawing_.notes = notes_.list();
    return std::move(drawing_);
  }

 private:
  void header() {
    bool is_unit = false;
    while (groups_.code() != 0) {
      if (groups_.code() == 9) is_unit = groups_.value() == "$INSUNITS";
      if (is_unit && groups_.code() == 70 && groups_.integer("") != 0)
        notes_.count("the file's unit ($INSUNITS " + std::to_string(groups_.integer("")) + ") is not kept", "");
      groups_.next();
    }
  }

  // Blocks too: they draw nothing without an INSERT, which is noted.
  void skip(const std::string& section) {
    std::size_t polls = 0;
    while (!groups_.is(0, "ENDSEC")) {
      if (groups_.is(0, "SECTION") || groups_.is(0, "EOF"))
        groups_.fail("", "the section " + io::quoted(section) + " does not end");
      if (++polls % 4096 == 0) context_.poll();
      groups_.next();
    }
  }

  void entities() {
    std::size_t number = 0;
    while (!groups_.is(0, "ENDSEC")) {
      if (++number % 256 == 0) context_.poll();
      const std::string unnamed = "entity " + std::to_string(number);
      if (groups_.code() != 0) groups_.fail(unnamed, "an entity should begin here");
      Entity entity = read_entity(unnamed);
      if (entity.type == "POLYLINE") read_vertices(entity);
      if (entity.is_on_paper) {
        notes_.count("entities of the paper space are not read", entity.element);
      } else {
        add(entity);
      }
    }
  }

  // Its groups up to the next one of code 0.
  Entity read_entity(const std::string& unnamed) {
    Entity entity;
    entity.type = groups_.value();
    entity.element = unnamed;
    entity.line = groups_.line();
    if (entity.type == "SECTION" || entity.type == "EOF") groups_.fail("", "the section 'ENTITIES' does not end");
    if (entity.type == "VERTEX" || entity.type == "SEQEND")
      groups_.fail(unnamed, io::quoted(entity.type) + " is outside of a POLYLINE");
    const bool is_read = is_known(entity.type);
    while (groups_.next(), groups_.code() != 0) {
      if (groups_.code() == 8 && groups_.value() != "0") {
        entity.layer = groups_.value();
        entity.element = "layer " + entity.layer + " " + unnamed;
      }
      if (is_read) group(entity);
    }
    if (entity.has_x) groups_.fail(entity.element, "a y (group 20) is missing");
    return entity;
  }

  static bool is_known(std::string_view type) {
    static constexpr std::array types = {"LINE", "LWPOLYLINE", "POLYLINE", "VERTEX", "ARC", "CIRCLE", "POINT"};
    return std::ranges::any_of(types, [type](const char* known) { return type == known; });
  }

  double number(const Entity& entity) const { return groups_.number(entity.element); }

  void group(Entity& entity) {
    switch (groups_.code()) {
      case 10:
      case 20:
        return point_group(entity);
      case 11:
      case 21:
        return end_group(entity);
      case 30:
      case 31:
      case 38:
        entity.has_height |= number(entity) != 0;
        return;
      case 39:
        if (number(entity) != 0) notes_.count("thickness is ignored", entity.element);
        return;
      case 40:
        if (entity.type == "ARC" || entity.type == "CIRCLE") {
          entity.radius = number(entity);
          entity.has_radius = true;
          return;
        }
        [[fallthrough]];
      case 41:
      case 43:
        if (number(entity) != 0) notes_.count("widths are ignored", entity.element);
        return;
      case 42:
        if (entity.bulges.empty()) groups_.fail(entity.element, "a bulge (group 42) before the first vertex");
        entity.bulges.back() = number(entity);
        return;
      default:
        return further_group(entity);
    }
  }

  // x and y of a vertex, one after the other.
  void point_group(Entity& entity) const {
    const bool is_x = groups_.code() == 10;
    if (is_x && entity.has_x) groups_.fail(entity.element, "a y (group 20) is missing");
    if (!is_x && !entity.has_x) groups_.fail(entity.element, "a y (group 20) without an x");
    if (is_x && !entity.points.empty() && entity.type != "LWPOLYLINE")
      groups_.fail(entity.element, "a second point (group 10)");
    if (is_x) {
      entity.points.push_back({number(entity), 0});
      entity.bulges.push_back(0);
    } else {
      entity.points.back().y = number(entity);
    }
    entity.has_x = is_x;
  }

  void end_group(Entity& entity) {
    if (entity.type != "LINE") return;
    if (groups_.code() == 11) {
      end_point_.x = number(entity);
      entity.has_end_x = true;
    } else {
      end_point_.y = number(entity);
      entity.has_end_y = true;
    }
  }

  void further_group(Entity& entity) {
    switch (groups_.code()) {
      case 50:
        entity.start = number(entity);
        break;
      case 51:
        entity.end = number(entity);
        break;
      case 67:
        entity.is_on_paper = groups_.integer(entity.element) != 0;
        break;
      case 70:
        entity.flags = groups_.integer(entity.element);
        break;
      case 90:
        entity.count = groups_.integer(entity.element);
        break;
      case 210:
      case 220:
      case 230:
        entity.extrusion[static_cast<std::size_t>(groups_.code() - 210) / 10] = number(entity);
        break;
      default:
        break;
    }
  }

  // The VERTEX entities of a POLYLINE, and SEQEND.
  void read_vertices(Entity& polyline) {
    static constexpr std::int64_t curve_or_surface = 2 | 4 | 16 | 64;
    if ((polyline.flags & curve_or_surface) != 0) {
      groups_.fail_at(polyline.line, polyline.element,
                      "polylines that are fitted curves, meshes or surfaces are not supported");
    }
    polyline.points.clear();  // group 10 of a POLYLINE is a dummy, with the height
    polyline.bulges.clear();
    while (groups_.is(0, "VERTEX")) {
      Entity vertex;
      vertex.type = "VERTEX";
      vertex.element = polyline.element + ", vertex " + std::to_string(polyline.points.size() + 1);
      while (groups_.next(), groups_.code() != 0) group(vertex);
      if (vertex.points.empty() || vertex.has_x)
        groups_.fail(vertex.element, "its point (groups 10 and 20) is missing");
      polyline.points.push_back(vertex.points[0]);
      polyline.bulges.push_back(vertex.bulges[0]);
      polyline.has_height |= vertex.has_height;
    }
    if (!groups_.is(0, "SEQEND")) groups_.fail(polyline.element, "VERTEX or SEQEND should stand here");
    while (groups_.next(), groups_.code() != 0) {
    }
  }

  // Whether x is mirrored: the entity's plane is seen from below. LINE and POINT have coordinates of the world.
  bool is_mirrored(const Entity& entity) const {
    if (entity.type == "LINE" || entity.type == "POINT") return false;
    const bool is_upright = entity.extrusion[0] == 0 && entity.extrusion[1] == 0 && entity.extrusion[2] != 0;
    if (!is_upright) groups_.fail_at(entity.line, entity.element, "its extrusion direction is not along z");
    return entity.extrusion[2] < 0;
  }

  void add(Entity& entity) {
    if (!is_known(entity.type))
      return notes_.count("entities " + io::quoted(entity.type) + " are not read", entity.element);
    if (entity.has_height) notes_.count("entities lose their Z", entity.element);
    const bool is_polyline = entity.type == "LWPOLYLINE" || entity.type == "POLYLINE";
    if (!is_polyline && entity.points.empty()) fail(entity, "its point (groups 10 and 20) is missing");
    if (is_polyline) return polyline(entity);
    if (entity.type == "POINT") return push(entity, entity.points[0]);
    if (entity.type == "LINE") {
      if (!entity.has_end_x || !entity.has_end_y) fail(entity, "its end (groups 11 and 21) is missing");
      return push(entity, DrawingPath{{entity.points[0], end_point_}, {}, false});
    }
    if (!entity.has_radius) fail(entity, "its radius (group 40) is missing");
    if (entity.type == "CIRCLE") return push(entity, circle_of(entity));
    arc(entity);
  }

  [[noreturn]] void fail(const Entity& entity, std::string_view what) const {
    groups_.fail_at(entity.line, entity.element, what);
  }

  template <class Shape>
  void push(const Entity& entity, Shape&& shape) {
    drawing_.elements.push_back({std::forward<Shape>(shape), entity.element, entity.layer});
  }

  DrawingCircle circle_of(const Entity& entity) const {
    DrawingCircle circle{entity.points[0], entity.radius};
    if (is_mirrored(entity)) circle.center.x = plain(-circle.center.x);
    return circle;
  }

  void polyline(Entity& entity) {
    if (entity.count >= 0 && static_cast<std::uint64_t>(entity.count) != entity.points.size() &&
        entity.type == "LWPOLYLINE") {
      fail(entity, std::to_string(entity.points.size()) + " vertices where " + std::to_string(entity.count) +
                       " are announced (group 90)");
    }
    const bool is_closed = (entity.flags & 1) != 0;
    const std::size_t vertices = entity.points.size();
    if (vertices < (is_closed ? 1U : 2U)) fail(entity, "it has too few vertices");
    DrawingPath path{{entity.points[0]}, {}, false};
    for (std::size_t i = 1; i < vertices; ++i) append_edge(path, entity.bulges[i - 1], entity.points[i]);
    if (is_closed) close_with_edge(path, entity.bulges.back());
    if (is_mirrored(entity)) mirror(path);
    if (is_closed && options_.closed_paths_are_polygons && can_bound(path)) {
      push(entity, DrawingPolygon{{std::move(path)}, FillRule::even_odd});
    } else {
      push(entity, std::move(path));
    }
  }

  static void mirror(DrawingPath& path) {
    for (Point2& p : path.points) p.x = plain(-p.x);
    for (double& bulge : path.bulges) bulge = plain(-bulge);
  }

  void arc(const Entity& entity) {
    if (entity.radius < 0) fail(entity, "its radius is negative");
    const auto arc = arc_of_angles(entity.points[0], entity.radius, entity.start, entity.end);
    if (!arc) fail(entity, "its ends are beyond the largest double");
    if (arc->distance > 0) notes_.moved("arcs are rounded", entity.element, arc->distance);
    if (arc->is_whole) {
      notes_.count("arcs once around are circles", entity.element);
      return push(entity, circle_of(entity));
    }
    DrawingPath path{{arc->start}, {}, false};
    append_edge(path, arc->bulge, arc->end);
    if (is_mirrored(entity)) mirror(path);
    push(entity, std::move(path));
  }

  DxfGroups groups_;
  const DrawingReadOptions& options_;
  const Context& context_;
  Drawing drawing_;
  DrawingNotes notes_;
  Point2 end_point_;  // of the LINE that is read
};

}  // namespace

Drawing read_dxf(std::string_view text, const std::string& name, const DrawingReadOptions& options,
                 const Context& context) {
  return DxfReader(text, name, options, context).run();
}

}  // namespace quoin::io
