// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/assembly_page.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "quoin/assembly/candidates.h"
#include "quoin/assembly/overlap.h"
#include "quoin/cli/assembly_report.h"
#include "quoin/cli/planar.h"
#include "quoin/cli/scene_of_solid.h"
#include "quoin/cli/target_writing.h"
#include "quoin/solid/exit.h"
#include "quoin/view/plan_page.h"
#include "quoin/view/sphere_arrangement_picture.h"

namespace quoin::cli {

namespace {

using Parts = std::span<const AssemblyPart>;

/// Beyond that many cells of a motion space nobody finds one in a picture.
constexpr std::size_t most_cells_shown = 20'000;
constexpr std::size_t most_stops_named = 8;
/// Of cells with solutions.
constexpr Color solution_color{46, 157, 91, 255};
constexpr Color solution_face_color{150, 205, 165, 255};

PlanPart drawn(const AssemblyPart& part, const Context& context) {
  const Solid solid = solid_of(part, context);
  const Triangulated triangles = triangulate_boundary(solid.boundary(), {}, context);
  ViewPart shown = std::move(scene_of_solid(solid.boundary(), triangles, part.name, context).parts[0]);
  return {part.name, std::move(shown.vertices), std::move(shown.triangles), std::move(shown.edges)};
}

Vector3 unit_vector(const SphereDirection& direction) {
  const auto v = rounded_direction(direction);
  const double length = std::hypot(v[0], v[1], v[2]);
  return {v[0] / length, v[1] / length, v[2] / length};
}

std::string names_of(const PartSet& set, Parts parts) {
  std::string names;
  for (const std::uint32_t part : set.members()) names += (names.empty() ? "" : " ") + parts[part].name;
  return names;
}

/// Collects graphs, equal ones once.
class Graphs {
 public:
  explicit Graphs(std::vector<PlanGraph>& list) : list_(list) {}

  std::uint32_t number_of(const BlockingGraph& graph, const PartSet& within) {
    const auto [at, is_new] =
        number_.try_emplace(std::pair(graph.rows(), within), static_cast<std::uint32_t>(list_.size()));
    if (!is_new) return at->second;
    PlanGraph result;
    const std::vector<std::uint32_t> members = within.members();
    for (const std::uint32_t i : members) {
      for (const std::uint32_t j : members) {
        if (graph.has_arc(i, j)) result.arcs.push_back({i, j});
      }
    }
    for (const PartSet& set : graph.movable_sets(within)) result.movable.push_back(set.members());
    list_.push_back(std::move(result));
    return at->second;
  }

 private:
  std::vector<PlanGraph>& list_;
  std::map<std::pair<std::vector<std::uint64_t>, PartSet>, std::uint32_t> number_;
};

void add_sequence(const AssemblyPlan& plan, Graphs& graphs, PlanPicture& picture) {
  const Disassembly& found = *plan.disassembly;
  for (const DisassemblyState& state : found.states) {
    PlanState shown{state.parts.members(), {}, state.is_expanded};
    for (const DisassemblyMove& move : state.moves) {
      PlanMove step{move.moving.members(), unit_vector(move.direction), direction_text(move.direction)};
      step.graph = graphs.number_of(blocking_graph(plan.pairs, move.direction, state.parts), state.parts);
      step.moved_state = move.moved;
      step.rest_state = move.rest;
      shown.moves.push_back(std::move(step));
    }
    picture.states.push_back(std::move(shown));
  }
  for (const Disassembly::Step& step : found.steps) picture.steps.push_back({step.state, step.move});
  picture.interlocked = found.interlocked;
}

/// By cell, the number of its graph.
struct CellGraphs {
  std::vector<std::uint32_t> vertices;
  std::vector<std::uint32_t> edges;
  std::vector<std::uint32_t> faces;
};

CellGraphs graphs_of_cells(const MotionSpace& space, Graphs& graphs, const Context& context) {
  const dcel::Dcel& cells = space.arrangement().cells();
  CellGraphs result{std::vector<std::uint32_t>(cells.vertices.size(), 0),
                    std::vector<std::uint32_t>(cells.edges.size(), 0),
                    std::vector<std::uint32_t>(cells.faces.size(), 0)};
  space.walk(
      [&](MotionCell cell, const BlockingGraph& graph) {
        const std::uint32_t number = graphs.number_of(graph, PartSet::all(graph.part_count()));
        (cell.kind == MotionCell::Kind::vertex ? result.vertices
         : cell.kind == MotionCell::Kind::edge ? result.edges
                                               : result.faces)[cell.id] = number;
      },
      context);
  for (std::size_t e = 0; e < result.edges.size(); ++e)
    result.edges[e] = result.edges[space.cell_of(dcel::EdgeId(e)).index()];
  return result;
}

CellLook look_of(const PlanGraph& graph, const std::string& name, Parts parts) {
  CellLook look;
  look.text.name = name;
  look.text.facts.emplace_back("Blocked pairs", std::to_string(graph.arcs.size()));
  if (graph.movable.empty()) {
    look.text.facts.emplace_back("Can move", "nothing");
    return look;
  }
  look.fill.color = solution_color;
  look.style = EdgeStyle::strong;
  std::string sets;
  for (std::size_t k = 0; k < graph.movable.size() && k < 6; ++k) {
    PartSet set(parts.size());
    for (const std::uint32_t part : graph.movable[k]) set.insert(part);
    sets += (k > 0 ? "\n" : "") + names_of(set, parts);
  }
  if (graph.movable.size() > 6) sets += "\nand " + std::to_string(graph.movable.size() - 6) + " more sets";
  look.text.facts.emplace_back("Can move", sets);
  return look;
}

/// The sphere of directions; vertices that only cut an edge are no points of it.
void add_sphere(Parts parts, const MotionSpace& space, const CellGraphs& numbers, PlanPicture& picture) {
  const dcel::Dcel& cells = space.arrangement().cells();
  ArrangementPictureOptions how;
  how.face = [&](dcel::FaceId f) {
    CellLook look = look_of(picture.graphs[numbers.faces[f.index()]], "Face " + std::to_string(f.value), parts);
    if (look.fill.color) look.fill.color = solution_face_color;
    return look;
  };
  how.edge = [&](dcel::EdgeId e) {
    return look_of(picture.graphs[numbers.edges[e.index()]], "Edge " + std::to_string(space.cell_of(e).value), parts);
  };
  how.vertex = [&](dcel::VertexId v) {
    CellLook look = look_of(picture.graphs[numbers.vertices[v.index()]], "Vertex " + std::to_string(v.value), parts);
    look.text.facts.emplace_back("Direction", direction_text(space.direction_in({MotionCell::Kind::vertex, v.value})));
    return look;
  };
  how.curve_name = [](CurveId) { return std::string(); };
  picture.sphere = sphere_picture_of(space.arrangement(), how);
  std::vector<SpherePoint> points;
  std::size_t at = 0;
  for (std::size_t v = 0; v < cells.vertices.size(); ++v) {
    if (!cells.is_real(dcel::VertexId(v))) continue;
    SpherePoint& point = picture.sphere.points[at++];
    if (space.is_cut(dcel::VertexId(v))) continue;
    points.push_back(std::move(point));
    picture.point_graphs.push_back(numbers.vertices[v]);
  }
  picture.sphere.points = std::move(points);
  for (std::size_t e = 0; e < cells.edges.size(); ++e) {
    if (cells.is_real(dcel::EdgeId(e))) picture.edge_graphs.push_back(numbers.edges[e]);
  }
  for (std::size_t f = 0; f < cells.faces.size(); ++f) {
    if (cells.is_real(dcel::FaceId(f))) picture.face_graphs.push_back(numbers.faces[f]);
  }
}

void add_facts(Parts parts, const AssemblyPlan& plan, PlanPicture& picture) {
  const auto add = [&](const std::string& name, std::size_t number) {
    picture.facts.emplace_back(name, std::to_string(number));
  };
  add("Parts", picture.parts.size());
  if (plan.partition) {
    add("Directions: vertices", plan.partition->cells.vertices);
    add("edges", plan.partition->cells.edges);
    add("faces", plan.partition->cells.faces);
    add("Cells with solutions", plan.partition->solution_cells);
  }
  if (plan.infinitesimal) {
    const Partition& found = plan.infinitesimal->partition;
    picture.facts.emplace_back("Sets that can begin to move",
                               (found.has_all ? "" : "more than ") + std::to_string(found.solution_count));
    add(found.has_all ? "of these stopped later" : "of those looked at stopped later",
        plan.infinitesimal->stopped.size());
    for (std::size_t k = 0; k < plan.infinitesimal->stopped.size() && k < most_stops_named; ++k) {
      const StoppedMotion& stop = plan.infinitesimal->stopped[k];
      const Solution& solution = found.solutions[stop.solution];
      picture.facts.emplace_back(
          names_of(solution.movable[stop.movable], parts) + " along " + direction_text(solution.direction),
          parts[stop.stops[0][0]].name + " would meet " + parts[stop.stops[0][1]].name);
    }
  }
  if (plan.disassembly) {
    add("Steps", plan.disassembly->steps.size());
    picture.facts.emplace_back("Comes apart", plan.disassembly->is_complete() ? "altogether" : "not altogether");
  }
}

}  // namespace

void write_assembly_page(Parts parts, const AssemblyPlan& plan, const Target& target, const Options& options,
                         const Context& context) {
  PlanPicture picture;
  picture.title = planar_title(options);
  for (const AssemblyPart& part : parts) picture.parts.push_back(drawn(part, context));
  Graphs graphs(picture.graphs);
  if (plan.disassembly) add_sequence(plan, graphs, picture);
  add_facts(parts, plan, picture);
  if (plan.space) {
    const MotionCounts& counts = plan.partition->cells;
    if (counts.vertices + counts.edges + counts.faces <= most_cells_shown) {
      const CellGraphs numbers = graphs_of_cells(*plan.space, graphs, context);
      add_sphere(parts, *plan.space, numbers, picture);
    } else {
      picture.facts.emplace_back("Sphere of directions", "too many cells to show");
    }
  }
  write_target(target, [&](std::ostream& out) { write_plan_page(out, picture); });
}

}  // namespace quoin::cli
