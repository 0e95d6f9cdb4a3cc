// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/face_pole.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>

namespace quoin {

namespace {

constexpr int most_squares = 600;

double distance_to_segment(const Point2& p, const Point2& a, const Point2& b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double length = dx * dx + dy * dy;
  const double t = length > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / length, 0.0, 1.0) : 0.0;
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

/// Positive inside.
double signed_distance(const Point2& p, const std::vector<std::vector<Point2>>& polygons, const PictureBox& box) {
  bool is_inside = false;
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& polygon : polygons) {
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
      const Point2& a = polygon[i];
      const Point2& b = polygon[j];
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) is_inside = !is_inside;
      nearest = std::min(nearest, distance_to_segment(p, a, b));
    }
  }
  const double in_box = std::min({p.x - box.low.x, box.high.x - p.x, p.y - box.low.y, box.high.y - p.y});
  return std::min(is_inside ? nearest : -nearest, in_box);
}

struct Square {
  Point2 center;
  double half = 0;
  double distance = 0;

  double bound() const { return distance + half * std::numbers::sqrt2; }
  friend bool operator<(const Square& a, const Square& b) { return a.bound() < b.bound(); }
};

}  // namespace

Pole pole_of(const std::vector<std::vector<Point2>>& polygons, const PictureBox& box, double precision) {
  PictureBox extent;
  for (const auto& polygon : polygons) {
    for (const Point2& p : polygon) extent.add(p);
  }
  extent.low = {std::max(extent.low.x, box.low.x), std::max(extent.low.y, box.low.y)};
  extent.high = {std::min(extent.high.x, box.high.x), std::min(extent.high.y, box.high.y)};
  if (extent.is_empty() || extent.width() <= 0 || extent.height() <= 0) return {};
  const auto square = [&](const Point2& center, double half) {
    return Square{center, half, signed_distance(center, polygons, box)};
  };
  std::priority_queue<Square> squares;
  const double size =
      std::max(std::min(extent.width(), extent.height()), std::max(extent.width(), extent.height()) / 16);
  Square best = square({(extent.low.x + extent.high.x) / 2, (extent.low.y + extent.high.y) / 2}, 0);
  for (double x = extent.low.x; x < extent.high.x; x += size) {
    for (double y = extent.low.y; y < extent.high.y; y += size) {
      squares.push(square({x + size / 2, y + size / 2}, size / 2));
    }
  }
  for (int n = 0; n < most_squares && !squares.empty(); ++n) {
    const Square top = squares.top();
    squares.pop();
    if (top.distance > best.distance) best = top;
    if (top.bound() <= best.distance + precision) break;
    const double half = top.half / 2;
    for (const double sx : {-half, half}) {
      for (const double sy : {-half, half}) squares.push(square({top.center.x + sx, top.center.y + sy}, half));
    }
  }
  return {best.center, best.distance};
}

}  // namespace quoin
