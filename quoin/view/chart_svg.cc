// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/chart_svg.h"

#include "quoin/view/page_text.h"
#include "quoin/view/svg_drawing.h"

namespace quoin {

void ChartSvg::begin(std::string_view name, double width, double height, std::string_view title) {
  out_ << R"(<svg xmlns="http://www.w3.org/2000/svg" class=")" << name << R"(" role="img" width=")";
  write_pixel(width);
  out_ << "\" height=\"";
  write_pixel(height);
  out_ << "\" viewBox=\"0 0 ";
  write_pixel(width);
  out_ << ' ';
  write_pixel(height);
  out_ << "\">\n<title>";
  page_text::write_xml(out_, title);
  out_ << "</title>\n<style>\n"
       << '.' << name << "{background:#fff;color:#333;font:12px sans-serif}\n"
       << '.' << name << " text{fill:currentColor}\n";
}

void ChartSvg::begin_dark_rules(std::string_view name) {
  out_ << "@media (prefers-color-scheme:dark){\n." << name << "{background:#181c22;color:#ddd}\n";
}

void ChartSvg::end_rules() {
  out_ << "}\n</style>\n";
}

void ChartSvg::end() {
  out_ << "</svg>\n";
}

void ChartSvg::write_color(std::size_t line, PictureTheme theme) {
  constexpr std::string_view digits = "0123456789abcdef";
  const Color color = line_color(line, theme);
  out_ << '#';
  for (const std::uint8_t channel : {color.r, color.g, color.b}) out_ << digits[channel / 16] << digits[channel % 16];
}

void ChartSvg::write_pixel(double value) {
  svg_drawing::write_pixel(out_, value);
}

void ChartSvg::move_to(double x, double y) {
  out_ << 'M';
  write_pixel(x);
  out_ << ' ';
  write_pixel(y);
}

void ChartSvg::write_line(std::string_view kind, double x1, double y1, double x2, double y2) {
  out_ << "<path class=\"" << kind << "\" d=\"";
  move_to(x1, y1);
  out_ << 'L';
  write_pixel(x2);
  out_ << ' ';
  write_pixel(y2);
  out_ << "\"/>\n";
}

void ChartSvg::write_label(std::string_view anchor, double x, double y, std::string_view text) {
  out_ << "<text text-anchor=\"" << anchor << "\" x=\"";
  write_pixel(x);
  out_ << "\" y=\"";
  write_pixel(y + 4);
  out_ << "\">";
  page_text::write_xml(out_, text);
  out_ << "</text>\n";
}

}  // namespace quoin
