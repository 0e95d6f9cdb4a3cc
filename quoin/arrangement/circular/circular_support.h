// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "quoin/base/id.h"
#include "quoin/kernel/rational_point.h"
#include "quoin/number/rational.h"

namespace quoin {

/// A supporting circle or line of a `CircularFamily`.
using CircularSupportId = Id<struct CircularSupportTag>;

/// How a support was given, which decides how exact arithmetic reads it.
enum class CircularForm : std::uint8_t {
  radius,           ///< circle: centre and radius are doubles
  squared_radius,   ///< circle: centre and squared radius are doubles
  rational_circle,  ///< circle: `CircularPools::circles`
  segment,          ///< line through two points of doubles
  rational_line     ///< line: `CircularPools::lines`
};

/// A circle or a line in doubles, rounded to nearest where the form is rational.
struct CircularSupport {
  double x = 0;               ///< of the centre, or of the smaller of the two points of a line
  double y = 0;               ///< likewise
  double radius = 0;          ///< within 2u of itself; exact in form `radius`
  double squared_radius = 0;  ///< within u of itself
  double x_tail = 0;  ///< what rounding cut off x, y and the squared radius; with it each is within u^2 of itself
  double y_tail = 0;
  double squared_radius_tail = 0;
  double dx = 0;  ///< direction of a line, lexicographically positive, each within u of itself
  double dy = 0;
  double end_x = 0;  ///< the larger of the two points of a line
  double end_y = 0;
  std::uint32_t rational = 0;  ///< index into the pool of its form
  CircularForm form = CircularForm::radius;
  bool vertical = false;

  bool is_line() const { return form >= CircularForm::segment; }
  bool is_rational() const { return form == CircularForm::rational_circle || form == CircularForm::rational_line; }
};

struct RationalCircle {
  Rational x;
  Rational y;
  Rational squared_radius;
};

/// The line from (x, y) to the lexicographically larger (end_x, end_y).
struct RationalLine {
  Rational x;
  Rational y;
  Rational end_x;
  Rational end_y;
};

/// Rational data over a common denominator w > 0: a circle with the centre (x, y) / w and the squared radius
/// `square` / w^2, a line from (x, y) / w to (end_x, end_y) / w, a point (x, y) / w.
struct HomogeneousCircle {
  explicit HomogeneousCircle(const RationalCircle& circle);
  Integer x;
  Integer y;
  Integer square;
  Integer w;
};
struct HomogeneousLine {
  explicit HomogeneousLine(const RationalLine& line);
  Integer x;
  Integer y;
  Integer end_x;
  Integer end_y;
  Integer w;
};
struct HomogeneousPoint {
  explicit HomogeneousPoint(const RationalPoint2& point);
  Integer x;
  Integer y;
  Integer w;
};

/// Everything that points and branches refer to; grows only.
struct CircularPools {
  std::vector<CircularSupport> supports;
  std::vector<HomogeneousCircle> circles;
  std::vector<HomogeneousLine> lines;
  std::vector<HomogeneousPoint> points;

  RationalCircle exact_circle(std::uint32_t support) const;
  RationalLine exact_line(std::uint32_t support) const;
  RationalPoint2 exact_point(std::uint32_t rational) const;
};

/// What defines a point of a `CircularFamily`.
enum class CircularPointKind : std::uint8_t {
  doubles,   ///< x, y themselves
  rational,  ///< an entry of `CircularPools::points`
  crossing,  ///< of the supports first < second
  extreme    ///< leftmost or rightmost point of the circle `first`
};

/// A point: its definition, and doubles within `CircularFamily::error()` of the true coordinates. Crossings of lines
/// far outside everything else have no doubles (NaN), so that every comparison of them is exact.
struct CircularPoint {
  static constexpr std::uint32_t none = 0xFFFFFFFFU;

  double x = 0;
  double y = 0;
  std::uint32_t first = none;     ///< a support that the point lies on, whatever the kind
  std::uint32_t second = none;    ///< another one
  std::uint32_t rational = none;  ///< kind rational
  std::int8_t root =
      0;  ///< crossing: the lexicographically smaller (-1), larger (+1) or only (0) one; extreme: left -1
  std::int8_t half_first = 0;   ///< sign of y minus that of the centre, if `first` is a circle
  std::int8_t half_second = 0;  ///< likewise
  CircularPointKind kind : 2 = CircularPointKind::doubles;
  bool exact_x : 1 = true;  ///< x is the coordinate itself
  bool exact_y : 1 = true;
};
static_assert(sizeof(CircularPoint) == 32);

}  // namespace quoin
