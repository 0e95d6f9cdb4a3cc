// SPDX-License-Identifier: Apache-2.0
//
// Filtered predicates against the plain floating-point formulas on random points, which every filter decides; and the
// exact tiers on degenerate points.
#include <benchmark/benchmark.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "quoin/kernel/predicates2.h"
#include "quoin/kernel/predicates3.h"

namespace {

using quoin::Point3;
using quoin::Sign;

using Call = std::array<std::uint32_t, 5>;

constexpr std::size_t count = 4096;  // 96 KiB: in the second cache

std::vector<Point3> random_points() {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> coordinate(0, 1);
  std::vector<Point3> points(count);
  for (Point3& p : points) p = {coordinate(random), coordinate(random), coordinate(random)};
  return points;
}

// The same on a plane (x, y, x + y of 26-bit integers), or on a sphere of integers.
std::vector<Point3> coplanar_points() {
  std::mt19937_64 random(2);
  std::vector<Point3> points(count);
  for (Point3& p : points) {
    p.x = static_cast<double>(random() >> 38);
    p.y = static_cast<double>(random() >> 38);
    p.z = p.x + p.y;
  }
  return points;
}

std::vector<Point3> cospherical_points() {
  std::mt19937_64 random(3);
  const std::vector<Point3> octant{{3, 4, 12}, {4, 12, 3}, {12, 3, 4}, {4, 3, 12}, {3, 12, 4}, {12, 4, 3}, {0, 5, 12}};
  std::vector<Point3> points(count);
  for (Point3& p : points) {
    p = octant[random() % octant.size()];
    for (unsigned axis = 0; axis < 3; ++axis) p[axis] = (random() & 1) != 0 ? p[axis] : -p[axis];
  }
  return points;
}

// Points as a triangulation asks for them: by five random indices, so that no compiler evaluates two calls at once.
std::vector<Call> random_calls() {
  std::mt19937_64 random(4);
  std::vector<Call> calls(count);
  for (auto& call : calls) {
    for (std::uint32_t& index : call) index = static_cast<std::uint32_t>(random() % count);
  }
  return calls;
}

template <class Predicate>
void run(benchmark::State& state, const std::vector<Point3>& points, Predicate predicate) {
  const std::vector<Call> calls = random_calls();
  for (auto _ : state) {
    int sum = 0;
    for (const auto& call : calls) sum += quoin::to_int(predicate(points.data(), call));
    benchmark::DoNotOptimize(sum);
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * count));
}

Sign plain_orientation(const Point3* p, const Call& i) {
  using quoin::filter::difference;
  const Point3 a = difference(p[i[1]], p[i[0]]);
  const Point3 b = difference(p[i[2]], p[i[0]]);
  const Point3 c = difference(p[i[3]], p[i[0]]);
  return quoin::sign_of(c.x * (a.y * b.z - a.z * b.y) + c.y * (a.z * b.x - a.x * b.z) + c.z * (a.x * b.y - a.y * b.x));
}

Sign plain_in_sphere(const Point3* p, const Call& i) {
  using quoin::filter::difference;
  const Point3 a = difference(p[i[0]], p[i[4]]);
  const Point3 b = difference(p[i[1]], p[i[4]]);
  const Point3 c = difference(p[i[2]], p[i[4]]);
  const Point3 d = difference(p[i[3]], p[i[4]]);
  const auto lift = [](const Point3& q) { return q.x * q.x + q.y * q.y + q.z * q.z; };
  const double ab = a.x * b.y - b.x * a.y;
  const double bc = b.x * c.y - c.x * b.y;
  const double cd = c.x * d.y - d.x * c.y;
  const double da = d.x * a.y - a.x * d.y;
  const double ac = a.x * c.y - c.x * a.y;
  const double bd = b.x * d.y - d.x * b.y;
  const double abc = a.z * bc - b.z * ac + c.z * ab;
  const double bcd = b.z * cd - c.z * bd + d.z * bc;
  const double cda = c.z * da + d.z * ac + a.z * cd;
  const double dab = d.z * ab + a.z * bd + b.z * da;
  return quoin::sign_of((lift(a) * bcd - lift(b) * cda) + (lift(c) * dab - lift(d) * abc));
}

Sign exact_orientation(const Point3* p, const Call& i) {
  return quoin::orientation(p[i[0]], p[i[1]], p[i[2]], p[i[3]]);
}

Sign exact_in_sphere(const Point3* p, const Call& i) {
  return quoin::in_sphere(p[i[0]], p[i[1]], p[i[2]], p[i[3]], p[i[4]]);
}

void orientation_plain(benchmark::State& state) {
  run(state, random_points(), plain_orientation);
}
void orientation_filtered(benchmark::State& state) {
  run(state, random_points(), exact_orientation);
}
void orientation_degenerate(benchmark::State& state) {
  run(state, coplanar_points(), exact_orientation);
}
void in_sphere_plain(benchmark::State& state) {
  run(state, random_points(), plain_in_sphere);
}
void in_sphere_filtered(benchmark::State& state) {
  run(state, random_points(), exact_in_sphere);
}
void in_sphere_degenerate(benchmark::State& state) {
  run(state, cospherical_points(), exact_in_sphere);
}

BENCHMARK(orientation_plain);
BENCHMARK(orientation_filtered);
BENCHMARK(orientation_degenerate);
BENCHMARK(in_sphere_plain);
BENCHMARK(in_sphere_filtered);
BENCHMARK(in_sphere_degenerate);

}  // namespace

BENCHMARK_MAIN();
