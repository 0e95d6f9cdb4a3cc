// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <utility>

#include "quoin/base/error.h"
#include "quoin/solid/query/shell_components.h"

namespace quoin {

namespace {

/// Copies faces of a boundary one by one into a new one.
class BoundaryPart {
 public:
  explicit BoundaryPart(const Brep& whole)
      : whole_(whole), place_(whole.points.point_count(), none), shell_place_(whole.shells.size(), none) {
    part_.leaf_names = whole.leaf_names;
    part_.component_count = 1;
  }

  void add(std::uint32_t face) {
    std::array<PointId, 3> plane = whole_.face_planes[face];
    for (PointId& p : plane) p = point(p);
    part_.face_planes.push_back(plane);
    for (std::uint32_t l = whole_.face_first_loop[face]; l < whole_.face_first_loop[face + 1]; ++l) {
      for (const PointId p : whole_.loop(l)) part_.loop_vertices.push_back(point(p));
      part_.loop_begin.push_back(static_cast<std::uint32_t>(part_.loop_vertices.size()));
    }
    part_.face_first_loop.push_back(static_cast<std::uint32_t>(part_.loop_count()));
    for (std::uint32_t o = whole_.face_first_origin[face]; o < whole_.face_first_origin[face + 1]; ++o) {
      part_.origins.push_back(whole_.origins[o]);
    }
    part_.face_first_origin.push_back(static_cast<std::uint32_t>(part_.origins.size()));
    part_.face_shells.push_back(shell(whole_.face_shells[face]));
    if (!whole_.face_colors.empty()) part_.face_colors.push_back(whole_.face_colors[face]);
  }

  Brep take() {
    part_.points = Constructions(std::move(points_));
    return std::move(part_);
  }

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFFU;

  PointId point(PointId p) {
    if (place_[p.index()] == none) {
      place_[p.index()] = static_cast<std::uint32_t>(points_.size());
      points_.push_back(whole_.points.exact(p));
    }
    return PointId(std::size_t{place_[p.index()]});
  }

  std::uint32_t shell(std::uint32_t number) {
    if (shell_place_[number] == none) {
      shell_place_[number] = static_cast<std::uint32_t>(part_.shells.size());
      part_.shells.push_back(whole_.shells[number]);
    }
    return shell_place_[number];
  }

  const Brep& whole_;
  Brep part_;
  std::vector<RationalPoint3> points_;
  std::vector<std::uint32_t> place_;
  std::vector<std::uint32_t> shell_place_;
};

}  // namespace

std::vector<Brep> component_boundaries(const Brep& boundary, const Context& context) {
  if (boundary.is_unbounded) throw InputError("the solid is unbounded");
  const std::vector<std::uint32_t> component = components_of_shells(boundary, context);
  std::vector<std::vector<std::uint32_t>> faces(boundary.component_count);
  for (std::uint32_t f = 0; f < boundary.face_count(); ++f) faces[component[boundary.face_shells[f]]].push_back(f);
  std::vector<Brep> parts;
  for (const auto& of_part : faces) {
    context.poll();
    BoundaryPart part(boundary);
    for (const std::uint32_t f : of_part) part.add(f);
    parts.push_back(part.take());
  }
  return parts;
}

}  // namespace quoin
