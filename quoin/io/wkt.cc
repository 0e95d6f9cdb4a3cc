// SPDX-License-Identifier: Apache-2.0
//
// Well-known text: OGC Simple Features 1.2.1 section 7, with the curves of ISO/IEC 13249-3 and the SRID prefix of EWKT.
#include <array>
#include <utility>

#include "quoin/io/drawing_arcs.h"
#include "quoin/io/drawing_formats.h"
#include "quoin/io/text_lines.h"

namespace quoin::io {

namespace {

enum class Tag {
  point,
  line,
  arcs,
  compound,
  polygon,
  curve_polygon,
  multi_point,
  multi_line,
  multi_curve,
  multi_polygon,
  multi_surface,
  collection
};

struct Keyword {
  std::string_view word;
  std::string_view name;
  Tag tag;
};

constexpr std::array keywords = {Keyword{"point", "point", Tag::point},
                                 Keyword{"linestring", "linestring", Tag::line},
                                 Keyword{"circularstring", "circularstring", Tag::arcs},
                                 Keyword{"compoundcurve", "compoundcurve", Tag::compound},
                                 Keyword{"polygon", "polygon", Tag::polygon},
                                 Keyword{"curvepolygon", "curvepolygon", Tag::curve_polygon},
                                 Keyword{"multipoint", "multipoint", Tag::multi_point},
                                 Keyword{"multilinestring", "multilinestring", Tag::multi_line},
                                 Keyword{"multicurve", "multicurve", Tag::multi_curve},
                                 Keyword{"multipolygon", "multipolygon", Tag::multi_polygon},
                                 Keyword{"multisurface", "multisurface", Tag::multi_surface},
                                 Keyword{"geometrycollection", "collection", Tag::collection}};

// Coordinates of a vertex beyond x and y; "unknown" until the first vertex of a geometry without Z, M or ZM.
struct Dimension {
  bool is_known = false;
  std::size_t numbers = 2;
};

class WktReader {
 public:
  WktReader(std::string_view text, const std::string& name, const Context& context)
      : cursor_(text, name), context_(context) {}

  Drawing run() {
    for (;;) {
      while (cursor_.accept(';')) {
      }
      cursor_.skip_space();
      if (cursor_.at_end()) break;
      ++geometries_;
      skip_srid();
      geometry("", geometries_, 0);
    }
    if (geometries_ == 0) cursor_.fail("", "there is no geometry");
    drawing_.notes = notes_.list();
    return std::move(drawing_);
  }

 private:
  void skip_srid() {
    const std::size_t begin = cursor_.position();
    if (!is_word(cursor_.word(), "srid")) return cursor_.move_to(begin);
    const std::string element = "geometry " + std::to_string(geometries_);
    if (!cursor_.accept('=')) cursor_.fail(element, "SRID is not followed by '='");
    cursor_.number(element);
    if (!cursor_.accept(';')) cursor_.fail(element, "SRID is not followed by ';'");
    notes_.count("reference systems (SRID) are not kept", element);
  }

  // A keyword with its dimension and body. `prefix` names what it is a part of, `index` which part.
  void geometry(const std::string& prefix, std::size_t index, std::size_t depth) {
    const std::string part = prefix + "geometry " + std::to_string(index);
    if (depth >= max_nesting) cursor_.fail(part, "collections are nested too deeply");
    cursor_.skip_space();
    const std::size_t begin = cursor_.position();
    const Keyword& keyword = known(cursor_.word(), begin, part);
    const std::string element = prefix + std::string(keyword.name) + " " + std::to_string(index);
    Dimension dimension = dimension_after(cursor_.text().substr(begin, cursor_.position() - begin), keyword);
    body(keyword.tag, element, dimension, depth);
  }

  const Keyword& known(std::string_view word, std::size_t begin, const std::string& part) const {
    for (const Keyword& keyword : keywords) {
      if (fits(word, keyword.word)) return keyword;
    }
    TextCursor at = cursor_;
    at.move_to(begin);
    at.fail(part, at.found() + " is no geometry that is read");
  }

  // The keyword, perhaps with Z, M or ZM at its end.
  static bool fits(std::string_view word, std::string_view keyword) {
    if (word.size() < keyword.size() || !is_word(word.substr(0, keyword.size()), keyword)) return false;
    const std::string_view rest = word.substr(keyword.size());
    return rest.empty() || is_word(rest, "z") || is_word(rest, "m") || is_word(rest, "zm");
  }

  Dimension dimension_after(std::string_view word, const Keyword& keyword) {
    std::string_view suffix = word.substr(keyword.word.size());
    if (suffix.empty()) {
      const std::size_t before = cursor_.position();
      suffix = cursor_.word();
      if (!is_word(suffix, "z") && !is_word(suffix, "m") && !is_word(suffix, "zm")) {
        cursor_.move_to(before);
        return {};
      }
    }
    return {true, 2 + suffix.size()};
  }

  bool accept_empty(const std::string& element) {
    const std::size_t before = cursor_.position();
    if (!is_word(cursor_.word(), "empty")) {
      cursor_.move_to(before);
      return false;
    }
    notes_.count("empty geometries add nothing", element);
    return true;
  }

  // Takes `item` as often as a list in parentheses has items.
  template <class Item>
  void list(const std::string& element, const Item& item) {
    if (!cursor_.accept('(')) cursor_.fail(element, "'(' should stand here, and " + cursor_.found() + " does");
    std::size_t index = 0;
    do {
      if (++polls_ % 256 == 0) context_.poll();
      item(++index);
    } while (cursor_.accept(','));
    cursor_.skip_space();
    if (!cursor_.accept(')')) cursor_.fail(element, "',' or ')' should stand here, and " + cursor_.found() + " does");
  }

  void body(Tag tag, const std::string& element, Dimension& dimension, std::size_t depth) {
    if (accept_empty(element)) return;
    const auto parts = [&](Tag part, std::string_view name, bool may_be_tagged) {
      list(element, [&](std::size_t index) { member(part, element, name, index, may_be_tagged, dimension, depth); });
    };
    switch (tag) {
      case Tag::point:
        return point(element, dimension);
      case Tag::line:
      case Tag::arcs:
      case Tag::compound:
        return curve(tag, element, dimension);
      case Tag::polygon:
      case Tag::curve_polygon:
        return polygon(tag, element, dimension);
      case Tag::multi_point:
        return parts(Tag::point, "point", false);
      case Tag::multi_line:
        return parts(Tag::line, "linestring", false);
      case Tag::multi_curve:
        return parts(Tag::line, "linestring", true);
      case Tag::multi_polygon:
        return parts(Tag::polygon, "polygon", false);
      case Tag::multi_surface:
        return parts(Tag::polygon, "polygon", true);
      case Tag::collection:
        return list(element, [&](std::size_t index) { geometry(element + ", ", index, depth + 1); });
    }
  }

  void member(Tag tag, const std::string& parent, std::string_view name, std::size_t index, bool may_be_tagged,
              Dimension& dimension, std::size_t depth) {
    cursor_.skip_space();
    const std::string element = parent + ", " + std::string(name) + " " + std::to_string(index);
    const char next = cursor_.peek();
    if (may_be_tagged && next != '(' && next != 'e' && next != 'E') return tagged_member(tag, parent, index, depth);
    if (tag == Tag::point && next != '(' && next != 'e' && next != 'E') {  // MULTIPOINT (1 2, 3 4)
      return add(element, vertex(element, dimension));
    }
    body(tag, element, dimension, depth);
  }

  // A member of a MULTICURVE or MULTISURFACE that says what it is.
  void tagged_member(Tag tag, const std::string& parent, std::size_t index, std::size_t depth) {
    const std::size_t begin = cursor_.position();
    const std::string_view word = cursor_.word();
    const bool is_surface = fits(word, "polygon") || fits(word, "curvepolygon");
    const bool is_curve = fits(word, "linestring") || fits(word, "circularstring") || fits(word, "compoundcurve");
    cursor_.move_to(begin);
    if (tag == Tag::polygon ? !is_surface : !is_curve)
      cursor_.fail(parent + ", part " + std::to_string(index), cursor_.found() + " does not belong here");
    geometry(parent + ", ", index, depth + 1);
  }

  template <class Shape>
  void add(const std::string& element, Shape&& shape) {
    drawing_.elements.push_back({std::forward<Shape>(shape), element, ""});
  }

  Point2 vertex(const std::string& element, Dimension& dimension) {
    const double x = cursor_.number(element);
    const double y = cursor_.number(element);
    std::size_t numbers = 2;
    for (; numbers < 4; ++numbers) {
      cursor_.skip_space();
      if (number_length(cursor_.rest()) == 0) break;
      cursor_.number(element);
    }
    if (!dimension.is_known) dimension = {true, numbers};
    if (numbers != dimension.numbers) {
      cursor_.fail(element, "a vertex of " + std::to_string(numbers) + " numbers among those of " +
                                std::to_string(dimension.numbers));
    }
    if (numbers > 2) notes_.count("vertices lose their Z or M", element);
    return {x, y};
  }

  void point(const std::string& element, Dimension& dimension) {
    list(element, [&](std::size_t index) {
      const Point2 p = vertex(element, dimension);
      if (index > 1) cursor_.fail(element, "a point has one vertex");
      add(element, p);
    });
  }

  std::vector<Point2> vertices(const std::string& element, Dimension& dimension) {
    std::vector<Point2> points;
    list(element, [&](std::size_t) { points.push_back(vertex(element, dimension)); });
    return points;
  }

  void curve(Tag tag, const std::string& element, Dimension& dimension) {
    cursor_.skip_space();
    const std::size_t begin = cursor_.position();
    DrawingPath path;
    if (tag == Tag::arcs) {
      const std::vector<Point2> points = vertices(element, dimension);
      if (const auto circle = whole_circle(points)) return add(element, *circle);
      path = arcs_through(points, element, begin);
    } else {
      path = chain(tag, element, dimension);
    }
    if (path.points.size() < 2) cursor_.fail_at(begin, element, "a curve has at least two vertices");
    if (path.points.size() > 2 && path.points.front() == path.points.back()) close_at_repeated_end(path);
    add(element, std::move(path));
  }

  // CIRCULARSTRING (a, b, a), where centre and radius of the circle over the diameter a - b are doubles.
  static std::optional<DrawingCircle> whole_circle(const std::vector<Point2>& points) {
    if (points.size() != 3 || points[0] != points[2] || points[0] == points[1]) return std::nullopt;
    return circle_over_diameter(points[0], points[1]);
  }

  void polygon(Tag tag, const std::string& element, Dimension& dimension) {
    DrawingPolygon polygon;
    list(element, [&](std::size_t index) {
      const std::string ring_name = element + ", ring " + std::to_string(index);
      cursor_.skip_space();
      const std::size_t begin = cursor_.position();
      const Tag ring_tag = tag == Tag::curve_polygon ? ring_keyword(ring_name) : Tag::line;
      DrawingPath ring = chain(ring_tag, ring_name, dimension);
      if (ring.points.front() != ring.points.back())
        cursor_.fail_at(begin, ring_name, "the ring is not closed: its last vertex is not its first");
      close_at_repeated_end(ring);
      if (!can_bound(ring)) cursor_.fail_at(begin, ring_name, "the ring has too few vertices");
      polygon.rings.push_back(std::move(ring));
    });
    add(element, std::move(polygon));
  }

  Tag ring_keyword(const std::string& ring_name) {
    if (cursor_.peek() == '(') return Tag::line;
    const std::size_t begin = cursor_.position();
    const std::string_view word = cursor_.word();
    for (const Keyword& keyword : keywords) {
      const bool is_curve = keyword.tag == Tag::line || keyword.tag == Tag::arcs || keyword.tag == Tag::compound;
      if (!is_curve || !fits(word, keyword.word)) continue;
      dimension_after(word, keyword);
      return keyword.tag;
    }
    cursor_.move_to(begin);
    cursor_.fail(ring_name, cursor_.found() + " is no ring");
  }

  // An open path, as it is written, of straight edges, arcs or both.
  DrawingPath chain(Tag tag, const std::string& element, Dimension& dimension) {
    DrawingPath path;
    if (tag == Tag::compound) {
      list(element, [&](std::size_t index) {
        const std::string part = element + ", part " + std::to_string(index);
        cursor_.skip_space();
        const std::size_t begin = cursor_.position();
        const Tag part_tag = ring_keyword(part);
        if (part_tag == Tag::compound) cursor_.fail_at(begin, part, "a compound curve inside another");
        append(path, chain(part_tag, part, dimension), part, begin);
      });
      return path;
    }
    const std::size_t begin = cursor_.position();
    std::vector<Point2> points = vertices(element, dimension);
    if (tag == Tag::arcs) return arcs_through(points, element, begin);
    path.points = std::move(points);
    return path;
  }

  DrawingPath arcs_through(const std::vector<Point2>& points, const std::string& element, std::size_t begin) {
    DrawingPath path;
    if (points.size() < 3 || points.size() % 2 == 0)
      cursor_.fail_at(begin, element, "arcs need an odd number of vertices, at least three");
    path.points.push_back(points[0]);
    for (std::size_t i = 0; i + 2 < points.size(); i += 2) arc(path, points[i + 1], points[i + 2], element, begin);
    return path;
  }

  void append(DrawingPath& path, const DrawingPath& part, const std::string& element, std::size_t begin) const {
    if (part.points.size() < 2) cursor_.fail_at(begin, element, "a curve has at least two vertices");
    if (path.points.empty()) path.points.push_back(part.points[0]);
    if (path.points.back() != part.points[0])
      cursor_.fail_at(begin, element, "it does not begin where the part before it ends");
    for (std::size_t e = 0; e < part.edge_count(); ++e) append_edge(path, part.bulge(e), part.end(e));
  }

  void arc(DrawingPath& path, const Point2& middle, const Point2& end, const std::string& element, std::size_t begin) {
    const Point2 start = path.points.back();
    if (start == end && start == middle) return append_edge(path, 0, end);
    if (start == end) {  // the whole circle over the diameter from start to middle
      append_edge(path, 1, middle);
      append_edge(path, 1, end);
      return;
    }
    const auto bulge = bulge_through(start, middle, end);
    if (!bulge) cursor_.fail_at(begin, element, "no arc goes through three of its vertices");
    if (bulge->distance > 0) notes_.moved("arcs are rounded", element, bulge->distance);
    append_edge(path, bulge->bulge, end);
  }

  TextCursor cursor_;
  const Context& context_;
  Drawing drawing_;
  DrawingNotes notes_;
  std::size_t geometries_ = 0;
  std::size_t polls_ = 0;
};

}  // namespace

Drawing read_wkt(std::string_view text, const std::string& name, const Context& context) {
  return WktReader(text, name, context).run();
}

}  // namespace quoin::io
