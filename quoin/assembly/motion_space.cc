// SPDX-License-Identifier: Apache-2.0
#include "quoin/assembly/motion_space.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "quoin/arrangement/sweep/build_visitor.h"
#include "quoin/base/disjoint_sets.h"

namespace quoin {

namespace {

struct Drawing {
  GeodesicFamily family;
  PieceList<GeodesicFamily> list;
  std::vector<std::uint32_t> colours;  // by piece: the group
};

void add_arc(const BlockedRegion& region, const BlockedRegion::Arc& arc, Drawing& drawing) {
  if (arc.source == BlockedRegion::Arc::no_vertex) {
    drawing.family.add_great_circle(drawing.list, arc.normal);
  } else {
    drawing.family.add_arc(drawing.list, region.vertices[arc.source].at, region.vertices[arc.target].at, arc.normal);
  }
}

}  // namespace

MotionSpace::MotionSpace(std::size_t part_count, std::span<const RegionGroup> groups, const Context& context,
                         Arcs fixed)
    : part_count_(part_count), groups_(groups), fixed_(std::move(fixed)) {
  draw(context);
  find_cuts();
}

void MotionSpace::draw(const Context& context) {
  Drawing drawing;
  std::vector<std::pair<std::uint32_t, Coincidence>> points;  // of the list, their vertices not known yet
  for (std::uint32_t g = 0; g < groups_.size(); ++g) {
    const BlockedRegion& region = groups_[g].region;
    for (std::uint32_t a = 0; a < region.arcs.size(); ++a) {
      add_arc(region, region.arcs[a], drawing);
      drawing.colours.resize(drawing.list.pieces.size(), g);
      sources_.push_back({g, a});
    }
    for (const BlockedRegion::Vertex& vertex : region.vertices) {
      drawing.family.add_point(drawing.list, vertex.at);
      sources_.push_back({g, BlockedRegion::Arc::no_vertex});
      points.push_back({drawing.list.lone_points.back().point, {0, g, vertex.is_blocked}});
    }
  }
  BuildVisitor<GeodesicFamily> visitor(drawing.family, drawing.list);
  Sweep<GeodesicFamily>(drawing.family, drawing.list, {}, {drawing.colours}, visitor, context).run();
  arrangement_ = visitor.finish(std::move(drawing.family));
  for (auto& [point, coincidence] : points) {
    coincidence.vertex = visitor.vertex_of_point()[point].value;
    coincidences_.push_back(coincidence);
  }
  std::ranges::sort(coincidences_, [](const Coincidence& a, const Coincidence& b) {
    return std::pair(a.vertex, a.group) < std::pair(b.vertex, b.group);
  });
  first_coincidence_.assign(arrangement_.vertex_count() + 1, 0);
  for (const Coincidence& c : coincidences_) ++first_coincidence_[c.vertex + 1];
  for (std::size_t v = 0; v < arrangement_.vertex_count(); ++v) first_coincidence_[v + 1] += first_coincidence_[v];
}

void MotionSpace::find_cuts() {
  const dcel::Dcel& cells = arrangement_.cells();
  is_cut_.assign(cells.vertices.size(), false);
  DisjointSets edges(cells.edges.size());
  for (std::size_t i = 0; i < cells.vertices.size(); ++i) {
    const dcel::VertexId v(i);
    const dcel::HalfedgeId out = cells[v].out;
    if (!cells.is_real(v) || out.is_none() || first_coincidence_[i] != first_coincidence_[i + 1]) continue;
    const dcel::HalfedgeId other = cells.clockwise(out);
    if (other == out || cells.clockwise(other) != out) continue;
    if (!arrangement_.family().same_plane(arrangement_.branch(out.edge()), arrangement_.branch(other.edge()))) continue;
    is_cut_[i] = true;
    edges.unite(out.edge().value, other.edge().value);
  }
  edge_cell_.resize(cells.edges.size());
  for (std::size_t e = 0; e < edge_cell_.size(); ++e) {
    edge_cell_[e] = static_cast<std::uint32_t>(edges.find(static_cast<std::uint32_t>(e)));
  }
}

MotionCounts MotionSpace::counts() const {
  const dcel::Dcel& cells = arrangement_.cells();
  MotionCounts counts;
  for (std::size_t v = 0; v < cells.vertices.size(); ++v) {
    if (cells.is_real(dcel::VertexId(v)) && !is_cut_[v]) ++counts.vertices;
  }
  for (std::size_t e = 0; e < cells.edges.size(); ++e) {
    if (cells.is_real(dcel::EdgeId(e)) && edge_cell_[e] == e) ++counts.edges;
  }
  for (std::size_t f = 0; f < cells.faces.size(); ++f) counts.faces += cells.is_real(dcel::FaceId(f)) ? 1 : 0;
  return counts;
}

}  // namespace quoin
