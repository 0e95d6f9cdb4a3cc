// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/rational_point.h"
#include "quoin/solid/leaf.h"
#include "quoin/solid/query/point_location.h"

namespace quoin {

/// Whether a bounded solid has points inside in common with another one, placed anew for each question.
///
/// Exact. Vertices of one are looked for in the other first, those first that last told something; where none is, an
/// intersection decides. So questions about nearby places that are answered by yes cost little.
class SolidMeeting {
 public:
  using SharedLeaf = std::shared_ptr<const Leaf>;

  /// The boundaries must outlive it; the leaves are theirs.
  SolidMeeting(const Brep& a, SharedLeaf leaf_of_a, const Brep& b, SharedLeaf leaf_of_b, const Context& context);

  /// Of a with all t - q for q of b, where no such place makes the two touch without meeting.
  bool with_reflection_at(const RationalPoint3& t);

 private:
  bool has_vertex_inside(const RationalPoint3& t);
  bool is_inside(const SolidLocator& locator, const Leaf& leaf, std::uint32_t vertex, const RationalPoint3& t) const;

  SharedLeaf leaf_of_a_;
  SharedLeaf leaf_of_b_;
  SolidLocator locator_of_a_;
  SolidLocator locator_of_b_;
  const Context& context_;
  std::vector<std::uint32_t> order_;  // vertices of b by number, those of a after all of these
};

}  // namespace quoin
