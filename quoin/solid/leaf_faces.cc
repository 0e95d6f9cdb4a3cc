// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/leaf_faces.h"

#include <algorithm>

#include "quoin/kernel/projection.h"
#include "quoin/solid/overlay/point_merger.h"
#include "quoin/triangulation/polygon.h"

namespace quoin {

namespace {

class FaceCutter {
 public:
  FaceCutter(const Brep& boundary, const Constructions& points, std::size_t max_listed, MeshDiagnosis& diagnosis,
             const Context& context)
      : b_(boundary), points_(points), max_listed_(max_listed), diagnosis_(diagnosis), context_(context) {}

  MeshTiles run() {
    overlay::PointMerger merger(points_);
    for (std::size_t p = 0; p < points_.point_count(); ++p) first_.push_back(merger.insert(PointId{p}));
    for (std::uint32_t f = 0; f < b_.face_count(); ++f) {
      if (f % 256 == 0) context_.poll();
      if (!lies_in_its_plane(f)) {
        note(diagnosis_.not_planar_faces, f, max_listed_);
        continue;
      }
      gather_edges(f);
      cancel_opposite();
      if (!chain_loops() || !triangulate(f)) note(diagnosis_.not_simple_faces, f, max_listed_);
    }
    return std::move(out_);
  }

 private:
  // A directed edge of a face.
  struct Edge {
    PointId from;
    PointId to;
    friend auto operator<=>(const Edge& a, const Edge& b) {
      return std::pair(a.from.value, a.to.value) <=> std::pair(b.from.value, b.to.value);
    }
  };

  bool lies_in_its_plane(std::uint32_t f) const {
    const auto& [a, b, c] = b_.face_planes[f];
    // The capture names what it takes: clang does not capture structured bindings in C++20.
    const auto is_flat = [&, &a = a, &b = b, &c = c](unsigned axis) {
      return points_.turn(a, b, c, axis) == Sign::zero;
    };
    if (is_flat(0) && is_flat(1) && is_flat(2)) return false;
    for (std::uint32_t l = b_.face_first_loop[f]; l < b_.face_first_loop[f + 1]; ++l) {
      for (const PointId p : b_.loop(l)) {
        if (points_.orientation(a, b, c, p) != Sign::zero) return false;
      }
    }
    return true;
  }

  void gather_edges(std::uint32_t f) {
    edges_.clear();
    singles_.clear();
    for (std::uint32_t l = b_.face_first_loop[f]; l < b_.face_first_loop[f + 1]; ++l) {
      const auto loop = b_.loop(l);
      if (loop.size() == 1) singles_.push_back(first_[loop[0].index()]);
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Edge e{first_[loop[i].index()], first_[loop[i + 1 == loop.size() ? 0 : i + 1].index()]};
        if (e.from != e.to) edges_.push_back(e);
      }
    }
    std::sort(edges_.begin(), edges_.end());
  }

  // Of an edge passed a times forward and b times backward, the excess of one over the other stays, or one of each: a
  // slit. Nothing stays of a face that has no area.
  void cancel_opposite() {
    std::vector<Edge> kept;
    bool has_area = false;
    for (auto e = edges_.begin(); e != edges_.end();) {
      const auto [first, end] = std::equal_range(edges_.begin(), edges_.end(), *e);
      const auto [first_back, end_back] = std::equal_range(edges_.begin(), edges_.end(), Edge{e->to, e->from});
      const std::ptrdiff_t excess = (end - first) - (end_back - first_back);
      kept.insert(kept.end(), static_cast<std::size_t>(excess == 0 ? 1 : std::max<std::ptrdiff_t>(excess, 0)), *e);
      has_area = has_area || excess != 0;
      e = end;
    }
    edges_ = std::move(kept);
    if (has_area) return;
    edges_.clear();
    singles_.clear();
  }

  // Any closed chains of the edges: triangulation asks for no more. Fails where a vertex is left more often than
  // entered.
  bool chain_loops() {
    ids_ = singles_;
    for (const Edge& e : edges_) ids_.push_back(e.from);
    std::sort(ids_.begin(), ids_.end(), [](PointId a, PointId b) { return a.value < b.value; });
    ids_.erase(std::unique(ids_.begin(), ids_.end()), ids_.end());
    loop_points_.clear();
    loop_begin_.assign(1, 0);
    std::vector<bool> used(edges_.size(), false);
    for (std::size_t start = 0; start < edges_.size(); ++start) {
      if (used[start]) continue;
      for (std::size_t at = start;;) {
        used[at] = true;
        loop_points_.push_back(index_of(edges_[at].from));
        if (edges_[at].to == edges_[start].from) break;
        auto next = std::lower_bound(edges_.begin(), edges_.end(), edges_[at].to,
                                     [](const Edge& e, PointId p) { return e.from.value < p.value; });
        while (next != edges_.end() && next->from == edges_[at].to &&
               used[static_cast<std::size_t>(next - edges_.begin())])
          ++next;
        if (next == edges_.end() || next->from != edges_[at].to) return false;
        at = static_cast<std::size_t>(next - edges_.begin());
      }
      loop_begin_.push_back(static_cast<std::uint32_t>(loop_points_.size()));
    }
    for (const PointId p : singles_) {
      loop_points_.push_back(index_of(p));
      loop_begin_.push_back(static_cast<std::uint32_t>(loop_points_.size()));
    }
    return true;
  }

  std::uint32_t index_of(PointId p) const {
    const auto at =
        std::lower_bound(ids_.begin(), ids_.end(), p, [](PointId a, PointId b) { return a.value < b.value; });
    return static_cast<std::uint32_t>(at - ids_.begin());
  }

  bool triangulate(std::uint32_t f) {
    const auto& [a, b, c] = b_.face_planes[f];
    const unsigned axis = projection_axis(points_, a, b, c);
    const PolygonView view{axis, points_.turn(a, b, c, axis) == Sign::positive};
    triangles_.clear();
    if (!triangulate_polygon(points_, ids_, view, loop_points_, loop_begin_, triangles_)) return false;
    for (const PolygonTriangle& t : triangles_) {
      Tile tile{ids_[t[0]].value, ids_[t[1]].value, ids_[t[2]].value};
      if (b_.is_unbounded) std::swap(tile[1], tile[2]);
      out_.tiles.push_back(tile);
      out_.tile_face.push_back(f);
    }
    return true;
  }

  const Brep& b_;
  const Constructions& points_;
  std::size_t max_listed_;
  MeshDiagnosis& diagnosis_;
  const Context& context_;
  MeshTiles out_;
  std::vector<PointId> first_;  // of the points equal to one, the first
  std::vector<Edge> edges_;
  std::vector<PointId> singles_;  // loops of one vertex
  std::vector<PointId> ids_;      // vertices of a face, ascending
  std::vector<std::uint32_t> loop_points_;
  std::vector<std::uint32_t> loop_begin_;
  std::vector<PolygonTriangle> triangles_;
};

}  // namespace

std::vector<RationalPoint3> exact_points(const Constructions& points, const Context& context) {
  std::vector<RationalPoint3> result;
  result.reserve(points.point_count());
  for (std::size_t p = 0; p < points.point_count(); ++p) {
    if (p % 1024 == 0) context.poll();
    result.push_back(points.exact(PointId{p}));
  }
  return result;
}

MeshTiles make_tiles(const Brep& boundary, const Constructions& points, std::size_t max_listed,
                     MeshDiagnosis& diagnosis, const Context& context) {
  return FaceCutter(boundary, points, max_listed, diagnosis, context).run();
}

}  // namespace quoin
