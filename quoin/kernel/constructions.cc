// SPDX-License-Identifier: Apache-2.0
#include "quoin/kernel/constructions.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "quoin/base/error.h"
#include "quoin/kernel/constructed_filters.h"
#include "quoin/kernel/constructions_exact.h"
#include "quoin/kernel/constructions_grid.h"
#include "quoin/number/two_doubles.h"

namespace quoin {

using detail::ExactTable;
using detail::ExplicitPoints;

struct Constructions::Store {
  std::variant<ExactTable<detail::Numbers30>, ExactTable<detail::Numbers61>, ExactTable<detail::Numbers124>,
               ExactTable<detail::NumbersBig>, ExactTable<detail::NumbersRational>>
      table;

  template <class Visitor>
  auto visit(Visitor&& visitor) const {
    return std::visit(std::forward<Visitor>(visitor), table);
  }
  template <class Visitor>
  auto visit(Visitor&& visitor) {
    return std::visit(std::forward<Visitor>(visitor), table);
  }
};

namespace {

constexpr int plain_exponent = 330;

template <class Numbers>
ExactTable<Numbers> table_of_doubles(const std::vector<Point3>& points, std::vector<Point3> tails, int lo) {
  return ExactTable<Numbers>(ExplicitPoints<Numbers>(points.data(), std::move(tails), lo), points.size());
}

struct RoundedPoints {
  std::vector<Point3> points;
  std::vector<Point3> tails;  // what rounding cut off; empty if nothing
  bool has_tails = true;      // else doubles do not hold that
};
RoundedPoints rounded_points(const std::vector<RationalPoint3>& exact, const Context* context) {
  RoundedPoints result;
  result.points.resize(exact.size());
  result.tails.resize(exact.size());
  bool is_cut = false;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    if (context != nullptr && i % 256 == 0) context->poll();
    for (unsigned axis = 0; axis < 3; ++axis) {
      const Rational& x = exact[i][axis];
      const auto parts = result.has_tails ? as_two_doubles(x) : std::nullopt;
      result.has_tails = parts.has_value();
      result.points[i][axis] = parts ? parts->value + 0.0 : x.to_double() + 0.0;
      result.tails[i][axis] = parts ? parts->tail : 0;
      is_cut = is_cut || result.tails[i][axis] != 0;
    }
  }
  if (!is_cut || !result.has_tails) result.tails.clear();
  return result;
}

constexpr unsigned next_axis(unsigned axis) {
  return (axis + 1) % 3;
}
constexpr unsigned previous_axis(unsigned axis) {
  return (axis + 2) % 3;
}

/// The least power of two above x, or infinity.
double power_of_two_above(double x) {
  return x == 0 ? 0 : std::ldexp(1.0, std::ilogb(x) + 1);
}

}  // namespace

Constructions::Constructions() : counter_(std::make_unique<detail::TierCounter>()) {}
Constructions::Constructions(Constructions&&) noexcept = default;
Constructions& Constructions::operator=(Constructions&&) noexcept = default;
Constructions::~Constructions() = default;

// The side filter holds for extents from 2^-1000 (smaller ones let it underflow); it sees by itself that one is too
// large.
void Constructions::set_extent(double largest) {
  const double extent = std::isfinite(largest) ? power_of_two_above(largest) : HUGE_VAL;
  extent_ = extent >= 0x1p-1000 ? extent : HUGE_VAL;
}

Constructions::Constructions(std::vector<Point3> explicit_points) : Constructions() {
  set_doubles(std::move(explicit_points), {});
}

Constructions::Constructions(std::vector<RationalPoint3> explicit_points, const Context* context) : Constructions() {
  RoundedPoints rounded = rounded_points(explicit_points, context);
  if (rounded.has_tails) {
    set_doubles(std::move(rounded.points), std::move(rounded.tails));
    return;
  }
  double largest = 0;
  for (const Point3& p : rounded.points) largest = std::max(largest, filter::max_abs(p));
  filter_kind_ = FilterKind::rounded;
  grid_class_ = GridClass::rational;
  explicit_count_ = explicit_points.size();
  points_ = std::move(rounded.points);
  set_extent(largest);
  ExplicitPoints<detail::NumbersRational> points(std::move(explicit_points));
  store_ = std::make_unique<Store>(Store{ExactTable<detail::NumbersRational>(std::move(points), explicit_count_)});
}

void Constructions::set_doubles(std::vector<Point3> points, std::vector<Point3> tails) {
  const detail::Grid grid = detail::grid_of(points, tails);
  points_ = std::move(points);
  explicit_count_ = points_.size();
  const bool plain = grid.lo >= -plain_exponent && grid.hi <= plain_exponent;
  filter_kind_ = !tails.empty() ? FilterKind::rounded : plain ? FilterKind::plain : FilterKind::any_range;
  set_extent(grid.largest);
  grid_class_ = grid.grid_class;
  switch (grid.grid_class) {
    case GridClass::bits30:
      store_ = std::make_unique<Store>(Store{table_of_doubles<detail::Numbers30>(points_, std::move(tails), grid.lo)});
      break;
    case GridClass::bits61:
      store_ = std::make_unique<Store>(Store{table_of_doubles<detail::Numbers61>(points_, std::move(tails), grid.lo)});
      break;
    case GridClass::bits124:
      store_ = std::make_unique<Store>(Store{table_of_doubles<detail::Numbers124>(points_, std::move(tails), grid.lo)});
      break;
    default:
      store_ = std::make_unique<Store>(Store{table_of_doubles<detail::NumbersBig>(points_, std::move(tails), grid.lo)});
      break;
  }
}

void Constructions::resize_points(std::size_t count) {
  points_.reserve(std::max(count, explicit_count_));  // exactly, where growing would double
  points_.resize(std::max(count, explicit_count_));
  store_->visit([&](auto& table) { table.resize_points(points_.size() - explicit_count_, points_.data()); });
}

void Constructions::resize_planes(std::size_t count) {
  planes_.resize(count);
  store_->visit([&](auto& table) { table.resize_planes(count); });
}

void Constructions::resize_lines(std::size_t count) {
  lines_.resize(count);
  store_->visit([&](auto& table) { table.resize_lines(count); });
}

void Constructions::set_plane(PlaneId plane, PointId a, PointId b, PointId c) {
  planes_[plane.index()] = store_->visit([&](auto& table) { return table.set_plane(plane, a, b, c); });
}

void Constructions::set_axis_plane(PlaneId plane, PointId p, PointId q, unsigned axis) {
  planes_[plane.index()] = store_->visit([&](auto& table) { return table.set_axis_plane(plane, p, q, axis); });
}

void Constructions::set_line(LineId line, PointId p, PointId q) {
  lines_[line.index()] = store_->visit([&](auto& table) { return table.set_line(line, p, q); });
}

void Constructions::set_line(LineId line, PlaneId p, PlaneId q) {
  lines_[line.index()] = store_->visit([&](auto& table) { return table.set_line(line, p, q); });
}

void Constructions::set_point(PointId point, PointId p, PointId q, PlaneId plane) {
  points_[point.index()] = store_->visit([&](auto& table) { return table.set_point(point, p, q, plane); });
}

void Constructions::set_crossing(PointId point, PointId p, PointId q, PointId r, PointId s, unsigned axis) {
  points_[point.index()] = store_->visit([&](auto& table) { return table.set_crossing(point, p, q, r, s, axis); });
}

void Constructions::set_point(PointId point, PlaneId p, PlaneId q, PlaneId r) {
  points_[point.index()] = store_->visit([&](auto& table) { return table.set_point(point, p, q, r); });
}

void Constructions::set_point(PointId point, std::array<PointId, 3> corners, std::array<std::uint32_t, 3> weights) {
  points_[point.index()] = store_->visit([&](auto& table) { return table.set_point(point, corners, weights); });
}

RationalPoint3 Constructions::exact(PointId point) const {
  return store_->visit([&](const auto& table) { return table.exact(point); });
}

std::array<Integer, 4> Constructions::homogeneous(PointId point) const {
  return store_->visit([&](const auto& table) { return table.homogeneous(point); });
}

std::array<Integer, 3> Constructions::direction(LineId line) const {
  return store_->visit([&](const auto& table) { return table.direction(line); });
}

bool Constructions::is_exact(PointId point) const {
  if (has_exact_doubles(point)) return true;
  return store_->visit([&](const auto& table) { return table.is_exact(point, rounded(point)); });
}

Sign Constructions::orientation_beyond_plain(PointId a, PointId b, PointId c, PointId d) const {
  const auto filtered =
      filter_kind_ == FilterKind::any_range ? filter::orientation_any_range : filter::orientation_rounded;
  const int sign = filtered(rounded(a), rounded(b), rounded(c), rounded(d));
  return is_decided(sign) ? static_cast<Sign>(sign) : exact_orientation(a, b, c, d);
}

Sign Constructions::turn(PointId a, PointId b, PointId c, unsigned axis) const {
  const auto filtered = filter_kind_ == FilterKind::rounded ? filter::turn_rounded : filter::turn;
  const int sign = filtered(rounded(a), rounded(b), rounded(c), next_axis(axis), previous_axis(axis));
  return is_decided(sign) ? static_cast<Sign>(sign) : exact_turn(a, b, c, axis);
}

Sign Constructions::turn_any(PointId a, PointId b, PointId c, unsigned axis) const {
  if (!is_explicit(a) || !is_explicit(b)) return turn_beyond_explicit(a, b, c, axis);
  const auto filtered = filter_kind_ == FilterKind::rounded ? filter::turn_rounded : filter::turn_rounded_last;
  const int sign = filtered(rounded(a), rounded(b), rounded(c), next_axis(axis), previous_axis(axis));
  return is_decided(sign) ? static_cast<Sign>(sign) : exact_turn_any(a, b, c, axis);
}

bool Constructions::equal(PointId p, PointId q) const {
  if (p == q) return true;
  const bool equal_doubles = rounded(p) == rounded(q);
  if (!equal_doubles || (has_exact_doubles(p) && has_exact_doubles(q))) {
    counter_->count_filter();
    return equal_doubles;
  }
  counter_->count_exact();
  return store_->visit([&](const auto& table) {
    return table.compare(p, q, 0) == Sign::zero && table.compare(p, q, 1) == Sign::zero &&
           table.compare(p, q, 2) == Sign::zero;
  });
}

Sign Constructions::normal_component(PlaneId plane, unsigned axis) const {
  const int sign = filter::certain_sign(planes_[plane.index()].normal(axis), 0);
  return is_decided(sign) ? static_cast<Sign>(sign) : exact_normal_component(plane, axis);
}

unsigned Constructions::main_axis(PlaneId plane) const {
  const filter::Plane& p = planes_[plane.index()];
  const double x = std::fabs(p.nx);
  const double y = std::fabs(p.ny);
  const double z = std::fabs(p.nz);
  return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
}

Sign Constructions::dot(PlaneId p, PlaneId q) const {
  const int sign = filter::dot(planes_[p.index()], planes_[q.index()]);
  return is_decided(sign) ? static_cast<Sign>(sign) : exact_dot(p, q);
}

Sign Constructions::component(LineId line, unsigned axis) const {
  const int sign = filter::certain_sign(lines_[line.index()][axis], 0);
  return is_decided(sign) ? static_cast<Sign>(sign) : exact_component(line, axis);
}

Sign Constructions::triple(LineId line, PlaneId p, PlaneId q) const {
  const int sign = filter::triple(lines_[line.index()], planes_[p.index()], planes_[q.index()]);
  return is_decided(sign) ? static_cast<Sign>(sign) : exact_triple(line, p, q);
}

Sign Constructions::exact_orientation(PointId a, PointId b, PointId c, PointId d) const {
  counter_->count_exact();
  return store_->visit([&](const auto& table) { return table.orientation(a, b, c, d); });
}

Sign Constructions::exact_turn(PointId a, PointId b, PointId c, unsigned axis) const {
  counter_->count_exact();
  return store_->visit([&](const auto& table) { return table.turn(a, b, c, axis); });
}

Sign Constructions::exact_side(PointId point, PlaneId plane) const {
  counter_->count_exact();
  return store_->visit([&](const auto& table) { return table.side(point, plane); });
}

Sign Constructions::exact_compare(PointId p, PointId q, unsigned axis) const {
  counter_->count_exact();
  return store_->visit([&](const auto& table) { return table.compare(p, q, axis); });
}

Sign Constructions::exact_turn_any(PointId a, PointId b, PointId c, unsigned axis) const {
  counter_->count_exact();
  return store_->visit([&](const auto& table) { return table.turn_any(a, b, c, axis); });
}

Sign Constructions::exact_normal_component(PlaneId plane, unsigned axis) const {
  counter_->count_exact();
  return store_->visit([&](const auto& table) { return table.normal_component(plane, axis); });
}

Sign Constructions::exact_dot(PlaneId p, PlaneId q) const {
  counter_->count_exact();
  return store_->visit([&](const auto& table) { return table.dot(p, q); });
}

Sign Constructions::exact_component(LineId line, unsigned axis) const {
  counter_->count_exact();
  return store_->visit([&](const auto& table) { return table.component(line, axis); });
}

Sign Constructions::exact_turn(LineId a, LineId b, unsigned axis) const {
  counter_->count_exact();
  return store_->visit([&](const auto& table) { return table.turn(a, b, axis); });
}

Sign Constructions::exact_triple(LineId line, PlaneId p, PlaneId q) const {
  counter_->count_exact();
  return store_->visit([&](const auto& table) { return table.triple(line, p, q); });
}

std::array<Rational, 4> Constructions::plane_equation(PlaneId plane) const {
  return store_->visit([&](const auto& table) { return table.plane_equation(plane); });
}

Constructions Constructions::subset(std::span<const PointId> points) const {
  Constructions result;
  result.points_.reserve(points.size());
  for (const PointId p : points) {
    if (is_explicit(p)) {
      if (result.explicit_count_ != result.points_.size()) {
        throw InternalError("explicit point " + std::to_string(p.value) + " follows a constructed one in a subset");
      }
      ++result.explicit_count_;
    }
    result.points_.push_back(rounded(p));
  }
  result.extent_ = extent_;
  result.filter_kind_ = filter_kind_;
  result.grid_class_ = grid_class_;
  result.store_ = store_->visit([&](const auto& table) {
    return std::make_unique<Store>(Store{table.subset(points, result.explicit_count_, result.points_.data())});
  });
  return result;
}

TierCounts Constructions::tier_counts() const {
  return {counter_->filter(), counter_->exact()};
}

}  // namespace quoin
