// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/svg_transform.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "quoin/io/text_lines.h"
#include "quoin/number/interval.h"

namespace quoin::io {

namespace {

bool is_power_of_two(double value) {
  int exponent = 0;
  return std::fabs(std::frexp(value, &exponent)) == 0.5;
}

}  // namespace

SvgTransform SvgTransform::after(const SvgTransform& inner) const {
  if (inner.is_identity_) return *this;
  if (is_identity_) return inner;
  SvgTransform both;
  both.is_identity_ = false;
  both.sx_ = sx_ * inner.sx_;
  both.sy_ = sy_ * inner.sy_;
  both.tx_ = sx_ * inner.tx_ + tx_;
  both.ty_ = sy_ * inner.ty_ + ty_;
  return both;
}

bool SvgTransform::is_excessive() const {
  const auto digits = [](const Rational& value) {
    return value.numerator().bit_length() + value.denominator().bit_length();
  };
  return !is_identity_ && std::max({digits(sx_), digits(tx_), digits(ty_)}) > 10'000;
}

Point2 SvgTransform::image(const Point2& p, const TextCursor& cursor, const std::string& element,
                           DrawingNotes& notes) const {
  const Rational x = sx_ * Rational(p.x) + tx_;
  const Rational y = sy_ * Rational(p.y) + ty_;
  const Point2 q{x.to_double(), y.to_double()};
  if (!std::isfinite(q.x) || !std::isfinite(q.y)) cursor.fail(element, "its transform leads beyond the largest double");
  const Rational error = abs(x - Rational(q.x)) + abs(y - Rational(q.y));
  if (error.sign() != Sign::zero)
    notes.moved("transformed points are rounded", element, Interval::around(error).upper());
  return q;
}

void SvgTransform::apply(DrawingPath& path, const TextCursor& cursor, const std::string& element,
                         DrawingNotes& notes) const {
  if (is_identity_) return;
  for (Point2& p : path.points) p = image(p, cursor, element, notes);
  if (sx_ == sy_) return;
  for (double& bulge : path.bulges) bulge = plain(-bulge);
}

void SvgTransform::apply(DrawingCircle& circle, const TextCursor& cursor, const std::string& element,
                         DrawingNotes& notes) const {
  if (is_identity_) return;
  circle.center = image(circle.center, cursor, element, notes);
  const Rational radius = abs(sx_) * Rational(circle.radius);
  circle.radius = radius.to_double();
  if (!std::isfinite(circle.radius)) cursor.fail(element, "its transform leads beyond the largest double");
  const Rational error = abs(radius - Rational(circle.radius));
  if (error.sign() != Sign::zero)
    notes.moved("transformed radii are rounded", element, Interval::around(error).upper());
}

SvgTransform SvgTransform::read(TextCursor cursor, const std::string& element) {
  SvgTransform all;
  std::size_t functions = 0;
  for (;;) {
    cursor.skip_comma();
    if (cursor.at_end()) return all;
    // Each may double the digits of the shift.
    if (++functions > max_nesting) cursor.fail(element, "the transform has too many functions");
    const std::string_view function = cursor.word();
    if (function.empty()) cursor.fail(element, "a transform should stand here, and " + cursor.found() + " does");
    all = all.after(one(cursor, function, element));
  }
}

SvgTransform SvgTransform::one(TextCursor& cursor, std::string_view function, const std::string& element) {
  if (function != "translate" && function != "scale" && function != "matrix")
    cursor.fail(element, "the transform " + quoted(function) + " is not supported");
  if (!cursor.accept('(')) cursor.fail(element, "'(' is missing behind the transform " + quoted(function));
  std::vector<double> numbers;
  while (!cursor.accept(')')) {
    if (numbers.size() == 6) cursor.fail(element, "the transform " + quoted(function) + " has too many numbers");
    numbers.push_back(cursor.number(element));
    cursor.skip_comma();
  }
  const std::size_t count = numbers.size();
  const bool fits = function == "matrix" ? count == 6 : count == 1 || count == 2;
  if (!fits) cursor.fail(element, "the transform " + quoted(function) + " has " + std::to_string(count) + " numbers");
  SvgTransform result;
  result.is_identity_ = false;
  if (function == "translate") {
    result.tx_ = Rational(numbers[0]);
    result.ty_ = Rational(count == 2 ? numbers[1] : 0.0);
    return result;
  }
  const double sx = numbers[0];
  const double sy = count == 1 ? sx : numbers[count == 2 ? 1 : 3];
  const bool is_turned = count == 6 && (numbers[1] != 0 || numbers[2] != 0);
  if (is_turned || std::fabs(sx) != std::fabs(sy) || !is_power_of_two(sx)) {
    cursor.fail(element, "the transform " + quoted(function) +
                             " is not supported but for scales by a power of two, equal in x and y but for the sign");
  }
  result.sx_ = Rational(sx);
  result.sy_ = Rational(sy);
  if (count == 6) {
    result.tx_ = Rational(numbers[4]);
    result.ty_ = Rational(numbers[5]);
  }
  return result;
}

}  // namespace quoin::io
