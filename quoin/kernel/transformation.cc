// SPDX-License-Identifier: Apache-2.0
#include "quoin/kernel/transformation.h"

#include <cmath>
#include <string>

#include "quoin/base/error.h"

namespace quoin {

namespace {

Transformation::Rows identity_rows() {
  Transformation::Rows rows;
  for (std::size_t i = 0; i < 3; ++i) rows[i][i] = Rational(1);
  return rows;
}

// Cofactor of the entry (i, j) of L.
Rational cofactor(const Transformation::Rows& m, std::size_t i, std::size_t j) {
  const auto& next = m[(i + 1) % 3];
  const auto& last = m[(i + 2) % 3];
  return next[(j + 1) % 3] * last[(j + 2) % 3] - next[(j + 2) % 3] * last[(j + 1) % 3];
}

Transformation rotation_of(unsigned axis, const Rational& cosine, const Rational& sine) {
  const std::size_t i = (axis + 1) % 3;
  const std::size_t j = (axis + 2) % 3;
  Transformation::Rows rows = identity_rows();
  rows[i][i] = cosine;
  rows[i][j] = -sine;
  rows[j][i] = sine;
  rows[j][j] = cosine;
  return Transformation(rows);
}

std::optional<double> double_if_exact(const Rational& value) {
  const double nearest = value.to_double();
  if (!std::isfinite(nearest) || Rational(nearest) != value) return std::nullopt;
  return nearest;
}

}  // namespace

Transformation::Transformation() : rows_(identity_rows()) {}

Transformation Transformation::from_doubles(const std::array<std::array<double, 4>, 3>& rows) {
  Rows exact;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      if (!std::isfinite(rows[i][j])) {
        throw InputError("entry " + std::to_string(j) + " of row " + std::to_string(i) +
                         " of a transformation is not finite");
      }
      exact[i][j] = Rational(rows[i][j]);
    }
  }
  return Transformation(exact);
}

Transformation Transformation::translation(const Rational& x, const Rational& y, const Rational& z) {
  Rows rows = identity_rows();
  rows[0][3] = x;
  rows[1][3] = y;
  rows[2][3] = z;
  return Transformation(rows);
}

Transformation Transformation::scaling(const Rational& x, const Rational& y, const Rational& z) {
  Rows rows;
  rows[0][0] = x;
  rows[1][1] = y;
  rows[2][2] = z;
  return Transformation(rows);
}

Transformation Transformation::rotation(unsigned axis, const Rational& half_tangent) {
  const Rational square = half_tangent * half_tangent;
  const Rational length = Rational(1) + square;
  return rotation_of(axis, (Rational(1) - square) / length, Rational(2) * half_tangent / length);
}

Transformation Transformation::quarter_turns(unsigned axis, int count) {
  constexpr std::array<int, 4> cosines{1, 0, -1, 0};
  const auto turns = static_cast<std::size_t>(((count % 4) + 4) % 4);
  return rotation_of(axis, Rational(cosines[turns]), Rational(cosines[(turns + 3) % 4]));
}

RationalPoint3 Transformation::operator()(const RationalPoint3& p) const {
  const auto coordinate = [&](const Row& row) { return row[0] * p.x + row[1] * p.y + row[2] * p.z + row[3]; };
  return {coordinate(rows_[0]), coordinate(rows_[1]), coordinate(rows_[2])};
}

RationalPoint3 Transformation::operator()(const Point3& p) const {
  return (*this)(exact_point(p));
}

std::optional<Point3> Transformation::image_if_exact(const Point3& p) const {
  const RationalPoint3 image = (*this)(p);
  const std::optional<double> x = double_if_exact(image.x);
  const std::optional<double> y = double_if_exact(image.y);
  const std::optional<double> z = double_if_exact(image.z);
  if (!x || !y || !z) return std::nullopt;
  return Point3{*x, *y, *z};
}

Point3 Transformation::rounded_image(const Point3& p) const {
  const RationalPoint3 image = (*this)(p);
  return {image.x.to_double(), image.y.to_double(), image.z.to_double()};
}

Rational Transformation::determinant() const {
  return rows_[0][0] * cofactor(rows_, 0, 0) + rows_[0][1] * cofactor(rows_, 0, 1) +
         rows_[0][2] * cofactor(rows_, 0, 2);
}

// L^-1 is the transposed matrix of cofactors over the determinant; the translation is -L^-1 t.
Transformation Transformation::inverse() const {
  const Rational size = determinant();
  if (size.sign() == Sign::zero) throw InputError("a transformation with determinant zero has no inverse");
  Rows rows;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      rows[i][j] = cofactor(rows_, j, i) / size;
      rows[i][3] -= rows[i][j] * rows_[j][3];
    }
  }
  return Transformation(rows);
}

Transformation operator*(const Transformation& a, const Transformation& b) {
  Transformation::Rows rows;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t k = 0; k < 3; ++k) rows[i][j] += a.rows_[i][k] * b.rows_[k][j];
    }
    rows[i][3] += a.rows_[i][3];
  }
  return Transformation(rows);
}

}  // namespace quoin
