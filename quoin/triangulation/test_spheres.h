// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "quoin/kernel/rational_point.h"

/// Smallest spheres, empty spheres and common points of balls by their definitions, in rationals, for few points.
namespace quoin::testing {

using Subset = std::vector<std::uint32_t>;

struct PowerSphere {
  Subset vertices;
  RationalPoint3 centre;
  Rational power;
};

class SlowSpheres {
 public:
  SlowSpheres(std::span<const Point3> points, std::vector<double> weights) : weights_(std::move(weights)) {
    for (const Point3& p : points) points_.push_back(exact_point(p));
    weights_.resize(points_.size(), 0.0);
    Subset subset;
    add_subsets(subset, 0);
  }

  /// The smallest spheres of all affinely independent subsets.
  const std::vector<PowerSphere>& spheres() const { return spheres_; }

  /// |x - p|^2 - w
  Rational power(const RationalPoint3& x, std::uint32_t p) const {
    const RationalPoint3 d = x - points_[p];
    return dot(d, d) - Rational(weights_[p]);
  }
  bool is_empty(const PowerSphere& s) const {
    for (std::uint32_t q = 0; q < points_.size(); ++q) {
      if (power(s.centre, q) < s.power) return false;
    }
    return true;
  }

  /// The least power of an empty sphere of all these and possibly others.
  std::optional<Rational> value(const Subset& simplex) const {
    std::optional<Rational> least;
    for (const std::size_t i : empty_) {
      const PowerSphere& s = spheres_[i];
      if (!std::includes(s.vertices.begin(), s.vertices.end(), simplex.begin(), simplex.end())) continue;
      if (!least || s.power < *least) least = s.power;
    }
    return least;
  }
  bool has_empty_sphere(const Subset& simplex) const {
    return std::any_of(empty_.begin(), empty_.end(), [&](std::size_t i) { return spheres_[i].vertices == simplex; });
  }

  /// Balls of squared radii a + weight have a common point if and only if a is at least this.
  Rational meeting(const Subset& balls) const {
    std::optional<Rational> least;
    for (const PowerSphere& s : spheres_) {
      if (!std::includes(balls.begin(), balls.end(), s.vertices.begin(), s.vertices.end())) continue;
      Rational most = power(s.centre, balls[0]);
      for (const std::uint32_t p : balls) most = std::max(most, power(s.centre, p));
      if (!least || most < *least) least = most;
    }
    return *least;
  }

 private:
  void add_subsets(Subset& subset, std::uint32_t from) {
    if (!subset.empty()) {
      std::optional<PowerSphere> s = sphere(subset);
      if (!s) return;
      if (is_empty(*s)) empty_.push_back(spheres_.size());
      spheres_.push_back(std::move(*s));
    }
    if (subset.size() == 4) return;
    for (std::uint32_t v = from; v < points_.size(); ++v) {
      subset.push_back(v);
      add_subsets(subset, v + 1);
      subset.pop_back();
    }
  }

  /// By elimination of 2 sum_j c_j u_i u_j = |u_i|^2 + w_p - w_i; nothing where rows are dependent.
  std::optional<PowerSphere> sphere(const Subset& subset) const {
    const std::size_t n = subset.size() - 1;
    const RationalPoint3& p = points_[subset[0]];
    std::vector<RationalPoint3> rows;
    for (std::size_t i = 0; i < n; ++i) rows.push_back(points_[subset[i + 1]] - p);
    std::vector<std::vector<Rational>> m(n, std::vector<Rational>(n + 1));
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) m[i][j] = Rational(2) * dot(rows[i], rows[j]);
      m[i][n] = dot(rows[i], rows[i]) + Rational(weights_[subset[0]]) - Rational(weights_[subset[i + 1]]);
    }
    for (std::size_t k = 0; k < n; ++k) {
      if (m[k][k].sign() == Sign::zero) return std::nullopt;  // of a Gram matrix: singular
      for (std::size_t i = 0; i < n; ++i) {
        if (i == k) continue;
        const Rational factor = m[i][k] / m[k][k];
        for (std::size_t j = k; j <= n; ++j) m[i][j] -= factor * m[k][j];
      }
    }
    PowerSphere result{subset, p, {}};
    for (std::size_t k = 0; k < n; ++k) result.centre = result.centre + rows[k] * (m[k][n] / m[k][k]);
    result.power = power(result.centre, subset[0]);
    return result;
  }

  std::vector<RationalPoint3> points_;
  std::vector<double> weights_;
  std::vector<PowerSphere> spheres_;
  std::vector<std::size_t> empty_;
};

}  // namespace quoin::testing
