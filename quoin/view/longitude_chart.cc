// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/longitude_chart.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace quoin::longitude_chart {

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double step_angle = 1.5 * degree;
constexpr double widest_step = 2;  // degrees of longitude
constexpr int most_halvings = 24;

double latitude(const Vector3& v) {
  return std::atan2(v.z, std::hypot(v.x, v.y)) / degree;
}

/// Charts what lies between the ends of an edge whose longitudes grow.
class Tracer {
 public:
  Tracer(double left, double right) : left_(left), right_(right) {}

  /// Rounding may put a point next to the identification on its other side.
  Point2 chart(const Vector3& v) const {
    double x = std::atan2(v.y, v.x) / degree;
    const double middle = (left_ + right_) / 2;
    if (x < middle - half_width) x += 2 * half_width;
    if (x > middle + half_width) x -= 2 * half_width;
    return {std::clamp(x, left_, right_), latitude(v)};
  }

  /// Appends what leads to b, b excluded: near a pole short steps are wide.
  void refine(const Vector3& a, const Vector3& b, int halvings, std::vector<Point2>& out) const {
    if (halvings == most_halvings || std::fabs(chart(b).x - chart(a).x) <= widest_step) return;
    const Vector3 sum{a.x + b.x, a.y + b.y, a.z + b.z};
    const double length = std::hypot(sum.x, sum.y, sum.z);
    const Vector3 middle{sum.x / length, sum.y / length, sum.z / length};
    refine(a, middle, halvings + 1, out);
    out.push_back(chart(middle));
    refine(middle, b, halvings + 1, out);
  }

 private:
  double left_;
  double right_;
};

}  // namespace

Point2 position(const GeodesicFamily::Point& p) {
  const double x = p.column != 0 ? p.column * half_width : std::atan2(p.approximate.y, p.approximate.x) / degree;
  if (p.side == Side::bottom) return {x, -half_height};
  if (p.side == Side::top) return {x, half_height};
  return {x, latitude(p.approximate)};
}

std::vector<Point2> path(const GeodesicArrangement& arrangement, dcel::EdgeId edge) {
  const GeodesicFamily& family = arrangement.family();
  const BranchId branch = arrangement.branch(edge);
  const Point2 left = position(arrangement.left_point(edge));
  Point2 right = position(arrangement.right_point(edge));
  if (family.is_vertical(branch)) {
    right.x = left.x;
    return {left, right};
  }
  const std::vector<Vector3> samples =
      family.flatten(branch, arrangement.left_point(edge), arrangement.right_point(edge), step_angle);
  const Tracer tracer(left.x, right.x);
  std::vector<Point2> points{left};
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    if (i > 0) points.push_back(tracer.chart(samples[i]));
    tracer.refine(samples[i], samples[i + 1], 0, points);
  }
  points.push_back(right);
  return points;
}

}  // namespace quoin::longitude_chart
