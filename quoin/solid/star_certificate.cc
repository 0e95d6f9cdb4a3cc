// SPDX-License-Identifier: Apache-2.0
//
// Bounds, u = 2^-53. The determinant: each of six terms carries 2 differences, 2 products and at most 5 sums, so the
// error is below 9 u (1 + 10 u) times the sum of the terms' magnitudes. The planar product: 1 difference, 1 product, 1
// sum in 2 terms: below 3 u (1 + 4 u) times theirs. 1.5e-15 exceeds both as long as nothing underflows, which sums
// above 1e-250 exclude.
#include "quoin/solid/star_certificate.h"

#include <cmath>

namespace quoin {

namespace {

constexpr double relative_bound = 1.5e-15;
constexpr double smallest_safe = 1e-250;

Vector3 minus(const Point3& a, const Point3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

bool is_certain(double value, double size) {
  return size > smallest_safe && std::fabs(value) > relative_bound * size;
}

class StarCertifier {
 public:
  StarCertifier(const Leaf& leaf, const Context& context)
      : leaf_(leaf),
        context_(context),
        axes_(leaf.vertices.size()),
        turns_(leaf.vertices.size(), 0),
        certain_(leaf.vertices.size(), 1) {}

  std::vector<std::uint8_t> run() {
    sum_normals();
    for (std::uint32_t t = 0; t < leaf_.tiles.size(); ++t) {
      if (t % 16384 == 0) context_.poll();
      for (std::uint32_t k = 0; k < 3; ++k) look_at(t, k);
    }
    for (std::size_t v = 0; v < certain_.size(); ++v) {
      if (turns_[v] != 1) certain_[v] = 0;
    }
    return std::move(certain_);
  }

 private:
  void sum_normals() {
    for (std::uint32_t t = 0; t < leaf_.tiles.size(); ++t) {
      if (t % 16384 == 0) context_.poll();
      const Tile& tile = leaf_.tiles[t];
      const Vector3 a = minus(leaf_.vertices[tile[1]], leaf_.vertices[tile[0]]);
      const Vector3 b = minus(leaf_.vertices[tile[2]], leaf_.vertices[tile[0]]);
      for (const std::uint32_t v : tile) {
        axes_[v].x += a.y * b.z - a.z * b.y;
        axes_[v].y += a.z * b.x - a.x * b.z;
        axes_[v].z += a.x * b.y - a.y * b.x;
      }
    }
  }

  void look_at(std::uint32_t t, std::uint32_t k) {
    const Tile& tile = leaf_.tiles[t];
    const std::uint32_t v = tile[k];
    if (certain_[v] == 0) return;
    if (leaf_.twins[3 * t + k] == Leaf::no_twin || leaf_.twins[3 * t + (k + 2) % 3] == Leaf::no_twin) {
      certain_[v] = 0;
      return;
    }
    const Vector3 a = minus(leaf_.vertices[tile[(k + 1) % 3]], leaf_.vertices[v]);
    const Vector3 b = minus(leaf_.vertices[tile[(k + 2) % 3]], leaf_.vertices[v]);
    const Vector3& d = axes_[v];
    const double terms[] = {a.x * b.y * d.z, a.y * b.z * d.x, a.z * b.x * d.y,
                            a.x * b.z * d.y, a.y * b.x * d.z, a.z * b.y * d.x};
    double size = 0;
    for (const double term : terms) size += std::fabs(term);
    const double det = (terms[0] - terms[4]) + (terms[1] - terms[5]) + (terms[2] - terms[3]);
    const Crossing before = across(a, d);
    const Crossing after = across(b, d);
    if (!(is_certain(det, size) && det > 0 && before.is_certain && after.is_certain)) {
      certain_[v] = 0;
      return;
    }
    if (before.value < 0 && after.value > 0 && turns_[v] < 2) ++turns_[v];
  }

  struct Crossing {
    double value;
    bool is_certain;
  };

  // (d x r) . e for the axis r least aligned with d: which side of the plane through d and r the edge lies on.
  static Crossing across(const Vector3& e, const Vector3& d) {
    const double x = std::fabs(d.x);
    const double y = std::fabs(d.y);
    const double z = std::fabs(d.z);
    double p = d.x * e.y;  // r along z
    double q = d.y * e.x;
    if (x <= y && x <= z) {
      p = d.y * e.z;
      q = d.z * e.y;
    } else if (y <= z) {
      p = d.z * e.x;
      q = d.x * e.z;
    }
    return {p - q, is_certain(p - q, std::fabs(p) + std::fabs(q))};
  }

  const Leaf& leaf_;
  const Context& context_;
  std::vector<Vector3> axes_;
  std::vector<std::uint8_t> turns_;
  std::vector<std::uint8_t> certain_;
};

}  // namespace

std::vector<std::uint8_t> certify_stars(const Leaf& leaf, const Context& context) {
  return StarCertifier(leaf, context).run();
}

}  // namespace quoin
