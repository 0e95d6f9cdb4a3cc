// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/hull_builder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "quoin/kernel/predicates3.h"
#include "quoin/kernel/rational_point.h"
#include "quoin/polytope/edge_predicates.h"

namespace quoin {

namespace {

constexpr double u = 0x1p-53;

Sign exact_orientation(const RationalPoint3& a, const RationalPoint3& b, const RationalPoint3& c,
                       const RationalPoint3& d) {
  return dot(cross(b - a, c - a), d - a).sign();
}

}  // namespace

HullBuilder::HullBuilder(std::span<const Point3> points, const Context& context) : points_(points) {
  start(context);
  find_centre();
}

HullBuilder::HullBuilder(std::span<const Point3> rounded, const Constructions& table, std::span<const PointId> ids,
                         const Context& context)
    : points_(rounded), table_(&table), ids_(ids) {
  start(context);
}

void HullBuilder::start(const Context& context) {
  constexpr std::size_t block = 1U << 14;
  for (std::size_t begin = 0; begin < points_.size(); begin += block) {
    context.poll();
    for (const Point3& p : points_.subspan(begin, std::min(block, points_.size() - begin))) {
      largest_ = std::max({largest_, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    }
  }
  std::array<std::uint32_t, 4> p{0, 1, 2, 3};
  if (orientation_of(0, 1, 2, 3) == Sign::positive) std::swap(p[1], p[2]);
  // From outside, the triangle opposite to corner 3 turns left.
  const std::array<std::array<std::uint32_t, 3>, 4> faces{
      {{p[0], p[1], p[2]}, {p[0], p[3], p[1]}, {p[1], p[3], p[2]}, {p[2], p[3], p[0]}}};
  for (const auto& [a, b, c] : faces) new_triangle(single_, a, b, c);
  triangles_[0].across = {1, 2, 3};
  triangles_[1].across = {3, 2, 0};
  triangles_[2].across = {1, 3, 0};
  triangles_[3].across = {2, 1, 0};
}

Sign HullBuilder::orientation_of(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
  if (table_ != nullptr) return table_->orientation_any(ids_[a], ids_[b], ids_[c], ids_[d]);
  return orientation(points_[a], points_[b], points_[c], points_[d]);
}

RationalPoint3 HullBuilder::exact(std::uint32_t point) const {
  return table_ != nullptr ? table_->exact(ids_[point]) : exact_point(points_[point]);
}

/// More than stay: new triangles are made before those that they replace are free, and threads leave places empty. What
/// is not touched takes no memory; to move all would take twice as much.
void HullBuilder::reserve(std::size_t vertices) {
  const std::size_t triangles = 2 * vertices + vertices / 8 + 4096;
  triangles_.reserve(triangles);
  planes_.reserve(triangles);
}

/// Strictly inside the first four.
void HullBuilder::find_centre() {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    centre_[axis] = (points_[0][axis] / 4 + points_[1][axis] / 4) + (points_[2][axis] / 4 + points_[3][axis] / 4);
  }
  has_centre_ = true;
  for (std::uint32_t t = 0; t < 4; ++t) {
    const auto& [a, b, c] = triangles_[t].corners;
    has_centre_ = has_centre_ && orientation(points_[a], points_[b], points_[c], centre_) == Sign::negative;
  }
}

/// With M the largest coordinate, n = (b - a) x (c - a) and P the sum of the magnitudes of its products: n errs by
/// 4 u P, which tells by 8 u M P over a distance of 2 M; the offset n.a by 3 u M P, the evaluation by 8 u M P.
/// Twenty-four pay for the rest. What falls below the range of doubles is less than 2^-1070 in n, which 2^-1000 M pays
/// for, and 2^-120 in the evaluation. Infinite or no number: decides nothing.
///
/// Coordinates of points of a table err by u M (below M = 2^-1000, where that may be less than a unit, 2^-120 pays):
/// six products of three differences of at most 2 M, each off by 2 u M, by 144 u M^3 together.
std::uint32_t HullBuilder::new_triangle(Hand& hand, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  std::uint32_t triangle;
  if (!hand.free.empty()) {
    triangle = hand.free.back();
    hand.free.pop_back();
  } else if (hand.fresh < hand.fresh_end) {
    triangle = hand.fresh++;
  } else {
    triangle = static_cast<std::uint32_t>(triangles_.size());
    triangles_.emplace_back();
    planes_.emplace_back();
  }
  const Point3& p = points_[a];
  const Point3& q = points_[b];
  const Point3& r = points_[c];
  const auto& [n, products] = rounded_normal(rounded({p, q}), rounded({p, r}));
  planes_[triangle] = {n.x, n.y, n.z, n.x * p.x + n.y * p.y + n.z * p.z};
  Triangle& t = triangles_[triangle];
  t.corners = {a, b, c};
  t.mark = 0;
  double slack = (24 * u * (1 + 0x1p-20)) * largest_ * products + 0x1p-1000 * largest_ + 0x1p-120;
  if (table_ != nullptr) slack += 160 * u * largest_ * largest_ * largest_;
  constexpr double most = std::numeric_limits<float>::max();
  t.slack = slack < most ? static_cast<float>(slack) : std::numeric_limits<float>::infinity();
  return triangle;
}

Sign HullBuilder::exact_side(std::uint32_t triangle, std::uint32_t point) const {
  const std::array<std::uint32_t, 3>& corners = triangles_[triangle].corners;
  return orientation_of(corners[0], corners[1], corners[2], point);
}

/// Negative where the plane through the centre and the edge separates p from the triangle.
Sign HullBuilder::side_from_centre(const Triangle& triangle, unsigned edge, std::uint32_t point) const {
  if (!has_centre_) return side_from_mean(triangle, edge, point);
  return orientation(centre_, points_[triangle.corners[edge]], points_[triangle.corners[next(edge)]], points_[point]);
}

/// The determinant is affine in each point: where its signs for the four points agree, their mean has that sign.
Sign HullBuilder::side_from_mean(const Triangle& triangle, unsigned edge, std::uint32_t point) const {
  const std::uint32_t a = triangle.corners[edge];
  const std::uint32_t b = triangle.corners[next(edge)];
  bool has_positive = false;
  bool has_negative = false;
  for (std::uint32_t i = 0; i < 4; ++i) {
    const Sign sign = orientation_of(i, a, b, point);
    has_positive = has_positive || sign == Sign::positive;
    has_negative = has_negative || sign == Sign::negative;
  }
  if (!has_negative) return has_positive ? Sign::positive : Sign::zero;
  if (!has_positive) return Sign::negative;
  RationalPoint3 mean{0, 0, 0};
  for (std::uint32_t i = 0; i < 4; ++i) mean = mean + exact(i);
  mean = mean * Rational(0.25);
  return exact_orientation(mean, exact(a), exact(b), exact(point));
}

/// A triangle that sees the point, or in whose cone from the centre it lies, or one that the hand must not replace.
HullBuilder::Found HullBuilder::locate(const Hand& hand, std::uint32_t point) const {
  std::uint32_t triangle = hand.hint;
  std::uint32_t from = none;
  for (;;) {
    const Triangle& t = triangles_[triangle];
    if (t.mark == hand.border) return {triangle, Place::border};
    if (side(triangle, point) == Sign::positive) return {triangle, Place::outside};
    unsigned k = 0;
    while (k < 3 && (t.across[k] == from || side_from_centre(t, k, point) != Sign::negative)) ++k;
    if (k == 3) return {triangle, Place::inside};
    from = triangle;
    triangle = t.across[k];
  }
}

/// Marks all that see the point; an edge between these and the others, of one that sees it, or none if one that the
/// hand must not replace sees it too.
HullBuilder::Edge HullBuilder::mark_visible(Hand& hand, std::uint32_t first, std::uint32_t point) {
  if (hand.epoch > none - 4) {
    hand.epoch = 0;
    for (Triangle& t : triangles_) t.mark = 0;
  }
  hand.epoch += 2;
  const std::uint32_t epoch = hand.epoch;
  std::vector<std::uint32_t>& visible = hand.visible;
  Edge rim{none, 0};
  visible.assign(1, first);
  triangles_[first].mark = epoch;
  for (std::size_t i = 0; i < visible.size(); ++i) {
    const std::uint32_t triangle = visible[i];
    for (unsigned k = 0; k < 3; ++k) {
      const std::uint32_t across = triangles_[triangle].across[k];
      std::uint32_t& mark = triangles_[across].mark;
      if (mark == epoch) continue;
      if (mark != epoch + 1) {
        const bool is_border = mark == hand.border;
        if (side(across, point) == Sign::positive) {
          if (is_border) return {none, 0};
          mark = epoch;
          visible.push_back(across);
          continue;
        }
        if (!is_border) mark = epoch + 1;
      }
      rim = {triangle, k};
    }
  }
  return rim;
}

/// Goes once around what is visible, with it on the left.
void HullBuilder::replace_visible(Hand& hand, const Edge& rim, std::uint32_t point) {
  std::uint32_t first = none;
  std::uint32_t before = none;
  std::uint32_t triangle = rim.triangle;
  unsigned k = rim.index;
  do {
    const std::uint32_t outer = triangles_[triangle].across[k];
    const std::uint32_t a = triangles_[triangle].corners[k];
    const std::uint32_t b = triangles_[triangle].corners[next(k)];
    const std::uint32_t added = new_triangle(hand, a, b, point);
    triangles_[added].across[0] = outer;
    triangles_[outer].across[index_of(triangles_[outer], triangle)] = added;
    if (before == none) {
      first = added;
    } else {
      triangles_[before].across[1] = added;
      triangles_[added].across[2] = before;
    }
    before = added;
    k = next(k);
    while (triangles_[triangles_[triangle].across[k]].mark == hand.epoch) {
      const std::uint32_t across = triangles_[triangle].across[k];
      k = next(index_of(triangles_[across], triangle));
      triangle = across;
    }
  } while (triangle != rim.triangle || k != rim.index);
  triangles_[before].across[1] = first;
  triangles_[first].across[2] = before;
  for (const std::uint32_t seen : hand.visible) {
    triangles_[seen].corners = {none, none, none};
    hand.free.push_back(seen);
  }
  hand.hint = before;
}

/// Changes nothing unless the point is outside and all is at hand. The rim of a disc of v triangles has at most v + 2
/// edges.
HullBuilder::Place HullBuilder::insert(Hand& hand, std::uint32_t point) {
  const Found found = locate(hand, point);
  if (found.place != Place::outside) return found.place;
  const Edge rim = mark_visible(hand, found.triangle, point);
  if (rim.triangle == none || !hand.has_room(hand.visible.size() + 2)) return Place::border;
  replace_visible(hand, rim, point);
  ++hand.inserted;
  return Place::outside;
}

}  // namespace quoin
