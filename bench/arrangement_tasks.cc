// SPDX-License-Identifier: Apache-2.0
#include "arrangement_tasks.h"

#include <memory>
#include <stdexcept>

#include "quoin/arrangement/circular/circular_polygon_set.h"
#include "quoin/arrangement/circular/circular_shapes.h"
#include "quoin/arrangement/geodesic/geodesic_polygon_set.h"
#include "quoin/arrangement/linear/linear_location.h"
#include "quoin/arrangement/linear/linear_polygon_set.h"
#include "quoin/arrangement/sets/planar_minkowski.h"

namespace bench {

namespace {

using quoin::CircularFamily;
using quoin::Context;
using quoin::GeodesicFamily;
using quoin::LinearFamily;
using quoin::PieceList;
using quoin::Point2;
using quoin::Vector3;

Point2 point_at(std::span<const std::int64_t> numbers, std::size_t i) {
  return {static_cast<double>(numbers[2 * i]), static_cast<double>(numbers[2 * i + 1])};
}
Vector3 vector_at(std::span<const std::int64_t> numbers, std::size_t i) {
  return {static_cast<double>(numbers[3 * i]), static_cast<double>(numbers[3 * i + 1]),
          static_cast<double>(numbers[3 * i + 2])};
}

void add(LinearFamily& family, PieceList<LinearFamily>& list, const Input& input) {
  for (std::size_t i = 0; i < input.size(); ++i) {
    family.add_segment(list, point_at(input[i], 0), point_at(input[i], 1));
  }
}
void add(CircularFamily& family, PieceList<CircularFamily>& list, const Input& input) {
  for (std::size_t i = 0; i < input.size(); ++i) {
    family.add_circle(list, point_at(input[i], 0), static_cast<double>(input[i][2]));
  }
}
void add(GeodesicFamily& family, PieceList<GeodesicFamily>& list, const Input& input) {
  for (std::size_t i = 0; i < input.size(); ++i) {
    if (input.kind == "great_circles") {
      family.add_great_circle(list, vector_at(input[i], 0));
    } else {
      family.add_arc(list, vector_at(input[i], 0), vector_at(input[i], 1));
    }
  }
}

std::vector<Input> read_all(const Task& task) {
  std::vector<Input> inputs;
  for (const std::string& file : task.files) inputs.push_back(arrangement_input::read(file));
  return inputs;
}

/// Adding the curves is part of the time: supports and pieces are made there.
template <class F>
void arrange_with(const std::vector<Input>& inputs, const Task& task) {
  const Context context(context_options(task));
  Best best;
  quoin::dcel::Counts counts;
  for (int round = 0; round < task.rounds; ++round) {
    best.start();
    F family;
    PieceList<F> list;
    for (const Input& input : inputs) add(family, list, input);
    const quoin::Arrangement<F> result = quoin::arrange(std::move(family), std::move(list), context);
    best.stop();
    counts = result.counts();
  }
  report(best, counts);
}

quoin::LinearPolygonSet polygon(const Input& input, std::size_t i, const Context& context) {
  LinearFamily family;
  PieceList<LinearFamily> list;
  std::vector<Point2> ring;
  for (std::size_t k = 0; 2 * k < input[i].size(); ++k) ring.push_back(point_at(input[i], k));
  family.add_polyline(list, ring, true);
  const std::uint32_t operand = 0;
  return combine_rings(std::move(family), list, {&operand, 1}, 1, quoin::FillRule::nonzero, quoin::SetOperation::unite,
                       context);
}

double area_of(const quoin::LinearPolygonSet& set) {
  return area(set).to_double();
}
double area_of(const quoin::CircularPolygonSet& set) {
  const auto& a = set.arrangement();
  double sum = 0;
  for (std::size_t e = 0; e < a.edge_count(); ++e) {
    const quoin::dcel::EdgeId id(e);
    const bool below = set.contains(a.cells().face(quoin::dcel::HalfedgeId(id, true)));
    const double part = area_under(a.family(), a.branch(id), a.left_point(id), a.right_point(id)).value;
    sum += below ? part : -part;
  }
  return sum;
}

template <class F>
void report_set(const Best& best, const quoin::PolygonSet<F>& set) {
  std::size_t holes = 0;
  const auto polygons = polygons_of(set);
  for (const quoin::PolygonWithHoles& part : polygons) holes += part.holes.size();
  report(best, set.arrangement().counts(),
         member("parts", static_cast<double>(polygons.size())) + member("holes", static_cast<double>(holes)) +
             member("area", area_of(set)));
}

template <class F, class Add>
void unite_with(const Input& input, const Task& task, const Add& add_ring) {
  const Context context(context_options(task));
  Best best;
  quoin::PolygonSet<F> result;
  for (int round = 0; round < task.rounds; ++round) {
    best.start();
    F family;
    PieceList<F> list;
    std::vector<std::uint32_t> operands;
    for (std::size_t i = 0; i < input.size(); ++i) {
      add_ring(family, list, i);
      operands.push_back(static_cast<std::uint32_t>(i));
    }
    result = combine_rings(std::move(family), list, operands, static_cast<std::uint32_t>(input.size()),
                           quoin::FillRule::nonzero, quoin::SetOperation::unite, context);
    best.stop();
  }
  report_set(best, result);
}

template <class Locator>
void locate_by(const quoin::LinearArrangement& arrangement, const Input& queries, const Task& task) {
  const Context context(context_options(task));
  std::vector<quoin::LinearPoint> points;
  for (std::size_t i = 0; i < queries.size(); ++i) points.push_back(LinearFamily::point(point_at(queries[i], 0)));
  Best built;
  Best asked;
  std::vector<quoin::Location> found(points.size());
  for (int round = 0; round < task.rounds; ++round) {
    built.start();
    const Locator locator(arrangement, context);
    built.stop();
    asked.start();
    for (std::size_t i = 0; i < points.size(); ++i) found[i] = locator.locate(points[i]);
    asked.stop();
  }
  const quoin::dcel::Dcel& cells = arrangement.cells();
  std::vector<double> size(cells.faces.size(), 0);  // halfedges of the outer boundary
  for (std::size_t h = 0; h < cells.halfedges.size(); ++h) {
    const quoin::dcel::HalfedgeId id(h);
    if (cells[cells[id].boundary].is_outer) ++size[cells.face(id).index()];
  }
  double vertices = 0;
  double edges = 0;
  double unbounded = 0;
  double boundary = 0;
  for (const quoin::Location& location : found) {
    vertices += location.is_vertex() ? 1 : 0;
    edges += location.is_edge() ? 1 : 0;
    if (!location.is_face()) continue;
    const bool is_outside = cells[location.face()].is_unbounded;
    unbounded += is_outside ? 1 : 0;
    boundary += is_outside ? 0 : size[location.face().index()];
  }
  report(asked, arrangement.counts(),
         member("build_seconds", built.seconds()) + member("build_cpu_seconds", built.cpu_seconds()) +
             member("on_vertices", vertices) + member("on_edges", edges) + member("unbounded", unbounded) +
             member("boundary", boundary));
}

quoin::LinearArrangement arrangement_of(const Input& input, const Context& context) {
  LinearFamily family;
  PieceList<LinearFamily> list;
  add(family, list, input);
  return quoin::arrange(std::move(family), list, context);
}

}  // namespace

void arrange(const Task& task) {
  const std::vector<Input> inputs = read_all(task);
  if (inputs.empty()) throw std::runtime_error("a file, please");
  if (inputs[0].kind == "segments") return arrange_with<LinearFamily>(inputs, task);
  if (inputs[0].kind == "circles") return arrange_with<CircularFamily>(inputs, task);
  arrange_with<GeodesicFamily>(inputs, task);
}

void overlay(const Task& task) {
  const Context context(context_options(task));
  const std::vector<Input> inputs = read_all(task);
  std::vector<quoin::LinearArrangement> sources;
  for (const Input& input : inputs) sources.push_back(arrangement_of(input, context));
  std::vector<const quoin::LinearArrangement*> pointers;
  for (const quoin::LinearArrangement& source : sources) pointers.push_back(&source);
  Best best;
  quoin::dcel::Counts counts;
  for (int round = 0; round < task.rounds; ++round) {
    best.start();
    const auto result = quoin::overlay<LinearFamily>(pointers, context);
    best.stop();
    counts = result.arrangement().counts();
  }
  report(best, counts);
}

void unite(const Task& task) {
  const Input input = arrangement_input::read(task.files.at(0));
  if (input.kind == "circles") {
    return unite_with<CircularFamily>(input, task, [&](CircularFamily& family, auto& list, std::size_t i) {
      family.add_circle(list, point_at(input[i], 0), static_cast<double>(input[i][2]));
    });
  }
  std::vector<Point2> ring;
  unite_with<LinearFamily>(input, task, [&](LinearFamily& family, auto& list, std::size_t i) {
    ring.clear();
    for (std::size_t k = 0; 2 * k < input[i].size(); ++k) ring.push_back(point_at(input[i], k));
    family.add_polyline(list, ring, true);
  });
}

void locate(const Task& task) {
  const Context context(context_options(task));
  const quoin::LinearArrangement arrangement = arrangement_of(arrangement_input::read(task.files.at(0)), context);
  const Input queries = arrangement_input::read(task.files.at(1));
  if (task.strategy == "ric") return locate_by<quoin::TrapezoidLocator<LinearFamily>>(arrangement, queries, task);
  locate_by<quoin::GridLocator<LinearFamily>>(arrangement, queries, task);
}

void minkowski(const Task& task) {
  const Context context(context_options(task));
  const quoin::LinearPolygonSet a = polygon(arrangement_input::read(task.files.at(0)), 0, context);
  const quoin::LinearPolygonSet b = polygon(arrangement_input::read(task.files.at(1)), 0, context);
  Best best;
  quoin::LinearPolygonSet sum;
  for (int round = 0; round < task.rounds; ++round) {
    best.start();
    sum = minkowski_sum(a, b, {}, context).sum;
    best.stop();
  }
  report_set(best, sum);
}

}  // namespace bench
