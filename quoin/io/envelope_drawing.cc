// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/envelope_drawing.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "quoin/base/error.h"
#include "quoin/io/piece_bulge.h"

namespace quoin {

namespace {

double bulge_between(const LinearFamily&, BranchId, const Point2&, const Point2&) {
  return 0;
}

template <class F>
class EnvelopeDrawer {
 public:
  EnvelopeDrawer(const F& family, const Envelope<F>& envelope) : family_(family), envelope_(envelope) {}

  Drawing draw() {
    for (std::size_t i = 0; i < envelope_.interval_count(); ++i) {
      if (i > 0) add_breakpoint(i - 1);
      if (!envelope_.is_gap(i)) add_interval(i);
    }
    finish_path();
    if (short_ > 0) {
      drawing_.notes.push_back(std::to_string(short_) + " intervals are too short to be written in doubles");
    }
    return std::move(drawing_);
  }

 private:
  /// The curve of an interval beside a breakpoint ends in its point.
  bool passes(std::size_t interval, std::size_t breakpoint) const {
    const auto& point = envelope_.point(breakpoint);
    return !envelope_.is_gap(interval) && family_.side(point) == Side::interior &&
           family_.compare_y_at_x(point, envelope_.branch(interval)) == Sign::zero;
  }

  void add_breakpoint(std::size_t i) {
    const bool from_left = passes(i, i);
    const bool to_right = passes(i + 1, i);
    if (from_left && to_right) return;
    finish_path();
    if (from_left || to_right || family_.side(envelope_.point(i)) != Side::interior) return;
    add_element(family_.position(envelope_.point(i)));
  }

  void add_interval(std::size_t i) {
    const std::optional<Point2> from = left_end(family_, envelope_, i);
    const std::optional<Point2> to = right_end(family_, envelope_, i);
    if (!from || !to) throw InputError("the envelope reaches infinity, which a drawing does not hold");
    if (path_.points.empty()) path_.points.push_back(*from);
    if (path_.points.back() == *to) {
      ++short_;
      return;
    }
    path_.bulges.push_back(bulge_between(family_, envelope_.branch(i), path_.points.back(), *to));
    path_.points.push_back(*to);
  }

  void finish_path() {
    if (std::ranges::all_of(path_.bulges, [](double bulge) { return bulge == 0; })) path_.bulges.clear();
    if (path_.points.size() > 1) add_element(std::move(path_));
    path_ = {};
  }

  template <class Shape>
  void add_element(Shape shape) {
    drawing_.elements.push_back({std::move(shape), "part " + std::to_string(drawing_.elements.size() + 1), {}});
  }

  const F& family_;
  const Envelope<F>& envelope_;
  Drawing drawing_;
  DrawingPath path_;
  std::size_t short_ = 0;
};

}  // namespace

Point2 point_over(const LinearFamily& family, BranchId branch, const LinearPoint& x) {
  const Rational at = x.is_end() ? family.first_support_point(BranchId(x.first)).x : family.exact(x).x;
  const RationalPoint2 a = family.first_support_point(branch);
  const RationalPoint2 b = family.second_support_point(branch);
  const Rational y = a.y + (at - a.x) * (b.y - a.y) / (b.x - a.x);
  return {at.to_double(), y.to_double()};
}

Point2 point_over(const CircularFamily& family, BranchId branch, const CircularPoint& x) {
  const Point2 position = family.position(x);
  if (family.compare_y_at_x(x, branch) == Sign::zero) return position;
  const CircularSupport& support = family.rounded(CircularFamily::support(branch));
  const double dx = position.x - support.x;
  if (support.is_line()) return {position.x, support.y + dx * (support.dy / support.dx)};
  const double height = std::sqrt(std::max(0.0, (support.radius - dx) * (support.radius + dx)));
  return {position.x, CircularFamily::is_upper(branch) ? support.y + height : support.y - height};
}

Drawing draw_envelope(const LinearFamily& family, const LinearEnvelope& envelope) {
  return EnvelopeDrawer<LinearFamily>(family, envelope).draw();
}

Drawing draw_envelope(const CircularFamily& family, const CircularEnvelope& envelope) {
  return EnvelopeDrawer<CircularFamily>(family, envelope).draw();
}

}  // namespace quoin
