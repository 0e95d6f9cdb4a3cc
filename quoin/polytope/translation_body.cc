// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/translation_body.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <utility>

#include "quoin/base/error.h"
#include "quoin/kernel/call_grid.h"

namespace quoin {

namespace {

using detail::CallGrid;
using detail::CallReader;

/// The coordinates that a formula reads, and rows of integers made of them.
class Values {
 public:
  explicit Values(const TranslationBody& body) : body_(body) {}
  void add(const Point3& p) {
    values_[size_++] = p.x;
    values_[size_++] = p.y;
    values_[size_++] = p.z;
  }
  void add_vertex(std::uint32_t v) {
    add(body_.point_of_first(v));
    add(body_.point_of_second(v));
  }

  /// Rows are of magnitude below 2^(bits + 4), so that formulas of them fit the numbers for differences of coordinates
  /// of three bits more.
  template <class Formula>
  Sign decide(const Formula& formula) const {
    constexpr int more = 3;
    const CallGrid grid(std::span<const double>(values_.data(), size_));
    if (grid.bits + more <= 61) return formula(CallReader<detail::CallNumbers<61>>(grid));
    if (grid.bits + more <= 124) return formula(CallReader<detail::CallNumbers<124>>(grid));
    return formula(CallReader<detail::BigCallNumbers>(grid));
  }

 private:
  const TranslationBody& body_;
  std::array<double, 48> values_{};
  std::size_t size_ = 0;
};

template <class N>
using Row = std::array<typename N::Linear, 3>;

/// Rows of differences of vertices and translations.
template <class N>
class Rows {
 public:
  Rows(const TranslationBody& body, const CallReader<N>& difference) : body_(body), difference_(difference) {}

  Row<N> between(std::uint32_t from, std::uint32_t to) const {
    const Row<N> second = minus(body_.point_of_second(to), body_.point_of_second(from));
    const Row<N> first = minus(body_.point_of_first(to), body_.point_of_first(from));
    return {second[0] - first[0], second[1] - first[1], second[2] - first[2]};
  }
  /// From a vertex to t.
  Row<N> to(const Point3& t, std::uint32_t from) const {
    const Row<N> second = minus(t, body_.point_of_second(from));
    const Row<N> first = minus(body_.point_of_first(from), {});
    return {second[0] + first[0], second[1] + first[1], second[2] + first[2]};
  }
  /// Four times what leads from the centre, by what leads from each anchor.
  template <class FromAnchor>
  Row<N> from_centre(const FromAnchor& from_anchor) const {
    Row<N> sum = from_anchor(body_.anchors()[0]);
    for (std::size_t i = 1; i < 4; ++i) {
      const Row<N> row = from_anchor(body_.anchors()[i]);
      for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] = sum[axis] + row[axis];
    }
    return sum;
  }
  std::array<typename N::Quadratic, 3> normal(std::uint32_t f) const {
    const std::uint32_t rim = body_.first_rim(f);
    return detail::cross<typename N::Quadratic>(between(body_.tail(rim), body_.tail(rim + 1)),
                                                between(body_.tail(rim), body_.tail(rim + 2)));
  }

 private:
  Row<N> minus(const Point3& a, const Point3& b) const {
    return {difference_(a.x, b.x), difference_(a.y, b.y), difference_(a.z, b.z)};
  }

  const TranslationBody& body_;
  const CallReader<N>& difference_;
};

template <class N>
Sign determinant(const Row<N>& a, const Row<N>& b, const Row<N>& c) {
  return detail::dot<typename N::Cubic>(detail::cross<typename N::Quadratic>(b, c), a).sign();
}

std::vector<Point3> vertices_of(const Polytope& p) {
  std::vector<Point3> points;
  for (std::uint32_t v = 0; v < p.vertex_count(); ++v) points.push_back(p.vertex(v));
  return points;
}

}  // namespace

TranslationBody::TranslationBody(const Polytope& first, const Polytope& second, const Context& context)
    : first_(vertices_of(first)), second_(vertices_of(second)) {
  if (std::max(first.dimension(), second.dimension()) < 3)
    throw InputError("neither of two polytopes is a solid: translations of such are not queried");
  if (first.is_rational() || second.is_rational()) throw InputError("a vertex of a polytope is no point of doubles");
  sum_ = minkowski_sum(second, reflected(first), context);
  link();
  choose_anchors();
}

/// Twins have the same ends.
void TranslationBody::link() {
  const auto count = static_cast<std::uint32_t>(sum_.corners.size());
  facets_.resize(count);
  for (std::uint32_t f = 0; f < facet_count(); ++f) {
    std::fill(facets_.begin() + first_rim(f), facets_.begin() + end_rim(f), f);
  }
  std::vector<std::pair<std::uint64_t, std::uint32_t>> by_ends(count);
  for (std::uint32_t rim = 0; rim < count; ++rim) {
    const auto [low, high] = std::minmax({tail(rim), head(rim)});
    by_ends[rim] = {(std::uint64_t{low} << 32) | high, rim};
  }
  std::sort(by_ends.begin(), by_ends.end());
  twins_.resize(count);
  for (std::uint32_t i = 0; i < count; i += 2) {
    twins_[by_ends[i].second] = by_ends[i + 1].second;
    twins_[by_ends[i + 1].second] = by_ends[i].second;
  }
}

bool TranslationBody::are_independent(const std::array<std::uint32_t, 4>& corners) const {
  Values values(*this);
  for (const std::uint32_t v : corners) values.add_vertex(v);
  return values.decide([&]<class N>(const CallReader<N>& reader) {
    const Rows<N> rows(*this, reader);
    return determinant<N>(rows.between(corners[0], corners[1]), rows.between(corners[0], corners[2]),
                          rows.between(corners[0], corners[3]));
  }) != Sign::zero;
}

/// Extreme in the directions of the corners of a tetrahedron in the box around; those of a body that is thin askew may
/// lie in one plane, then a facet and a vertex beside its plane do.
void TranslationBody::choose_anchors() {
  std::array<double, 3> low;
  std::array<double, 3> high;
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  const auto rounded = [&](std::uint32_t v, std::size_t axis) {
    return point_of_second(v)[axis] / 4 - point_of_first(v)[axis] / 4;  // in range
  };
  for (std::uint32_t v = 0; v < vertex_count(); ++v) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], rounded(v, axis));
      high[axis] = std::max(high[axis], rounded(v, axis));
    }
  }
  constexpr std::array<std::array<int, 3>, 4> directions{{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}};
  for (std::size_t i = 0; i < 4; ++i) {
    double most = -std::numeric_limits<double>::infinity();
    for (std::uint32_t v = 0; v < vertex_count(); ++v) {
      double value = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double extent = high[axis] - low[axis];
        if (extent > 0) value += directions[i][axis] * ((rounded(v, axis) - low[axis]) / extent);
      }
      if (value > most) {
        most = value;
        anchors_[i] = v;
      }
    }
  }
  if (are_independent(anchors_)) return;
  anchors_ = {tail(0), tail(1), tail(2), 0};
  while (!are_independent(anchors_)) ++anchors_[3];
}

RationalPoint3 TranslationBody::exact_normal(std::uint32_t f) const {
  const std::uint32_t rim = first_rim(f);
  const RationalPoint3 origin = exact(tail(rim));
  return cross(exact(tail(rim + 1)) - origin, exact(tail(rim + 2)) - origin);
}

Sign TranslationBody::height(std::uint32_t f, const Point3& t) const {
  const std::uint32_t rim = first_rim(f);
  Values values(*this);
  for (std::uint32_t i = 0; i < 3; ++i) values.add_vertex(tail(rim + i));
  values.add(t);
  return values.decide([&]<class N>(const CallReader<N>& reader) {
    const Rows<N> rows(*this, reader);
    return detail::dot<typename N::Cubic>(rows.normal(f), rows.to(t, tail(rim))).sign();
  });
}

Sign TranslationBody::seen(std::uint32_t rim, const Point3& t) const {
  const std::uint32_t a = tail(rim);
  const std::uint32_t b = head(rim);
  Values values(*this);
  for (const std::uint32_t v : anchors_) values.add_vertex(v);
  values.add_vertex(a);
  values.add_vertex(b);
  values.add(t);
  return values.decide([&]<class N>(const CallReader<N>& reader) {
    const Rows<N> rows(*this, reader);
    return determinant<N>(rows.from_centre([&](std::uint32_t v) { return rows.to(t, v); }),
                          rows.from_centre([&](std::uint32_t v) { return rows.between(v, a); }),
                          rows.from_centre([&](std::uint32_t v) { return rows.between(v, b); }));
  });
}

Sign TranslationBody::seen_along(std::uint32_t rim, const Point3& t, const Vector3& direction) const {
  Values values(*this);
  values.add_vertex(tail(rim));
  values.add_vertex(head(rim));
  values.add(t);
  values.add({direction.x, direction.y, direction.z});
  return values.decide([&]<class N>(const CallReader<N>& reader) {
    const Rows<N> rows(*this, reader);
    const Row<N> d{reader(direction.x, 0), reader(direction.y, 0), reader(direction.z, 0)};
    return determinant<N>(d, rows.to(t, tail(rim)), rows.to(t, head(rim)));  // both turned round
  });
}

Sign TranslationBody::along(std::uint32_t rim, const Point3& t) const {
  Values values(*this);
  values.add_vertex(tail(rim));
  values.add_vertex(head(rim));
  values.add(t);
  return values.decide([&]<class N>(const CallReader<N>& reader) {
    const Rows<N> rows(*this, reader);
    return detail::dot<typename N::Quadratic>(rows.to(t, tail(rim)), rows.between(tail(rim), head(rim))).sign();
  });
}

Sign TranslationBody::across(std::uint32_t rim, const Point3& t) const {
  const std::uint32_t f = facets_[rim];
  Values values(*this);
  for (std::uint32_t i = 0; i < 3; ++i) values.add_vertex(tail(first_rim(f) + i));
  values.add_vertex(tail(rim));
  values.add_vertex(head(rim));
  values.add(t);
  return values.decide([&]<class N>(const CallReader<N>& reader) {
    const Rows<N> rows(*this, reader);
    const auto inward = detail::cross<typename N::Cubic>(rows.normal(f), rows.between(tail(rim), head(rim)));
    return detail::dot<typename N::Quartic>(inward, rows.to(t, tail(rim))).sign();
  });
}

}  // namespace quoin
