// SPDX-License-Identifier: Apache-2.0
#include "quoin/assembly/region_extraction.h"

#include <algorithm>
#include <utility>

namespace quoin {

namespace {

using dcel::EdgeId;
using dcel::FaceId;
using dcel::HalfedgeId;
using dcel::VertexId;

class Extraction {
 public:
  explicit Extraction(const GeodesicPolygonSet& set)
      : set_(set), arrangement_(set.arrangement()), cells_(set.arrangement().cells()) {}

  BlockedRegion run() {
    find_cuts();
    number_vertices();
    is_done_.assign(cells_.edges.size(), false);
    // Chains that end at vertices first, then whole circles.
    for (const bool ends_at_vertex : {true, false}) {
      for (std::size_t h = 0; h < cells_.halfedges.size(); ++h) {
        const HalfedgeId halfedge(h);
        if (is_done_[halfedge.edge().index()] || !cells_.is_real(halfedge.edge())) continue;
        if (ends_at_vertex && is_cut_[cells_.origin(halfedge).index()]) continue;
        add_chain(halfedge);
      }
    }
    region_.blocks_elsewhere = region_.arcs.empty() && set_.contains(cells_.base_face);
    sort_region(region_);
    return std::move(region_);
  }

 private:
  /// A vertex of two edges along one great circle, where nothing changes.
  bool is_cut(VertexId v) const {
    const HalfedgeId out = cells_[v].out;
    if (out.is_none()) return false;
    const HalfedgeId other = cells_.clockwise(out);
    return other != out && cells_.clockwise(other) == out && set_.contains(v) == set_.contains(out.edge()) &&
           set_.contains(v) == set_.contains(other.edge()) &&
           arrangement_.family().same_plane(arrangement_.branch(out.edge()), arrangement_.branch(other.edge()));
  }
  void find_cuts() {
    is_cut_.resize(cells_.vertices.size());
    for (std::size_t v = 0; v < is_cut_.size(); ++v) is_cut_[v] = cells_.is_real(VertexId(v)) && is_cut(VertexId(v));
  }
  void number_vertices() {
    number_.assign(cells_.vertices.size(), BlockedRegion::Arc::no_vertex);
    for (std::size_t v = 0; v < number_.size(); ++v) {
      if (is_cut_[v] || !cells_.is_real(VertexId(v))) continue;
      number_[v] = static_cast<std::uint32_t>(region_.vertices.size());
      const SphereDirection at(arrangement_.family().direction(arrangement_.point(VertexId(v))));
      region_.vertices.push_back({at, set_.contains(VertexId(v))});
    }
  }
  void add_chain(HalfedgeId first) {
    HalfedgeId last = first;
    is_done_[first.edge().index()] = true;
    while (is_cut_[cells_.target(last).index()]) {
      // The edge on the other side of the cut.
      const HalfedgeId next = cells_.next(last);
      if (next == first) break;
      last = next;
      is_done_[last.edge().index()] = true;
    }
    BlockedRegion::Arc arc{normal_along(first), number_[cells_.origin(first).index()],
                           number_[cells_.target(last).index()], false};
    const bool left = set_.contains(cells_.face(first));
    const bool right = set_.contains(cells_.face(first.twin()));
    arc.is_slit = left && right;
    if (arc.is_slit ? !is_first_component_positive(arc.normal) : !left) {
      arc.normal = -arc.normal;
      std::swap(arc.source, arc.target);
    }
    region_.arcs.push_back(std::move(arc));
  }
  SphereDirection normal_along(HalfedgeId h) const {
    const SphereDirection normal(arrangement_.family().normal(arrangement_.branch(h.edge())));
    return h.is_forward() ? normal : -normal;
  }
  static bool is_first_component_positive(const SphereDirection& v) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (v.sign(axis) != Sign::zero) return v.sign(axis) == Sign::positive;
    }
    return false;
  }

  const GeodesicPolygonSet& set_;
  const GeodesicArrangement& arrangement_;
  const dcel::Dcel& cells_;
  std::vector<bool> is_cut_;
  std::vector<bool> is_done_;
  std::vector<std::uint32_t> number_;
  BlockedRegion region_;
};

}  // namespace

BlockedRegion extract_region(const GeodesicPolygonSet& set) {
  return Extraction(set).run();
}

}  // namespace quoin
