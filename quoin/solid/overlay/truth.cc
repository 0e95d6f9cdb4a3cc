// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/overlay/truth.h"

#include <algorithm>

#include "quoin/solid/overlay/winding.h"

namespace quoin::overlay {

ExpressionState::ExpressionState(const Expression& expression, std::size_t leaf_count)
    : expression_(&expression),
      parent_(expression.nodes().size(), none),
      true_count_(expression.nodes().size(), 0),
      true_(expression.nodes().size(), 0),
      winding_(leaf_count, 0),
      first_use_(leaf_count + 1, 0) {
  const auto nodes = expression.nodes();
  for (std::uint32_t n = 0; n < nodes.size(); ++n) {
    for (std::uint32_t c = 0; c < nodes[n].child_count; ++c) {
      const std::uint32_t child = expression.children()[nodes[n].first_child + c];
      parent_[child] = n;
      true_count_[n] += true_[child];
    }
    true_[n] = evaluate(n) ? 1 : 0;
    if (nodes[n].kind == Expression::Kind::leaf) ++first_use_[nodes[n].leaf + 1];
  }
  for (std::size_t i = 0; i < leaf_count; ++i) first_use_[i + 1] += first_use_[i];
  uses_.resize(first_use_.back());
  std::vector<std::uint32_t> fill(first_use_.begin(), first_use_.end() - 1);
  for (std::uint32_t n = 0; n < nodes.size(); ++n) {
    if (nodes[n].kind == Expression::Kind::leaf) uses_[fill[nodes[n].leaf]++] = n;
  }
}

bool ExpressionState::evaluate(std::uint32_t node) const {
  const Expression::Node& n = expression_->nodes()[node];
  switch (n.kind) {
    case Expression::Kind::leaf:
      return winding_[n.leaf] > 0;
    case Expression::Kind::any:
      return true_count_[node] > 0;
    case Expression::Kind::every:
      return true_count_[node] == n.child_count;
    case Expression::Kind::odd:
      return true_count_[node] % 2 != 0;
    case Expression::Kind::complement:
      return true_count_[node] == 0;
  }
  return false;
}

void ExpressionState::set(std::uint32_t node, bool value) {
  while (true_[node] != static_cast<std::uint8_t>(value)) {
    true_[node] = value ? 1 : 0;
    const std::uint32_t parent = parent_[node];
    if (parent == none) return;
    true_count_[parent] = value ? true_count_[parent] + 1 : true_count_[parent] - 1;
    node = parent;
    value = evaluate(parent);
  }
}

void ExpressionState::evaluate_all() {
  std::fill(true_count_.begin(), true_count_.end(), 0);
  for (std::uint32_t n = 0; n < true_.size(); ++n) {
    true_[n] = evaluate(n) ? 1 : 0;
    if (parent_[n] != none) true_count_[parent_[n]] += true_[n];
  }
}

void ExpressionState::wind(std::uint32_t leaf, int change) {
  const bool before = winding_[leaf] > 0;
  winding_[leaf] += change;
  const bool after = winding_[leaf] > 0;
  if (before == after) return;
  constexpr std::uint32_t share_of_many = 16;  // a path to the root may be as long as there are nodes
  const std::uint32_t uses = first_use_[leaf + 1] - first_use_[leaf];
  if (uses > 1 && uses >= true_.size() / share_of_many) return evaluate_all();
  for (std::uint32_t u = first_use_[leaf]; u < first_use_[leaf + 1]; ++u) set(uses_[u], after);
}

namespace {

// Walks from cell to cell across walls, depth first, with the state of the cell it stands in.
class CellWalk {
 public:
  CellWalk(const CellComplex& complex, ExpressionState& state, std::vector<std::uint8_t>& inside)
      : complex_(complex), state_(state), inside_(inside), seen_(complex.cell_count, false) {
    link_cells();
  }

  bool has_seen(std::uint32_t cell) const { return seen_[cell]; }

  /// The state must be that of `start`, and is again when it returns.
  void run(std::uint32_t start, const Context& context) {
    enter(start, none);
    std::size_t steps = 0;
    while (!path_.empty()) {
      if (++steps % 4096 == 0) context.poll();
      Step& step = path_.back();
      if (step.next == first_wall_[step.cell + 1]) {
        leave();
        continue;
      }
      const std::uint32_t wall = walls_[step.next++];
      const Patch& patch = complex_.patches[wall];
      const std::uint32_t other = patch.front == step.cell ? patch.back : patch.front;
      if (seen_[other]) continue;
      cross(wall, patch.front == step.cell);
      enter(other, wall);
    }
  }

 private:
  struct Step {
    std::uint32_t cell;
    std::uint32_t wall;  // through which it was entered
    std::uint32_t next;  // into walls_
  };

  // The patches by the cells at them.
  void link_cells() {
    first_wall_.assign(complex_.cell_count + 1, 0);
    for (const Patch& p : complex_.patches) {
      ++first_wall_[p.front + 1];
      ++first_wall_[p.back + 1];
    }
    for (std::size_t c = 0; c < complex_.cell_count; ++c) first_wall_[c + 1] += first_wall_[c];
    walls_.resize(first_wall_.back());
    std::vector<std::uint32_t> fill(first_wall_.begin(), first_wall_.end() - 1);
    for (std::uint32_t p = 0; p < complex_.patches.size(); ++p) {
      const Patch& patch = complex_.patches[p];
      walls_[fill[patch.front]++] = p;
      walls_[fill[patch.back]++] = p;
    }
  }

  void enter(std::uint32_t cell, std::uint32_t wall) {
    seen_[cell] = true;
    inside_[cell] = state_.truth() ? 1 : 0;
    path_.push_back({cell, wall, first_wall_[cell]});
  }

  void leave() {
    const Step step = path_.back();
    path_.pop_back();
    if (step.wall != none) cross(step.wall, complex_.patches[step.wall].front == step.cell);
  }

  void cross(std::uint32_t wall, bool from_front) {
    for (const Winding& w : complex_.windings_across(wall)) state_.wind(w.leaf, from_front ? w.number : -w.number);
  }

  const CellComplex& complex_;
  ExpressionState& state_;
  std::vector<std::uint8_t>& inside_;
  std::vector<bool> seen_;
  std::vector<std::uint32_t> first_wall_;
  std::vector<std::uint32_t> walls_;
  std::vector<Step> path_;
};

}  // namespace

CellTruth classify_cells(const Sheets& sheets, const CellComplex& complex, const Expression& expression,
                         const Context& context) {
  CellTruth truth;
  truth.inside.assign(complex.cell_count, 0);
  ExpressionState state(expression, sheets.scene->leaves.size());
  truth.is_unbounded = state.truth();
  CellWalk walk(complex, state, truth.inside);
  context.progress("winding numbers", 0);
  for (const Patch& patch : complex.patches) {
    if (walk.has_seen(patch.front)) continue;
    context.poll();
    const SheetWinding winding = winding_at(sheets, patch.sheet);
    for (const Winding& w : winding.windings) state.wind(w.leaf, w.number);
    walk.run(winding.in_front ? patch.front : patch.back, context);
    for (const Winding& w : winding.windings) state.wind(w.leaf, -w.number);
  }
  return truth;
}

}  // namespace quoin::overlay
