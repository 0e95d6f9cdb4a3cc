// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/solid.h"

#include <algorithm>
#include <map>

#include "quoin/base/error.h"
#include "quoin/solid/overlay/overlay.h"

namespace quoin {

namespace {

std::vector<Expression> leaf_expressions(std::size_t count) {
  std::vector<Expression> result;
  for (std::uint32_t i = 0; i < count; ++i) result.push_back(Expression::leaf(i));
  return result;
}

Solid evaluate_all(Expression (*combine)(std::span<const Expression>), std::span<const Solid> solids,
                   const Context& context) {
  return Solid::evaluate(combine(leaf_expressions(solids.size())), solids, context);
}

}  // namespace

Solid::Solid() : boundary_(std::make_shared<const Brep>()) {}

Solid Solid::of_leaf(std::shared_ptr<const Leaf> leaf) {
  Solid result;
  result.leaves_.push_back(std::move(leaf));
  result.expression_ = Expression::leaf(0);
  result.boundary_ = nullptr;
  return result;
}

Solid Solid::of_complement(std::shared_ptr<const Leaf> leaf) {
  Solid result = of_leaf(std::move(leaf));
  result.expression_ = Expression::complement(result.expression_);
  return result;
}

std::shared_ptr<const Brep> Solid::shared_boundary() const {
  if (!boundary_) throw Error("this solid is an operand that was not evaluated");
  return boundary_;
}

Solid Solid::from_leaf(std::shared_ptr<const Leaf> leaf, const Context& context) {
  Solid result = of_leaf(std::move(leaf));
  result.boundary_ = std::make_shared<const Brep>(overlay_boundary(result.leaves_, result.expression_, context));
  return result;
}

Solid Solid::from_boundary(Brep boundary, const std::string& name, const Context& context) {
  Solid result;
  if (boundary.face_count() == 0) {
    if (boundary.is_unbounded) result.expression_ = Expression::complement(result.expression_);
  } else {
    LeafResult leaf = make_leaf(boundary, name, {.find_crossings = false}, context);
    if (!leaf.leaf) throw InputError(name + ": the boundary bounds no solid");
    result = boundary.is_unbounded ? of_complement(std::move(leaf.leaf)) : of_leaf(std::move(leaf.leaf));
  }
  result.boundary_ = std::make_shared<const Brep>(std::move(boundary));
  return result;
}

Solid Solid::evaluate(const Expression& expression, std::span<const Solid> solids, const Context& context) {
  if (expression.leaf_count() > solids.size()) throw InputError("the expression names a solid that was not given");
  Solid result;
  std::map<const Leaf*, std::uint32_t> number;
  std::vector<Expression> operands;
  for (const Solid& solid : solids) {
    std::vector<Expression> renamed;
    for (const auto& leaf : solid.leaves_) {
      const auto [entry, is_new] = number.try_emplace(leaf.get(), static_cast<std::uint32_t>(result.leaves_.size()));
      if (is_new) result.leaves_.push_back(leaf);
      renamed.push_back(Expression::leaf(entry->second));
    }
    operands.push_back(solid.expression_.substitute(renamed));
  }
  result.expression_ = expression.substitute(operands);
  result.boundary_ = std::make_shared<const Brep>(overlay_boundary(result.leaves_, result.expression_, context));
  return result;
}

Solid unite(std::span<const Solid> solids, const Context& context) {
  return evaluate_all(&Expression::unite, solids, context);
}

Solid intersect(std::span<const Solid> solids, const Context& context) {
  return evaluate_all(&Expression::intersect, solids, context);
}

Solid symmetric_difference(std::span<const Solid> solids, const Context& context) {
  return evaluate_all(&Expression::exclusive, solids, context);
}

Solid subtract(const Solid& from, std::span<const Solid> tools, const Context& context) {
  std::vector<Solid> solids{from};
  solids.insert(solids.end(), tools.begin(), tools.end());
  const std::vector<Expression> all = leaf_expressions(solids.size());
  return Solid::evaluate(Expression::subtract(all[0], std::span(all).subspan(1)), solids, context);
}

Solid complement(const Solid& solid, const Context& context) {
  return Solid::evaluate(Expression::complement(Expression::leaf(0)), {&solid, 1}, context);
}

}  // namespace quoin
