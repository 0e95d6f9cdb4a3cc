// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/half_space.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "quoin/polytope/convex_boundary.h"

namespace quoin {

namespace {

/// Corner i of a box has the upper coordinate along axis k where bit k of i is set. Faces counterclockwise seen from
/// outside.
constexpr std::array<std::array<unsigned, 4>, 6> box_faces{
    {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};

class BoxCutter {
 public:
  BoxCutter(const ExactBox& box, const SectionPlane& plane) {
    for (unsigned i = 0; i < 8; ++i) {
      points_.push_back({(i & 1U) != 0 ? box.hi.x : box.lo.x, (i & 2U) != 0 ? box.hi.y : box.lo.y,
                         (i & 4U) != 0 ? box.hi.z : box.lo.z});
      heights_.push_back(dot(plane.normal, points_.back()) - plane.offset);
    }
  }

  /// All corners on one side or on the plane.
  bool is_all(Sign side) const {
    return std::ranges::all_of(heights_, [&](const Rational& h) { return h.sign() != -side; });
  }

  Solid run(const Context& context) {
    for (const auto& face : box_faces) clip(face);
    if (!is_all(Sign::negative)) close();
    keep_used_points();
    return Solid::from_boundary(convex_boundary(points_, corners_, begin_, "half-space"), "half-space", context);
  }

 private:
  void clip(std::span<const unsigned, 4> face) {
    std::vector<std::uint32_t> kept;
    for (std::size_t i = 0; i < 4; ++i) {
      const unsigned a = face[i];
      const unsigned b = face[(i + 1) % 4];
      if (heights_[a].sign() != Sign::positive) kept.push_back(a);
      if (heights_[a].sign() * heights_[b].sign() == Sign::negative) kept.push_back(crossing(a, b));
    }
    if (kept.size() < 3) return;
    add_face(kept);
    // The edge that lies in the plane; the new face runs along it the other way.
    for (std::size_t i = 0; i < kept.size(); ++i) {
      const std::uint32_t from = kept[i];
      const std::uint32_t to = kept[(i + 1) % kept.size()];
      if (is_on_plane(from) && is_on_plane(to)) next_[to] = from;
    }
  }

  bool is_on_plane(std::uint32_t p) const { return p >= 8 || heights_[p].sign() == Sign::zero; }

  std::uint32_t crossing(unsigned a, unsigned b) {
    const auto key = std::minmax(a, b);
    const auto known = crossings_.find(key);
    if (known != crossings_.end()) return known->second;
    const Rational part = heights_[a] / (heights_[a] - heights_[b]);
    points_.push_back(points_[a] + (points_[b] - points_[a]) * part);
    const auto number = static_cast<std::uint32_t>(points_.size() - 1);
    crossings_[key] = number;
    return number;
  }

  void close() {
    std::vector<std::uint32_t> face{next_.begin()->first};
    while (next_.at(face.back()) != face.front()) face.push_back(next_.at(face.back()));
    add_face(face);
  }

  void add_face(std::span<const std::uint32_t> face) {
    corners_.insert(corners_.end(), face.begin(), face.end());
    begin_.push_back(corners_.size());
  }

  void keep_used_points() {
    std::vector<std::uint32_t> place(points_.size(), 0);
    std::vector<bool> is_used(points_.size(), false);
    for (const std::uint32_t c : corners_) is_used[c] = true;
    std::vector<RationalPoint3> used;
    for (std::size_t p = 0; p < points_.size(); ++p) {
      place[p] = static_cast<std::uint32_t>(used.size());
      if (is_used[p]) used.push_back(points_[p]);
    }
    for (std::uint32_t& c : corners_) c = place[c];
    points_ = std::move(used);
  }

  std::vector<RationalPoint3> points_;
  std::vector<Rational> heights_;  // of the box's corners above the plane
  std::map<std::pair<unsigned, unsigned>, std::uint32_t> crossings_;
  std::map<std::uint32_t, std::uint32_t> next_;  // along the new face
  std::vector<std::uint32_t> corners_;
  std::vector<std::size_t> begin_{0};
};

}  // namespace

Solid half_space_in_box(const ExactBox& box, const SectionPlane& plane, const Context& context) {
  BoxCutter cutter(box, plane);
  if (cutter.is_all(Sign::positive)) return {};
  return cutter.run(context);
}

Solid solid_box(const ExactBox& box, const Context& context) {
  return half_space_in_box(box, {{Rational(0), Rational(0), Rational(1)}, box.hi.z}, context);
}

}  // namespace quoin
