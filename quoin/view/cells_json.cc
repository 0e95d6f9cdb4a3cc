// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/cells_json.h"

#include <array>

#include "quoin/view/page_text.h"
#include "quoin/view/picture_colors.h"

namespace quoin {

namespace {

std::string hexadecimal(const Color& color) {
  constexpr char digits[] = "0123456789abcdef";
  std::string text = "#";
  for (const std::uint8_t c : {color.r, color.g, color.b}) {
    text += digits[c >> 4];
    text += digits[c & 15];
  }
  return text;
}

}  // namespace

void CellsJson::write_head(const std::string& title, const std::vector<ViewFact>& facts,
                           const std::vector<std::string>& categories) {
  out_ << "\"title\":";
  page_text::write_json_string(out_, title);
  out_ << ",\"facts\":";
  page_text::write_json_facts(out_, facts);
  out_ << ",\"legend\":";
  std::uint32_t category = 0;
  page_text::write_json_list(out_, categories, [&](const std::string& name) {
    out_ << '[';
    page_text::write_json_string(out_, name);
    out_ << ',';
    page_text::write_number(out_, color_of({category++, {}}));
    out_ << ']';
  });
}

void CellsJson::write_cell(const PictureText& text, const PictureFill& fill) {
  out_ << "\n[";
  page_text::write_json_string(out_, text.name);
  out_ << ',';
  page_text::write_json_string(out_, text.label);
  out_ << ',';
  page_text::write_json_facts(out_, text.facts);
  out_ << ',';
  page_text::write_number(out_, color_of(fill));
  out_ << ']';
}

void CellsJson::write_colors() {
  out_ << "\"colors\":";
  page_text::write_json_list(out_, colors_, [&](const PictureFill& fill) {
    const std::size_t category = fill.category.value_or(0);
    const std::array<Color, 4> shades =
        fill.color
            ? std::array<Color, 4>{*fill.color, *fill.color, *fill.color, *fill.color}
            : std::array<Color, 4>{fill_color(category, PictureTheme::light), fill_color(category, PictureTheme::dark),
                                   line_color(category, PictureTheme::light), line_color(category, PictureTheme::dark)};
    page_text::write_json_list(out_, shades, [&](const Color& color) { out_ << '"' << hexadecimal(color) << '"'; });
  });
}

int CellsJson::color_of(const PictureFill& fill) {
  if (fill.is_none()) return -1;
  const std::uint64_t key = fill.color ? (1ULL << 32) + (std::uint64_t{fill.color->r} << 16) +
                                             (std::uint64_t{fill.color->g} << 8) + fill.color->b
                                       : *fill.category;
  const auto [at, is_new] = indices_.emplace(key, static_cast<int>(colors_.size()));
  if (is_new) colors_.push_back(fill);
  return at->second;
}

}  // namespace quoin
