// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/svg_drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "quoin/view/page_text.h"

namespace quoin::svg_drawing {

namespace {

using page_text::write_number;
using page_text::write_xml;

void write_color(std::ostream& out, const Color& color) {
  constexpr char digits[] = "0123456789abcdef";
  out << '#';
  for (const std::uint8_t c : {color.r, color.g, color.b}) out << digits[c >> 4] << digits[c & 15];
}

void write_point(std::ostream& out, const Point2& p) {
  write_pixel(out, p.x);
  out << ' ';
  write_pixel(out, p.y);
}

void write_arc(std::ostream& out, const PathStep& step, double sweep, const Point2& to) {
  out << 'A';
  const double radius = std::hypot(step.to.x - step.center.x, step.to.y - step.center.y);
  write_point(out, {radius, radius});
  // On the sheet y points downward, and so does SVG's sense of turning.
  out << " 0 0 " << (sweep > 0 ? '1' : '0') << ' ';
  write_point(out, to);
}

/// Arcs beyond a third of a turn are halved: their ends then tell them from their complement, however they are rounded.
void write_path_data(std::ostream& out, const PicturePath& path, bool is_closed) {
  if (path.steps.empty()) return;
  out << 'M';
  write_point(out, path.start);
  Point2 from = path.start;
  for (const PathStep& step : path.steps) {
    if (!step.is_arc()) {
      out << 'L';
      write_point(out, step.to);
    } else {
      const int count = static_cast<int>(std::ceil(std::fabs(step.sweep) / (2 * std::numbers::pi / 3) - 1e-9));
      for (int i = 1; i < count; ++i) {
        const double c = std::cos(step.sweep * i / count);
        const double s = std::sin(step.sweep * i / count);
        const double dx = from.x - step.center.x;
        const double dy = from.y - step.center.y;
        write_arc(out, step, step.sweep, {step.center.x + c * dx - s * dy, step.center.y + s * dx + c * dy});
      }
      write_arc(out, step, step.sweep, step.to);
    }
    from = step.to;
  }
  if (is_closed) out << 'Z';
}

/// Class and explicit colour.
void write_look(std::ostream& out, const PictureFill& fill, std::string_view further_class, bool is_line) {
  const bool has_class = (fill.category && !fill.color) || !further_class.empty();
  if (has_class) {
    out << " class=\"" << further_class;
    if (fill.category && !fill.color) {
      if (!further_class.empty()) out << ' ';
      out << 'c';
      write_number(out, *fill.category);
    }
    out << '"';
  }
  if (fill.color) {
    out << " style=\"" << (is_line ? "stroke:" : "fill:");
    write_color(out, *fill.color);
    if (fill.color->a != 255) {
      out << (is_line ? ";stroke-opacity:" : ";fill-opacity:");
      write_number(out, std::round(fill.color->a / 2.55) / 100);
    }
    out << '"';
  }
}

void write_tooltip(std::ostream& out, const PictureText& text) {
  out << "<title>";
  write_xml(out, text.name);
  bool is_first = text.name.empty();
  for (const ViewFact& fact : text.facts) {
    if (!is_first) out << '\n';
    is_first = false;
    write_xml(out, fact.first);
    out << ": ";
    write_xml(out, fact.second);
  }
  out << "</title>";
}

void end_cell(std::ostream& out, std::string_view element, const PictureText& text, bool has_tooltips) {
  if (has_tooltips && !(text.name.empty() && text.facts.empty())) {
    out << '>';
    write_tooltip(out, text);
    out << "</" << element << ">\n";
  } else {
    out << "/>\n";
  }
}

std::string_view class_of(EdgeStyle style) {
  switch (style) {
    case EdgeStyle::strong:
      return "strong";
    case EdgeStyle::faint:
      return "faint";
    case EdgeStyle::dashed:
      return "dashed";
    case EdgeStyle::plain:
      break;
  }
  return "";
}

std::set<std::uint32_t> categories_of(const PlanarPicture& picture) {
  std::set<std::uint32_t> categories;
  for (std::uint32_t i = 0; i < picture.categories.size(); ++i) categories.insert(i);
  const auto add = [&](const PictureFill& fill) {
    if (fill.category) categories.insert(*fill.category);
  };
  for (const PictureFace& face : picture.faces) add(face.fill);
  for (const PictureEdge& edge : picture.edges) add(edge.stroke);
  for (const PicturePoint& point : picture.points) add(point.fill);
  return categories;
}

}  // namespace

void write_pixel(std::ostream& out, double value) {
  const auto hundredths = static_cast<long long>(std::llround(value * 100));
  write_number(out, static_cast<double>(hundredths) / 100);
}

Strokes strokes_for(const PlanarPicture& picture, const PictureFrame& frame) {
  const double side = std::sqrt(frame.width() * frame.height());
  const auto for_each = [&](std::size_t count) { return side / std::sqrt(static_cast<double>(count + 1)); };
  return {std::clamp(for_each(picture.edges.size()) / 16, 0.35, 1.4),
          std::clamp(for_each(picture.points.size()) / 14, 0.6, 3.0)};
}

void write_theme_rules(std::ostream& out, const PlanarPicture& picture, PictureTheme theme, std::string_view prefix) {
  const bool is_light = theme == PictureTheme::light;
  const std::string_view ink = is_light ? "#27303b" : "#dfe4ea";
  const std::string_view paper = is_light ? "#fbfbfc" : "#1b1f25";
  const auto rule = [&](std::string_view selector) -> std::ostream& { return out << prefix << ' ' << selector << '{'; };
  rule(".paper") << "fill:" << paper << "}\n";
  rule(".edges") << "stroke:" << ink << "}\n";
  rule(".points") << "fill:" << ink << ";stroke:" << paper << "}\n";
  rule("text") << "fill:" << ink << ";stroke:" << paper << "}\n";
  for (const std::uint32_t category : categories_of(picture)) {
    const auto colored = [&](std::string_view group, std::string_view what, const Color& color) {
      out << prefix << ' ' << group << " .c" << std::to_string(category) << '{' << what;
      write_color(out, color);
      out << "}\n";
    };
    colored(".faces", "fill:", fill_color(category, theme));
    colored(".edges", "stroke:", line_color(category, theme));
    colored(".points", "fill:", line_color(category, theme));
  }
}

void write_common_rules(std::ostream& out, const Strokes& strokes, std::string_view prefix) {
  const auto rule = [&](std::string_view selector) -> std::ostream& { return out << prefix << ' ' << selector << '{'; };
  rule(".faces") << "fill:none;fill-rule:evenodd}\n";
  rule(".edges") << "fill:none;stroke-linecap:round;stroke-linejoin:round;stroke-width:";
  write_pixel(out, strokes.line);
  out << "}\n";
  rule(".strong") << "stroke-width:";
  write_pixel(out, 2 * strokes.line);
  out << "}\n";
  rule(".faint") << "stroke-opacity:.35}\n";
  rule(".dashed") << "stroke-dasharray:";
  write_pixel(out, 3 * strokes.line);
  out << ' ';
  write_pixel(out, 3 * strokes.line);
  out << ";stroke-opacity:.6}\n";
  rule(".points") << "stroke-width:";
  write_pixel(out, strokes.point / 3);
  out << "}\n";
  rule("text") << "font-family:system-ui,\"Segoe UI\",Roboto,\"Noto Sans\",\"Liberation Sans\",sans-serif;"
                  "text-anchor:middle;paint-order:stroke;stroke-width:2.5;stroke-linejoin:round;stroke-opacity:.75}\n";
}

void write_cells(std::ostream& out, const PlanarPicture& picture, const PictureFrame& frame, bool has_tooltips) {
  const Strokes strokes = strokes_for(picture, frame);
  out << "<g class=\"faces\">\n";
  for (const PictureFace& face : picture.faces) {
    out << "<path";
    write_look(out, face.fill, "", false);
    out << " d=\"";
    if (face.is_outside) write_path_data(out, frame.border(), true);
    for (const PicturePath& ring : face.rings) write_path_data(out, frame.ring(ring), true);
    out << '"';
    end_cell(out, "path", face.text, has_tooltips);
  }
  out << "</g>\n<g class=\"edges\">\n";
  for (const PictureEdge& edge : picture.edges) {
    out << "<path";
    write_look(out, edge.stroke, class_of(edge.style), true);
    out << " d=\"";
    for (const PicturePath& part : frame.curve(edge.path)) write_path_data(out, part, false);
    out << '"';
    end_cell(out, "path", edge.text, has_tooltips);
  }
  out << "</g>\n<g class=\"points\">\n";
  for (const PicturePoint& point : picture.points) {
    const Point2 at = frame.map(point.at);
    const bool is_seen = frame.is_near(at);
    out << "<circle";
    write_look(out, point.fill, "", false);
    out << " cx=\"";
    write_pixel(out, is_seen ? at.x : 0);
    out << "\" cy=\"";
    write_pixel(out, is_seen ? at.y : 0);
    out << "\" r=\"";
    write_pixel(out, is_seen ? strokes.point * point.size : 0);
    out << '"';
    end_cell(out, "circle", point.text, has_tooltips);
  }
  out << "</g>\n";
}

}  // namespace quoin::svg_drawing
