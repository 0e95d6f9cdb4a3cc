// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/sets/planar_area.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "quoin/base/error.h"

namespace quoin {

namespace {

/// A sum of rationals, each cut off to three doubles. Three roundings leave 2^-159 of a term or half the smallest
/// double.
class CutOffSum {
 public:
  void add(Rational term) {
    for (int i = 0; i < 3; ++i) {
      const double head = term.to_double();
      is_finite_ = is_finite_ && std::isfinite(head);
      if (head == 0 || !is_finite_) break;
      if (i == 0) largest_ = std::max(largest_, std::fabs(head));
      sum_ += Rational(head);
      term -= Rational(head);
    }
    if (term.sign() != Sign::zero) ++cut_off_;
  }

  /// The double nearest to half the sum, where that is certain.
  std::optional<double> half() const {
    if (!is_finite_) return std::nullopt;
    const Rational error =
        Rational(std::int64_t(cut_off_)) * (Rational(largest_) * Rational(0x1p-158) + Rational(0x1p-1074));
    const double low = ((sum_ - error) / Rational(2)).to_double();
    const double high = ((sum_ + error) / Rational(2)).to_double();
    return low == high ? std::optional(low) : std::nullopt;
  }

 private:
  Rational sum_;
  double largest_ = 0;
  std::size_t cut_off_ = 0;
  bool is_finite_ = true;
};

}  // namespace

double rounded_area(const LinearPolygonSet& set) {
  if (set.is_unbounded()) throw InputError("an unbounded set has no area");
  const LinearArrangement& arrangement = set.arrangement();
  CutOffSum twice;
  for (std::size_t i = 0; i < arrangement.edge_count(); ++i) {
    const dcel::EdgeId e(i);
    if (!arrangement.cells().is_real(e)) continue;
    const bool above = set.contains(arrangement.cells().face(dcel::HalfedgeId(e, false)));
    const bool below = set.contains(arrangement.cells().face(dcel::HalfedgeId(e, true)));
    if (above == below) continue;
    const RationalPoint2 a = arrangement.family().exact(arrangement.left_point(e));
    const RationalPoint2 b = arrangement.family().exact(arrangement.right_point(e));
    const Rational trapezoid = (b.x - a.x) * (a.y + b.y);
    twice.add(below ? trapezoid : -trapezoid);
  }
  const std::optional<double> rounded = twice.half();
  return rounded ? *rounded : area(set).to_double();
}

}  // namespace quoin
