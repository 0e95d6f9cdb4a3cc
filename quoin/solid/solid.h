// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/solid/brep.h"
#include "quoin/solid/expression.h"
#include "quoin/solid/leaf.h"

namespace quoin {

/// A regular set of space with a polyhedral boundary, exact: immutable, cheap to copy, safe to share between threads.
///
/// It knows the input meshes it was made from and the Boolean expression over them, so that a Boolean of solids is
/// again one arrangement of all input meshes: nothing is ever rounded between operations, and depth costs no precision.
class Solid {
 public:
  /// The empty set.
  Solid();

  /// The points of positive winding number with respect to the leaf's tiles.
  static Solid from_leaf(std::shared_ptr<const Leaf> leaf, const Context& context);

  /// The set that an exact boundary bounds, which keeps this boundary: of later operations it is the only input.
  /// O(n log n). @throws InputError  it bounds no solid
  static Solid from_boundary(Brep boundary, const std::string& name, const Context& context);

  /// An operand that is not evaluated by itself: its boundary is made with that of the expression it goes into, and
  /// asking for it before is an error.
  static Solid of_leaf(std::shared_ptr<const Leaf> leaf);
  /// The same of the complement.
  static Solid of_complement(std::shared_ptr<const Leaf> leaf);

  /// Evaluates the expression over `solids` (leaf i of the expression is solids[i]) as one arrangement.
  ///
  /// Regularized; coincident, touching, nested and identical operands are ordinary. O((n + k) log n) for n tiles and k
  /// intersections. Deterministic: the same bytes for any number of threads. @throws Cancelled, inputs untouched.
  static Solid evaluate(const Expression& expression, std::span<const Solid> solids, const Context& context);

  /// @throws Error  the solid is an operand that was not evaluated
  const Brep& boundary() const { return *shared_boundary(); }
  std::shared_ptr<const Brep> shared_boundary() const;
  bool is_empty() const { return boundary().face_count() == 0 && !boundary().is_unbounded; }
  std::span<const std::shared_ptr<const Leaf>> leaves() const { return leaves_; }

 private:
  std::vector<std::shared_ptr<const Leaf>> leaves_;
  Expression expression_;
  std::shared_ptr<const Brep> boundary_;
};

/// Regularized Booleans, each one call of Solid::evaluate.
Solid unite(std::span<const Solid> solids, const Context& context);
Solid intersect(std::span<const Solid> solids, const Context& context);
Solid subtract(const Solid& from, std::span<const Solid> tools, const Context& context);
Solid symmetric_difference(std::span<const Solid> solids, const Context& context);
Solid complement(const Solid& solid, const Context& context);

}  // namespace quoin
