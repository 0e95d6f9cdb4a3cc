// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/picture_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace quoin {

namespace {

constexpr double pi = std::numbers::pi;

Point2 turned(const Point2& p, const Point2& center, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const double x = p.x - center.x;
  const double y = p.y - center.y;
  return {center.x + c * x - s * y, center.y + s * x + c * y};
}

/// An arc that is left at x = `at` as it turns by less than a full turn; the angle from its beginning.
double angle_at_x(const Point2& from, const PathStep& step, double at) {
  const double radius = std::hypot(step.to.x - step.center.x, step.to.y - step.center.y);
  const double cosine = std::clamp((at - step.center.x) / radius, -1.0, 1.0);
  const double start = std::atan2(from.y - step.center.y, from.x - step.center.x);
  double best = 0;
  double best_excess = std::numeric_limits<double>::infinity();
  for (const double angle : {std::acos(cosine), -std::acos(cosine)}) {
    double turn = std::remainder(angle - start, 2 * pi);
    if (step.sweep > 0 && turn < 0) turn += 2 * pi;
    if (step.sweep < 0 && turn > 0) turn -= 2 * pi;
    // Angles just before the beginning are as good as none.
    if (std::fabs(turn) > 2 * pi - 1e-9) turn = 0;
    const double excess = std::max(0.0, std::fabs(turn) - std::fabs(step.sweep));
    if (excess < best_excess) {
      best_excess = excess;
      best = turn;
    }
  }
  return step.sweep > 0 ? std::clamp(best, 0.0, step.sweep) : std::clamp(best, step.sweep, 0.0);
}

/// Where the step, which crosses it, is at x = `at`, and the step cut there.
PathStep cut_at(const Point2& from, const PathStep& step, double at) {
  if (!step.is_arc()) {
    const double t = (at - from.x) / (step.to.x - from.x);
    return line_to({at, from.y + t * (step.to.y - from.y)});
  }
  const double angle = angle_at_x(from, step, at);
  Point2 to = turned(from, step.center, angle);
  to.x = at;
  return arc_to(to, step.center, angle);
}

}  // namespace

void PictureBox::add(const Point2& p) {
  low = {std::min(low.x, p.x), std::min(low.y, p.y)};
  high = {std::max(high.x, p.x), std::max(high.y, p.y)};
}

PictureBox PictureBox::enlarged(double part) const {
  if (is_empty()) return {{-0.5, -0.5}, {0.5, 0.5}};
  const double size = std::max(width(), height());
  // A box of one point far from the origin must grow by more than the spacing of doubles there.
  const double far = std::max({std::fabs(low.x), std::fabs(high.x), std::fabs(low.y), std::fabs(high.y)});
  const double margin = size > 0x1p-40 * far ? part * size : std::max(0.5, 0x1p-30 * far);
  return {{low.x - margin, low.y - margin}, {high.x + margin, high.y + margin}};
}

PicturePath path_of(const std::vector<Point2>& polyline) {
  PicturePath path;
  if (polyline.empty()) return path;
  path.start = polyline.front();
  for (std::size_t i = 1; i < polyline.size(); ++i) path.steps.push_back(line_to(polyline[i]));
  return path;
}

PicturePath circle_path(const Point2& center, double radius) {
  const Point2 right{center.x + radius, center.y};
  return {right, {arc_to({center.x - radius, center.y}, center, pi), arc_to(right, center, pi)}};
}

PicturePath reversed(const PicturePath& path) {
  PicturePath back{path.end(), {}};
  for (std::size_t i = path.steps.size(); i-- > 0;) {
    const Point2& to = i == 0 ? path.start : path.steps[i - 1].to;
    back.steps.push_back({to, -path.steps[i].sweep, path.steps[i].center});
  }
  return back;
}

void append(PicturePath& path, const PicturePath& next) {
  if (path.end() != next.start) path.steps.push_back(line_to(next.start));
  path.steps.insert(path.steps.end(), next.steps.begin(), next.steps.end());
}

void add_to(PictureBox& box, const PicturePath& path) {
  box.add(path.start);
  Point2 from = path.start;
  for (const PathStep& step : path.steps) {
    box.add(step.to);
    if (step.is_arc()) {
      // Corners at the quarter turns that the arc passes.
      const double radius = std::hypot(step.to.x - step.center.x, step.to.y - step.center.y);
      const double start = std::atan2(from.y - step.center.y, from.x - step.center.x);
      const auto [first, last] = std::minmax({start, start + step.sweep});
      for (double quarter = std::ceil(first / (pi / 2)); quarter * pi / 2 < last; ++quarter) {
        const double angle = quarter * pi / 2;
        box.add({step.center.x + radius * std::cos(angle), step.center.y + radius * std::sin(angle)});
      }
    }
    from = step.to;
  }
}

std::vector<Point2> flattened(const PicturePath& path, double tolerance) {
  std::vector<Point2> points{path.start};
  for (const PathStep& step : path.steps) {
    if (step.is_arc()) {
      const Point2 from = points.back();
      const double radius = std::hypot(step.to.x - step.center.x, step.to.y - step.center.y);
      const double angle = 2 * std::acos(std::clamp(1 - tolerance / radius, 0.0, 1.0));
      const double count = std::clamp(std::ceil(std::fabs(step.sweep) / std::max(angle, 1e-9)), 1.0, 1024.0);
      for (double i = 1; i < count; ++i) points.push_back(turned(from, step.center, step.sweep * i / count));
    }
    points.push_back(step.to);
  }
  return points;
}

PicturePath between_x(const PicturePath& path, double low, double high) {
  PicturePath part{path.start, {}};
  bool is_inside = path.start.x >= low;
  Point2 from = path.start;
  for (const PathStep& whole : path.steps) {
    PathStep step = whole;
    if (from.x >= high) break;
    if (!is_inside && step.to.x >= low) {
      const PathStep skipped = cut_at(from, step, low);
      step.sweep -= skipped.sweep;
      from = skipped.to;
      part.start = from;
      is_inside = true;
    }
    if (is_inside) {
      if (step.to.x > high) step = cut_at(from, step, high);
      if (step.to != from || std::fabs(step.sweep) > 1) part.steps.push_back(step);
    } else {
      part.start = step.to;
    }
    from = step.to;
  }
  return part;
}

PicturePath ring_between(const PicturePath& bottom, const PicturePath& top) {
  PicturePath ring = bottom;
  append(ring, reversed(top));
  if (ring.end() != ring.start) ring.steps.push_back(line_to(ring.start));
  return ring;
}

}  // namespace quoin
