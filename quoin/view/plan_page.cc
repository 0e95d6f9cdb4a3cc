// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/plan_page.h"

#include "quoin/base/error.h"
#include "quoin/view/built_templates.h"
#include "quoin/view/page.h"
#include "quoin/view/page_text.h"
#include "quoin/view/sphere_page.h"

namespace quoin {

namespace {

using page_text::write_json_list;
using page_text::write_json_string;
using page_text::write_number;

template <class Numbers>
void write_numbers(std::ostream& out, const Numbers& numbers) {
  write_json_list(out, numbers, [&](const auto number) { write_number(out, number); });
}

/// All numbers of a list of small arrays, one after the other.
template <class Rows, class Write>
void write_flat(std::ostream& out, const Rows& rows, const Write& write) {
  out << '[';
  const char* separator = "";
  for (const auto& row : rows) {
    out << separator;
    write(row);
    separator = ",";
  }
  out << ']';
}

void write_part(std::ostream& out, const PlanPart& part) {
  const auto write_indices = [&](const auto& row) {
    for (std::size_t k = 0; k < row.size(); ++k) {
      if (k > 0) out << ',';
      write_number(out, row[k]);
    }
  };
  out << "{\"name\":";
  write_json_string(out, part.name);
  out << ",\"vertices\":";
  write_flat(out, part.vertices, [&](const Point3& p) { write_indices(std::array{p.x, p.y, p.z}); });
  out << ",\"triangles\":";
  write_flat(out, part.triangles, write_indices);
  out << ",\"edges\":";
  write_flat(out, part.edges, write_indices);
  out << '}';
}

void write_state_number(std::ostream& out, std::uint32_t state) {
  if (state == PlanMove::no_state) {
    out << "null";
  } else {
    write_number(out, state);
  }
}

void write_move(std::ostream& out, const PlanMove& move) {
  out << "{\"moving\":";
  write_numbers(out, move.moving);
  out << ",\"direction\":";
  write_numbers(out, std::array{move.direction.x, move.direction.y, move.direction.z});
  out << ",\"exact\":";
  write_json_string(out, move.exact);
  out << ",\"graph\":";
  write_number(out, move.graph);
  out << ",\"moved\":";
  write_state_number(out, move.moved_state);
  out << ",\"rest\":";
  write_state_number(out, move.rest_state);
  out << '}';
}

void write_state(std::ostream& out, const PlanState& state) {
  out << "{\"parts\":";
  write_numbers(out, state.parts);
  out << ",\"moves\":";
  write_json_list(out, state.moves, [&](const PlanMove& move) { write_move(out, move); });
  out << ",\"sought\":" << (state.is_sought ? "true" : "false") << '}';
}

void write_graph(std::ostream& out, const PlanGraph& graph) {
  out << "{\"arcs\":";
  write_json_list(out, graph.arcs, [&](const auto& arc) { write_numbers(out, arc); });
  out << ",\"movable\":";
  write_json_list(out, graph.movable, [&](const auto& set) { write_numbers(out, set); });
  out << '}';
}

void write_plan(std::ostream& out, const PlanPicture& picture) {
  out << "<script type=\"application/json\" id=\"quoin-plan\">{\"format\":\"quoin-plan\",\"version\":1,\"title\":";
  write_json_string(out, picture.title);
  out << ",\"facts\":";
  page_text::write_json_facts(out, picture.facts);
  out << ",\n\"parts\":";
  write_json_list(out, picture.parts, [&](const PlanPart& part) { write_part(out, part); });
  out << ",\n\"states\":";
  write_json_list(out, picture.states, [&](const PlanState& state) { write_state(out, state); });
  out << ",\n\"steps\":";
  write_json_list(out, picture.steps, [&](const auto& step) { write_numbers(out, step); });
  out << ",\"interlocked\":";
  write_numbers(out, picture.interlocked);
  out << ",\n\"graphs\":";
  write_json_list(out, picture.graphs, [&](const PlanGraph& graph) { write_graph(out, graph); });
  out << ",\n\"cellGraphs\":{\"face\":";
  write_numbers(out, picture.face_graphs);
  out << ",\"edge\":";
  write_numbers(out, picture.edge_graphs);
  out << ",\"point\":";
  write_numbers(out, picture.point_graphs);
  out << "}}</script>\n";
}

}  // namespace

void write_plan_page(std::ostream& out, const PlanPicture& picture) {
  if (!has_view()) throw Error("the browser view was not built into this quoin (configure with -DQUOIN_VIEW=ON)");
  write_plan_page(out, picture, built_plan_template());
}

void write_plan_page(std::ostream& out, const PlanPicture& picture, std::string_view page_template) {
  const page_text::Template page = page_text::split_template(page_template);
  check_plan(picture);
  out << page.before_title;
  page_text::write_title(out, picture.title);
  out << page.before_scene;
  write_plan(out, picture);
  write_sphere_blocks(out, picture.sphere);
  out << page.rest;
}

}  // namespace quoin
