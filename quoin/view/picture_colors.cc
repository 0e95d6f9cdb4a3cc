// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/picture_colors.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace quoin {

namespace {

// The hues of web/src/palette.ts. No orange: that is what is picked.
constexpr std::array<Color, 10> calm{{
    {125, 158, 198},  // steel blue
    {219, 197, 128},  // sand
    {142, 182, 138},  // sage
    {202, 139, 150},  // dusty rose
    {167, 155, 203},  // lavender
    {110, 178, 173},  // teal
    {176, 182, 118},  // moss
    {154, 168, 178},  // slate
    {199, 160, 202},  // mauve
    {152, 192, 208},  // sky
}};

Color base_color(std::size_t category) {
  if (category < calm.size()) return calm[category];
  const double hue = std::fmod(static_cast<double>(category) * 137.50776, 360.0);
  const double lightness = 0.62 + 0.1 * (static_cast<double>(category % 3) - 1);
  const auto channel = [&](double offset) {
    const double k = std::fmod(offset + hue / 30, 12.0);
    return static_cast<std::uint8_t>(
        std::lround(255 * (lightness - 0.17 * std::max(-1.0, std::min({k - 3, 9 - k, 1.0})))));
  };
  return {channel(0), channel(8), channel(4)};
}

Color mix(const Color& a, const Color& b, double part_of_b) {
  const auto channel = [&](std::uint8_t x, std::uint8_t y) {
    return static_cast<std::uint8_t>(std::lround(x + part_of_b * (y - x)));
  };
  return {channel(a.r, b.r), channel(a.g, b.g), channel(a.b, b.b)};
}

}  // namespace

Color fill_color(std::size_t category, PictureTheme theme) {
  const Color base = base_color(category);
  return theme == PictureTheme::light ? mix(base, {255, 255, 255}, 0.3) : mix(base, {24, 28, 34}, 0.52);
}

Color line_color(std::size_t category, PictureTheme theme) {
  const Color base = base_color(category);
  return theme == PictureTheme::light ? mix(base, {10, 20, 40}, 0.4) : mix(base, {255, 255, 255}, 0.2);
}

}  // namespace quoin
