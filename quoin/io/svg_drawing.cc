// SPDX-License-Identifier: Apache-2.0
//
// SVG documents and bare path data as drawings: SVG 1.1, chapters 7 to 9.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "quoin/io/drawing_formats.h"
#include "quoin/io/svg_path.h"
#include "quoin/io/svg_transform.h"
#include "quoin/io/text_lines.h"
#include "quoin/io/xml_tags.h"
#include "quoin/number/error_free.h"

namespace quoin::io {

namespace {

// Deeper groups are refused; shifts add digits on the way.
constexpr std::size_t max_groups = 1000;

// What a group hands on.
struct Group {
  std::string_view tag;
  SvgTransform transform;
  FillRule fill = FillRule::nonzero;
  std::string layer;
};

bool is_silent(std::string_view tag) {
  return tag == "title" || tag == "desc" || tag == "metadata";
}

class SvgReader {
 public:
  SvgReader(std::string_view text, const std::string& name, const DrawingReadOptions& options, const Context& context)
      : cursor_(text, name), options_(options), context_(context) {}

  Drawing run() {
    cursor_.skip_space();
    if (cursor_.peek() == '<') {
      document();
    } else {
      const std::string element = "path 1";
      add_paths(element, read_path_data(cursor_, element, notes_, context_));
    }
    drawing_.notes = notes_.list();
    drawing_.has_rings_by_rule = true;
    return std::move(drawing_);
  }

 private:
  void document() {
    XmlTags tags(cursor_, "svg:");
    XmlTag tag;
    std::size_t count = 0;
    bool had_root = false;
    while (tags.next(tag)) {
      if (++count % 256 == 0) context_.poll();
      if (tag.is_end) {
        close(tag);
        continue;
      }
      if (groups_.empty()) {
        if (had_root || tag.name != "svg") cursor_.fail_at(tag.position, "", "one 'svg' element should stand here");
        had_root = true;
      }
      start(tag);
    }
    cursor_.move_to(cursor_.text().size());
    if (!had_root) cursor_.fail("", "there is no 'svg' element");
    if (!groups_.empty()) cursor_.fail("", "the element " + io::quoted(groups_.back().tag) + " does not end");
  }

  void close(const XmlTag& tag) {
    if (groups_.empty() || groups_.back().tag != tag.name) {
      cursor_.fail_at(tag.position, "",
                      "</" + std::string(tag.name.substr(0, 40)) + "> closes no element" +
                          (groups_.empty() ? "" : "; " + io::quoted(groups_.back().tag) + " is open"));
    }
    if (groups_.size() == skipped_from_) skipped_from_ = 0;
    groups_.pop_back();
  }

  void start(const XmlTag& tag) {
    if (skipped_from_ == 0) {
      draw(tag);
    } else if (!tag.is_empty) {
      push({tag.name, {}, FillRule::nonzero, ""}, tag);
    }
  }

  void push(Group group, const XmlTag& tag) {
    if (groups_.size() >= max_groups) cursor_.fail_at(tag.position, "", "elements are nested too deeply");
    groups_.push_back(std::move(group));
  }

  void draw(const XmlTag& tag) {
    const std::string element = element_name(tag);
    const bool is_container = tag.name == "svg" || tag.name == "g" || tag.name == "a";
    if (tag.name == "svg" && !groups_.empty())
      cursor_.fail_at(tag.position, element, "nested svg elements are not supported");
    if (is_container || is_shape(tag.name)) {
      Group group = group_of(tag, element);
      if (!is_container) shape(tag, element, group);
      if (!tag.is_empty) push(std::move(group), tag);
      return;
    }
    if (!is_silent(tag.name)) {
      const bool is_foreign = tag.name.find(':') != std::string_view::npos;
      notes_.count(is_foreign ? "elements of other namespaces are not read"
                              : "elements " + io::quoted(tag.name) + " are not read",
                   is_foreign ? std::string(tag.name) : "");
    }
    if (tag.is_empty) return;
    push({tag.name, {}, FillRule::nonzero, ""}, tag);
    skipped_from_ = groups_.size();
  }

  static bool is_shape(std::string_view tag) {
    static constexpr std::array shapes = {"path", "line", "polyline", "polygon", "rect", "circle", "ellipse"};
    return std::ranges::any_of(shapes, [tag](const char* shape) { return tag == shape; });
  }

  // "path 3 'id'": the third of its kind in the file.
  std::string element_name(const XmlTag& tag) {
    std::string element = std::string(tag.name.substr(0, 40)) + " " + std::to_string(++numbers_[tag.name]);
    if (const XmlAttribute* id = tag.find("id")) element += " " + io::quoted(xml_decoded(id->value));
    return element;
  }

  Group group_of(const XmlTag& tag, const std::string& element) {
    Group group;
    if (!groups_.empty()) group = groups_.back();
    group.tag = tag.name;
    if (const XmlAttribute* transform = tag.find("transform")) {
      group.transform = group.transform.after(SvgTransform::read(value_of(*transform), element));
      if (group.transform.is_excessive())
        cursor_.fail_at(transform->position, element, "its transforms together scale too far");
    }
    if (const XmlAttribute* fill = tag.find("fill-rule")) set_fill(group, fill->value);
    if (const XmlAttribute* style = tag.find("style")) read_style(group, *style, element);
    const XmlAttribute* mode = tag.find("inkscape:groupmode");
    const XmlAttribute* label = tag.find("inkscape:label");
    if (mode != nullptr && mode->value == "layer" && label != nullptr) group.layer = xml_decoded(label->value);
    if (tag.name == "svg" && tag.find("viewBox") != nullptr)
      notes_.count("coordinates are those of the file's viewBox, whatever its size on paper", "");
    return group;
  }

  static void set_fill(Group& group, std::string_view value) {
    value = first_word(value);
    if (value == "evenodd") group.fill = FillRule::even_odd;
    if (value == "nonzero") group.fill = FillRule::nonzero;
  }

  // "name: value; name: value".
  void read_style(Group& group, const XmlAttribute& style, const std::string& element) const {
    std::string_view rest = style.value;
    while (!rest.empty()) {
      const std::string_view item = rest.substr(0, rest.find(';'));
      rest.remove_prefix(std::min(item.size() + 1, rest.size()));
      const std::size_t colon = item.find(':');
      if (colon == std::string_view::npos) continue;
      const std::string_view property = first_word(item.substr(0, colon));
      if (property == "fill-rule") set_fill(group, item.substr(colon + 1));
      if (property == "transform" && first_word(item.substr(colon + 1)) != "none")
        cursor_.fail_at(style.position, element, "a transform in a style is not supported");
    }
  }

  // Positions in the file stay.
  TextCursor value_of(const XmlAttribute& attribute) const {
    return {cursor_, attribute.position, attribute.position + attribute.value.size()};
  }

  void shape(const XmlTag& tag, const std::string& element, const Group& group) {
    if (tag.name == "path") return path(tag, element, group);
    if (tag.name == "circle" || tag.name == "ellipse") return circle(tag, element, group);
    TextCursor at(cursor_, tag.position, cursor_.position());
    SvgPen pen(at, element, notes_);
    if (tag.name == "line") {
      pen.move(number(tag, "x1", element), number(tag, "y1", element), false);
      pen.line(number(tag, "x2", element), number(tag, "y2", element), false);
    } else if (tag.name == "rect") {
      rectangle(tag, element, pen);
    } else {
      if (!vertices(tag, element, pen)) return notes_.count("elements without vertices add nothing", element);
      if (tag.name == "polygon") pen.close();
    }
    finish(element, pen.take(), group);
  }

  void path(const XmlTag& tag, const std::string& element, const Group& group) {
    const XmlAttribute* data = tag.find("d");
    if (data == nullptr || first_word(data->value).empty() || first_word(data->value) == "none")
      return notes_.count("elements without vertices add nothing", element);
    TextCursor cursor = value_of(*data);
    finish(element, read_path_data(cursor, element, notes_, context_), group);
  }

  // The points of a polyline or polygon; whether there are any.
  bool vertices(const XmlTag& tag, const std::string& element, SvgPen& pen) const {
    const XmlAttribute* points = tag.find("points");
    if (points == nullptr) return false;
    TextCursor cursor = value_of(*points);
    cursor.skip_space();
    bool is_first = true;
    while (!cursor.at_end()) {
      const double x = cursor.number(element);
      cursor.skip_comma();
      const double y = cursor.number(element);
      if (is_first) {
        pen.move(x, y, false);
      } else {
        pen.line(x, y, false);
      }
      is_first = false;
      if (cursor.skip_comma() && cursor.at_end()) cursor.fail(element, "a number should follow the last comma");
    }
    return !is_first;
  }

  void rectangle(const XmlTag& tag, const std::string& element, SvgPen& pen) {
    const double x = number(tag, "x", element);
    const double y = number(tag, "y", element);
    const double width = number(tag, "width", element);
    const double height = number(tag, "height", element);
    if (width < 0 || height < 0) cursor_.fail_at(tag.position, element, "width or height is negative");
    const bool has_x = tag.find("rx") != nullptr;
    const double rx = std::min(number(tag, has_x ? "rx" : "ry", element), width / 2);
    const double ry = std::min(number(tag, tag.find("ry") != nullptr ? "ry" : "rx", element), height / 2);
    if (rx < 0 || ry < 0) cursor_.fail_at(tag.position, element, "the radius of the corners is negative");
    const double r = rx == 0 || ry == 0 ? 0 : rx;
    if (r != 0 && rx != ry) cursor_.fail_at(tag.position, element, "elliptical corners are not supported");
    if (r == 0) {
      pen.move(x, y, false);
      pen.horizontal(width, true);
      pen.vertical(height, true);
      pen.horizontal(-width, true);
      return pen.close();
    }
    const TwoDoubles across = two_difference(width, 2 * r);
    const TwoDoubles along = two_difference(height, 2 * r);
    const double cut_off = std::fabs(across.tail) + std::fabs(along.tail);
    if (cut_off > 0) notes_.moved("corners of rectangles are rounded", element, 2 * cut_off);
    pen.stand(x, y);
    pen.move(r, 0, true);  // straight parts may have no length: then the corners meet
    if (across.value > 0) pen.horizontal(across.value, true);
    pen.arc(r, false, true, r, r, true);
    if (along.value > 0) pen.vertical(along.value, true);
    pen.arc(r, false, true, -r, r, true);
    if (across.value > 0) pen.horizontal(-across.value, true);
    pen.arc(r, false, true, -r, -r, true);
    if (along.value > 0) pen.vertical(-along.value, true);
    pen.arc(r, false, true, r, -r, true);
    pen.close();
  }

  void circle(const XmlTag& tag, const std::string& element, const Group& group) {
    DrawingCircle circle{{number(tag, "cx", element), number(tag, "cy", element)}, 0};
    circle.radius = number(tag, tag.name == "circle" ? "r" : "rx", element);
    if (tag.name == "ellipse" && number(tag, "ry", element) != circle.radius)
      cursor_.fail_at(tag.position, element, "ellipses are not supported");
    group.transform.apply(circle, cursor_, element, notes_);
    drawing_.elements.push_back({circle, element, group.layer});
  }

  // The whole value; 0 without one. Units other than px would need a size on paper.
  double number(const XmlTag& tag, std::string_view name, const std::string& element) const {
    const XmlAttribute* attribute = tag.find(name);
    if (attribute == nullptr) return 0;
    TextCursor cursor = value_of(*attribute);
    const double value = cursor.number(element);
    const std::string_view unit = cursor.word();
    cursor.skip_space();
    if ((!unit.empty() && unit != "px") || !cursor.at_end())
      cursor.fail_at(attribute->position, element,
                     io::quoted(attribute->value) + " for " + io::quoted(name) + " is no number of user units");
    return value;
  }

  void finish(const std::string& element, std::vector<DrawingPath> paths, const Group& group) {
    for (DrawingPath& path : paths) group.transform.apply(path, cursor_, element, notes_);
    add_paths(element, std::move(paths), group);
  }

  // All closed subpaths as one polygon, if so asked, and the others.
  void add_paths(const std::string& element, std::vector<DrawingPath> paths, const Group& group = {}) {
    DrawingPolygon polygon{{}, group.fill};
    if (options_.closed_paths_are_polygons) {
      for (DrawingPath& path : paths) {
        if (path.is_closed && can_bound(path)) polygon.rings.push_back(std::exchange(path, {}));
      }
      std::erase_if(paths, [](const DrawingPath& path) { return path.points.empty(); });
    }
    const bool has_parts = paths.size() + (polygon.rings.empty() ? 0 : 1) > 1;
    if (!polygon.rings.empty()) drawing_.elements.push_back({std::move(polygon), element, group.layer});
    for (std::size_t i = 0; i < paths.size(); ++i) {
      const std::string part = has_parts ? element + ", subpath " + std::to_string(i + 1) : element;
      drawing_.elements.push_back({std::move(paths[i]), part, group.layer});
    }
  }

  TextCursor cursor_;
  const DrawingReadOptions& options_;
  const Context& context_;
  Drawing drawing_;
  DrawingNotes notes_;
  std::vector<Group> groups_;     // open elements
  std::size_t skipped_from_ = 0;  // size of groups_ where a part that is not read begins; 0: none
  std::map<std::string_view, std::size_t> numbers_;
};

}  // namespace

Drawing read_svg(std::string_view text, const std::string& name, const DrawingReadOptions& options,
                 const Context& context) {
  return SvgReader(text, name, options, context).run();
}

}  // namespace quoin::io
