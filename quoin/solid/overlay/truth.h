// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/solid/expression.h"
#include "quoin/solid/overlay/cells.h"

namespace quoin::overlay {

/// An expression that follows changes of single leaves: each costs the nodes whose truth changes, not the whole tree,
/// and no more than the whole tree where a leaf is used in a large part of it.
class ExpressionState {
 public:
  /// All leaves outside.
  explicit ExpressionState(const Expression& expression, std::size_t leaf_count);
  /// Adds to the winding number of a leaf; the leaf is true while it is positive.
  void wind(std::uint32_t leaf, int change);
  bool truth() const { return !true_.empty() && true_.back() != 0; }

 private:
  bool evaluate(std::uint32_t node) const;
  void evaluate_all();
  void set(std::uint32_t node, bool value);

  const Expression* expression_;
  std::vector<std::uint32_t> parent_;      // per node
  std::vector<std::uint32_t> true_count_;  // per node: of its children
  std::vector<std::uint8_t> true_;         // per node
  std::vector<int> winding_;               // per leaf
  std::vector<std::uint32_t> first_use_;   // per leaf, into uses_
  std::vector<std::uint32_t> uses_;        // nodes of the leaf
};

struct CellTruth {
  std::vector<std::uint8_t> inside;  ///< per cell
  bool is_unbounded = false;         ///< points far away are inside
};

/// Decides for each cell whether it belongs to the expression's set. One exact line per connected part of the complex,
/// then a walk across its walls. O(patches * depth of the expression) at worst.
CellTruth classify_cells(const Sheets& sheets, const CellComplex& complex, const Expression& expression,
                         const Context& context);

}  // namespace quoin::overlay
