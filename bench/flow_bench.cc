// SPDX-License-Identifier: Apache-2.0
// The flow complex of scans rounded to a grid, one thread: critical points, and how long tables, stable surfaces and
// unstable arcs take beside the triangulation.
// Usage: flow_bench [doubles] [memory] [points ...]; 2700, 12600 and 33700 if none are given; `doubles` leaves out the
// grid; `memory` prints memory instead, of one number of points.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "peak_memory.h"
#include "quoin/flow/flow_survey.h"

namespace {

using namespace quoin;

/// A bumpy closed surface in rings with noise, as a scanner sees it, rounded to a grid of 2000 steps.
std::vector<Point3> scan(std::size_t count, bool is_rounded) {
  std::mt19937_64 random(count);
  std::uniform_real_distribution<double> noise(-0.002, 0.002);
  std::vector<Point3> points;
  const double pi = std::acos(-1.0);
  const auto rings = static_cast<std::size_t>(std::sqrt(static_cast<double>(count) / 1.6));
  for (std::size_t i = 0; i < rings; ++i) {
    const double polar = pi * (static_cast<double>(i) + 0.5) / static_cast<double>(rings);
    const auto along = static_cast<std::size_t>(
        std::max(3.0, static_cast<double>(count) * std::sin(polar) * pi / 2 / static_cast<double>(rings)));
    for (std::size_t j = 0; j < along; ++j) {
      const double azimuth =
          2 * pi * (static_cast<double>(j) + 0.3 * static_cast<double>(i % 3)) / static_cast<double>(along);
      const double r = 0.8 + 0.1 * std::sin(5 * polar) * std::cos(4 * azimuth) + noise(random);
      const auto grid = [&](double x) { return is_rounded ? std::round(1000 * x) : x; };
      points.push_back({grid(r * std::sin(polar) * std::cos(azimuth)), grid(r * std::sin(polar) * std::sin(azimuth)),
                        grid(r * std::cos(polar))});
    }
  }
  return points;
}

class Clock {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    return seconds;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

double per(long kb, std::size_t points) {
  return 1024.0 * static_cast<double>(kb) / static_cast<double>(points);
}

void print(const char* name, const CrossingStatistics& crossings) {
  std::printf("; %zu comparisons, %zu %s not decided by doubles, %zu exact points of at most %zu bits\n",
              crossings.comparisons, crossings.undecided, name, crossings.exact_points, crossings.most_bits);
}

/// Largest memory so far, beyond the points.
void measure_memory(const std::vector<Point3>& points) {
  const Context context({.threads = 1});
  const long before = resident_kb();
  const Delaunay3 triangulation(points, context);
  const long with_triangulation = peak_kb() - before;
  const FlowCells flow(triangulation, context);
  const StableSurvey stable = survey_stable(flow, context);
  const UnstableSurvey unstable = survey_unstable(flow, context);
  const long with_all = peak_kb() - before;
  std::printf(
      "%zu points, %zu triangles, %zu ways: %.0f B per point for the triangulation, %.0f B with tables and ways, "
      "%.2f\n",
      points.size(), stable.triangles, unstable.segments.count(), per(with_triangulation, points.size()),
      per(with_all, points.size()), static_cast<double>(with_all) / static_cast<double>(with_triangulation));
}

void measure(const std::vector<Point3>& points) {
  const Context context({.threads = 1});
  Clock clock;
  double delaunay = 0;
  {
    const Delaunay3 unordered(points, context);
    delaunay = clock.lap();
  }
  const Delaunay3 triangulation(points, context, {.is_canonical = true});
  const double ordered = clock.lap();
  const FlowCells flow(triangulation, context);
  const double tables = clock.lap();
  const std::array<std::size_t, 4> c = flow.counts();
  const std::size_t n = triangulation.vertex_count();
  std::printf(
      "%zu points, %zu distinct: critical %zu %zu %zu %zu, sum %ld; D %.3f s, in canonical order %.2f D; tables "
      "%.3f s, %.2f D; %zu centre signs and %zu spheres not decided by doubles\n",
      points.size(), n, c[0], c[1], c[2], c[3], static_cast<long>(c[0] + c[2]) - static_cast<long>(c[1] + c[3]),
      delaunay, ordered / delaunay, tables, tables / delaunay, flow.undecided().centres, flow.undecided().spheres);
  clock.lap();
  const StableSurvey stable = survey_stable(flow, context);
  const double s2 = clock.lap();
  std::printf(
      "  S2 %.3f s, with tables %.2f D; %zu triangles, nS2 mean %.2f most %zu; flagged: vertex %zu, midpoint %zu", s2,
      (tables + s2) / delaunay, stable.triangles, stable.depths.mean(), stable.depths.most(),
      stable.with_voronoi_vertex, stable.with_regular_point);
  print("facets", stable.crossings);
  clock.lap();
  const UnstableSurvey unstable = survey_unstable(flow, context);
  const double u2 = clock.lap();
  std::printf(
      "  U2 %.3f s, with tables %.2f D; nU2 mean %.2f most %zu; cascades mean %.2f most %zu; %zu passed a regular "
      "point, %zu end in saddles",
      u2, (tables + u2) / delaunay, unstable.segments.mean(), unstable.segments.most(), unstable.cascades.mean(),
      unstable.cascades.most(), unstable.passed_regular, unstable.in_saddles);
  print("facets", unstable.crossings);
}

}  // namespace

int main(int argc, char** argv) {
  bool is_rounded = true;
  bool is_memory = false;
  std::vector<std::size_t> counts;
  for (int i = 1; i < argc; ++i) {
    if (std::string(argv[i]) == "doubles") {
      is_rounded = false;
    } else if (std::string(argv[i]) == "memory") {
      is_memory = true;
    } else {
      counts.push_back(std::strtoull(argv[i], nullptr, 10));
    }
  }
  if (counts.empty()) counts = {2700, 12600, 33700};
  for (const std::size_t count : counts) {
    const std::vector<Point3> points = scan(count, is_rounded);
    is_memory ? measure_memory(points) : measure(points);
  }
}
