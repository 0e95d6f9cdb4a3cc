// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <type_traits>
#include <utility>
#include <vector>

#include "quoin/arrangement/edit/observer.h"

namespace quoin {

/// What becomes of values when cells split and merge.
template <class T>
struct CellRules {
  T initial{};                                      ///< of new cells
  std::function<T(const T&)> on_split{};            ///< of the part that is new; default: a copy
  std::function<T(const T&, const T&)> on_merge{};  ///< of the kept cell and the one that goes; default: the first
};

/// User data of any type on the vertices, edges, halfedges or faces of an arrangement, which follows its changes.
///
/// `Cell` is VertexId, EdgeId, HalfedgeId or FaceId. In a global change, old cells that go on keep their values; a
/// cell cut in several counts as split. Removed cells lose theirs.
template <class Cell, class T>
class CellData : public ArrangementObserver {
 public:
  explicit CellData(CellRules<T> rules = {}) : rules_(std::move(rules)) {}

  T& operator[](Cell cell) { return slot(cell.index()); }
  const T& operator[](Cell cell) const {
    return cell.index() < slots_.size() ? slots_[cell.index()].value : rules_.initial;
  }

  void after_create_vertex(dcel::VertexId v) override {
    if constexpr (is_on<dcel::VertexId>) slot(v.index()) = rules_.initial;
  }
  void after_remove_vertex(dcel::VertexId v) override {
    if constexpr (is_on<dcel::VertexId>) slot(v.index()) = rules_.initial;
  }
  void after_create_edge(dcel::EdgeId e) override { reset_edge(e); }
  void after_remove_edge(dcel::EdgeId e) override { reset_edge(e); }
  void after_split_edge(dcel::EdgeId left, dcel::VertexId v, dcel::EdgeId right) override {
    if constexpr (is_on<dcel::VertexId>) slot(v.index()) = rules_.initial;
    if constexpr (is_on<dcel::EdgeId>) split(left.index(), right.index());
    if constexpr (is_on<dcel::HalfedgeId>) {
      split(2 * left.index(), 2 * right.index());
      split(2 * left.index() + 1, 2 * right.index() + 1);
    }
  }
  void after_merge_edges(dcel::EdgeId left, dcel::VertexId v, dcel::EdgeId right) override {
    if constexpr (is_on<dcel::VertexId>) slot(v.index()) = rules_.initial;
    if constexpr (is_on<dcel::EdgeId>) merge(left.index(), right.index());
    if constexpr (is_on<dcel::HalfedgeId>) {
      merge(2 * left.index(), 2 * right.index());
      merge(2 * left.index() + 1, 2 * right.index() + 1);
    }
  }
  void after_split_face(dcel::FaceId old, dcel::FaceId created) override {
    if constexpr (is_on<dcel::FaceId>) split(old.index(), created.index());
  }
  void after_merge_faces(dcel::FaceId kept, dcel::FaceId gone) override {
    if constexpr (is_on<dcel::FaceId>) merge(kept.index(), gone.index());
  }
  void after_global_change(const CellMap& map) override {
    std::vector<Slot> old = std::move(slots_);
    slots_.clear();
    std::vector<bool> is_taken(old.size(), false);
    const auto take = [&](std::size_t to, std::size_t from) {
      if (from >= old.size()) return;
      slot(to) = is_taken[from] ? split_value(old[from].value) : old[from].value;
      is_taken[from] = true;
    };
    if constexpr (is_on<dcel::VertexId>) take_all(map.old_vertex, take);
    if constexpr (is_on<dcel::EdgeId>) take_all(map.old_edge, take);
    if constexpr (is_on<dcel::FaceId>) take_all(map.old_face, take);
    if constexpr (is_on<dcel::HalfedgeId>) {
      for (std::size_t e = 0; e < map.old_edge.size(); ++e) {
        if (map.old_edge[e].is_none()) continue;
        take(2 * e, 2 * map.old_edge[e].index());
        take(2 * e + 1, 2 * map.old_edge[e].index() + 1);
      }
    }
  }

 private:
  struct Slot {
    T value;
  };
  template <class Other>
  static constexpr bool is_on = std::is_same_v<Cell, Other>;

  template <class OldCells, class Take>
  static void take_all(const OldCells& old_cells, const Take& take) {
    for (std::size_t i = 0; i < old_cells.size(); ++i) {
      if (!old_cells[i].is_none()) take(i, old_cells[i].index());
    }
  }
  T& slot(std::size_t index) {
    if (index >= slots_.size()) slots_.resize(index + 1, Slot{rules_.initial});
    return slots_[index].value;
  }
  T split_value(const T& value) const { return rules_.on_split ? rules_.on_split(value) : value; }
  void split(std::size_t from, std::size_t to) {
    T value = split_value(slot(from));
    slot(to) = std::move(value);
  }
  void merge(std::size_t kept, std::size_t gone) {
    const T other = slot(gone);
    if (rules_.on_merge) slot(kept) = rules_.on_merge(T(slot(kept)), other);
    slot(gone) = rules_.initial;
  }
  void reset_edge(dcel::EdgeId e) {
    if constexpr (is_on<dcel::EdgeId>) slot(e.index()) = rules_.initial;
    if constexpr (is_on<dcel::HalfedgeId>) {
      slot(2 * e.index()) = rules_.initial;
      slot(2 * e.index() + 1) = rules_.initial;
    }
  }

  CellRules<T> rules_;
  std::vector<Slot> slots_;
};

}  // namespace quoin
