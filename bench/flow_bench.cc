// SPDX-License-Identifier: Apache-2.0
// The flow complex of scans rounded to a grid, one thread: critical points, and how long tables, stable surfaces and
// unstable arcs take beside the triangulation.
// Usage: flow_bench [doubles] [points ...]; 2700, 12600 and 33700 if none are given; `doubles` leaves out the grid.
// Memory is that of the whole process, so give one number for it.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "peak_memory.h"
#include "quoin/flow/saddle_arcs.h"
#include "quoin/flow/saddle_surfaces.h"

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

void stable(const FlowCells& flow, double tables, double delaunay, const Context& context) {
  Clock clock;
  SaddleSurfaces surfaces(flow);
  Histogram depths;
  std::size_t triangles = 0;
  std::size_t at_vertex = 0;
  std::size_t at_midpoint = 0;
  flow.for_each_saddle(context, [&](CellFacet saddle) {
    const SurfacePieces& surface = surfaces.follow(saddle, context);
    triangles += 2 * surface.pieces.size();
    at_vertex += surface.has_voronoi_vertex ? 1 : 0;
    at_midpoint += surface.has_regular_point ? 1 : 0;
    for (const SurfacePiece& piece : surface.pieces) {
      if (piece.is_side) depths.add(piece.depth);
    }
  });
  const double seconds = clock.lap();
  std::printf(
      "  S2 %.3f s, with tables %.2f D; %zu triangles, nS2 mean %.2f most %zu; flagged: vertex %zu, midpoint %zu; "
      "%zu of %zu comparisons undecided, %zu exact points of at most %zu bits\n",
      seconds, (tables + seconds) / delaunay, triangles, depths.mean(), depths.most(), at_vertex, at_midpoint,
      surfaces.crosser().undecided_count(), surfaces.crosser().comparison_count(),
      surfaces.crosser().chain().exact_count(), surfaces.crosser().chain().most_bits());
}

void unstable(const FlowCells& flow, double tables, double delaunay, const Context& context) {
  Clock clock;
  SaddleArcs arcs(flow);
  Histogram segments;
  std::size_t passed = 0;
  std::size_t in_saddles = 0;
  flow.for_each_saddle(context, [&](CellFacet saddle) {
    for (const SaddleEnd& end : arcs.ends(saddle, context)) {
      segments.add(end.segments);
      passed += end.has_passed_regular ? 1 : 0;
      in_saddles += end.kind == SaddleEnd::Kind::saddle ? 1 : 0;
    }
  });
  const double seconds = clock.lap();
  std::printf(
      "  U2 %.3f s, with tables %.2f D; nU2 mean %.2f most %zu; cascades mean %.2f most %zu; %zu of %zu comparisons "
      "undecided, %zu exact points of at most %zu bits; %zu passed a regular point, %zu end in saddles\n",
      seconds, (tables + seconds) / delaunay, segments.mean(), segments.most(), arcs.cascades().mean(),
      arcs.cascades().most(), arcs.crosser().undecided_count(), arcs.crosser().comparison_count(),
      arcs.crosser().chain().exact_count(), arcs.crosser().chain().most_bits(), passed, in_saddles);
}

void measure(const std::vector<Point3>& points) {
  const Context context({.threads = 1});
  const long before = resident_kb();
  Clock clock;
  const Delaunay3 triangulation(points, context, {.is_canonical = std::getenv("CANON") != nullptr});
  const double delaunay = clock.lap();
  const long with_triangulation = peak_kb();
  clock.lap();
  const FlowCells flow(triangulation, context);
  const double tables = clock.lap();
  const std::array<std::size_t, 4> c = flow.counts();
  std::printf(
      "%zu points, %zu distinct: critical %zu %zu %zu %zu, sum %ld; D %.3f s, tables %.2f D; %zu centre signs and "
      "%zu spheres not decided by doubles\n",
      points.size(), triangulation.vertex_count(), c[0], c[1], c[2], c[3],
      static_cast<long>(c[0] + c[2]) - static_cast<long>(c[1] + c[3]), delaunay, tables / delaunay,
      flow.undecided().centres, flow.undecided().spheres);
  stable(flow, tables, delaunay, context);
  unstable(flow, tables, delaunay, context);
  const std::size_t n = triangulation.vertex_count();
  std::printf("  memory per point: %.0f B at the end of the triangulation, %.0f B at most (%.2f)\n",
              per(with_triangulation - before, n), per(peak_kb() - before, n),
              static_cast<double>(peak_kb() - before) / static_cast<double>(with_triangulation - before));
}

}  // namespace

int main(int argc, char** argv) {
  bool is_rounded = true;
  std::vector<std::size_t> counts;
  for (int i = 1; i < argc; ++i) {
    if (std::string(argv[i]) == "doubles") {
      is_rounded = false;
    } else {
      counts.push_back(std::strtoull(argv[i], nullptr, 10));
    }
  }
  if (counts.empty()) counts = {2700, 12600, 33700};
  for (const std::size_t count : counts) measure(scan(count, is_rounded));
}
