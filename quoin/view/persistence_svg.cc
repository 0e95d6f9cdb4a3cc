// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/persistence_svg.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/view/chart_svg.h"

namespace quoin {

namespace {

constexpr double margin = 64;
constexpr double side = 560;     // of the field, and its width
constexpr double headroom = 36;  // beyond the largest value, for what stays
constexpr double legend_width = 110;

// Values in a range as parts of it, for ranges up to the largest doubles.
class Scale {
 public:
  explicit Scale(std::span<const PersistenceInterval> intervals) {
    bool is_first = true;
    const auto include = [&](double value) {
      low_ = is_first ? value : std::min(low_, value);
      high_ = is_first ? value : std::max(high_, value);
      is_first = false;
    };
    for (const PersistenceInterval& interval : intervals) {
      include(interval.birth);
      if (std::isfinite(interval.death)) include(interval.death);
    }
    if (high_ / 2 - low_ / 2 > std::abs(high_) * 1e-12) return;
    const double pad = std::max(std::abs(high_) * 1e-3, low_ == 0 ? 1.0 : 1e-300);
    low_ = std::max(low_ - pad, std::numeric_limits<double>::lowest());
    high_ = std::min(high_ + pad, std::numeric_limits<double>::max());
  }

  double part(double value) const { return (value / 2 - low_ / 2) / (high_ / 2 - low_ / 2); }

  // About five round numbers.
  std::vector<double> ticks() const {
    const double half = high_ / 2 - low_ / 2;
    double step = std::pow(10, std::floor(std::log10(half)));
    if (half / step < 1.5) step /= 2;
    if (half / step > 4) step *= 2;
    std::vector<double> result;
    const double first = std::ceil(low_ / step);
    for (int i = 0; i < 20; ++i) {
      const double tick = (first + i) * step;
      if (!std::isfinite(tick) || tick > high_) break;
      if (tick >= low_ && (result.empty() || tick > result.back())) result.push_back(tick == 0 ? 0 : tick);
    }
    return result;
  }

 private:
  double low_ = 0;
  double high_ = 0;
};

std::string tick_text(double value) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 6).ptr;
  return {text.data(), end};
}

class PersistenceSvg {
 public:
  PersistenceSvg(std::ostream& out, std::span<const PersistenceInterval> intervals, const std::string& title)
      : out_(out), chart_(out), title_(title), intervals_(intervals.begin(), intervals.end()), scale_(intervals) {
    std::stable_sort(intervals_.begin(), intervals_.end(), [](const auto& a, const auto& b) {
      if (a.degree != b.degree) return a.degree < b.degree;
      return a.birth != b.birth ? a.birth < b.birth : a.death < b.death;
    });
    for (const PersistenceInterval& interval : intervals_)
      if (degrees_.empty() || degrees_.back() != interval.degree) degrees_.push_back(interval.degree);
  }

  void write_diagram() {
    const double top = margin - headroom / 2;  // of what stays
    write_head(margin + side);
    chart_.write_line("axis", margin, margin + side, margin + side, margin);
    chart_.write_line("grid", margin, top, margin + side, top);
    chart_.write_label("end", margin - 8, top, "\xE2\x88\x9E");
    for (const double tick : scale_.ticks()) {
      const double at = side * scale_.part(tick);
      chart_.write_line("grid", margin + at, margin + side, margin + at, margin + side + 5);
      chart_.write_line("grid", margin - 5, margin + side - at, margin, margin + side - at);
      chart_.write_label("middle", margin + at, margin + side + 16, tick_text(tick));
      chart_.write_label("end", margin - 8, margin + side - at, tick_text(tick));
    }
    chart_.write_line("frame", margin, margin + side, margin + side, margin + side);
    chart_.write_line("frame", margin, margin + side, margin, top);
    chart_.write_label("middle", margin + side / 2, margin + side + 38, "birth");
    chart_.write_label("middle", margin, top - 18, "death");
    write_paths("point", [&](const PersistenceInterval& interval, std::size_t) {
      chart_.move_to(margin + side * scale_.part(interval.birth),
                     std::isfinite(interval.death) ? margin + side - side * scale_.part(interval.death) : top);
      out_ << "h0";
    });
    write_end();
  }

  void write_bars() {
    const double pitch = intervals_.empty() ? 1 : std::clamp(side / static_cast<double>(intervals_.size()), 0.05, 12.0);
    const double height = std::max(60.0, pitch * static_cast<double>(intervals_.size()));
    bar_width_ = 0.7 * pitch;
    write_head(margin + height);
    for (const double tick : scale_.ticks()) {
      const double x = margin + side * scale_.part(tick);
      chart_.write_line("grid", x, margin, x, margin + height + 5);
      chart_.write_label("middle", x, margin + height + 16, tick_text(tick));
    }
    chart_.write_line("frame", margin, margin + height, margin + side + headroom, margin + height);
    write_paths("bar", [&](const PersistenceInterval& interval, std::size_t row) {
      const double y = margin + pitch * (static_cast<double>(row) + 0.5);
      chart_.move_to(margin + side * scale_.part(interval.birth), y);
      out_ << 'H';
      chart_.write_pixel(margin +
                         (std::isfinite(interval.death) ? side * scale_.part(interval.death) : side + headroom));
    });
    write_end();
  }

 private:
  void write_head(double bottom) {
    constexpr std::string_view name = "quoin-persistence";
    chart_.begin(name, margin + side + headroom + legend_width, bottom + margin, title_);
    out_ << ".quoin-persistence path{fill:none}\n"
            ".frame,.axis{stroke:currentColor}.grid{stroke:currentColor;opacity:.25}.axis{opacity:.5}\n"
            ".point{stroke-width:6;stroke-linecap:round}\n"
            ".bar{stroke-width:";
    chart_.write_pixel(std::max(bar_width_, 0.03));
    out_ << "}\n";
    write_colors(PictureTheme::light);
    chart_.begin_dark_rules(name);
    write_colors(PictureTheme::dark);
    chart_.end_rules();
  }

  void write_colors(PictureTheme theme) {
    for (const int degree : degrees_) {
      out_ << ".d" << std::to_string(degree) << "{stroke:";
      chart_.write_color(static_cast<std::size_t>(degree), theme);
      out_ << "}\n";
    }
  }

  // One path for each degree, and its line in the legend. Later degrees lie on top.
  template <class Call>
  void write_paths(std::string_view kind, const Call& draw) {
    std::size_t row = 0;
    for (std::size_t i = 0; i < degrees_.size(); ++i) {
      const std::size_t first = row;
      out_ << "<path class=\"" << kind << " d" << std::to_string(degrees_[i]) << "\" d=\"";
      for (; row < intervals_.size() && intervals_[row].degree == degrees_[i]; ++row) draw(intervals_[row], row);
      out_ << "\"/>\n";
      const double y = margin + 20 * static_cast<double>(i);
      const double x = margin + side + headroom + 14;
      out_ << "<path class=\"point d" << std::to_string(degrees_[i]) << "\" d=\"";
      chart_.move_to(x, y);
      out_ << "h0\"/>\n";
      chart_.write_label("start", x + 10, y, "H" + std::to_string(degrees_[i]) + ": " + std::to_string(row - first));
    }
  }

  void write_end() { chart_.end(); }

  std::ostream& out_;
  ChartSvg chart_;
  const std::string& title_;
  std::vector<PersistenceInterval> intervals_;
  Scale scale_;
  std::vector<int> degrees_;
  double bar_width_ = 1;
};

void require_intervals(std::span<const PersistenceInterval> intervals) {
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    const PersistenceInterval& interval = intervals[i];
    if (!std::isfinite(interval.birth) || !(interval.death >= interval.birth) || interval.degree < 0)
      throw InputError("interval " + std::to_string(i) + " is none");
  }
}

}  // namespace

void write_persistence_diagram(std::ostream& out, std::span<const PersistenceInterval> intervals,
                               const std::string& title) {
  require_intervals(intervals);
  PersistenceSvg(out, intervals, title).write_diagram();
}

void write_barcode(std::ostream& out, std::span<const PersistenceInterval> intervals, const std::string& title) {
  require_intervals(intervals);
  PersistenceSvg(out, intervals, title).write_bars();
}

}  // namespace quoin
