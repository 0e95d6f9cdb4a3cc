// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/assembly_report.h"

#include <array>
#include <cmath>

namespace quoin::cli {

namespace {

using Json = nlohmann::ordered_json;
using Parts = std::span<const AssemblyPart>;

constexpr std::size_t most_lines = 40;

Json names_of(const PartSet& set, Parts parts) {
  Json names = Json::array();
  for (const std::uint32_t part : set.members()) names.push_back(parts[part].name);
  return names;
}

Json point(const Point3& p) {
  return {p.x, p.y, p.z};
}

void add_direction(const SphereDirection& direction, Json& to) {
  to["direction"] = rounded_direction(direction);
  to["exact"] = {direction.integer(0).to_string(), direction.integer(1).to_string(), direction.integer(2).to_string()};
}

Json describe_parts(Parts parts) {
  Json list = Json::array();
  for (const AssemblyPart& part : parts) {
    list.push_back({{"name", part.name},
                    {"pieces", part.pieces.size()},
                    {"bounds", {point(part.box.low()), point(part.box.high())}}});
  }
  return list;
}

Json describe_solutions(const Partition& partition, Parts parts) {
  Json list = Json::array();
  for (const Solution& solution : partition.solutions) {
    for (const PartSet& moving : solution.movable) {
      Json one;
      add_direction(solution.direction, one);
      one["cell"] = name_of(solution.cell.kind);
      one["cell_id"] = solution.cell.id;
      one["move"] = names_of(moving, parts);
      list.push_back(std::move(one));
    }
  }
  return list;
}

void add_counts(const Partition& partition, Json& to) {
  to["motion_space"] = {
      {"vertices", partition.cells.vertices}, {"edges", partition.cells.edges}, {"faces", partition.cells.faces}};
  to["solution_cells"] = partition.solution_cells;
  to["solution_count"] = partition.solution_count;
  to["all_listed"] = partition.has_all;
}

Json describe(const InfinitesimalFreedom& freedom, Parts parts) {
  Json json;
  add_counts(freedom.partition, json);
  json["solutions"] = describe_solutions(freedom.partition, parts);
  Json stopped = Json::array();
  for (const StoppedMotion& stop : freedom.stopped) {
    const Solution& solution = freedom.partition.solutions[stop.solution];
    Json one;
    add_direction(solution.direction, one);
    one["cell"] = name_of(solution.cell.kind);
    one["move"] = names_of(solution.movable[stop.movable], parts);
    Json stops = Json::array();
    for (const auto& [moving, met] : stop.stops) stops.push_back({parts[moving].name, parts[met].name});
    one["stopped_by"] = std::move(stops);
    stopped.push_back(std::move(one));
  }
  json["stopped"] = std::move(stopped);
  return json;
}

Json number_or_null(std::uint32_t state) {
  return state == DisassemblyMove::no_state ? Json() : Json(state);
}

Json describe(const DisassemblyMove& move, Parts parts) {
  Json json{{"move", names_of(move.moving, parts)}};
  add_direction(move.direction, json);
  return json;
}

Json describe(const Disassembly& disassembly, Parts parts) {
  Json json{{"complete", disassembly.is_complete()}};
  Json steps = Json::array();
  for (const Disassembly::Step& step : disassembly.steps) {
    const DisassemblyState& state = disassembly.states[step.state];
    Json one = describe(state.moves[step.move], parts);
    one["from"] = names_of(state.parts, parts);
    one["state"] = step.state;
    steps.push_back(std::move(one));
  }
  json["steps"] = std::move(steps);
  Json interlocked = Json::array();
  for (const std::uint32_t state : disassembly.interlocked)
    interlocked.push_back(names_of(disassembly.states[state].parts, parts));
  json["interlocked"] = std::move(interlocked);
  Json states = Json::array();
  for (const DisassemblyState& state : disassembly.states) {
    Json moves = Json::array();
    for (const DisassemblyMove& move : state.moves) {
      Json one = describe(move, parts);
      one["moved_state"] = number_or_null(move.moved);
      one["rest_state"] = number_or_null(move.rest);
      moves.push_back(std::move(one));
    }
    states.push_back({{"parts", names_of(state.parts, parts)},
                      {"moves", std::move(moves)},
                      {"sought", state.is_expanded},
                      {"all_moves", state.has_all_moves}});
  }
  json["states"] = std::move(states);
  return json;
}

Json describe(const PhaseTimes& times) {
  return {{"maps", times.maps},
          {"reflections", times.reflections},
          {"sums", times.sums},
          {"projections", times.projections},
          {"unions", times.unions},
          {"motion_space", times.motion_space},
          {"processing", times.processing}};
}

std::string list_of(const PartSet& set, Parts parts) {
  std::string text;
  for (const std::uint32_t part : set.members()) text += (text.empty() ? "" : " ") + parts[part].name;
  return text;
}

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

/// Of sets found, before their number.
std::string at_least(const Partition& partition) {
  return partition.has_all ? "" : "more than ";
}

std::string text_of(const Partition& partition, Parts parts) {
  std::string text = "motion space: " + counted(partition.cells.vertices, "vertex", "vertices") + ", " +
                     counted(partition.cells.edges, "edge", "edges") + ", " +
                     counted(partition.cells.faces, "face", "faces") + "\n";
  if (parts.size() < 2) return text + "one part has nothing to leave\n";
  if (partition.is_interlocked()) return text + "interlocked: no set of parts can move away from the others\n";
  text += at_least(partition) + counted(partition.solution_count, "solution", "solutions") + " in " +
          counted(partition.solution_cells, "cell", "cells") + "\n";
  std::size_t lines = 0;
  for (const Solution& solution : partition.solutions) {
    for (const PartSet& moving : solution.movable) {
      if (++lines > most_lines) continue;
      text += "  " + std::string(name_of(solution.cell.kind)) + " " + direction_text(solution.direction) + ": " +
              list_of(moving, parts) + "\n";
    }
  }
  if (lines > most_lines) text += "  and " + std::to_string(lines - most_lines) + " more (see --json)\n";
  return text;
}

std::string text_of(const InfinitesimalFreedom& freedom, Parts parts) {
  const Partition& found = freedom.partition;
  std::string text = "can begin to move: " + at_least(found) + counted(found.solution_count, "set", "sets") + " in " +
                     counted(found.solution_cells, "cell", "cells") + "; of " +
                     (found.has_all ? "these" : "those looked at") +
                     " are stopped later: " + std::to_string(freedom.stopped.size()) + "\n";
  for (std::size_t k = 0; k < freedom.stopped.size() && k < most_lines; ++k) {
    const StoppedMotion& stop = freedom.stopped[k];
    const Solution& solution = found.solutions[stop.solution];
    text += "  " + std::string(name_of(solution.cell.kind)) + " " + direction_text(solution.direction) + ": " +
            list_of(solution.movable[stop.movable], parts) + ", stopped where " + parts[stop.stops[0][0]].name +
            " meets " + parts[stop.stops[0][1]].name + "\n";
  }
  return text;
}

std::string text_of(const Disassembly& disassembly, Parts parts) {
  std::string text = "sequence:\n";
  for (std::size_t k = 0; k < disassembly.steps.size(); ++k) {
    const Disassembly::Step& step = disassembly.steps[k];
    const DisassemblyState& state = disassembly.states[step.state];
    const DisassemblyMove& move = state.moves[step.move];
    text += "  " + std::to_string(k + 1) + ". " + direction_text(move.direction) + ": " + list_of(move.moving, parts) +
            " from " + list_of(state.parts.without(move.moving), parts) + "\n";
  }
  for (const std::uint32_t state : disassembly.interlocked)
    text += "  interlocked: " + list_of(disassembly.states[state].parts, parts) + "\n";
  return text;
}

}  // namespace

const char* name_of(MotionCell::Kind kind) {
  switch (kind) {
    case MotionCell::Kind::vertex:
      return "vertex";
    case MotionCell::Kind::edge:
      return "edge";
    case MotionCell::Kind::face:
      break;
  }
  return "face";
}

std::string direction_text(const SphereDirection& direction) {
  return "(" + direction.integer(0).to_string() + ", " + direction.integer(1).to_string() + ", " +
         direction.integer(2).to_string() + ")";
}

std::array<double, 3> rounded_direction(const SphereDirection& direction) {
  std::array<double, 3> result{};
  if (direction.bits() <= 53) {
    for (std::size_t axis = 0; axis < 3; ++axis) result[axis] = Rational(direction.integer(axis)).to_double();
    return result;
  }
  const Integer scale = Integer(1) << direction.bits();
  for (std::size_t axis = 0; axis < 3; ++axis) result[axis] = Rational(direction.integer(axis), scale).to_double();
  const double length = std::hypot(result[0], result[1], result[2]);
  for (double& component : result) component /= length;
  return result;
}

Json assembly_report(Parts parts, const AssemblyPlan& plan) {
  Json report{{"parts", describe_parts(parts)}};
  const SumCounts& sums = plan.pairs.counts;
  report["sums"] = {{"total", sums.total()},
                    {"facet", sums.facet},
                    {"edge", sums.edge},
                    {"vertex", sums.vertex},
                    {"separated", sums.separated}};
  if (plan.partition) {
    add_counts(*plan.partition, report);
    report["interlocked"] = parts.size() > 1 && plan.partition->is_interlocked();
    report["solutions"] = describe_solutions(*plan.partition, parts);
  }
  if (plan.infinitesimal) report["infinitesimal"] = describe(*plan.infinitesimal, parts);
  if (plan.disassembly) report["sequence"] = describe(*plan.disassembly, parts);
  report["seconds"] = describe(plan.times);
  return report;
}

std::string assembly_text(Parts parts, const AssemblyPlan& plan) {
  const SumCounts& sums = plan.pairs.counts;
  std::string text = counted(parts.size(), "part", "parts") + ", " + counted(sums.total(), "sum", "sums") +
                     " of pieces: origin on a facet " + std::to_string(sums.facet) + ", an edge " +
                     std::to_string(sums.edge) + ", a vertex " + std::to_string(sums.vertex) + ", apart " +
                     std::to_string(sums.separated) + "\n";
  if (plan.partition) text += text_of(*plan.partition, parts);
  if (plan.infinitesimal) text += text_of(*plan.infinitesimal, parts);
  if (plan.disassembly) text += text_of(*plan.disassembly, parts);
  return text;
}

}  // namespace quoin::cli
