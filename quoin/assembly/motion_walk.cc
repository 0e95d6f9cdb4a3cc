// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include "quoin/arrangement/cells/face_walk.h"
#include "quoin/assembly/motion_space.h"

namespace quoin {

namespace {

constexpr std::size_t cells_between_polls = 64;

}  // namespace

/// A graph that is kept up to date from cell to cell. From a face it steps to the edges and vertices of its boundary
/// and back: there, a region counts as its own edge or vertex says, and all others as in the face.
class MotionWalk {
 public:
  MotionWalk(const MotionSpace& space, const MotionSpace::Visit& visit, const Context& context)
      : space_(space),
        cells_(space.arrangement_.cells()),
        visit_(visit),
        context_(context),
        graph_(space.part_count_),
        is_in_(space.groups_.size(), false) {}

  void run() {
    for (const auto& [from, to] : space_.fixed_) graph_.set_arc(from, to, true);
    find_start();
    is_edge_done_.assign(cells_.edges.size(), false);
    is_vertex_done_.assign(cells_.vertices.size(), false);
    dcel::walk_faces(
        cells_, [&](dcel::HalfedgeId h) { cross(h); }, [&](dcel::FaceId f) { visit_face(f); });
  }

 private:
  const BlockedRegion& region(std::uint32_t group) const { return space_.groups_[group].region; }
  const BlockedRegion::Arc& arc_of(const MotionSpace::Source& source) const {
    return region(source.group).arcs[source.arc];
  }
  const MotionSpace::Source& source_of(CurveUse use) const { return space_.sources_[use.curve().index()]; }
  /// Whether the face of h, which the curve bounds, is in the curve's region.
  bool is_inside(dcel::HalfedgeId h, CurveUse use) const {
    return arc_of(source_of(use)).is_slit || h.is_forward() != use.is_reversed();
  }

  void set(std::uint32_t group, bool is_in) {
    if (is_in_[group] == is_in) return;
    is_in_[group] = is_in;
    for (const auto& [from, to] : space_.groups_[group].arcs) graph_.set_arc(from, to, is_in);
  }
  void cross(dcel::HalfedgeId h) {
    for (const CurveUse use : space_.arrangement_.curves(h.edge())) {
      set(source_of(use).group, is_inside(h.twin(), use));
    }
  }

  /// The first arc of a region that the walk steps over, or runs along, tells whether it began inside.
  void find_start() {
    std::vector<bool> is_known(is_in_.size(), false);
    for (std::uint32_t g = 0; g < is_in_.size(); ++g) {
      const bool has_border = std::ranges::any_of(region(g).arcs, [](const auto& arc) { return !arc.is_slit; });
      is_known[g] = !has_border;
      if (!has_border) set(g, region(g).blocks_elsewhere || !region(g).arcs.empty());
    }
    std::vector<std::uint32_t> inside;
    dcel::walk_faces(
        cells_,
        [&](dcel::HalfedgeId h) {
          for (const CurveUse use : space_.arrangement_.curves(h.edge())) {
            const MotionSpace::Source& source = source_of(use);
            if (is_known[source.group] || arc_of(source).is_slit) continue;
            is_known[source.group] = true;
            if (is_inside(h, use)) inside.push_back(source.group);
          }
        },
        [](dcel::FaceId) {});
    for (const std::uint32_t group : inside) set(group, true);
  }

  void visit_face(dcel::FaceId f) {
    if (++visited_ % cells_between_polls == 0) {
      context_.progress("directions", static_cast<double>(visited_) / static_cast<double>(cells_.faces.size()));
    }
    visit_({MotionCell::Kind::face, f.value}, graph_);
    for (dcel::BoundaryId b = cells_[f].first_boundary; !b.is_none(); b = cells_[b].next) {
      const dcel::HalfedgeId first = cells_[b].halfedge;
      dcel::HalfedgeId h = first;
      do {
        visit_edge(h.edge());
        visit_vertex(cells_.origin(h));
        h = cells_.next(h);
      } while (h != first);
    }
    for (dcel::VertexId v = cells_[f].first_isolated; !v.is_none(); v = cells_[v].next_isolated) visit_vertex(v);
  }
  void visit_edge(dcel::EdgeId e) {
    const dcel::EdgeId cell = space_.cell_of(e);
    if (is_edge_done_[cell.index()]) return;
    is_edge_done_[cell.index()] = true;
    for (const CurveUse use : space_.arrangement_.curves(e)) step_to(source_of(use).group, false);
    visit_({MotionCell::Kind::edge, cell.value}, graph_);
    step_back();
  }
  void visit_vertex(dcel::VertexId v) {
    if (is_vertex_done_[v.index()] || space_.is_cut(v)) return;
    is_vertex_done_[v.index()] = true;
    const dcel::HalfedgeId first = cells_[v].out;
    if (!first.is_none()) {
      dcel::HalfedgeId out = first;
      do {
        for (const CurveUse use : space_.arrangement_.curves(out.edge())) step_to(source_of(use).group, false);
        out = cells_.clockwise(out);
      } while (out != first);
    }
    for (std::uint32_t c = space_.first_coincidence_[v.index()]; c < space_.first_coincidence_[v.index() + 1]; ++c) {
      step_to(space_.coincidences_[c].group, space_.coincidences_[c].is_blocked);
    }
    visit_({MotionCell::Kind::vertex, v.value}, graph_);
    step_back();
  }
  void step_to(std::uint32_t group, bool is_in) {
    if (is_in_[group] == is_in) return;
    stepped_.emplace_back(group, is_in_[group]);
    set(group, is_in);
  }
  void step_back() {
    while (!stepped_.empty()) {
      set(stepped_.back().first, stepped_.back().second);
      stepped_.pop_back();
    }
  }

  const MotionSpace& space_;
  const dcel::Dcel& cells_;
  const MotionSpace::Visit& visit_;
  const Context& context_;
  BlockingGraph graph_;
  std::vector<bool> is_in_;  // by group, at the current cell
  std::vector<bool> is_edge_done_;
  std::vector<bool> is_vertex_done_;
  std::vector<std::pair<std::uint32_t, bool>> stepped_;  // groups and what they were in the face
  std::size_t visited_ = 0;
};

void MotionSpace::walk(const Visit& visit, const Context& context) const {
  MotionWalk(*this, visit, context).run();
}

}  // namespace quoin
