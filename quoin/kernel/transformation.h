// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "quoin/kernel/point.h"
#include "quoin/kernel/rational_point.h"
#include "quoin/number/rational.h"

namespace quoin {

/// An affine map of space, p -> L p + t, with rational entries: composing, inverting and applying are exact.
///
/// Rotations by angles with irrational sine or cosine are not among them; `rotation` takes the tangent of half the
/// angle, `quarter_turns` multiples of 90 degrees, and `from_doubles` whatever matrix a caller has rounded.
class Transformation {
 public:
  using Row = std::array<Rational, 4>;  ///< of L, with the entry of t last
  using Rows = std::array<Row, 3>;

  /// The identity.
  Transformation();
  explicit Transformation(const Rows& rows) : rows_(rows) {}
  /// The entries mean exactly what they say. @throws InputError  an entry is not finite
  static Transformation from_doubles(const std::array<std::array<double, 4>, 3>& rows);
  static Transformation translation(const Rational& x, const Rational& y, const Rational& z);
  static Transformation scaling(const Rational& x, const Rational& y, const Rational& z);
  /// About the axis through the origin, counterclockwise seen from its positive end, by 2 atan(half_tangent): the sine
  /// is 2 t / (1 + t^2), the cosine (1 - t^2) / (1 + t^2).
  static Transformation rotation(unsigned axis, const Rational& half_tangent);
  /// About the axis through the origin, counterclockwise, by `count` right angles.
  static Transformation quarter_turns(unsigned axis, int count);

  const Rows& rows() const { return rows_; }

  RationalPoint3 operator()(const RationalPoint3& p) const;
  RationalPoint3 operator()(const Point3& p) const;
  /// The image where its coordinates are doubles; nothing where one must be rounded or is beyond the range.
  std::optional<Point3> image_if_exact(const Point3& p) const;
  /// Each coordinate of the image rounded to nearest, ties to even; infinite beyond the range.
  Point3 rounded_image(const Point3& p) const;

  /// Of L; the factor of volumes. Negative: the map turns inside out. Zero: it flattens, there is no inverse.
  Rational determinant() const;
  /// @throws InputError  the determinant is zero
  Transformation inverse() const;

  /// p -> a(b(p)).
  friend Transformation operator*(const Transformation& a, const Transformation& b);
  friend bool operator==(const Transformation&, const Transformation&) = default;

 private:
  Rows rows_;
};

}  // namespace quoin
