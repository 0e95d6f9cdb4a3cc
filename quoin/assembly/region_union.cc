// SPDX-License-Identifier: Apache-2.0
#include "quoin/assembly/region_union.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "quoin/arrangement/cells/face_walk.h"

namespace quoin {

namespace {

struct Drawn {
  GeodesicArrangement arrangement;
  std::vector<std::uint32_t> region_of_curve;
};

Drawn draw(std::span<const ConvexRegion> regions, const Context& context) {
  GeodesicFamily family;
  PieceList<GeodesicFamily> list;
  Drawn drawn;
  for (std::uint32_t r = 0; r < regions.size(); ++r) {
    const ConvexRegion& region = regions[r];
    for (std::size_t i = 0; i < region.normals.size(); ++i) {
      if (region.corners.empty()) {
        family.add_great_circle(list, region.normals[i].exact());
      } else {
        family.add_arc(list, region.corners[i].exact(), region.corners[(i + 1) % region.corners.size()].exact(),
                       region.normals[i].exact());
      }
      drawn.region_of_curve.push_back(r);
    }
  }
  drawn.arrangement = arrange(std::move(family), std::move(list), context);
  return drawn;
}

/// Which cells of a drawing of regions are in one of them. A walk over the faces keeps up to date in which regions it
/// is; on an edge or vertex, those whose boundary passes there do not count.
class UnionWalk {
 public:
  UnionWalk(const Drawn& drawn, std::size_t regions)
      : drawn_(drawn), cells_(drawn.arrangement.cells()), is_in_(regions, false) {}

  GeodesicPolygonSet run() {
    find_start();
    faces_.assign(cells_.faces.size(), false);
    edges_.assign(cells_.edges.size(), false);
    vertices_.assign(cells_.vertices.size(), false);
    dcel::walk_faces(
        cells_, [&](dcel::HalfedgeId h) { cross(h); }, [&](dcel::FaceId f) { visit(f); });
    return {drawn_.arrangement, std::move(vertices_), std::move(edges_), std::move(faces_)};
  }

 private:
  /// Whether a step over h, out of its face, leaves the region of the curve.
  static bool leaves(dcel::HalfedgeId h, CurveUse use) { return h.is_forward() != use.is_reversed(); }
  std::uint32_t region_of(CurveUse use) const { return drawn_.region_of_curve[use.curve().index()]; }

  /// The walk starts in the regions whose boundaries it first crosses outwards.
  void find_start() {
    std::vector<bool> is_known(is_in_.size(), false);
    dcel::walk_faces(
        cells_,
        [&](dcel::HalfedgeId h) {
          for (const CurveUse use : drawn_.arrangement.curves(h.edge())) {
            const std::uint32_t region = region_of(use);
            if (is_known[region]) continue;
            is_known[region] = true;
            is_in_[region] = leaves(h, use);
          }
        },
        [](dcel::FaceId) {});
    count_ = static_cast<std::size_t>(std::ranges::count(is_in_, true));
  }
  void cross(dcel::HalfedgeId h) {
    for (const CurveUse use : drawn_.arrangement.curves(h.edge())) {
      is_in_[region_of(use)] = !leaves(h, use);
      count_ = leaves(h, use) ? count_ - 1 : count_ + 1;
    }
  }
  void visit(dcel::FaceId f) {
    faces_[f.index()] = count_ > 0;
    for (dcel::BoundaryId b = cells_[f].first_boundary; !b.is_none(); b = cells_[b].next) {
      const dcel::HalfedgeId first = cells_[b].halfedge;
      dcel::HalfedgeId h = first;
      do {
        if (h.is_forward()) edges_[h.edge().index()] = counts_beyond(list_on(h.edge()));
        vertices_[cells_.origin(h).index()] = counts_beyond(list_around(cells_.origin(h)));
        h = cells_.next(h);
      } while (h != first);
    }
  }
  /// Whether the walk is in a region that is not among these.
  bool counts_beyond(std::vector<std::uint32_t>& touched) const {
    std::ranges::sort(touched);
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    const auto inside =
        std::ranges::count_if(touched, [&](std::uint32_t region) { return static_cast<bool>(is_in_[region]); });
    return count_ > static_cast<std::size_t>(inside);
  }
  std::vector<std::uint32_t>& list_on(dcel::EdgeId e) {
    touched_.clear();
    for (const CurveUse use : drawn_.arrangement.curves(e)) touched_.push_back(region_of(use));
    return touched_;
  }
  std::vector<std::uint32_t>& list_around(dcel::VertexId v) {
    touched_.clear();
    const dcel::HalfedgeId first = cells_[v].out;
    dcel::HalfedgeId out = first;
    do {
      for (const CurveUse use : drawn_.arrangement.curves(out.edge())) touched_.push_back(region_of(use));
      out = cells_.clockwise(out);
    } while (out != first);
    return touched_;
  }

  const Drawn& drawn_;
  const dcel::Dcel& cells_;
  std::vector<bool> is_in_;  // by region, at the current face
  std::size_t count_ = 0;
  std::vector<bool> faces_;
  std::vector<bool> edges_;
  std::vector<bool> vertices_;
  std::vector<std::uint32_t> touched_;
};

}  // namespace

GeodesicPolygonSet sweep_union(std::span<const ConvexRegion> regions, const Context& context) {
  const Drawn drawn = draw(regions, context);
  return UnionWalk(drawn, regions.size()).run();
}

}  // namespace quoin
