// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <sstream>

#include "quoin/arrangement/circular/circular_arrangement.h"
#include "quoin/arrangement/circular/circular_location.h"
#include "quoin/arrangement/circular/circular_polygon_set.h"
#include "quoin/arrangement/linear/linear_location.h"
#include "quoin/arrangement/linear/linear_polygon_set.h"
#include "quoin/cli/commands.h"
#include "quoin/cli/exact_targets.h"
#include "quoin/cli/failure.h"
#include "quoin/cli/planar.h"
#include "quoin/cli/planar_pictures.h"
#include "quoin/cli/point_queries.h"
#include "quoin/io/drawing_curves.h"

namespace quoin::cli {

namespace {

using Json = nlohmann::ordered_json;

/// An arrangement of one or more drawings, and the names of its curves.
template <class F>
struct NamedArrangement {
  Arrangement<F> arrangement;
  std::vector<std::string> names;
};

template <class F>
void add_inputs(F& family, PieceList<F>& list, std::span<const PlanarInput> inputs, std::vector<std::string>& names) {
  for (const PlanarInput& input : inputs) {
    const std::size_t first = names.size();
    try {
      add_input(family, list, input, names);
    } catch (const InputError& error) {
      throw InputError(input.name + ": " + error.what());
    }
    if (inputs.size() == 1) continue;
    for (std::size_t i = first; i < names.size(); ++i) names[i] = input.name + ": " + names[i];
  }
}

template <class F>
NamedArrangement<F> arrange_drawings(std::span<const PlanarInput> inputs, const Context& context) {
  F family;
  PieceList<F> list;
  NamedArrangement<F> result;
  add_inputs(family, list, inputs, result.names);
  result.arrangement = arrange(std::move(family), list, context);
  return result;
}

Json as_json(const dcel::Counts& counts) {
  return {{"vertices", counts.vertices},
          {"edges", counts.edges},
          {"faces", counts.faces},
          {"components", counts.components},
          {"isolated_vertices", counts.isolated_vertices},
          {"unbounded_faces", counts.unbounded_faces}};
}

std::string as_text(const dcel::Counts& counts) {
  std::ostringstream out;
  out << counts.vertices << " vertices, " << counts.edges << " edges, " << counts.faces << " faces, "
      << counts.components << " components\n";
  return out.str();
}

template <class F>
int arrange_with(std::span<const PlanarInput> inputs, std::vector<std::string>& warnings, const Options& options,
                 const Context& context) {
  const NamedArrangement<F> made = arrange_drawings<F>(inputs, context);
  const dcel::Counts counts = made.arrangement.counts();
  Json json = as_json(counts);
  json["curves"] = made.arrangement.curve_count();
  write_pictures(made.arrangement, made.names, {}, options);
  write_exact_targets(made.arrangement, made.names, options);
  print_report(std::move(json), as_text(counts), warnings, options);
  return 0;
}

/// Counts how cells of an overlay of two come about.
template <class F>
class CaseCounter : public OverlayVisitor<F> {
 public:
  static constexpr std::array names{
      "vertex_on_vertex", "vertex_on_edge", "edge_on_vertex", "vertex_in_face",   "face_around_vertex",
      "crossing",         "overlap",        "edge_in_face",   "face_around_edge", "face"};
  std::array<std::size_t, 10> counts{};

  void vertex_on_vertex(dcel::VertexId, dcel::VertexId, dcel::VertexId) override { ++counts[0]; }
  void vertex_on_edge(dcel::VertexId, dcel::VertexId, dcel::EdgeId) override { ++counts[1]; }
  void edge_on_vertex(dcel::VertexId, dcel::EdgeId, dcel::VertexId) override { ++counts[2]; }
  void vertex_in_face(dcel::VertexId, dcel::VertexId, dcel::FaceId) override { ++counts[3]; }
  void face_around_vertex(dcel::VertexId, dcel::FaceId, dcel::VertexId) override { ++counts[4]; }
  void crossing(dcel::VertexId, dcel::EdgeId, dcel::EdgeId) override { ++counts[5]; }
  void overlap(dcel::EdgeId, dcel::EdgeId, dcel::EdgeId) override { ++counts[6]; }
  void edge_in_face(dcel::EdgeId, dcel::EdgeId, dcel::FaceId) override { ++counts[7]; }
  void face_around_edge(dcel::EdgeId, dcel::FaceId, dcel::EdgeId) override { ++counts[8]; }
  void face(dcel::FaceId, dcel::FaceId, dcel::FaceId) override { ++counts[9]; }
};

template <class F>
int overlay_with(std::span<const PlanarInput> inputs, std::vector<std::string>& warnings, const Options& options,
                 const Context& context) {
  std::vector<NamedArrangement<F>> sources;
  std::vector<std::string> names;
  for (const PlanarInput& input : inputs) {
    sources.push_back(arrange_drawings<F>({&input, 1}, context));
    for (const std::string& name : sources.back().names) names.push_back(input.name + ": " + name);
  }
  std::vector<const Arrangement<F>*> pointers;
  for (const NamedArrangement<F>& source : sources) pointers.push_back(&source.arrangement);
  const Overlay<F> all = overlay<F>(pointers, context);
  const dcel::Counts counts = all.arrangement().counts();
  Json json = as_json(counts);
  json["sources"] = Json::array();
  for (const NamedArrangement<F>& source : sources) json["sources"].push_back(as_json(source.arrangement.counts()));
  if (sources.size() == 2) {
    CaseCounter<F> cases;
    visit_cells(all, cases);
    for (std::size_t i = 0; i < cases.counts.size(); ++i) json["cells"][CaseCounter<F>::names[i]] = cases.counts[i];
  }
  // A face of the overlay shows the faces it comes from.
  const auto face_label = [&](dcel::FaceId f) {
    std::string label;
    for (std::size_t i = 0; i < sources.size(); ++i) {
      label += (i > 0 ? "/" : "") + std::to_string(all.source(f, i).id);
    }
    return label;
  };
  write_pictures(all.arrangement(), names, face_label, options);
  write_exact_targets(all.arrangement(), names, options);
  print_report(std::move(json), as_text(counts), warnings, options);
  return 0;
}

RationalPoint2 point_of(const Query& query) {
  return {query.numbers[0], query.numbers[1]};
}

const char* kind_of(const Location& location) {
  return location.is_vertex() ? "vertex" : location.is_edge() ? "edge" : "face";
}

template <class F>
int locate_with(std::span<const PlanarInput> inputs, const std::vector<Query>& queries,
                std::vector<std::string>& warnings, const Options& options, const Context& context) {
  F family;
  PieceList<F> list;
  std::vector<std::string> names;
  add_inputs(family, list, inputs, names);
  std::vector<typename F::Point> points;
  for (const Query& query : queries) points.push_back(family.point(point_of(query)));
  const Arrangement<F> arrangement = arrange(std::move(family), list, context);
  const std::vector<Location> found = locate_batch(arrangement, std::span<const typename F::Point>(points), context);
  Json json{{"points", Json::array()}};
  std::string text;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    Json one{{"point", {queries[i].numbers[0].to_double(), queries[i].numbers[1].to_double()}},
             {"cell", kind_of(found[i])},
             {"id", found[i].index()}};
    if (found[i].is_edge()) {
      one["curves"] = Json::array();
      for (const CurveUse use : arrangement.curves(found[i].edge())) {
        one["curves"].push_back(names[use.curve().index()]);
      }
    }
    if (found[i].is_face()) one["unbounded"] = arrangement.cells()[found[i].face()].is_unbounded;
    text += queries[i].text + ": " + kind_of(found[i]) + " " + std::to_string(found[i].index()) + "\n";
    json["points"].push_back(std::move(one));
  }
  write_pictures(arrangement, names, {}, options);
  write_exact_targets(arrangement, names, options);
  print_report(std::move(json), text, warnings, options);
  return 0;
}

}  // namespace

int run_arrange(const Options& options, const Context& context) {
  if (options.sphere) return run_arrange_on_sphere(options, context);
  std::vector<std::string> warnings;
  const std::vector<PlanarInput> inputs = read_drawings(options, warnings, context);
  return any_arcs(inputs) ? arrange_with<CircularFamily>(inputs, warnings, options, context)
                          : arrange_with<LinearFamily>(inputs, warnings, options, context);
}

int run_overlay(const Options& options, const Context& context) {
  std::vector<std::string> warnings;
  const std::vector<PlanarInput> inputs = read_drawings(options, warnings, context);
  return any_arcs(inputs) ? overlay_with<CircularFamily>(inputs, warnings, options, context)
                          : overlay_with<LinearFamily>(inputs, warnings, options, context);
}

int run_locate(const Options& options, const Context& context) {
  if (options.points.empty() && options.points_file.empty())
    throw UsageError("nothing to locate: --point or --points is needed");
  const std::vector<Query> queries = point_queries(options, 2);
  std::vector<std::string> warnings;
  const std::vector<PlanarInput> inputs = read_drawings(options, warnings, context);
  return any_arcs(inputs) ? locate_with<CircularFamily>(inputs, queries, warnings, options, context)
                          : locate_with<LinearFamily>(inputs, queries, warnings, options, context);
}

}  // namespace quoin::cli
