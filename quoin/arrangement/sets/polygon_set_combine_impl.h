// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numeric>

#include "quoin/arrangement/sets/polygon_set_impl.h"

/// Bodies of `combine` and `combine_rings`, for the one source file per family that instantiates them.
namespace quoin {

namespace polygon_set_detail {

/// How many operands a place is in, and whether the first is one of them.
struct Membership {
  std::uint32_t count = 0;
  bool in_first = false;

  void set(std::size_t operand, bool before, bool now) {
    if (before == now) return;
    count += now ? 1U : 0xFFFFFFFFU;
    if (operand == 0) in_first = now;
  }
  bool decide(SetOperation operation, std::size_t operands) const {
    switch (operation) {
      case SetOperation::unite:
        return count > 0;
      case SetOperation::intersect:
        return operands > 0 && count == operands;
      case SetOperation::subtract:
        return in_first && count == 1;
      case SetOperation::symmetric_difference:
        return count % 2 == 1;
      case SetOperation::first:
        return in_first;
    }
    return false;
  }
};

/// Membership of faces, edges and vertices of a superposition of sets, found while walking over its faces.
template <CurveFamily F>
class SetWalk {
 public:
  SetWalk(const Superposition<F>& drawn, std::span<const PolygonSet<F>* const> sets, SetOperation operation)
      : drawn_(drawn), cells_(drawn.arrangement.cells()), sets_(sets), operation_(operation), is_in_(sets.size()) {
    for (std::size_t i = 0; i < sets.size(); ++i) {
      is_in_[i] = sets[i]->contains(sets[i]->arrangement().cells().base_face);
      here_.set(i, false, is_in_[i]);
    }
    members_.faces.assign(cells_.faces.size(), false);
  }

  Members run(Regularity regularity) {
    if (regularity == Regularity::plain) {
      members_.edges.assign(cells_.edges.size(), false);
      members_.vertices.assign(cells_.vertices.size(), false);
      is_vertex_done_.assign(cells_.vertices.size(), false);
      list_coincidences();
    }
    dcel::walk_faces(
        cells_, [&](HalfedgeId h) { cross(h); },
        [&](FaceId f) {
          members_.faces[f.index()] = here_.decide(operation_, sets_.size());
          if (regularity == Regularity::plain) decide_around(f);
        });
    if (regularity == Regularity::regularized) close_faces(cells_, members_);
    return std::move(members_);
  }

 private:
  void cross(HalfedgeId h) {
    for (const CurveUse use : drawn_.arrangement.curves(h.edge())) {
      const auto [source, edge] = drawn_.source_of(use);
      const FaceId face = sets_[source]->arrangement().cells().face(HalfedgeId(edge, h.is_forward()));
      const bool now = sets_[source]->contains(face);
      here_.set(source, is_in_[source], now);
      is_in_[source] = now;
    }
  }

  /// Edges and vertices on the boundary of a face: operands that have no edge or vertex there are as in the face.
  void decide_around(FaceId f) {
    for (dcel::BoundaryId b = cells_[f].first_boundary; !b.is_none(); b = cells_[b].next) {
      const HalfedgeId first = cells_[b].halfedge;
      HalfedgeId h = first;
      do {
        if (cells_.is_real(h.edge()) && h.is_forward()) decide_edge(h.edge());
        if (cells_.is_real(cells_.origin(h))) decide_vertex(cells_.origin(h));
        h = cells_.next(h);
      } while (h != first);
    }
    for (VertexId v = cells_[f].first_isolated; !v.is_none(); v = cells_[v].next_isolated) decide_vertex(v);
  }
  void decide_edge(EdgeId e) {
    Membership on = here_;
    for (const CurveUse use : drawn_.arrangement.curves(e)) {
      const auto [source, edge] = drawn_.source_of(use);
      on.set(source, is_in_[source], sets_[source]->contains(edge));
    }
    members_.edges[e.index()] = on.decide(operation_, sets_.size());
  }
  void decide_vertex(VertexId v) {
    if (is_vertex_done_[v.index()]) return;
    is_vertex_done_[v.index()] = true;
    touched_.clear();
    for (std::uint32_t at = first_coincidence_[v.index()]; at < first_coincidence_[v.index() + 1]; ++at) {
      const std::uint32_t global = coincidences_[at];
      const auto above = std::upper_bound(drawn_.first_vertex.begin(), drawn_.first_vertex.end(), global);
      const auto source = static_cast<std::uint32_t>(above - drawn_.first_vertex.begin() - 1);
      const VertexId vertex(std::size_t{global - drawn_.first_vertex[source]});
      touched_.emplace_back(source, sets_[source]->contains(vertex));
    }
    const std::size_t by_vertex = touched_.size();
    for_each_out(cells_, v, [&](HalfedgeId out) {
      for (const CurveUse use : drawn_.arrangement.curves(out.edge())) {
        const auto [source, edge] = drawn_.source_of(use);
        touched_.emplace_back(source, sets_[source]->contains(edge));
      }
    });
    // An operand's own vertex comes before its edges, and one of its edges is enough: it passes through.
    std::stable_sort(touched_.begin() + static_cast<std::ptrdiff_t>(by_vertex), touched_.end());
    std::stable_sort(touched_.begin(), touched_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    Membership on = here_;
    for (std::size_t i = 0; i < touched_.size(); ++i) {
      if (i > 0 && touched_[i].first == touched_[i - 1].first) continue;
      on.set(touched_[i].first, is_in_[touched_[i].first], touched_[i].second);
    }
    members_.vertices[v.index()] = on.decide(operation_, sets_.size());
  }
  void list_coincidences() {
    first_coincidence_.assign(cells_.vertices.size() + 1, 0);
    for (const VertexId v : drawn_.vertex_of_source) {
      if (!v.is_none()) ++first_coincidence_[v.index() + 1];
    }
    for (std::size_t v = 0; v < cells_.vertices.size(); ++v) first_coincidence_[v + 1] += first_coincidence_[v];
    std::vector<std::uint32_t> next(first_coincidence_.begin(), first_coincidence_.end() - 1);
    coincidences_.resize(first_coincidence_.back());
    for (std::size_t i = 0; i < drawn_.vertex_of_source.size(); ++i) {
      const VertexId v = drawn_.vertex_of_source[i];
      if (!v.is_none()) coincidences_[next[v.index()]++] = static_cast<std::uint32_t>(i);
    }
  }

  const Superposition<F>& drawn_;
  const dcel::Dcel& cells_;
  std::span<const PolygonSet<F>* const> sets_;
  SetOperation operation_;
  std::vector<bool> is_in_;  // by operand, at the current face
  Membership here_;
  Members members_;
  std::vector<bool> is_vertex_done_;
  std::vector<std::uint32_t> first_coincidence_;
  std::vector<std::uint32_t> coincidences_;
  std::vector<std::pair<std::uint32_t, bool>> touched_;
};

inline bool is_inside(std::int32_t winding, FillRule rule) {
  switch (rule) {
    case FillRule::nonzero:
      return winding != 0;
    case FillRule::even_odd:
      return winding % 2 != 0;
    case FillRule::positive:
      return winding > 0;
  }
  return false;
}

/// What stepping over h, into the face of its twin, adds to the winding number of a curve along it: from above to below
/// a curve that runs to the right, its left is left.
inline std::int32_t winding_step(dcel::HalfedgeId h, CurveUse use) {
  return h.is_forward() != use.is_reversed() ? -1 : 1;
}

}  // namespace polygon_set_detail

template <CurveFamily F>
PolygonSet<F> combine(std::span<const PolygonSet<F>* const> sets, SetOperation operation, Regularity regularity,
                      const Context& context) {
  std::vector<const Arrangement<F>*> sources;
  for (const PolygonSet<F>* set : sets) sources.push_back(&set->arrangement());
  const Superposition<F> drawn = superpose<F>(sources, context);
  auto members = polygon_set_detail::SetWalk<F>(drawn, sets, operation).run(regularity);
  return PolygonSet<F>(drawn.arrangement, std::move(members.vertices), std::move(members.edges),
                       std::move(members.faces));
}

template <CurveFamily F>
PolygonSet<F> combine_regions(const Arrangement<F>& drawn, const RegionGroups& groups, SetOperation operation) {
  const dcel::Dcel& cells = drawn.cells();
  polygon_set_detail::Members members{{}, {}, std::vector<bool>(cells.faces.size(), false)};
  polygon_set_detail::Membership here;
  std::vector<std::int32_t> winding(groups.operand_of_element.size(), 0);
  std::vector<std::uint32_t> elements_around(groups.operand_count, 0);  // by operand: how many hold the place
  dcel::walk_faces(
      cells,
      [&](dcel::HalfedgeId h) {
        for (const CurveUse use : drawn.curves(h.edge())) {
          const std::uint32_t element = groups.element_of_curve[use.curve().index()];
          const FillRule rule = groups.rule_of_element[element];
          const bool before = polygon_set_detail::is_inside(winding[element], rule);
          winding[element] += polygon_set_detail::winding_step(h, use);
          const bool now = polygon_set_detail::is_inside(winding[element], rule);
          if (before == now) continue;
          const std::uint32_t operand = groups.operand_of_element[element];
          std::uint32_t& around = elements_around[operand];
          here.set(operand, around > 0, now || around > 1);
          around += now ? 1U : 0xFFFFFFFFU;
        }
      },
      [&](dcel::FaceId f) { members.faces[f.index()] = here.decide(operation, groups.operand_count); });
  polygon_set_detail::close_faces(cells, members);
  return PolygonSet<F>(drawn, std::move(members.vertices), std::move(members.edges), std::move(members.faces));
}

template <CurveFamily F>
PolygonSet<F> combine_rings(F family, const PieceList<F>& rings, std::span<const std::uint32_t> operand_of_curve,
                            std::uint32_t operand_count, FillRule rule, SetOperation operation,
                            const Context& context) {
  RegionGroups groups;
  groups.element_of_curve.assign(operand_of_curve.begin(), operand_of_curve.end());
  groups.rule_of_element.assign(operand_count, rule);
  groups.operand_of_element.resize(operand_count);
  std::iota(groups.operand_of_element.begin(), groups.operand_of_element.end(), 0U);
  groups.operand_count = operand_count;
  return combine_regions(arrange(std::move(family), rings, context), groups, operation);
}

}  // namespace quoin
