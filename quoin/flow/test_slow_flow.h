// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "quoin/flow/face_formulas.h"
#include "quoin/flow/test_lazy_number.h"
#include "quoin/kernel/rational_point.h"

/// The flow by its definition, from the points alone: no triangulation, no tables; all contact points, all subsets of
/// them, all bisectors. For tests.
namespace quoin::testing {

using LazyVector = flow::Vector<LazyNumber>;

inline LazyVector lazy(const RationalPoint3& p) {
  return {LazyNumber(p.x), LazyNumber(p.y), LazyNumber(p.z)};
}
inline RationalPoint3 exact(const LazyVector& v) {
  return {v.x.exact(), v.y.exact(), v.z.exact()};
}

class SlowFlow {
 public:
  explicit SlowFlow(const std::vector<Point3>& points) {
    for (const Point3& p : points) points_.push_back(lazy(exact_point(p)));
  }

  /// Numbers of the nearest points.
  std::vector<std::size_t> contacts(const LazyVector& x) const {
    std::vector<std::size_t> nearest;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (nearest.empty()) {
        nearest.push_back(i);
        continue;
      }
      const LazyVector a = points_[i] - x;
      const LazyVector b = points_[nearest[0]] - x;
      const Sign sign = (dot(a, a) - dot(b, b)).sign();
      if (sign == Sign::negative) nearest.clear();
      if (sign != Sign::positive) nearest.push_back(i);
    }
    return nearest;
  }

  /// The point of the hull of the contacts that is nearest to x.
  LazyVector driver(const LazyVector& x, const std::vector<std::size_t>& contact) const {
    std::array<std::size_t, 4> chosen{};
    for (std::size_t size = 1; size <= 4; ++size) {
      std::optional<LazyVector> found = try_subsets(x, contact, chosen, 0, size, 0);
      if (found) return *found;
    }
    return x;
  }

  struct Step {
    bool stops = false;
    bool is_infinite = false;
    std::size_t crossed = 0;  ///< how many points stay nearest on the way
    LazyVector reached;
  };

  Step step(const LazyVector& x) const {
    const std::vector<std::size_t> contact = contacts(x);
    const LazyVector v = x - driver(x, contact);
    Step step;
    step.stops = dot(v, v).sign() == Sign::zero;
    if (step.stops) return step;
    const LazyVector base = points_[contact[0]] - x;
    std::optional<LazyVector> keeper;
    LazyNumber most;
    for (const std::size_t i : contact) {
      const LazyNumber along = dot(points_[i], v);
      const Sign sign = keeper ? (along - most).sign() : Sign::positive;
      if (sign == Sign::positive) step.crossed = 0;
      if (sign != Sign::negative) ++step.crossed;
      if (sign != Sign::positive) continue;
      keeper = points_[i];
      most = along;
    }
    meet(x, v, *keeper, dot(base, base), step);
    return step;
  }

 private:
  /// The least s > 0 with another point as near to x + s v as the keeper.
  void meet(const LazyVector& x, const LazyVector& v, const LazyVector& keeper, const LazyNumber& distance,
            Step& step) const {
    std::optional<LazyNumber> least;
    for (const LazyVector& q : points_) {
      const LazyNumber gain = dot(q - keeper, v);
      if (gain.sign() != Sign::positive) continue;
      const LazyVector to = q - x;
      const LazyNumber s = (dot(to, to) - distance) / (gain * LazyNumber(2.0));
      if (!least || (s - *least).sign() == Sign::negative) least = s;
    }
    step.is_infinite = !least;
    if (least) step.reached = x + v * *least;
  }

  std::optional<LazyVector> try_subsets(const LazyVector& x, const std::vector<std::size_t>& contact,
                                        std::array<std::size_t, 4>& chosen, std::size_t have, std::size_t size,
                                        std::size_t from) const {
    if (have == size) {
      const std::optional<LazyVector> z = centre_if_inside(x, chosen, size);
      if (!z) return std::nullopt;
      for (const std::size_t q : contact) {
        if (dot(points_[q] - *z, x - *z).sign() == Sign::positive) return std::nullopt;
      }
      return z;
    }
    for (std::size_t i = from; i < contact.size(); ++i) {
      chosen[have] = contact[i];
      const std::optional<LazyVector> z = try_subsets(x, contact, chosen, have + 1, size, i + 1);
      if (z) return z;
    }
    return std::nullopt;
  }

  /// Projection of x to the flat of the chosen points, if it is in their hull.
  std::optional<LazyVector> centre_if_inside(const LazyVector& x, const std::array<std::size_t, 4>& chosen,
                                             std::size_t size) const {
    const auto p = [&](std::size_t i) -> const LazyVector& { return points_[chosen[i]]; };
    const LazyNumber half(0.5);
    if (size == 1) return p(0);
    if (size == 2) return (p(0) + p(1)) * half;
    if (size == 3) {
      for (std::size_t i = 0; i < 3; ++i) {
        if (dot(p((i + 1) % 3) - p(i), p((i + 2) % 3) - p(i)).sign() == Sign::negative) return std::nullopt;
      }
      const LazyVector n = cross(p(1) - p(0), p(2) - p(0));
      return x - n * (dot(x - p(0), n) / dot(n, n));
    }
    for (std::size_t i = 0; i < 4; ++i) {
      const LazyVector n = cross(p((i + 2) % 4) - p((i + 1) % 4), p((i + 3) % 4) - p((i + 1) % 4));
      const Sign apex = dot(n, p(i) - p((i + 1) % 4)).sign();
      if (apex == Sign::zero || dot(n, x - p((i + 1) % 4)).sign() == -apex) return std::nullopt;
    }
    return x;
  }

  std::vector<LazyVector> points_;
};

}  // namespace quoin::testing
