// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/histogram_svg.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>
#include <vector>

#include "quoin/view/chart_svg.h"

namespace quoin {

namespace {

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
  explicit HistogramSvg(std::ostream& out) : out_(out), chart_(out) {}

  void write_head(std::size_t count, const std::string& title) {
    constexpr std::string_view name = "quoin-histogram";
    chart_.begin(name, width + 2 * margin, margin + static_cast<double>(count) * (height + gap), title);
    out_ << ".frame{stroke:currentColor;fill:none}.grid{stroke:currentColor;opacity:.25;fill:none}\n";
    write_colors(PictureTheme::light);
    chart_.begin_dark_rules(name);
    write_colors(PictureTheme::dark);
    chart_.end_rules();
  }

  void write(const NamedHistogram& named, std::size_t place) {
    const Histogram& histogram = *named.histogram;
    const Bars bars(histogram);
    const double top = margin + static_cast<double>(place) * (height + gap);
    const double bottom = top + height;
    chart_.write_label("start", margin, top - 30, named.name);
    chart_.write_label("start", margin, top - 14,
                       std::to_string(histogram.count()) + " values, mean " + text_of(histogram.mean()) +
                           ", deviation " + text_of(histogram.deviation()) + ", mode " +
                           std::to_string(histogram.mode()) + ", median " + std::to_string(histogram.median()) +
                           ", most " + std::to_string(histogram.most()));
    // A value that occurs once is seen.
    const double decades = std::log10(static_cast<double>(bars.most)) + 0.3;
    const auto level = [&](double count) { return bottom - height * (std::log10(count) + 0.3) / decades; };
    for (double count = 1; count <= static_cast<double>(bars.most); count *= 10) {
      chart_.write_line("grid", margin - 5, level(count), margin + width, level(count));
      chart_.write_label("end", margin - 8, level(count), std::to_string(static_cast<std::size_t>(count)));
    }
    const double pitch = width / static_cast<double>(std::max<std::size_t>(1, bars.counts.size()));
    const std::size_t between = std::max<std::size_t>(1, (bars.counts.size() + 9) / 10);
    for (std::size_t i = 0; i < bars.counts.size(); i += between) {
      chart_.write_label("middle", margin + pitch * (static_cast<double>(i) + 0.5), bottom + 14,
                         std::to_string(i * bars.step));
    }
    out_ << "<path class=\"bars\" d=\"";
    for (std::size_t i = 0; i < bars.counts.size(); ++i) {
      if (bars.counts[i] == 0) continue;
      chart_.move_to(margin + pitch * (static_cast<double>(i) + 0.08), bottom);
      out_ << 'V';
      chart_.write_pixel(level(static_cast<double>(bars.counts[i])));
      out_ << 'h';
      chart_.write_pixel(0.84 * pitch);
      out_ << 'V';
      chart_.write_pixel(bottom);
      out_ << 'z';
    }
    out_ << "\"/>\n";
    chart_.write_line("frame", margin, bottom, margin + width, bottom);
  }

  void write_end() { chart_.end(); }

 private:
  void write_colors(PictureTheme theme) {
    out_ << ".bars{fill:";
    chart_.write_color(0, theme);
    out_ << "}\n";
  }

  std::ostream& out_;
  ChartSvg chart_;
};

}  // namespace

void write_histograms(std::ostream& out, std::span<const NamedHistogram> histograms, const std::string& title) {
  HistogramSvg svg(out);
  svg.write_head(histograms.size(), title);
  for (std::size_t i = 0; i < histograms.size(); ++i) svg.write(histograms[i], i);
  svg.write_end();
}

}  // namespace quoin
