// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/solid_meeting.h"

#include <algorithm>
#include <array>
#include <utility>

#include "quoin/solid/expression.h"
#include "quoin/solid/overlay/overlay.h"
#include "quoin/solid/placement.h"

namespace quoin {

namespace {

/// Those that are corners of tiles, as other points may only span planes; counted from `first`.
void append_corners(const Leaf& leaf, std::uint32_t first, std::vector<std::uint32_t>& out) {
  std::vector<bool> is_corner(leaf.vertices.size(), false);
  for (const Tile& tile : leaf.tiles) {
    for (const std::uint32_t v : tile) is_corner[v] = true;
  }
  for (std::uint32_t v = 0; v < is_corner.size(); ++v) {
    if (is_corner[v]) out.push_back(first + v);
  }
}

}  // namespace

SolidMeeting::SolidMeeting(const Brep& a, SharedLeaf leaf_of_a, const Brep& b, SharedLeaf leaf_of_b,
                           const Context& context)
    : leaf_of_a_(std::move(leaf_of_a)),
      leaf_of_b_(std::move(leaf_of_b)),
      locator_of_a_(a, context),
      locator_of_b_(b, context),
      context_(context) {
  append_corners(*leaf_of_b_, 0, order_);
  append_corners(*leaf_of_a_, static_cast<std::uint32_t>(leaf_of_b_->vertices.size()), order_);
}

bool SolidMeeting::is_inside(const SolidLocator& locator, const Leaf& leaf, std::uint32_t vertex,
                             const RationalPoint3& t) const {
  return locator.locate(t - leaf.exact(vertex)).place == Place::in;
}

bool SolidMeeting::has_vertex_inside(const RationalPoint3& t) {
  const auto of_b = static_cast<std::uint32_t>(leaf_of_b_->vertices.size());
  for (std::size_t i = 0; i < order_.size(); ++i) {
    context_.poll();
    const std::uint32_t v = order_[i];
    const bool is_found =
        v < of_b ? is_inside(locator_of_a_, *leaf_of_b_, v, t) : is_inside(locator_of_b_, *leaf_of_a_, v - of_b, t);
    if (!is_found) continue;
    const auto found = order_.begin() + static_cast<std::ptrdiff_t>(i);
    std::rotate(order_.begin(), found, found + 1);
    return true;
  }
  return false;
}

bool SolidMeeting::with_reflection_at(const RationalPoint3& t) {
  if (has_vertex_inside(t)) return true;
  const std::array leaves{Expression::leaf(0), Expression::leaf(1)};
  const std::array both{leaf_of_a_, reflected(*leaf_of_b_, t, context_)};
  return overlay_boundary(both, Expression::intersect(leaves), context_).face_count() != 0;
}

}  // namespace quoin
