// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "quoin/arrangement/edit/observer.h"
#include "quoin/arrangement/location/location.h"

namespace quoin {

/// Marks a locator as stale when its arrangement changes, if attached to it: `arrangement.attach(watch)`. The locator
/// must outlive the watch.
template <PointLocator L>
class LocatorWatch : public ArrangementObserver {
 public:
  explicit LocatorWatch(L& locator) : locator_(locator) {}

  /// Changes since the locator was last brought up to date; one edit may be several.
  std::size_t changes() const { return changes_; }
  /// Rebuilds the locator if it is stale. @throws Cancelled
  void refresh(const Context& context) {
    if (locator_.is_stale()) locator_.rebuild(context);
    changes_ = 0;
  }

  void before_create_vertex() override { note(); }
  void before_remove_vertex(dcel::VertexId) override { note(); }
  void before_create_edge(dcel::VertexId, dcel::VertexId) override { note(); }
  void before_remove_edge(dcel::EdgeId) override { note(); }
  void before_split_edge(dcel::EdgeId) override { note(); }
  void before_merge_edges(dcel::EdgeId, dcel::VertexId, dcel::EdgeId) override { note(); }
  void before_split_face(dcel::FaceId) override { note(); }
  void before_merge_faces(dcel::FaceId, dcel::FaceId) override { note(); }
  void before_move_boundary(dcel::BoundaryId, dcel::FaceId, dcel::FaceId) override { note(); }
  void before_move_isolated(dcel::VertexId, dcel::FaceId, dcel::FaceId) override { note(); }
  void before_change_frame() override { note(); }
  void before_global_change() override { note(); }

 private:
  void note() {
    ++changes_;
    locator_.mark_stale();
  }

  L& locator_;
  std::size_t changes_ = 0;
};

}  // namespace quoin
