// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <vector>

#include "quoin/kernel/point.h"

namespace quoin {

/// The next piece of a path: straight, or part of a circle.
struct PathStep {
  Point2 to;
  double sweep = 0;  ///< radians, counterclockwise positive, at most a full turn; zero: straight
  Point2 center{};   ///< of the circle where sweep is not zero

  bool is_arc() const { return sweep != 0; }
};

inline PathStep line_to(const Point2& to) {
  return {to, 0, {}};
}
inline PathStep arc_to(const Point2& to, const Point2& center, double sweep) {
  return {to, sweep, center};
}

/// A curve of a picture: rounded, for looking at. A polyline is a path of straight steps.
struct PicturePath {
  Point2 start;
  std::vector<PathStep> steps;

  const Point2& end() const { return steps.empty() ? start : steps.back().to; }
};

/// A rectangle of the plane; empty where low exceeds high.
struct PictureBox {
  Point2 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Point2 high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  bool is_empty() const { return !(low.x <= high.x && low.y <= high.y); }
  double width() const { return high.x - low.x; }
  double height() const { return high.y - low.y; }
  void add(const Point2& p);
  /// Larger by a part of its larger side on all sides; a box of one point grows to size 1.
  PictureBox enlarged(double part) const;
  bool contains(const Point2& p) const { return low.x <= p.x && p.x <= high.x && low.y <= p.y && p.y <= high.y; }
};

PicturePath path_of(const std::vector<Point2>& polyline);
/// Two half turns, counterclockwise.
PicturePath circle_path(const Point2& center, double radius);
PicturePath reversed(const PicturePath& path);
/// Goes on with another path; where that starts elsewhere, a straight step leads there.
void append(PicturePath& path, const PicturePath& next);
void add_to(PictureBox& box, const PicturePath& path);

/// Vertices of a polyline whose distance from the path is at most `tolerance`, start included; steps may be cut into
/// 1024 at most.
std::vector<Point2> flattened(const PicturePath& path, double tolerance);

/// The part of an x-monotone path from left to right with low <= x <= high; a single point if they do not meet.
PicturePath between_x(const PicturePath& path, double low, double high);

/// The closed curve around what lies above `bottom` and below `top`, both from left to right: cells of a vertical
/// decomposition, and what lies between two envelopes.
PicturePath ring_between(const PicturePath& bottom, const PicturePath& top);

}  // namespace quoin
