// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/histogram_svg.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>
#include <vector>

#include "quoin/view/page_text.h"
#include "quoin/view/picture_colors.h"
#include "quoin/view/svg_drawing.h"

namespace quoin {

namespace {

using svg_drawing::write_pixel;

constexpr double margin = 64;
constexpr double width = 560;   // of the field
constexpr double height = 180;  // of one
constexpr double gap = 92;      // between two
constexpr std::size_t most_bars = 80;

std::string text_of(double value) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 4).ptr;
  return {text.data(), end};
}

/// How often a value in each range of `step` values occurs.
struct Bars {
  std::size_t step = 1;
  std::vector<std::size_t> counts;
  std::size_t most = 1;

  explicit Bars(const Histogram& histogram) {
    const std::vector<std::size_t>& all = histogram.counts();
    step = std::max<std::size_t>(1, (all.size() + most_bars - 1) / most_bars);
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (i % step == 0) counts.push_back(0);
      counts.back() += all[i];
      most = std::max(most, counts.back());
    }
  }
};

class HistogramSvg {
 public:
  explicit HistogramSvg(std::ostream& out) : out_(out) {}

  void write_head(std::size_t count, const std::string& title) {
    const double all = margin + static_cast<double>(count) * (height + gap);
    out_ << R"(<svg xmlns="http://www.w3.org/2000/svg" class="quoin-histogram" role="img" width=")";
    write_pixel(out_, width + 2 * margin);
    out_ << "\" height=\"";
    write_pixel(out_, all);
    out_ << "\" viewBox=\"0 0 ";
    write_pixel(out_, width + 2 * margin);
    out_ << ' ';
    write_pixel(out_, all);
    out_ << "\">\n<title>";
    page_text::write_xml(out_, title);
    out_ << "</title>\n<style>\n"
            ".quoin-histogram{background:#fff;color:#333;font:12px sans-serif}\n"
            ".quoin-histogram text{fill:currentColor}\n"
            ".frame{stroke:currentColor;fill:none}.grid{stroke:currentColor;opacity:.25;fill:none}\n";
    write_colors(PictureTheme::light);
    out_ << "@media (prefers-color-scheme:dark){\n.quoin-histogram{background:#181c22;color:#ddd}\n";
    write_colors(PictureTheme::dark);
    out_ << "}\n</style>\n";
  }

  void write(const NamedHistogram& named, std::size_t place) {
    const Histogram& histogram = *named.histogram;
    const Bars bars(histogram);
    const double top = margin + static_cast<double>(place) * (height + gap);
    const double bottom = top + height;
    write_label("start", margin, top - 30, named.name);
    write_label("start", margin, top - 14,
                std::to_string(histogram.count()) + " values, mean " + text_of(histogram.mean()) + ", deviation " +
                    text_of(histogram.deviation()) + ", mode " + std::to_string(histogram.mode()) + ", median " +
                    std::to_string(histogram.median()) + ", most " + std::to_string(histogram.most()));
    // A value that occurs once is seen.
    const double decades = std::log10(static_cast<double>(bars.most)) + 0.3;
    const auto level = [&](double count) { return bottom - height * (std::log10(count) + 0.3) / decades; };
    for (double count = 1; count <= static_cast<double>(bars.most); count *= 10) {
      write_line("grid", margin - 5, level(count), margin + width, level(count));
      write_label("end", margin - 8, level(count), std::to_string(static_cast<std::size_t>(count)));
    }
    const double pitch = width / static_cast<double>(std::max<std::size_t>(1, bars.counts.size()));
    const std::size_t between = std::max<std::size_t>(1, (bars.counts.size() + 9) / 10);
    for (std::size_t i = 0; i < bars.counts.size(); i += between) {
      write_label("middle", margin + pitch * (static_cast<double>(i) + 0.5), bottom + 14,
                  std::to_string(i * bars.step));
    }
    out_ << "<path class=\"bars\" d=\"";
    for (std::size_t i = 0; i < bars.counts.size(); ++i) {
      if (bars.counts[i] == 0) continue;
      move_to(margin + pitch * (static_cast<double>(i) + 0.08), bottom);
      out_ << 'V';
      write_pixel(out_, level(static_cast<double>(bars.counts[i])));
      out_ << 'h';
      write_pixel(out_, 0.84 * pitch);
      out_ << 'V';
      write_pixel(out_, bottom);
      out_ << 'z';
    }
    out_ << "\"/>\n";
    write_line("frame", margin, bottom, margin + width, bottom);
  }

  void write_end() { out_ << "</svg>\n"; }

 private:
  void write_colors(PictureTheme theme) {
    constexpr std::string_view digits = "0123456789abcdef";
    const Color color = line_color(0, theme);
    out_ << ".bars{fill:#";
    for (const std::uint8_t channel : {color.r, color.g, color.b}) out_ << digits[channel / 16] << digits[channel % 16];
    out_ << "}\n";
  }

  void move_to(double x, double y) {
    out_ << 'M';
    write_pixel(out_, x);
    out_ << ' ';
    write_pixel(out_, y);
  }

  void write_line(std::string_view kind, double x1, double y1, double x2, double y2) {
    out_ << "<path class=\"" << kind << "\" d=\"";
    move_to(x1, y1);
    out_ << 'L';
    write_pixel(out_, x2);
    out_ << ' ';
    write_pixel(out_, y2);
    out_ << "\"/>\n";
  }

  void write_label(std::string_view anchor, double x, double y, const std::string& text) {
    out_ << "<text text-anchor=\"" << anchor << "\" x=\"";
    write_pixel(out_, x);
    out_ << "\" y=\"";
    write_pixel(out_, y + 4);
    out_ << "\">";
    page_text::write_xml(out_, text);
    out_ << "</text>\n";
  }

  std::ostream& out_;
};

}  // namespace

void write_histograms(std::ostream& out, std::span<const NamedHistogram> histograms, const std::string& title) {
  HistogramSvg svg(out);
  svg.write_head(histograms.size(), title);
  for (std::size_t i = 0; i < histograms.size(); ++i) svg.write(histograms[i], i);
  svg.write_end();
}

}  // namespace quoin
