// SPDX-License-Identifier: Apache-2.0
// The flow complex of scans rounded to a grid, one thread: critical points, and how long tables, stable surfaces and
// unstable arcs take beside the triangulation.
// Usage: flow_bench [doubles] [memory] [sheets] [json] [points ...]; 2700, 12600 and 33700 if none are given; `doubles`
// leaves out the grid; `memory` prints memory instead, of one number of points; `sheets` follows unstable sheets of
// index 1 too, which take far longer; `json` prints a line of JSON for each number of points (bench/run_flow reads it).
#include <algorithm>
#include <array>
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

struct Words {
  bool is_rounded = true;
  bool is_memory = false;
  bool has_sheets = false;
  bool is_json = false;
};

double per(long kb, std::size_t points) {
  return 1024.0 * static_cast<double>(kb) / static_cast<double>(points);
}

/// Largest memory so far, beyond the points.
void measure_memory(const std::vector<Point3>& points, const Words& words) {
  const Context context({.threads = 1});
  const long before = resident_kb();
  const Delaunay3 triangulation(points, context);
  const long with_triangulation = peak_kb() - before;
  const FlowCells flow(triangulation, context);
  const StableSurvey stable = survey_stable(flow, context);
  const UnstableSurvey unstable = survey_unstable(flow, context);
  const long with_all = peak_kb() - before;
  const double ratio = static_cast<double>(with_all) / static_cast<double>(with_triangulation);
  if (words.is_json) {
    std::printf("{\"points\": %zu, \"triangulation\": %.1f, \"all\": %.1f, \"ratio\": %.4f}\n", points.size(),
                per(with_triangulation, points.size()), per(with_all, points.size()), ratio);
    return;
  }
  std::printf(
      "%zu points, %zu triangles, %zu ways: %.0f B per point for the triangulation, %.0f B with tables and ways, "
      "%.2f\n",
      points.size(), stable.triangles, unstable.segments.count(), per(with_triangulation, points.size()),
      per(with_all, points.size()), ratio);
}

/// All that is measured of one cloud; times in seconds.
struct Result {
  std::size_t points = 0;
  std::size_t distinct = 0;
  std::array<std::size_t, 4> critical{};
  CellSignCounts undecided;
  double delaunay = 0;
  double unordered_s2 = 0;  // and tables, of cells in the order of insertion
  double ordered = 0;
  double tables = 0;
  double s2 = 0;
  double u2 = 0;
  double u1 = 0;
  StableSurvey stable;
  UnstableSurvey unstable;
  SheetSurvey sheets;

  long sum() const {
    return static_cast<long>(critical[0] + critical[2]) - static_cast<long>(critical[1] + critical[3]);
  }
};

Result measure(const std::vector<Point3>& points, const Words& words) {
  const Context context({.threads = 1});
  Result result;
  Clock clock;
  {
    const Delaunay3 unordered(points, context);
    result.delaunay = clock.lap();
    const FlowCells flow(unordered, context);
    survey_stable(flow, context);
    result.unordered_s2 = clock.lap();
  }
  clock.lap();
  const Delaunay3 triangulation(points, context, {.is_canonical = true});
  result.ordered = clock.lap();
  const FlowCells flow(triangulation, context);
  result.tables = clock.lap();
  result.points = points.size();
  result.distinct = triangulation.vertex_count();
  result.critical = flow.counts();
  result.undecided = flow.undecided();
  clock.lap();
  result.stable = survey_stable(flow, context);
  result.s2 = clock.lap();
  result.unstable = survey_unstable(flow, context);
  result.u2 = clock.lap();
  if (words.has_sheets) {
    result.sheets = survey_sheets(flow, context);
    result.u1 = clock.lap();
  }
  return result;
}

void print(const char* name, const CrossingStatistics& crossings) {
  std::printf("; %zu comparisons, %zu %s not decided by doubles, %zu exact points of at most %zu bits\n",
              crossings.filters.comparisons.calls, crossings.undecided, name, crossings.exact_points,
              crossings.most_bits);
}

void print(const Result& r, const Words& words) {
  const std::array<std::size_t, 4>& c = r.critical;
  std::printf(
      "%zu points, %zu distinct: critical %zu %zu %zu %zu, sum %ld; D %.3f s, in canonical order %.2f D; tables "
      "%.3f s, %.2f D; %zu centre signs and %zu spheres not decided by doubles\n",
      r.points, r.distinct, c[0], c[1], c[2], c[3], r.sum(), r.delaunay, r.ordered / r.delaunay, r.tables,
      r.tables / r.delaunay, r.undecided.centres, r.undecided.spheres);
  std::printf(
      "  S2 %.3f s, with tables %.2f D; %zu triangles, nS2 mean %.2f most %zu; flagged: vertex %zu, midpoint %zu", r.s2,
      (r.tables + r.s2) / r.delaunay, r.stable.triangles, r.stable.depths.mean(), r.stable.depths.most(),
      r.stable.with_voronoi_vertex.size(), r.stable.with_regular_point.size());
  print("facets", r.stable.crossings);
  std::printf(
      "  U2 %.3f s, with tables %.2f D; nU2 mean %.2f most %zu; cascades mean %.2f most %zu; %zu passed a regular "
      "point, %zu end in saddles",
      r.u2, (r.tables + r.u2) / r.delaunay, r.unstable.segments.mean(), r.unstable.segments.most(),
      r.unstable.cascades.mean(), r.unstable.cascades.most(), r.unstable.passed_regular.size(),
      r.unstable.in_saddles.size());
  print("facets", r.unstable.crossings);
  if (!words.has_sheets) return;
  std::printf("  U1 %.3f s, %.1f D; %zu pieces, %.2f us each; parts mean %.2f most %zu; %zu with a regular point", r.u1,
              r.u1 / r.delaunay, r.sheets.pieces, 1e6 * r.u1 / static_cast<double>(r.sheets.pieces),
              r.sheets.parts.mean(), r.sheets.parts.most(), r.sheets.with_regular_point.size());
  print("facets", r.sheets.crossings);
}

void print_json(const char* name, const Histogram& h) {
  std::printf(", \"%s\": {\"mean\": %.4f, \"deviation\": %.4f, \"mode\": %zu, \"median\": %zu, \"most\": %zu}", name,
              h.mean(), h.deviation(), h.mode(), h.median(), h.most());
}

void print_json(const Result& r, const Words& words) {
  const std::array<std::size_t, 4>& c = r.critical;
  std::printf(
      "{\"points\": %zu, \"distinct\": %zu, \"critical\": [%zu, %zu, %zu, %zu], \"sum\": %ld, \"delaunay\": %.6f, "
      "\"unordered_s2\": %.6f, \"ordered\": %.6f, \"tables\": %.6f, \"s2\": %.6f, \"u2\": %.6f",
      r.points, r.distinct, c[0], c[1], c[2], c[3], r.sum(), r.delaunay, r.unordered_s2, r.ordered, r.tables, r.s2,
      r.u2);
  print_json("ns2", r.stable.depths);
  print_json("nu2", r.unstable.segments);
  print_json("nwcc", r.unstable.cascades);
  if (words.has_sheets) {
    std::printf(", \"u1\": %.6f, \"pieces\": %zu", r.u1, r.sheets.pieces);
    print_json("parts", r.sheets.parts);
  }
  const auto undecided = [](const CrossingStatistics& crossings) {
    return std::array{crossings.undecided, crossings.filters.comparisons.calls, crossings.depth};
  };
  const std::array<std::size_t, 3> s = undecided(r.stable.crossings);
  const std::array<std::size_t, 3> u = undecided(r.unstable.crossings);
  std::printf(
      ", \"s2_undecided\": %zu, \"s2_comparisons\": %zu, \"s2_depth\": %zu, \"u2_undecided\": %zu, "
      "\"u2_comparisons\": %zu, \"u2_depth\": %zu}\n",
      s[0], s[1], s[2], u[0], u[1], u[2]);
}

}  // namespace

int main(int argc, char** argv) {
  Words words;
  std::vector<std::size_t> counts;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "doubles") {
      words.is_rounded = false;
    } else if (word == "memory") {
      words.is_memory = true;
    } else if (word == "sheets") {
      words.has_sheets = true;
    } else if (word == "json") {
      words.is_json = true;
    } else {
      counts.push_back(std::strtoull(argv[i], nullptr, 10));
    }
  }
  if (counts.empty()) counts = {2700, 12600, 33700};
  for (const std::size_t count : counts) {
    const std::vector<Point3> points = scan(count, words.is_rounded);
    if (words.is_memory) {
      measure_memory(points, words);
      continue;
    }
    const Result result = measure(points, words);
    words.is_json ? print_json(result, words) : print(result, words);
  }
}
