// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "quoin/flow/face_formulas.h"

/// Ways through Voronoi facets in doubles with bounds of their errors.
namespace quoin::flow {

/// A place on the Voronoi edge of a triangle (p, q, r): z + t n with its circumcentre z and n = (q - p) x (r - p). The
/// place itself is within `error` of t.
struct RoundedPlace {
  double t = 0;
  double error = 0;
};

/// The Voronoi edge of another triangle of the facet's edge, as the ray sees it: it is met at power / slope times the
/// distance of the point from the midpoint.
struct RoundedLine {
  double power = 0;
  double slope = 0;
  double power_error = 0;
  double slope_error = 0;  ///< of both reasons
  double slope_rounding = 0;
  double along = 0;  ///< how fast the slope changes with t
  Vector<double> from;
};

/// The ray from the midpoint of an edge (p0, p1), in its Voronoi facet, through a place on the Voronoi edge of the
/// triangle (p0, p1, apex).
///
/// Errors are of two kinds. Rounding: all that is computed from input points alone, and from t as if it were exact; a
/// few u relative to the sizes of what goes in, derived at each bound, with norms that are sums of magnitudes. And that
/// of t, which is a number along a line that is known exactly: it is carried by the exact derivative of the fraction.
/// Each bound has a factor of 2 at least to spare, so products of errors, below 1e-8 of them, need no care. Coordinates
/// are multiplied by a power of two that makes them at most 1, and what is outside a range in which nothing that counts
/// underflows is refused: exact numbers take over.
class RoundedRay {
 public:
  RoundedRay(const Point3& p0, const Point3& p1, const Point3& apex, double scale, const RoundedPlace& place)
      : p0_(p0), p1_(p1), scale_(scale), error_(place.error) {
    w_ = difference(p1, p0);
    const Vector<double> v = difference(apex, p0);
    const Vector<double> v1 = difference(apex, p1);
    n_ = cross(w_, v);
    const double nn = dot(n_, n_);
    if (!(nn > least_square)) return;
    const double w_norm = norm(w_);
    const double v_norm = norm(v);
    // z from the midpoint is (n x w) power / (2 n . n).
    const Vector<double> centre = cross(n_, w_) * (dot(v, v1) / (2 * nn));
    y_ = centre + n_ * place.t;
    y_norm_ = norm(y_);
    area_ = w_norm * v_norm;
    n_norm_ = norm(n_);
    // n has an error of 8 u |w| |v|; with k = |w| |v| / |n| >= 1: 17 k u of n . n, 8 k u of n x w, so 40 k u of the
    // centre and of n t; and 5 u |v| |v1| of the power, times |w| / 2 |n|.
    const double inverse = 1 / std::sqrt(nn);
    const double k = area_ * inverse;
    rounding_ = 1e-14 * k * (norm(centre) + std::fabs(place.t) * n_norm_) + 1e-15 * area_ * norm(v1) * inverse;
    is_usable_ = k < most_thin && rounding_ < 1e100 && error_ < 1e100;
  }

  bool is_usable() const { return is_usable_; }

  RoundedLine line(const Point3& q) const {
    RoundedLine line;
    line.from = difference(q, p0_);
    const Vector<double> to = difference(q, p1_);
    const Vector<double> u = line.from + to;
    const double f = norm(line.from);
    const double g = norm(to);
    line.power = dot(line.from, to);
    line.power_error = 8e-16 * f * g + tiny;  // 5 u of the sum of magnitudes
    line.slope = dot(y_, u);
    line.along = dot(n_, u);
    // u has an error of 2 u (f + g), the product rounds 3 times.
    line.slope_rounding = norm(u) * rounding_ + 1e-15 * (f + g) * y_norm_ + tiny;
    // n . u: 8 u |w| |v| |u|, that of u and roundings: at most 2e-15 |w| |v| (f + g).
    line.slope_error = line.slope_rounding + error_ * (std::fabs(line.along) + 4e-15 * area_ * (f + g));
    return line;
  }

  /// Sign of the power of `a` times the slope of `b` minus the reverse, for magnitudes; 0 if undecided.
  static int compare(const RoundedLine& a, const RoundedLine& b) {
    const double left = std::fabs(a.power) * std::fabs(b.slope);
    const double right = std::fabs(b.power) * std::fabs(a.slope);
    const double bound = std::fabs(a.power) * b.slope_error + (std::fabs(b.slope) + b.slope_error) * a.power_error +
                         std::fabs(b.power) * a.slope_error + (std::fabs(a.slope) + a.slope_error) * b.power_error +
                         1e-15 * (left + right) + tiny;
    const double value = left - right;
    return value > bound ? 1 : value < -bound ? -1 : 0;
  }

  /// Where the ray meets the Voronoi edge of (p0, p1, q). False if doubles do not tell.
  bool land(const RoundedLine& line, RoundedPlace& place) const {
    const Vector<double> n = cross(w_, line.from);
    const double nn = dot(n, n);
    const double slope = std::fabs(line.slope) - line.slope_error;
    const double power = std::fabs(line.power);
    if (!(nn > least_square && slope > least && power > least)) return false;
    const double area = norm(w_) * norm(line.from);
    const double n_norm = norm(n);
    const double k = area / std::sqrt(nn);
    if (!(k < most_thin)) return false;
    const double along = dot(y_, n);
    const double normals = dot(n_, n);
    place.t = line.power * along / (line.slope * nn);
    // y . n: the errors of y and of n, and roundings.
    const double along_error = rounding_ * n_norm + 2e-15 * y_norm_ * area;
    // The derivative of the fraction by t is its power times this over its slope squared.
    const double turn = normals * line.slope - along * line.along;
    const double turn_error = 1e-14 * area_ * area * std::fabs(line.slope) + std::fabs(normals) * line.slope_rounding +
                              along_error * std::fabs(line.along) +
                              std::fabs(along) * 4e-15 * area_ * (norm(line.from) + y_slack(line));
    const double high = (power + line.power_error) / (nn * slope);
    const double carried = high * error_ * (std::fabs(turn) + turn_error) / slope;
    const double rounded = high * (along_error + std::fabs(along) * line.slope_rounding / slope) +
                           line.power_error * std::fabs(along) / (nn * slope) +
                           std::fabs(place.t) * (5e-15 * k + 2e-15);
    place.error = 1.01 * (carried + rounded) + 0x1p-600;
    return place.error < 1e100;
  }

 private:
  static constexpr double least = 0x1p-80;
  static constexpr double least_square = 0x1p-160;
  static constexpr double most_thin = 0x1p26;
  static constexpr double tiny = 0x1p-1000;

  Vector<double> difference(const Point3& a, const Point3& b) const {
    return {(a.x - b.x) * scale_, (a.y - b.y) * scale_, (a.z - b.z) * scale_};
  }
  static double norm(const Vector<double>& v) { return std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z); }
  /// |q - p1| is at most that of q - p0 and of the edge together.
  double y_slack(const RoundedLine& line) const { return norm(line.from) + norm(w_); }

  const Point3& p0_;
  const Point3& p1_;
  double scale_;
  double error_;
  Vector<double> w_;
  Vector<double> n_;
  Vector<double> y_;
  double y_norm_ = 0;
  double n_norm_ = 0;
  double area_ = 0;
  double rounding_ = 0;
  bool is_usable_ = false;
};

/// The place of the circumcentre of (p, q, r, apex) on the Voronoi edge of (p, q, r): power / (2 n . n det). False if
/// doubles do not tell.
inline bool place_of_centre(const Point3& p, const Point3& q, const Point3& r, const Point3& apex, double scale,
                            RoundedPlace& place) {
  const auto difference = [scale](const Point3& a, const Point3& b) {
    return Vector<double>{(a.x - b.x) * scale, (a.y - b.y) * scale, (a.z - b.z) * scale};
  };
  const auto norm = [](const Vector<double>& v) { return std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z); };
  const Vector<double> a = difference(q, p);
  const Vector<double> b = difference(r, p);
  const Vector<double> to = difference(apex, p);
  const Vector<double> n = cross(a, b);
  const double nn = dot(n, n);
  const double det = dot(n, to);
  const double aa = dot(a, a);
  const double bb = dot(b, b);
  const Vector<double> centre = cross(b * aa - a * bb, n);
  const double power = dot(to, to) * nn - dot(to, centre);
  const double ab = norm(a) * norm(b);
  const double far = norm(to);
  // Along at most 20 roundings and the 8 u of n, twice: below 64 u of the product of norms.
  const double power_error = 8e-15 * far * ab * ab * (far + norm(a) + norm(b));
  const double det_error = 2e-15 * ab * far;
  const double nn_error = 4e-15 * ab * norm(n);
  const double low = std::fabs(det) - det_error;
  if (!(nn > 0x1p-160 && low > 0x1p-120 && nn_error < 1e-7 * nn)) return false;
  place.t = power / (2 * nn * det);
  place.error =
      1.01 * (power_error / (2 * nn * low) + std::fabs(place.t) * (det_error / low + nn_error / nn + 2e-15)) + 0x1p-600;
  return place.error < 1e100;
}

}  // namespace quoin::flow
