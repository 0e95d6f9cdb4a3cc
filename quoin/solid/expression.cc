// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/expression.h"

#include <algorithm>

namespace quoin {

Expression Expression::leaf(std::uint32_t index) {
  Expression result;
  result.nodes_.push_back({Kind::leaf, index, 0, 0});
  return result;
}

Expression Expression::combine(Kind kind, std::span<const Expression> operands) {
  Expression result;
  std::vector<std::uint32_t> roots;
  for (const Expression& operand : operands) {
    if (operand.is_empty()) continue;  // appended below, where its place among the children is known
    const auto node_shift = static_cast<std::uint32_t>(result.nodes_.size());
    const auto child_shift = static_cast<std::uint32_t>(result.children_.size());
    for (Node node : operand.nodes_) {
      node.first_child += child_shift;
      result.nodes_.push_back(node);
    }
    for (const std::uint32_t child : operand.children_) result.children_.push_back(child + node_shift);
    roots.push_back(static_cast<std::uint32_t>(result.nodes_.size() - 1));
  }
  const bool some_empty =
      std::any_of(operands.begin(), operands.end(), [](const Expression& e) { return e.is_empty(); });
  if (some_empty) {  // the empty set is a union of nothing
    result.nodes_.push_back({Kind::any, 0, static_cast<std::uint32_t>(result.children_.size()), 0});
    roots.push_back(static_cast<std::uint32_t>(result.nodes_.size() - 1));
  }
  const auto first = static_cast<std::uint32_t>(result.children_.size());
  result.children_.insert(result.children_.end(), roots.begin(), roots.end());
  result.nodes_.push_back({kind, 0, first, static_cast<std::uint32_t>(roots.size())});
  return result;
}

Expression Expression::unite(std::span<const Expression> operands) {
  return combine(Kind::any, operands);
}
Expression Expression::intersect(std::span<const Expression> operands) {
  return combine(Kind::every, operands);
}
Expression Expression::exclusive(std::span<const Expression> operands) {
  return combine(Kind::odd, operands);
}
Expression Expression::complement(const Expression& operand) {
  return combine(Kind::complement, {&operand, 1});
}

Expression Expression::subtract(const Expression& from, std::span<const Expression> tools) {
  if (tools.empty()) return from;
  const Expression parts[] = {from, complement(unite(tools))};
  return intersect(parts);
}

std::uint32_t Expression::leaf_count() const {
  std::uint32_t count = 0;
  for (const Node& node : nodes_) {
    if (node.kind == Kind::leaf) count = std::max(count, node.leaf + 1);
  }
  return count;
}

Expression Expression::substitute(std::span<const Expression> replacement) const {
  Expression result;
  std::vector<std::uint32_t> root_of(nodes_.size());
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    Node node = nodes_[i];
    const auto child_shift = static_cast<std::uint32_t>(result.children_.size());
    if (node.kind == Kind::leaf) {
      const Expression& inner = replacement[node.leaf];
      const auto node_shift = static_cast<std::uint32_t>(result.nodes_.size());
      for (Node copy : inner.nodes_) {
        copy.first_child += child_shift;
        result.nodes_.push_back(copy);
      }
      for (const std::uint32_t child : inner.children_) result.children_.push_back(child + node_shift);
      if (inner.is_empty()) result.nodes_.push_back({Kind::any, 0, child_shift, 0});
    } else {
      for (std::uint32_t c = 0; c < node.child_count; ++c) {
        result.children_.push_back(root_of[children_[node.first_child + c]]);
      }
      node.first_child = child_shift;
      result.nodes_.push_back(node);
    }
    root_of[i] = static_cast<std::uint32_t>(result.nodes_.size() - 1);
  }
  return result;
}

std::uint32_t ExpressionBuilder::leaf(std::uint32_t index) {
  result_.nodes_.push_back({Expression::Kind::leaf, index, 0, 0});
  return static_cast<std::uint32_t>(result_.nodes_.size() - 1);
}

std::uint32_t ExpressionBuilder::combine(Expression::Kind kind, std::span<const std::uint32_t> children) {
  const auto first = static_cast<std::uint32_t>(result_.children_.size());
  result_.children_.insert(result_.children_.end(), children.begin(), children.end());
  result_.nodes_.push_back({kind, 0, first, static_cast<std::uint32_t>(children.size())});
  return static_cast<std::uint32_t>(result_.nodes_.size() - 1);
}

}  // namespace quoin
