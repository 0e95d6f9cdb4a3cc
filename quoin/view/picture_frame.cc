// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/picture_frame.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace quoin {

namespace {

constexpr double largest_radius = 1e4;  // pixels; beyond it arcs become chords
constexpr double sagitta = 0.05;        // pixels

bool is_straight(const PicturePath& path) {
  return std::ranges::none_of(path.steps, [](const PathStep& step) { return step.is_arc(); });
}

Point2 between(const Point2& a, const Point2& b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

/// The part of a segment inside a box (Liang and Barsky 1984), as parameters.
std::optional<std::pair<double, double>> inside(const Point2& a, const Point2& b, const PictureBox& box) {
  double first = 0;
  double last = 1;
  const auto cut = [&](double start, double change, double low, double high) {
    if (change == 0) return low <= start && start <= high;
    double enter = (low - start) / change;
    double leave = (high - start) / change;
    if (enter > leave) std::swap(enter, leave);
    first = std::max(first, enter);
    last = std::min(last, leave);
    return first <= last;
  };
  if (!cut(a.x, b.x - a.x, box.low.x, box.high.x) || !cut(a.y, b.y - a.y, box.low.y, box.high.y)) return std::nullopt;
  return std::pair{first, last};
}

/// What of a polygon has a nonnegative `inner` coordinate (Sutherland and Hodgman 1974): runs along the line where the
/// polygon leaves, which adds no area.
template <class Inner>
std::vector<Point2> half(const std::vector<Point2>& polygon, const Inner& inner) {
  std::vector<Point2> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2& a = polygon[i];
    const Point2& b = polygon[(i + 1) % polygon.size()];
    const double ia = inner(a);
    const double ib = inner(b);
    if (ia >= 0) kept.push_back(a);
    if ((ia >= 0) != (ib >= 0)) kept.push_back(between(a, b, ia / (ia - ib)));
  }
  return kept;
}

}  // namespace

PictureFrame::PictureFrame(const PictureBox& box, double size, double reach) : box_(box) {
  scale_ = size / std::max(box.width(), box.height());
  width_ = box.width() * scale_;
  height_ = box.height() * scale_;
  const double margin = reach * std::max(width_, height_) + 8;
  region_ = {{-margin, -margin}, {width_ + margin, height_ + margin}};
}

std::vector<PicturePath> PictureFrame::curve(const PicturePath& path) const {
  PicturePath whole = mapped(path);
  if (!is_straight(whole)) return {std::move(whole)};
  std::vector<PicturePath> parts;
  bool goes_on = false;
  Point2 from = whole.start;
  for (const PathStep& step : whole.steps) {
    const auto seen = inside(from, step.to, region_);
    if (seen) {
      const Point2 begin = seen->first == 0 ? from : between(from, step.to, seen->first);
      const Point2 end = seen->second == 1 ? step.to : between(from, step.to, seen->second);
      if (!goes_on || seen->first > 0) parts.push_back({begin, {}});
      parts.back().steps.push_back(line_to(end));
    }
    goes_on = seen && seen->second == 1;
    from = step.to;
  }
  return parts;
}

PicturePath PictureFrame::ring(const PicturePath& path) const {
  PicturePath whole = mapped(path);
  if (!is_straight(whole)) return whole;
  std::vector<Point2> polygon = flattened(whole, 1);
  if (std::ranges::all_of(polygon, [&](const Point2& p) { return region_.contains(p); })) return whole;
  polygon = half(polygon, [&](const Point2& p) { return p.x - region_.low.x; });
  polygon = half(polygon, [&](const Point2& p) { return region_.high.x - p.x; });
  polygon = half(polygon, [&](const Point2& p) { return p.y - region_.low.y; });
  polygon = half(polygon, [&](const Point2& p) { return region_.high.y - p.y; });
  return path_of(polygon);
}

PictureFrame PictureFrame::without_surroundings() const {
  PictureFrame frame = *this;
  frame.region_ = {{0, 0}, {width_, height_}};
  return frame;
}

PicturePath PictureFrame::border() const {
  const Point2& low = region_.low;
  const Point2& high = region_.high;
  return path_of({low, {high.x, low.y}, high, {low.x, high.y}});
}

/// In pixels; with arcs only where every renderer draws them well.
PicturePath PictureFrame::mapped(const PicturePath& path) const {
  PicturePath out{map(path.start), {}};
  bool has_arcs = false;
  bool has_far_ends = is_far(out.start);
  for (const PathStep& step : path.steps) {
    const PathStep seen{map(step.to), -step.sweep, step.is_arc() ? map(step.center) : Point2{}};
    has_far_ends |= is_far(seen.to);
    if (step.is_arc()) {
      const double radius = std::hypot(seen.to.x - seen.center.x, seen.to.y - seen.center.y);
      if (radius > largest_radius || is_far(seen.center)) {
        add_chords(out, out.end(), seen, 0, 1);
        continue;
      }
      has_arcs = true;
    }
    out.steps.push_back(seen);
  }
  return has_arcs && has_far_ends ? path_of(flattened(out, sagitta)) : out;
}

/// Chords of the part of an arc between two parts of its sweep: fine where they are seen.
void PictureFrame::add_chords(PicturePath& out, const Point2& from, const PathStep& step, double begin,
                              double end) const {
  const double dx = from.x - step.center.x;
  const double dy = from.y - step.center.y;
  const double radius = std::hypot(dx, dy);
  const auto at = [&](double part) -> Point2 {
    if (part == 0) return from;
    if (part == 1) return step.to;
    const double c = std::cos(step.sweep * part);
    const double s = std::sin(step.sweep * part);
    return {step.center.x + c * dx - s * dy, step.center.y + s * dx + c * dy};
  };
  const double angle = std::fabs(step.sweep) * (end - begin);
  const double height = 2 * radius * std::pow(std::sin(angle / 4), 2);
  if (angle < 1.5) {
    const Point2 a = at(begin);
    const Point2 b = at(end);
    const Point2 low{std::min(a.x, b.x) - height, std::min(a.y, b.y) - height};
    const Point2 high{std::max(a.x, b.x) + height, std::max(a.y, b.y) + height};
    const bool is_unseen =
        high.x < region_.low.x || low.x > region_.high.x || high.y < region_.low.y || low.y > region_.high.y;
    if (height < sagitta || is_unseen || angle < 1e-12) {
      out.steps.push_back(line_to(b));
      return;
    }
  }
  const double middle = (begin + end) / 2;
  add_chords(out, from, step, begin, middle);
  add_chords(out, from, step, middle, end);
}

bool PictureFrame::is_far(const Point2& pixel) const {
  const double far = 4 * largest_radius;
  return std::fabs(pixel.x) > far || std::fabs(pixel.y) > far;
}

}  // namespace quoin
