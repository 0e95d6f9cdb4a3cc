// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <string>

#include "quoin/base/error.h"
#include "quoin/view/plan_page.h"

namespace quoin {

namespace {

template <class Indices>
void require_below(const Indices& indices, std::size_t end, const std::string& what) {
  for (const auto index : indices) {
    if (index >= end)
      throw InputError("plan: " + what + " names number " + std::to_string(index) + " of " + std::to_string(end));
  }
}

void check_part(const PlanPart& part) {
  const std::string what = "part '" + part.name + "'";
  for (const Point3& p : part.vertices) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      throw InputError("plan: " + what + " has a vertex that is not finite");
  }
  for (const auto& triangle : part.triangles) require_below(triangle, part.vertices.size(), what);
  for (const auto& edge : part.edges) require_below(edge, part.vertices.size(), what);
}

void check_state(const PlanState& state, const PlanPicture& picture, const std::string& what) {
  require_below(state.parts, picture.parts.size(), what);
  for (const PlanMove& move : state.moves) {
    require_below(move.moving, picture.parts.size(), what);
    require_below(std::array{move.graph}, picture.graphs.size(), what);
    for (const std::uint32_t next : {move.moved_state, move.rest_state}) {
      if (next != PlanMove::no_state) require_below(std::array{next}, picture.states.size(), what);
    }
  }
}

void check_cells(const std::vector<std::uint32_t>& graphs, std::size_t cells, const PlanPicture& picture,
                 const std::string& what) {
  if (graphs.size() != cells) throw InputError("plan: " + what + " and their graphs are not equally many");
  require_below(graphs, picture.graphs.size(), what);
}

}  // namespace

void check_plan(const PlanPicture& picture) {
  for (const PlanPart& part : picture.parts) check_part(part);
  for (std::size_t s = 0; s < picture.states.size(); ++s)
    check_state(picture.states[s], picture, "state " + std::to_string(s));
  for (const auto& [state, move] : picture.steps) {
    require_below(std::array{state}, picture.states.size(), "a step");
    require_below(std::array{move}, picture.states[state].moves.size(), "a step");
  }
  require_below(picture.interlocked, picture.states.size(), "what is interlocked");
  for (const PlanGraph& graph : picture.graphs) {
    for (const auto& arc : graph.arcs) require_below(arc, picture.parts.size(), "a graph");
    for (const auto& set : graph.movable) require_below(set, picture.parts.size(), "a graph");
  }
  check_cells(picture.face_graphs, picture.sphere.faces.size(), picture, "faces");
  check_cells(picture.edge_graphs, picture.sphere.edges.size(), picture, "edges");
  check_cells(picture.point_graphs, picture.sphere.points.size(), picture, "points");
  check_picture(picture.sphere);
}

}  // namespace quoin
