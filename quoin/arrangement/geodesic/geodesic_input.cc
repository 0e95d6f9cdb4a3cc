// SPDX-License-Identifier: Apache-2.0
// Input arcs, cut at the identification and at the poles into pieces of branches.
#include <string>
#include <utility>

#include "quoin/arrangement/geodesic/geodesic_family.h"
#include "quoin/base/error.h"

namespace quoin {
namespace {

const SphereDirection& axis_direction(std::size_t axis) {
  static const std::array<SphereDirection, 3> axes{
      std::array<std::int64_t, 3>{1, 0, 0}, std::array<std::int64_t, 3>{0, 1, 0}, std::array<std::int64_t, 3>{0, 0, 1}};
  return axes[axis];
}

[[noreturn]] void refuse(const PieceList<GeodesicFamily>& list, const std::string& why) {
  throw InputError("curve " + std::to_string(list.curve_count) + ": " + why);
}

void require_direction(const PieceList<GeodesicFamily>& list, const SphereDirection& v, const std::string& what) {
  if (!v.is_finite()) refuse(list, what + " is not finite");
  if (!v.is_valid()) refuse(list, what + " is the zero vector");
}

/// The normal of the support is n or -n: the one with n.z > 0, or n.z = 0 and the first nonzero component positive.
bool is_canonical(const SphereDirection& n) {
  for (const std::size_t axis : {2U, 0U, 1U}) {
    if (n.sign(axis) != Sign::zero) return n.sign(axis) == Sign::positive;
  }
  return true;
}

}  // namespace

/// An input curve while it is cut: counterclockwise about the canonical normal, from the source, or from the target if
/// `backward`.
struct GeodesicFamily::Tour {
  Tour(PieceList<GeodesicFamily>& target, const SphereDirection& given)
      : list(target), normal(is_canonical(given) ? given : -given), backward(!is_canonical(given)) {}

  void add(BranchId branch, const Point& left, const Point& right, bool reversed) const {
    const std::uint32_t first = list.add_point(left);
    const std::uint32_t second = list.add_point(right);
    list.pieces.push_back({branch, first, second, curve, reversed});
  }

  PieceList<GeodesicFamily>& list;
  SphereDirection normal;
  bool backward = false;
  std::uint32_t support = 0;
  CurveId curve = CurveId(list.curve_count++);
};

CurveId GeodesicFamily::add_arc(PieceList<GeodesicFamily>& list, const SphereDirection& source,
                                const SphereDirection& target) {
  require_direction(list, source, "the source");
  require_direction(list, target, "the target");
  const SphereDirection normal = cross(source, target);
  if (!normal.is_valid()) {
    refuse(list, "source and target are equal or antipodal, which leaves the plane of the arc open; give its normal");
  }
  return add_checked_arc(list, source, target, normal);
}

CurveId GeodesicFamily::add_arc(PieceList<GeodesicFamily>& list, const SphereDirection& source,
                                const SphereDirection& target, const SphereDirection& normal) {
  require_direction(list, source, "the source");
  require_direction(list, target, "the target");
  require_direction(list, normal, "the normal");
  if (dot_sign(normal, source) != Sign::zero) refuse(list, "the source is not on the plane of the arc");
  if (dot_sign(normal, target) != Sign::zero) refuse(list, "the target is not on the plane of the arc");
  return add_checked_arc(list, source, target, normal);
}

CurveId GeodesicFamily::add_checked_arc(PieceList<GeodesicFamily>& list, const SphereDirection& source,
                                        const SphereDirection& target, const SphereDirection& normal) {
  Tour tour(list, normal);
  tour.support = add_support(tour.normal);
  const Point from = direction_point(tour.backward ? target : source);
  const Point to = direction_point(tour.backward ? source : target);
  if (supports_[tour.support].is_vertical) {
    add_vertical(tour, from, to);
  } else {
    add_flat(tour, from, to);
  }
  return tour.curve;
}

CurveId GeodesicFamily::add_great_circle(PieceList<GeodesicFamily>& list, const SphereDirection& normal) {
  require_direction(list, normal, "the normal");
  Tour tour(list, normal);
  tour.support = add_support(tour.normal);
  if (supports_[tour.support].is_vertical) {
    add_meridian_piece(tour, false, nullptr, nullptr);
    add_meridian_piece(tour, true, nullptr, nullptr);
  } else {
    const Point cut = direction_point(cross(tour.normal, axis_direction(1)));
    tour.add(branch(tour.support, false), cut, on_side(cut, Side::right), tour.backward);
  }
  return tour.curve;
}

GeodesicFamily::Point GeodesicFamily::make_point(const SphereDirection& direction) {
  if (!direction.is_valid()) throw InputError("the direction of the point is zero or not finite");
  const Point p = direction_point(direction);
  if (!is_at_pole(p.approximate)) return p;
  return pole_end(-axis_direction(0), p.approximate.z < 0 ? Side::bottom : Side::top);
}

CurveId GeodesicFamily::add_point(PieceList<GeodesicFamily>& list, const SphereDirection& direction) {
  require_direction(list, direction, "the point");
  const CurveId curve(list.curve_count++);
  list.lone_points.push_back({list.add_point(make_point(direction)), curve});
  return curve;
}

std::uint32_t GeodesicFamily::add_circle(const SphereDirection& normal) {
  if (!normal.is_valid()) throw InputError("the normal is zero or not finite");
  return add_support(is_canonical(normal) ? normal : -normal);
}

GeodesicFamily::Point GeodesicFamily::make_crossing(std::uint32_t a, std::uint32_t b, int sign) const {
  if (a == b) throw InputError("a circle does not cross itself");
  if (supports_[a].is_vertical && supports_[b].is_vertical) throw InputError("both circles pass through the poles");
  const Point p = crossing(a, b);
  return sign < 0 ? antipode(p) : p;
}

GeodesicFamily::Point GeodesicFamily::make_pole_end(BranchId vertical, Side side) {
  const std::array<Integer, 3> n = normal(vertical);
  return pole_end(std::array<Integer, 3>{-n[1], n[0], Integer()}, side);
}

/// Increasing longitude from left to right; the identification is crossed at most once.
void GeodesicFamily::add_flat(const Tour& tour, const Point& from, const Point& to) {
  const BranchId b = branch(tour.support, false);
  const Point end = on_side(to, Side::right);
  if (compare_xy(from, end) == Sign::negative) {
    tour.add(b, from, end, tour.backward);
    return;
  }
  const Point cut = direction_point(cross(tour.normal, axis_direction(1)));
  tour.add(b, from, on_side(cut, Side::right), tour.backward);
  tour.add(b, cut, end, tour.backward);
}

/// About the canonical normal the second half runs upward and the first downward: whole halves until one holds the end.
void GeodesicFamily::add_vertical(const Tour& tour, const Point& from, const Point& to) {
  const auto is_on_second_half = [&](const Point& p) {
    // The horizontal direction of the second half is e_z x n.
    const Vector3& n = supports_[tour.support].normal;
    return n.y != 0 ? (p.approximate.x < 0) == (n.y > 0) : (p.approximate.y > 0) == (n.x > 0);
  };
  const auto is_pole = [](const Point& p) { return is_at_pole(p.approximate); };
  const Point* start = is_pole(from) ? nullptr : &from;
  bool upward = is_pole(from) ? from.approximate.z < 0 : is_on_second_half(from);
  while (true) {
    const Point* end = nullptr;
    bool is_last = is_pole(to) && (to.approximate.z > 0) == upward;
    if (!is_pole(to) && is_on_second_half(to) == upward) {
      const Sign order = start == nullptr ? Sign::negative : compare_latitude(*start, to);
      is_last = start == nullptr || order == (upward ? Sign::negative : Sign::positive);
      if (is_last) end = &to;
    }
    add_meridian_piece(tour, upward, upward ? start : end, upward ? end : start);
    if (is_last) return;
    start = nullptr;
    upward = !upward;
  }
}

/// Between two points of a half, or its poles where none are given.
void GeodesicFamily::add_meridian_piece(const Tour& tour, bool second_half, const Point* low, const Point* high) {
  const SphereDirection horizontal =
      second_half ? cross(axis_direction(2), tour.normal) : cross(tour.normal, axis_direction(2));
  const Point left = low != nullptr ? *low : pole_end(horizontal, Side::bottom);
  const Point right = high != nullptr ? *high : pole_end(horizontal, Side::top);
  tour.add(branch(tour.support, second_half), left, right, second_half == tour.backward);
}

}  // namespace quoin
