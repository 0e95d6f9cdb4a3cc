// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/picture_svg.h"

#include <algorithm>

#include "quoin/base/error.h"
#include "quoin/view/page_text.h"
#include "quoin/view/picture_labels.h"
#include "quoin/view/svg_drawing.h"

namespace quoin {

namespace {

using svg_drawing::write_pixel;

constexpr double legend_font = 13;
constexpr double legend_row = 21;

class SvgWriter {
 public:
  SvgWriter(std::ostream& out, const PlanarPicture& picture, const SvgOptions& options)
      : out_(out), picture_(picture), options_(options), frame_(shown_box(picture), options.size, 0.01) {
    if (!options.has_points) picture_.points.clear();
    if (!options.has_edges) picture_.edges.clear();
    if (!options.has_legend || picture.categories.empty()) return;
    double longest = 0;
    for (const std::string& name : picture.categories) longest = std::max(longest, text_width(name));
    legend_width_ = 50 + legend_font * longest;
    legend_height_ = 20 + legend_row * static_cast<double>(picture.categories.size());
  }

  void write() {
    const double width = frame_.width() + legend_width_;
    const double height = std::max(frame_.height(), legend_height_);
    write_head(width, height);
    write_style();
    write_rectangle("class=\"paper\"", {0, 0}, {width, height});
    out_ << "<svg width=\"";  // clips to the sheet
    write_pixel(out_, frame_.width());
    out_ << "\" height=\"";
    write_pixel(out_, frame_.height());
    out_ << "\">\n";
    svg_drawing::write_cells(out_, picture_, frame_, options_.has_tooltips);
    out_ << "</svg>\n";
    if (options_.has_labels) write_labels();
    if (legend_width_ > 0) write_legend();
    out_ << "</svg>\n";
  }

 private:
  void write_head(double width, double height) {
    out_ << "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"quoin-picture\" width=\"";
    write_pixel(out_, width);
    out_ << "\" height=\"";
    write_pixel(out_, height);
    out_ << "\" viewBox=\"0 0 ";
    write_pixel(out_, width);
    out_ << ' ';
    write_pixel(out_, height);
    out_ << "\" role=\"img\">\n";
    if (picture_.title.empty()) return;
    out_ << "<title>";
    page_text::write_xml(out_, picture_.title);
    out_ << "</title>\n";
  }

  void write_style() {
    constexpr std::string_view prefix = ".quoin-picture";
    out_ << "<style>\n";
    svg_drawing::write_common_rules(out_, svg_drawing::strokes_for(picture_, frame_), prefix);
    svg_drawing::write_theme_rules(out_, picture_, PictureTheme::light, prefix);
    out_ << "@media (prefers-color-scheme:dark){\n";
    svg_drawing::write_theme_rules(out_, picture_, PictureTheme::dark, prefix);
    out_ << "}\n</style>\n";
  }

  void write_rectangle(std::string_view attributes, const Point2& at, const Point2& size) {
    out_ << "<rect " << attributes << " x=\"";
    write_pixel(out_, at.x);
    out_ << "\" y=\"";
    write_pixel(out_, at.y);
    out_ << "\" width=\"";
    write_pixel(out_, size.x);
    out_ << "\" height=\"";
    write_pixel(out_, size.y);
    out_ << "\"/>\n";
  }

  void write_text(std::string_view text, const Point2& at, double size, std::string_view attributes = "") {
    out_ << "<text x=\"";
    write_pixel(out_, at.x);
    out_ << "\" y=\"";
    write_pixel(out_, at.y + 0.35 * size);
    out_ << "\" font-size=\"";
    write_pixel(out_, size);
    out_ << '"' << attributes << '>';
    page_text::write_xml(out_, text);
    out_ << "</text>\n";
  }

  void write_labels() {
    out_ << "<g class=\"labels\">\n";
    for (const PlacedLabel& label : place_labels(picture_, frame_)) {
      const LabelAnchor& anchor = label.anchor;
      const PictureText& text = anchor.kind == CellKind::face   ? picture_.faces[anchor.cell].text
                                : anchor.kind == CellKind::edge ? picture_.edges[anchor.cell].text
                                                                : picture_.points[anchor.cell].text;
      write_text(text.label, label.at, label.size);
    }
    out_ << "</g>\n";
  }

  void write_legend() {
    out_ << "<g class=\"legend faces\">\n";
    const double left = frame_.width() + 16;
    for (std::size_t i = 0; i < picture_.categories.size(); ++i) {
      const double middle = 10 + legend_row * (static_cast<double>(i) + 0.5);
      write_rectangle("class=\"c" + std::to_string(i) + "\" rx=\"3\"", {left, middle - 6}, {12, 12});
      write_text(picture_.categories[i], {left + 19, middle}, legend_font, " style=\"text-anchor:start\"");
    }
    out_ << "</g>\n";
  }

  std::ostream& out_;
  PlanarPicture picture_;
  const SvgOptions& options_;
  PictureFrame frame_;
  double legend_width_ = 0;
  double legend_height_ = 0;
};

}  // namespace

void write_svg(std::ostream& out, const PlanarPicture& picture, const SvgOptions& options) {
  if (!(options.size > 0 && options.size <= 1e6)) throw InputError("picture: its size is not between 0 and 1e6 pixels");
  check_picture(picture);
  SvgWriter(out, picture, options).write();
}

}  // namespace quoin
