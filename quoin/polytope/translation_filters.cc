// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/translation_filters.h"

#include <algorithm>

#include "quoin/number/interval.h"

namespace quoin {

namespace {

using Enclosed = std::array<Interval, 3>;

Enclosed difference(const Enclosed& a, const Enclosed& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Enclosed enclosed_cross(const Enclosed& a, const Enclosed& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Interval enclosed_dot(const Enclosed& a, const Enclosed& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Enclosed enclosed(const TranslationBody& body, std::uint32_t v) {
  const Point3& p = body.point_of_first(v);
  const Point3& q = body.point_of_second(v);
  return {Interval(q.x) - Interval(p.x), Interval(q.y) - Interval(p.y), Interval(q.z) - Interval(p.z)};
}

double middle(const Interval& a) {
  return a.lower() + (a.upper() - a.lower()) / 2;
}
/// No less than the distance of any member from the middle.
double radius(const Interval& a) {
  if (a.is_point()) return 0;
  const double m = middle(a);
  return (1 + 0x1p-50) * std::max(a.upper() - m, m - a.lower()) + 0x1p-1060;
}
Vector3 middle(const Enclosed& a) {
  return {middle(a[0]), middle(a[1]), middle(a[2])};
}
/// The largest of r + k u |m| over the components.
double relative_error(const Enclosed& a, double k) {
  double most = 0;
  for (const Interval& c : a) {
    most = std::max(most, radius(c) + k * 0x1p-53 * std::fabs(middle(c)));
  }
  return (1 + 0x1p-30) * most;
}
bool is_below(const Enclosed& a, double limit) {
  return std::all_of(a.begin(), a.end(), [&](const Interval& c) { return -limit < c.lower() && c.upper() < limit; });
}

}  // namespace

TranslationFilters::TranslationFilters(const TranslationBody& body, const Context& context) {
  Enclosed mean;
  for (const std::uint32_t v : body.anchors()) {
    const Enclosed corner = enclosed(body, v);
    for (std::size_t axis = 0; axis < 3; ++axis) mean[axis] = mean[axis] + corner[axis] * Interval(0.25);
  }
  is_in_range_ = is_below(mean, 0x1p200);
  const Vector3 near = is_in_range_ ? middle(mean) : Vector3{};
  centre_ = {near.x, near.y, near.z};
  const Enclosed origin{Interval(centre_.x), Interval(centre_.y), Interval(centre_.z)};
  std::vector<Enclosed> from_double;
  std::vector<Enclosed> from_centre;
  for (const Interval& c : mean) centre_error_ = std::max(centre_error_, radius(c));
  for (std::uint32_t v = 0; v < body.vertex_count(); ++v) {
    if (v % 1024 == 0) context.poll();
    const Enclosed corner = enclosed(body, v);
    from_double.push_back(difference(corner, origin));
    from_centre.push_back(difference(corner, mean));
    is_in_range_ = is_in_range_ && is_below(from_double.back(), 0x1p199) && is_below(from_centre.back(), 0x1p199);
    vertices_.push_back(middle(from_double.back()));
    for (const Interval& c : from_double.back()) vertex_error_ = std::max(vertex_error_, radius(c));
  }
  for (const Vector3& v : vertices_) extent_ = std::max(extent_, is_in_range_ ? length(v) : 1);
  planes_.resize(body.facet_count());
  sides_.resize(body.rim_count());
  if (!is_in_range_) return;
  for (std::uint32_t f = 0; f < body.facet_count(); ++f) {
    if (f % 1024 == 0) context.poll();
    const std::uint32_t rim = body.first_rim(f);
    const Enclosed& a = from_double[body.tail(rim)];
    const Enclosed normal =
        enclosed_cross(difference(from_double[body.tail(rim + 1)], a), difference(from_double[body.tail(rim + 2)], a));
    const Interval height = enclosed_dot(normal, a);
    // Components of the translation and products rounded once, sums three times; the height is taken off once.
    planes_[f] = {middle(normal), middle(height), relative_error(normal, 6),
                  (1 + 0x1p-30) * (radius(height) + 3 * u * std::fabs(middle(height)))};
  }
  for (std::uint32_t rim = 0; rim < body.rim_count(); ++rim) {
    if (rim % 1024 == 0) context.poll();
    const Enclosed normal = enclosed_cross(from_centre[body.tail(rim)], from_centre[body.head(rim)]);
    sides_[rim] = {middle(normal), relative_error(normal, 5)};
  }
}

}  // namespace quoin
