// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "quoin/arrangement/cells/dcel.h"

namespace quoin {

/// What became of the cells in an operation on a whole arrangement.
///
/// An old cell may go on as several new ones (`new_*` names one of them) or not at all; a new cell lies in one old cell
/// of its kind (`old_*`) or in none. Both are indexed by the ids of the other side, dead and fictitious cells too.
struct CellMap {
  std::vector<dcel::VertexId> new_vertex;
  std::vector<dcel::VertexId> old_vertex;
  std::vector<dcel::EdgeId> new_edge;
  std::vector<dcel::EdgeId> old_edge;
  std::vector<dcel::FaceId> new_face;
  std::vector<dcel::FaceId> old_face;
};

/// Is told of every change of the arrangement it is attached to.
///
/// Every change is announced before anything is touched and told after all links are right again; one edit may consist
/// of several changes, as the creation of an edge that splits a face. Only holes of a face just split may still be in
/// the wrong part: their moves follow. Cells that close the plane at infinity are told of like others; ask for
/// their state. Operations on a whole arrangement are one change. Observers must not edit.
class ArrangementObserver {
 public:
  ArrangementObserver() = default;
  ArrangementObserver(const ArrangementObserver&) = delete;
  ArrangementObserver& operator=(const ArrangementObserver&) = delete;
  /// Detaches.
  virtual ~ArrangementObserver() { detach(); }

  /// False before attachment, and once the arrangement is gone or was assigned another.
  bool is_attached() const { return !list_.expired(); }
  void detach();

  virtual void before_create_vertex() {}
  virtual void after_create_vertex(dcel::VertexId) {}
  virtual void before_remove_vertex(dcel::VertexId) {}
  virtual void after_remove_vertex(dcel::VertexId) {}

  virtual void before_create_edge(dcel::VertexId /*left*/, dcel::VertexId /*right*/) {}
  virtual void after_create_edge(dcel::EdgeId) {}
  virtual void before_remove_edge(dcel::EdgeId) {}
  virtual void after_remove_edge(dcel::EdgeId) {}
  virtual void before_split_edge(dcel::EdgeId) {}
  /// The left part is the old edge.
  virtual void after_split_edge(dcel::EdgeId /*left*/, dcel::VertexId, dcel::EdgeId /*right*/) {}
  virtual void before_merge_edges(dcel::EdgeId /*left*/, dcel::VertexId, dcel::EdgeId /*right*/) {}
  /// The merged edge is the left one; the right one and the vertex are dead.
  virtual void after_merge_edges(dcel::EdgeId /*left*/, dcel::VertexId, dcel::EdgeId /*right*/) {}

  virtual void before_change_curves(dcel::EdgeId) {}
  /// Other curves run along the edge now.
  virtual void after_change_curves(dcel::EdgeId) {}

  virtual void before_split_face(dcel::FaceId) {}
  virtual void after_split_face(dcel::FaceId /*old*/, dcel::FaceId /*created*/) {}
  virtual void before_merge_faces(dcel::FaceId /*kept*/, dcel::FaceId /*gone*/) {}
  /// What was in the face that is gone is in the other now.
  virtual void after_merge_faces(dcel::FaceId /*kept*/, dcel::FaceId /*gone*/) {}
  virtual void before_move_boundary(dcel::BoundaryId, dcel::FaceId /*from*/, dcel::FaceId /*to*/) {}
  virtual void after_move_boundary(dcel::BoundaryId, dcel::FaceId /*from*/, dcel::FaceId /*to*/) {}
  virtual void before_move_isolated(dcel::VertexId, dcel::FaceId /*from*/, dcel::FaceId /*to*/) {}
  virtual void after_move_isolated(dcel::VertexId, dcel::FaceId /*from*/, dcel::FaceId /*to*/) {}

  /// The frame of fictitious edges at infinity comes with the first unbounded curve and goes with the last.
  virtual void before_change_frame() {}
  virtual void after_change_frame() {}

  /// Insertion of many curves, renumbering. Between the two the arrangement must not be read.
  virtual void before_global_change() {}
  virtual void after_global_change(const CellMap&) {}

  /// Called at attachment, to take in what there is already.
  virtual void after_attach(const dcel::Dcel&) {}

 private:
  friend class ObserverList;
  using List = std::vector<ArrangementObserver*>;
  std::weak_ptr<List> list_;
};

/// The observers of one arrangement, in order of attachment. Copies of the arrangement start without any; a moved
/// arrangement takes them along.
class ObserverList {
 public:
  ObserverList() = default;
  ObserverList(const ObserverList&) {}
  ObserverList(ObserverList&&) noexcept = default;
  ObserverList& operator=(const ObserverList& other) {
    if (this != &other) list_.reset();
    return *this;
  }
  ObserverList& operator=(ObserverList&&) noexcept = default;
  ~ObserverList() = default;

  /// An observer watches one arrangement at a time.
  void attach(ArrangementObserver& observer, const dcel::Dcel& cells);
  bool is_empty() const { return list_ == nullptr || list_->empty(); }

  /// Calls a member function of every observer.
  template <class... Parameters, class... Arguments>
  void tell(void (ArrangementObserver::*what)(Parameters...), const Arguments&... arguments) const {
    if (list_ == nullptr) return;
    for (ArrangementObserver* observer : *list_) (observer->*what)(arguments...);
  }

 private:
  std::shared_ptr<ArrangementObserver::List> list_;
};

}  // namespace quoin
