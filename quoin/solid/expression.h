// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace quoin {

/// A Boolean expression over numbered leaves, as a tree in one array (children before parents, root last).
///
/// Value type. The empty expression (no nodes) denotes the empty set.
class Expression {
 public:
  enum class Kind : std::uint8_t {
    leaf,       ///< the set of leaf `leaf`
    any,        ///< union: true when any child is
    every,      ///< intersection: true when every child is
    odd,        ///< symmetric difference: true when an odd number of children are
    complement  ///< of its only child
  };
  struct Node {
    Kind kind = Kind::leaf;
    std::uint32_t leaf = 0;         ///< of Kind::leaf
    std::uint32_t first_child = 0;  ///< into children()
    std::uint32_t child_count = 0;
  };

  Expression() = default;
  static Expression leaf(std::uint32_t index);
  static Expression unite(std::span<const Expression> operands);
  static Expression intersect(std::span<const Expression> operands);
  static Expression exclusive(std::span<const Expression> operands);
  static Expression complement(const Expression& operand);
  static Expression subtract(const Expression& from, std::span<const Expression> tools);

  std::span<const Node> nodes() const { return nodes_; }
  std::span<const std::uint32_t> children() const { return children_; }
  bool is_empty() const { return nodes_.empty(); }
  /// One more than the largest leaf index named; 0 when none.
  std::uint32_t leaf_count() const;

  /// The same with leaf i replaced by replacement[i] (a whole expression).
  Expression substitute(std::span<const Expression> replacement) const;

 private:
  friend class ExpressionBuilder;
  static Expression combine(Kind kind, std::span<const Expression> operands);
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> children_;
};

/// Makes an expression from the leaves up, in time linear in its size.
class ExpressionBuilder {
 public:
  /// A node that names leaf `index`; its number.
  std::uint32_t leaf(std::uint32_t index);
  /// A node over others, none of them a child already; its number. One child for Kind::complement.
  std::uint32_t combine(Expression::Kind kind, std::span<const std::uint32_t> children);
  /// The expression whose root is the node made last.
  Expression take() { return std::move(result_); }

 private:
  Expression result_;
};

}  // namespace quoin
