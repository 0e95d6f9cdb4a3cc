// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "quoin/flow/test_slow_flow.h"

/// Stationary points of the distance to some points by their definition: no triangulation. For tests.
namespace quoin::testing {

inline std::string text(const RationalPoint3& p) {
  return p.x.to_string() + " " + p.y.to_string() + " " + p.z.to_string();
}

/// Whether z, in the hull of some points, is in its relative interior; and the dimension of the hull.
class HullOfContacts {
 public:
  /// Points are given from z.
  explicit HullOfContacts(std::vector<RationalPoint3> from_z) : points_(std::move(from_z)) {
    const RationalPoint3 zero{};
    const RationalPoint3& a = points_[0];
    for (const RationalPoint3& b : points_) {
      if (b != a) dimension_ = std::max(dimension_, 1U);
      for (const RationalPoint3& c : points_) {
        const RationalPoint3 n = cross(b - a, c - a);
        if (n == zero) continue;
        if (dimension_ < 2) normal_ = n;
        dimension_ = std::max(dimension_, 2U);
        for (const RationalPoint3& d : points_) {
          if (dot(n, d - a).sign() != Sign::zero) dimension_ = 3;
        }
      }
    }
  }

  unsigned dimension() const { return dimension_; }

  /// Not so if a plane through z and faces of the hull has all points on one side.
  bool has_in_interior() const {
    if (dimension_ < 2) return true;  // one point, or the middle of two
    for (const RationalPoint3& a : points_) {
      if (dimension_ == 2 && is_on_one_side(cross(normal_, a))) return false;
      for (const RationalPoint3& b : points_) {
        if (dimension_ == 3 && is_on_one_side(cross(a, b))) return false;
      }
    }
    return true;
  }

 private:
  bool is_on_one_side(const RationalPoint3& normal) const {
    bool is_above = false;
    bool is_below = false;
    for (const RationalPoint3& p : points_) {
      const Sign sign = dot(normal, p).sign();
      is_above |= sign == Sign::positive;
      is_below |= sign == Sign::negative;
    }
    return is_above != is_below;
  }

  std::vector<RationalPoint3> points_;
  unsigned dimension_ = 0;
  RationalPoint3 normal_{};
};

/// The centre of the smallest sphere through up to four points; nothing if they are not in general position.
inline std::optional<RationalPoint3> smallest_sphere_centre(const std::vector<RationalPoint3>& p) {
  const RationalPoint3& a = p[0];
  const Rational half = Rational(1) / Rational(2);
  if (p.size() == 1) return a;
  const RationalPoint3 u = p[1] - a;
  if (p.size() == 2) return a + u * half;
  const RationalPoint3 v = p[2] - a;
  const RationalPoint3 n = cross(u, v);
  const RationalPoint3 w = p.size() == 3 ? n : p[3] - a;
  // x . u = u . u / 2, x . v = v . v / 2, and x . w = w . w / 2 or 0, by Cramer's rule.
  const Rational volume = dot(n, w);
  if (volume.sign() == Sign::zero) return std::nullopt;
  RationalPoint3 sum = cross(v, w) * dot(u, u) + cross(w, u) * dot(v, v);
  if (p.size() == 4) sum = sum + n * dot(w, w);
  return a + sum * (half / volume);
}

/// What a stationary point is.
struct StationaryPoint {
  unsigned dimension = 0;  ///< of the hull of the nearest points: of critical points the index
  bool is_critical = false;
  friend bool operator==(const StationaryPoint&, const StationaryPoint&) = default;
};

/// All of them by their places. Points must differ. O(n^5).
inline std::map<std::string, StationaryPoint> stationary_points(const std::vector<Point3>& points) {
  const SlowFlow slow(points);
  std::map<std::string, StationaryPoint> found;
  const auto look = [&](const std::vector<RationalPoint3>& chosen, std::size_t first) {
    const std::optional<RationalPoint3> z = smallest_sphere_centre(chosen);
    if (!z || found.contains(text(*z))) return;
    const LazyVector at = lazy(*z);
    const std::vector<std::size_t> contact = slow.contacts(at);
    if (std::find(contact.begin(), contact.end(), first) == contact.end()) return;
    if (exact(slow.driver(at, contact)) != *z) return;
    std::vector<RationalPoint3> from_z;
    for (const std::size_t i : contact) from_z.push_back(exact_point(points[i]) - *z);
    const HullOfContacts hull(from_z);
    found[text(*z)] = {hull.dimension(), hull.has_in_interior()};
  };
  const auto p = [&](std::size_t i) { return exact_point(points[i]); };
  for (std::size_t i = 0; i < points.size(); ++i) {
    look({p(i)}, i);
    for (std::size_t j = 0; j < i; ++j) {
      look({p(i), p(j)}, i);
      for (std::size_t k = 0; k < j; ++k) {
        look({p(i), p(j), p(k)}, i);
        for (std::size_t l = 0; l < k; ++l) look({p(i), p(j), p(k), p(l)}, i);
      }
    }
  }
  return found;
}

}  // namespace quoin::testing
