// SPDX-License-Identifier: Apache-2.0
// Times queries of how a polytope lies to another one as it moves: a million places on a path around and through it,
// with the hint of the last query and without. Arguments are frequencies of the geodesic spheres that it is of;
// counters say how many facets the body of translations has, and how many steps a query took.
#include <benchmark/benchmark.h>

#include <cmath>
#include <map>
#include <memory>
#include <vector>

#include "quoin/polytope/proximity_queries.h"
#include "quoin/solid/shapes.h"

namespace {

const quoin::Context one_thread({.threads = 1});
constexpr int places = 1000000;

quoin::Polytope sphere(std::size_t frequency, double degrees) {
  quoin::Mesh mesh = quoin::shapes::geodesic_sphere(frequency);
  const double angle = degrees * 0.017453292519943295;
  mesh = quoin::shapes::rotated(mesh, quoin::shapes::Axis::x, angle);
  mesh = quoin::shapes::rotated(mesh, quoin::shapes::Axis::z, angle);
  return quoin::Polytope::hull_of(mesh.vertices, one_thread);
}

const quoin::ProximityQueries& queries_of(std::size_t frequency) {
  static std::map<std::size_t, std::unique_ptr<quoin::ProximityQueries>> made;
  auto& queries = made[frequency];
  if (!queries) {
    queries = std::make_unique<quoin::ProximityQueries>(sphere(frequency, 0), sphere(frequency, 3), one_thread);
  }
  return *queries;
}

/// Many times around, nearer and further, so that a third of the places overlap.
std::vector<quoin::Vector3> path() {
  std::vector<quoin::Vector3> result;
  for (int i = 0; i < places; ++i) {
    const double angle = 0.001 * i;
    const double radius = 2.2 + 0.6 * std::sin(0.37 * angle);
    const double height = std::sin(0.11 * angle);
    const double flat = std::sqrt(1 - height * height);
    result.push_back({radius * flat * std::cos(angle), radius * flat * std::sin(angle), radius * height});
  }
  return result;
}

template <class Ask>
void run(benchmark::State& state, bool is_coherent, const Ask& ask) {
  const quoin::ProximityQueries& queries = queries_of(static_cast<std::size_t>(state.range(0)));
  const std::vector<quoin::Vector3> translations = path();
  std::uint64_t steps = 0;
  for (auto _ : state) {
    quoin::ProximityHint hint;
    for (const quoin::Vector3& t : translations) {
      if (!is_coherent) hint.facet = hint.exit = quoin::ProximityHint::none;
      ask(queries, t, hint);
    }
    steps = hint.steps;
  }
  state.counters["facets"] = static_cast<double>(queries.body().facet_count());
  state.counters["steps"] = static_cast<double>(steps) / places;
  state.counters["per_query"] = benchmark::Counter(static_cast<double>(state.iterations()) * places,
                                                   benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void relation(benchmark::State& state, bool is_coherent) {
  run(state, is_coherent,
      [](const auto& queries, const auto& t, auto& hint) { benchmark::DoNotOptimize(queries.relation(t, hint)); });
}
void nearest(benchmark::State& state, bool is_coherent) {
  run(state, is_coherent,
      [](const auto& queries, const auto& t, auto& hint) { benchmark::DoNotOptimize(queries.nearest(t, hint)); });
}
void penetration(benchmark::State& state, bool is_coherent) {
  run(state, is_coherent, [](const auto& queries, const auto& t, auto& hint) {
    benchmark::DoNotOptimize(queries.penetration(t, {0, 0.5, 1}, hint));
  });
}
void build(benchmark::State& state) {
  const auto frequency = static_cast<std::size_t>(state.range(0));
  const quoin::Polytope first = sphere(frequency, 0);
  const quoin::Polytope second = sphere(frequency, 3);
  for (auto _ : state) benchmark::DoNotOptimize(quoin::ProximityQueries(first, second, one_thread));
}

void sizes(benchmark::internal::Benchmark* bench) {
  bench->Arg(3)->Arg(9)->Arg(29)->Unit(benchmark::kMillisecond);
}

BENCHMARK_CAPTURE(relation, with_hint, true)->Apply(sizes);
BENCHMARK_CAPTURE(relation, without, false)->Apply(sizes);
BENCHMARK_CAPTURE(nearest, with_hint, true)->Apply(sizes);
BENCHMARK_CAPTURE(nearest, without, false)->Apply(sizes);
BENCHMARK_CAPTURE(penetration, with_hint, true)->Apply(sizes);
BENCHMARK(build)->Apply(sizes);

}  // namespace

BENCHMARK_MAIN();
