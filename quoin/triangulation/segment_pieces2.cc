// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/segment_pieces2.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "quoin/arrangement/linear/linear_arrangement.h"
#include "quoin/base/error.h"
#include "quoin/triangulation/spatial_order2.h"

namespace quoin {

namespace {

constexpr std::uint32_t none = Vertex2::none_value;

// From points and segments to their arrangement, and back to vertices.
class Cutter {
 public:
  Cutter(std::span<const Point2> points, std::span<const Segment2> segments, const Context& context)
      : segments_(segments), context_(context) {
    require_ends(points.size());
    order_ = spatial_order(points, context);
    vertex_of_input_.resize(points.size());
    for (std::uint32_t v = 0; v < order_.points.size(); ++v) {
      for (const std::uint32_t input : order_.inputs_of(v)) vertex_of_input_[input] = v;
    }
  }

  SegmentPieces2 run() {
    arrange_all();
    find_given_vertices();
    SegmentPieces2 result{make_table(), {order_.inputs.begin(), order_.inputs.end()}, {}, {}, {}};
    result.input_begin.assign(order_.input_begin.begin(), order_.input_begin.end());
    if (result.input_begin.empty()) {
      result.input_begin.resize(order_.points.size() + 1);
      std::iota(result.input_begin.begin(), result.input_begin.end(), 0U);
    }
    collect_pieces(result);
    return result;
  }

 private:
  void require_ends(std::size_t count) const {
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      for (const std::uint32_t end : segments_[i]) {
        if (end < count) continue;
        throw InputError("segment " + std::to_string(i) + " ends at point " + std::to_string(end) + " of " +
                         std::to_string(count));
      }
    }
  }

  std::uint32_t end_vertex(std::uint32_t segment, unsigned end) const {
    return vertex_of_input_[segments_[segment][end]];
  }

  void arrange_all() {
    LinearFamily family;
    PieceList<LinearFamily> list;
    for (std::uint32_t s = 0; s < segments_.size(); ++s) {
      const std::uint32_t a = end_vertex(s, 0);
      const std::uint32_t b = end_vertex(s, 1);
      if (a == b) continue;
      family.add_segment(list, order_.points[a], order_.points[b]);
      segment_of_curve_.push_back(s);
    }
    for (const Point2& p : order_.points) family.add_point(list, p);
    arrangement_ = arrange(std::move(family), std::move(list), context_);
  }

  // Both the arrangement's vertices and the points, sorted, are in lexicographic order, and every point is a vertex.
  void find_given_vertices() {
    std::vector<std::uint32_t> sorted(order_.points.size());
    std::iota(sorted.begin(), sorted.end(), 0U);
    std::sort(sorted.begin(), sorted.end(), [&](std::uint32_t a, std::uint32_t b) {
      return lexicographically_less(order_.points[a], order_.points[b]);
    });
    vertex_.assign(arrangement_.vertex_count(), none);
    std::size_t next = 0;
    for (std::size_t v = 0; v < arrangement_.vertex_count(); ++v) {
      const dcel::VertexId id(v);
      if (!arrangement_.cells().is_real(id)) continue;
      const LinearPoint& p = arrangement_.point(id);
      if (next < sorted.size() &&
          arrangement_.family().compare_xy(p, LinearFamily::point(order_.points[sorted[next]])) == Sign::zero) {
        vertex_[v] = sorted[next++];
      } else {
        (p.is_explicit() ? plain_crossings_ : crossings_).push_back(id);
      }
    }
    if (next != sorted.size()) throw InternalError("points are missing in the arrangement of segments");
  }

  // Crossings along a curve, by their rounded coordinates: any order is right. Those that are doubles come first.
  Constructions make_table() {
    const auto sort = [&](std::vector<dcel::VertexId>& list) {
      std::vector<Point2> rounded;
      for (const dcel::VertexId v : list) {
        const LinearPoint& p = arrangement_.point(v);
        rounded.push_back({p.x, p.y});
      }
      std::vector<dcel::VertexId> sorted;
      for (const std::uint32_t i : spatial_order(rounded, context_).inputs) sorted.push_back(list[i]);
      list = std::move(sorted);
    };
    sort(plain_crossings_);
    sort(crossings_);
    std::vector<Point3> plain;
    plain.reserve(order_.points.size() + plain_crossings_.size());
    for (const Point2& p : order_.points) plain.push_back({p.x, p.y, 0});
    for (const dcel::VertexId v : plain_crossings_) {
      vertex_[v.index()] = static_cast<std::uint32_t>(plain.size());
      plain.push_back({arrangement_.point(v).x, arrangement_.point(v).y, 0});
    }
    Constructions table(std::move(plain));
    auto id = static_cast<std::uint32_t>(table.explicit_count());
    table.resize_points(id + crossings_.size());
    for (const dcel::VertexId v : crossings_) {
      if (id % 1024 == 0) context_.poll();
      const LinearPoint& p = arrangement_.point(v);
      const std::uint32_t s = segment_of_curve_[p.first];
      const std::uint32_t t = segment_of_curve_[p.second];
      const auto end = [&](std::uint32_t segment, unsigned k) { return PointId(std::size_t{end_vertex(segment, k)}); };
      table.set_crossing(PointId(std::size_t{id}), end(s, 0), end(s, 1), end(t, 0), end(t, 1), 2);
      vertex_[v.index()] = id++;
    }
    return table;
  }

  void collect_pieces(SegmentPieces2& result) const {
    for (std::size_t e = 0; e < arrangement_.edge_count(); ++e) {
      const dcel::EdgeId edge(e);
      if (!arrangement_.cells().is_real(edge)) continue;
      result.pieces.push_back({Vertex2(vertex_[arrangement_.left(edge).index()]),
                               Vertex2(vertex_[arrangement_.right(edge).index()]),
                               static_cast<std::uint32_t>(result.uses.size())});
      for (const CurveUse& use : arrangement_.curves(edge)) {
        result.uses.push_back({segment_of_curve_[use.curve().index()], use.is_reversed()});
      }
    }
  }

  std::span<const Segment2> segments_;
  const Context& context_;
  SpatialOrder2 order_;
  std::vector<std::uint32_t> vertex_of_input_;
  std::vector<std::uint32_t> segment_of_curve_;  // supports and curves of segments have the same numbers
  LinearArrangement arrangement_;
  std::vector<std::uint32_t> vertex_;            // of the arrangement's
  std::vector<dcel::VertexId> plain_crossings_;  // their coordinates are exact
  std::vector<dcel::VertexId> crossings_;
};

}  // namespace

SegmentPieces2 cut_segments(std::span<const Point2> points, std::span<const Segment2> segments,
                            const Context& context) {
  return Cutter(points, segments, context).run();
}

}  // namespace quoin
