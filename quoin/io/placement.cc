// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/placement.h"

#include <algorithm>
#include <cmath>

#include "quoin/number/error_free.h"
#include "quoin/number/interval.h"

namespace quoin::io {

namespace {

constexpr std::size_t max_parts_of_entry = 4;
constexpr std::size_t max_parts = 2 * 3 * max_parts_of_entry + max_parts_of_entry;

// The sum of doubles, without rounding, as parts that do not overlap, smallest first (Shewchuk 1997, GROW-EXPANSION).
class ExactSum {
 public:
  void add(double value) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const TwoDoubles sum = two_sum(value, parts_[i]);
      value = sum.value;
      if (sum.tail != 0) parts_[kept++] = sum.tail;
    }
    if (value != 0) parts_[kept++] = value;
    size_ = kept;
  }

  // Makes each part the rounded sum of itself and all below it (COMPRESS): |part below| <= half a unit of its last
  // place.
  void compress() {
    if (size_ == 0) return;
    std::size_t bottom = size_ - 1;
    double value = parts_[bottom];
    for (std::size_t i = size_ - 1; i-- > 0;) {
      const TwoDoubles sum = fast_two_sum(value, parts_[i]);
      value = sum.value;
      if (sum.tail != 0) {
        parts_[bottom--] = sum.value;
        value = sum.tail;
      }
    }
    parts_[bottom] = value;
    std::size_t top = 0;
    for (std::size_t i = bottom + 1; i < size_; ++i) {
      const TwoDoubles sum = fast_two_sum(parts_[i], value);
      value = sum.value;
      if (sum.tail != 0) parts_[top++] = sum.tail;
    }
    parts_[top] = value;
    size_ = top + 1;
  }

  std::size_t size() const { return size_; }
  // From the largest.
  double part(std::size_t k) const { return parts_[size_ - 1 - k]; }

 private:
  std::array<double, max_parts> parts_{};
  std::size_t size_ = 0;
};

// Doubles whose sum is the number; false where some of them are not enough or leave the range of exact products.
bool split_into_doubles(Rational rest, std::vector<double>& parts) {
  for (std::size_t k = 0; k < max_parts_of_entry; ++k) {
    if (rest.sign() == Sign::zero) return true;
    const double part = rest.to_double();
    if (!std::isfinite(part) || part == 0 || std::fabs(part) > 0x1p995) return false;
    parts.push_back(part);
    rest -= Rational(part);
  }
  return rest.sign() == Sign::zero;
}

bool is_power_of_two(double value) {
  int exponent = 0;
  return std::fabs(std::frexp(value, &exponent)) == 0.5;
}

}  // namespace

Placement::Placement(const Transformation& map)
    : map_(map), is_identity_(map == Transformation()), is_mirror_(map.determinant().sign() == Sign::negative) {
  for (std::size_t row = 0; row < 3; ++row) {
    has_terms_[row] = true;
    for (std::size_t axis = 0; axis < 4; ++axis) {
      std::vector<double> factors;
      has_terms_[row] = has_terms_[row] && split_into_doubles(map.rows()[row][axis], factors);
      for (const double factor : factors) terms_[row].push_back({axis, factor});
    }
  }
}

Point3 Placement::image(const Point3& p, RoundingCount& rounding) const {
  if (is_identity_) return p;
  Point3 result;
  for (std::size_t row = 0; row < 3; ++row) {
    double value = 0;
    if (!fast_coordinate(row, p, value, rounding)) value = exact_coordinate(row, p, rounding);
    result[row] = value;
  }
  return result;
}

// The largest part h of the sum is the rounded sum of itself and the next, t. What is below them, less than a unit of
// the last place of t, changes the rounding only where h + t lies on the border between two doubles' ranges; t is a
// power of two there.
bool Placement::fast_coordinate(std::size_t row, const Point3& p, double& value, RoundingCount& rounding) const {
  if (!has_terms_[row]) return false;
  ExactSum sum;
  for (const Term& term : terms_[row]) {
    if (term.axis == 3) {
      sum.add(term.factor);
      continue;
    }
    const double coordinate = p[term.axis];
    if (coordinate == 0) continue;
    if (!is_product_exact_range(term.factor, coordinate)) return false;
    const TwoDoubles product = two_product(term.factor, coordinate);
    if (product.tail != 0) sum.add(product.tail);
    sum.add(product.value);
  }
  sum.compress();
  value = sum.size() == 0 ? 0 : sum.part(0);
  if (!std::isfinite(value)) return false;
  if (sum.size() <= 1) return true;
  const double next = sum.part(1);
  if (value + next != value || (sum.size() > 2 && is_power_of_two(next))) return false;
  ++rounding.coordinates;
  rounding.largest = std::max(rounding.largest, std::fabs(next) * (1 + 0x1p-50));
  return true;
}

double Placement::exact_coordinate(std::size_t row, const Point3& p, RoundingCount& rounding) const {
  const Transformation::Row& m = map_.rows()[row];
  const Rational exact = m[0] * Rational(p.x) + m[1] * Rational(p.y) + m[2] * Rational(p.z) + m[3];
  const double nearest = exact.to_double();
  if (!std::isfinite(nearest)) return nearest;
  if (Rational(nearest) != exact) {
    ++rounding.coordinates;
    rounding.largest = std::max(rounding.largest, Interval::around(abs(exact - Rational(nearest))).upper());
  }
  return nearest;
}

}  // namespace quoin::io
