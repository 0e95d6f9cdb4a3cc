// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/query/shell_components.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <tuple>

#include "quoin/base/error.h"
#include "quoin/solid/query/face_place.h"
#include "quoin/solid/query/point_location.h"

namespace quoin {

namespace {

constexpr unsigned line_axis = 2;

// Where an upward line goes through a face. Of faces met in one point those come first that are lower next to it, where
// the line is moved by (e, e^2) with an infinitesimal e.
struct Crossing {
  Rational height;
  Rational slope_x;
  Rational slope_y;
  std::uint32_t shell;

  bool operator<(const Crossing& other) const {
    return std::tie(height, slope_x, slope_y) < std::tie(other.height, other.slope_x, other.slope_y);
  }
};

// Shells joined where a line runs through material from one to the next.
class ShellGrouping {
 public:
  ShellGrouping(const Brep& boundary, const Context& context)
      : b_(boundary), locator_(boundary, context), context_(context), parent_(boundary.shells.size() + 1) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }

  // A cavity's line leaves it for the last time into its material. From there on the line is in that piece, in
  // cavities of it, or in what these hold, until it comes out of the piece: so it joins the cavity with the outer
  // shell.
  std::vector<std::uint32_t> run() {
    const std::vector<std::optional<std::uint32_t>> faces = face_of_each_void();
    for (const auto& face : faces) {
      context_.poll();
      if (face) join_along_line_through(*face);
    }
    return numbers();
  }

 private:
  // Not a face along the lines; every closed shell has another.
  std::vector<std::optional<std::uint32_t>> face_of_each_void() const {
    std::vector<std::optional<std::uint32_t>> faces(b_.shells.size());
    for (std::uint32_t f = 0; f < b_.face_count(); ++f) {
      auto& face = faces[b_.face_shells[f]];
      if (!face && b_.shells[b_.face_shells[f]].is_void && up(f) != Sign::zero) face = f;
    }
    return faces;
  }

  Sign up(std::uint32_t face) const {
    const auto& plane = b_.face_planes[face];
    return b_.points.turn(plane[0], plane[1], plane[2], line_axis);
  }

  void join_along_line_through(std::uint32_t face) {
    const std::vector<Crossing> crossings = crossings_of_line_through(face);
    if (crossings.size() % 2 != 0) throw InternalError("a line crosses a boundary an odd number of times");
    // Material lies between the first and the second, and so on; in unbounded solids before the first, and so on.
    if (!b_.is_unbounded) {
      for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) join(crossings[i].shell, crossings[i + 1].shell);
      return;
    }
    for (std::size_t i = 1; i + 2 < crossings.size(); i += 2) join(crossings[i].shell, crossings[i + 1].shell);
    for (const Crossing* end : {&crossings.front(), &crossings.back()}) join(end->shell, infinity());
  }

  std::vector<Crossing> crossings_of_line_through(std::uint32_t face) const {
    const PlacedPoint point(b_.points, interior_point(b_, face));
    const std::array<double, 2> at{point.rounded()[(line_axis + 1) % 3], point.rounded()[(line_axis + 2) % 3]};
    std::vector<std::uint32_t> near;
    locator_.tree().tiles_on_line(line_axis, at, at, near);
    std::vector<Crossing> crossings;
    for (const std::uint32_t f : near) {
      if (place_in_face(b_, f, point, line_axis).is_inside_when_moved) crossings.push_back(crossing(f, point.exact()));
    }
    std::sort(crossings.begin(), crossings.end());
    return crossings;
  }

  Crossing crossing(std::uint32_t face, const RationalPoint3& point) const {
    const auto& plane = b_.face_planes[face];
    const RationalPoint3 a = b_.points.exact(plane[0]);
    const RationalPoint3 normal = cross(b_.points.exact(plane[1]) - a, b_.points.exact(plane[2]) - a);
    const Rational slope_x = -normal.x / normal.z;
    const Rational slope_y = -normal.y / normal.z;
    return {a.z + slope_x * (point.x - a.x) + slope_y * (point.y - a.y), slope_x, slope_y, b_.face_shells[face]};
  }

  std::uint32_t infinity() const { return static_cast<std::uint32_t>(b_.shells.size()); }

  std::uint32_t root(std::uint32_t shell) {
    while (parent_[shell] != shell) shell = parent_[shell] = parent_[parent_[shell]];
    return shell;
  }

  void join(std::uint32_t s, std::uint32_t t) { parent_[root(s)] = root(t); }

  std::vector<std::uint32_t> numbers() {
    constexpr std::uint32_t none = 0xFFFFFFFFU;
    std::vector<std::uint32_t> number_of_root(parent_.size(), none);
    std::uint32_t next = 0;
    if (b_.is_unbounded) number_of_root[root(infinity())] = next++;
    std::vector<std::uint32_t> result;
    for (std::uint32_t s = 0; s < b_.shells.size(); ++s) {
      std::uint32_t& number = number_of_root[root(s)];
      if (number == none) number = next++;
      result.push_back(number);
    }
    return result;
  }

  const Brep& b_;
  SolidLocator locator_;
  const Context& context_;
  std::vector<std::uint32_t> parent_;  // the last entry stands for what lies at infinity
};

}  // namespace

std::vector<std::uint32_t> components_of_shells(const Brep& boundary, const Context& context) {
  if (boundary.component_count <= 1) return std::vector<std::uint32_t>(boundary.shells.size(), 0);
  if (std::none_of(boundary.shells.begin(), boundary.shells.end(), [](const Shell& shell) { return shell.is_void; })) {
    std::vector<std::uint32_t> result(boundary.shells.size());
    std::iota(result.begin(), result.end(), boundary.is_unbounded ? 1U : 0U);
    return result;
  }
  return ShellGrouping(boundary, context).run();
}

}  // namespace quoin
