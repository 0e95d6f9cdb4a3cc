// SPDX-License-Identifier: Apache-2.0
// The flow complex of scans rounded to a grid, one thread: critical points, and how long tables, stable surfaces and
// unstable arcs take beside the triangulation.
// Usage: flow_bench [points ...]; 2700, 12600 and 33700 if none are given.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "quoin/flow/flow_complex.h"
#include "quoin/flow/stable_surface.h"
#include "quoin/flow/unstable_arcs.h"

namespace {

using namespace quoin;

/// A bumpy closed surface in rings with noise, as a scanner sees it, rounded to a grid of 2000 steps.
std::vector<Point3> scan(std::size_t count) {
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
      const auto grid = [&](double x) { return std::round(1000 * x); };
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

struct Mean {
  double sum = 0;
  std::size_t count = 0;
  std::size_t most = 0;
  void add(std::size_t value) {
    sum += static_cast<double>(value);
    ++count;
    most = std::max(most, value);
  }
  double mean() const { return count == 0 ? 0 : sum / static_cast<double>(count); }
};

void stable(const FlowComplex& flow, const std::vector<DeloneFace>& saddles, double delaunay, const Context& context) {
  Clock clock;
  Mean depth;
  std::size_t triangles = 0;
  std::size_t flagged = 0;
  std::size_t exact = 0;
  for (const DeloneFace& saddle : saddles) {
    const StableSurface surface = stable_surface(flow, saddle.index, context);
    triangles += surface.triangles.size();
    flagged += surface.is_ordinary() ? 0 : 1;
    exact += surface.points.exact_count();
    for (const StableSide& side : surface.sides) depth.add(side.depth);
  }
  const double seconds = clock.lap();
  std::printf(
      "  S2 %.3f s, %.2f D; %zu triangles, depth mean %.2f most %zu; %zu of %zu not ordinary; %zu exact points\n",
      seconds, seconds / delaunay, triangles, depth.mean(), depth.most, flagged, saddles.size(), exact);
}

void unstable(const FlowComplex& flow, const std::vector<DeloneFace>& saddles, double delaunay,
              const Context& context) {
  Clock clock;
  ArcTracer tracer(flow);
  Mean segments;
  Mean cascades;
  std::size_t passed = 0;
  std::size_t in_saddles = 0;
  for (const DeloneFace& saddle : saddles) {
    for (const UnstableArc& arc : tracer.trace(saddle.index, context).arcs) {
      segments.add(arc.segments);
      cascades.add(arc.longest_cascade);
      passed += arc.has_passed_regular ? 1 : 0;
      in_saddles += !arc.is_infinite && arc.end.dimension < 3 ? 1 : 0;
    }
  }
  const double seconds = clock.lap();
  std::printf(
      "  U2 %.3f s, %.2f D; segments mean %.2f most %zu; cascades most %zu; %zu crossings, %zu exact points; "
      "%zu passed a regular point, %zu end in saddles\n",
      seconds, seconds / delaunay, segments.mean(), segments.most, cascades.most, tracer.crossing_count(),
      tracer.exact_count(), passed, in_saddles);
}

void measure(std::size_t count) {
  const Context context({.threads = 1});
  const std::vector<Point3> points = scan(count);
  Clock clock;
  const Delaunay3 triangulation(points, context);
  const double delaunay = clock.lap();
  const FlowComplex flow(triangulation, context);
  const double tables = clock.lap();
  const std::array<std::size_t, 4> c = flow.counts();
  std::printf("%zu points, %zu distinct: critical %zu %zu %zu %zu, sum %ld; %zu regular; D %.3f s, tables %.2f D\n",
              points.size(), triangulation.vertex_count(), c[0], c[1], c[2], c[3],
              static_cast<long>(c[0] + c[2]) - static_cast<long>(c[1] + c[3]),
              flow.faces_of_kind(FlowKind::regular).size(), delaunay, tables / delaunay);
  std::vector<DeloneFace> saddles = flow.faces_of_kind(FlowKind::critical);
  std::erase_if(saddles, [](const DeloneFace& face) { return face.dimension != 2; });
  stable(flow, saddles, delaunay, context);
  unstable(flow, saddles, delaunay, context);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    for (const std::size_t count : {2700, 12600, 33700}) measure(count);
  }
  for (int i = 1; i < argc; ++i) measure(static_cast<std::size_t>(std::strtoull(argv[i], nullptr, 10)));
}
