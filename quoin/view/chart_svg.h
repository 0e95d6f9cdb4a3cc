// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <ostream>
#include <string>
#include <string_view>

#include "quoin/view/picture_colors.h"

namespace quoin {

/// What SVG diagrams with axes are written with. Lengths are pixels, y downwards.
class ChartSvg {
 public:
  explicit ChartSvg(std::ostream& out) : out_(out) {}

  /// Up to the style rules. `name` is the class of the whole, white under dark grey text, and in dark themes reversed.
  void begin(std::string_view name, double width, double height, std::string_view title);
  /// After rules of the light theme: what follows, up to end_rules, is of the dark one.
  void begin_dark_rules(std::string_view name);
  void end_rules();
  void end();

  /// The color of a line of a diagram, as #rrggbb.
  void write_color(std::size_t line, PictureTheme theme);
  void write_pixel(double value);
  void move_to(double x, double y);
  void write_line(std::string_view kind, double x1, double y1, double x2, double y2);
  /// Its middle is at this height; `anchor` is start, middle or end.
  void write_label(std::string_view anchor, double x, double y, std::string_view text);

 private:
  std::ostream& out_;
};

}  // namespace quoin
