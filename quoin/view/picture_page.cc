// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/picture_page.h"

#include "quoin/base/error.h"
#include "quoin/view/built_templates.h"
#include "quoin/view/cells_json.h"
#include "quoin/view/page.h"
#include "quoin/view/page_text.h"
#include "quoin/view/picture_labels.h"
#include "quoin/view/svg_drawing.h"

namespace quoin {

namespace {

constexpr double sheet_size = 1000;

template <class List, class Write>
void write_member(std::ostream& out, std::string_view name, const List& list, const Write& write) {
  out << ",\n\"" << name << "\":";
  page_text::write_json_list(out, list, write);
}

/// Places of labels, in pixels of the drawing: [kind, cell, x, y, room].
void write_anchors(std::ostream& out, const PlanarPicture& picture, const PictureFrame& frame) {
  write_member(out, "anchors", label_anchors(picture, frame), [&](const LabelAnchor& anchor) {
    out << '[' << static_cast<char>('0' + static_cast<int>(anchor.kind)) << ',';
    page_text::write_number(out, anchor.cell);
    for (const double value : {anchor.at.x, anchor.at.y, anchor.room}) {
      out << ',';
      svg_drawing::write_pixel(out, value);
    }
    out << ']';
  });
}

void write_data(std::ostream& out, const PlanarPicture& picture, const PictureFrame& frame) {
  CellsJson json(out);
  out << "<script type=\"application/json\" id=\"quoin-picture\">{\"format\":\"quoin-picture\",\"version\":1,";
  json.write_head(picture.title, picture.facts, picture.categories);
  const svg_drawing::Strokes strokes = svg_drawing::strokes_for(picture, frame);
  out << ",\"sheet\":[";
  svg_drawing::write_pixel(out, frame.width());
  out << ',';
  svg_drawing::write_pixel(out, frame.height());
  out << "],\"strokes\":[";
  svg_drawing::write_pixel(out, strokes.line);
  out << ',';
  svg_drawing::write_pixel(out, strokes.point);
  out << ']';
  write_member(out, "faces", picture.faces, [&](const PictureFace& f) { json.write_cell(f.text, f.fill); });
  write_member(out, "edges", picture.edges, [&](const PictureEdge& e) { json.write_cell(e.text, e.stroke); });
  write_member(out, "points", picture.points, [&](const PicturePoint& p) { json.write_cell(p.text, p.fill); });
  write_anchors(out, picture, frame);
  out << ",\n";
  json.write_colors();
  out << "}</script>\n";
}

void write_drawing(std::ostream& out, const PlanarPicture& picture, const PictureFrame& frame) {
  out << "<svg id=\"quoin-drawing\" class=\"quoin-picture\" xmlns=\"http://www.w3.org/2000/svg\">\n<style>\n";
  constexpr std::string_view prefix = ".quoin-picture";
  svg_drawing::write_common_rules(out, svg_drawing::strokes_for(picture, frame), prefix);
  svg_drawing::write_theme_rules(out, picture, PictureTheme::light, prefix);
  svg_drawing::write_theme_rules(out, picture, PictureTheme::dark, "[data-theme=dark] .quoin-picture");
  out << "</style>\n";
  svg_drawing::write_cells(out, picture, frame, false);
  out << "</svg>\n";
}

}  // namespace

void write_picture_page(std::ostream& out, const PlanarPicture& picture) {
  if (!has_view()) throw Error("the browser view was not built into this quoin (configure with -DQUOIN_VIEW=ON)");
  write_picture_page(out, picture, built_picture_template());
}

void write_picture_page(std::ostream& out, const PlanarPicture& picture, std::string_view page_template) {
  const page_text::Template page = page_text::split_template(page_template);
  check_picture(picture);
  const PictureFrame frame(shown_box(picture), sheet_size, 1);
  out << page.before_title;
  page_text::write_title(out, picture.title);
  out << page.before_scene;
  write_data(out, picture, frame);
  write_drawing(out, picture, frame);
  out << page.rest;
}

}  // namespace quoin
