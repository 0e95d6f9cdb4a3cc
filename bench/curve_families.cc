// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>

#include "arrangement_families.h"

namespace families {

namespace {

constexpr Int half = Int{1} << 20;
using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Uniform on the sphere.
Vector random_direction(Random& random) {
  while (true) {
    Vector v;
    for (double& coordinate : v) coordinate = random.signed_unit();
    const double norm = std::sqrt(dot(v, v));
    if (norm > 1 || norm < 0x1p-10) continue;
    for (double& coordinate : v) coordinate /= norm;
    return v;
  }
}

std::array<Int, 3> rounded(const Vector& v) {
  const double scale = static_cast<double>(half) / std::sqrt(dot(v, v));
  return {std::llround(v[0] * scale), std::llround(v[1] * scale), std::llround(v[2] * scale)};
}

std::vector<Circle> random_circles(Int count, Int smallest, Int largest, Random& random) {
  std::vector<Circle> result;
  for (Int i = 0; i < count; ++i) {
    const Int x = random.between(-half / 2, half / 2);
    const Int y = random.between(-half / 2, half / 2);
    result.push_back({x, y, random.between(smallest, largest)});
  }
  return result;
}

}  // namespace

// About a quarter of all pairs cross.
std::vector<Circle> circles(Int count, Random& random) {
  return random_circles(count, half / 25, 8 * half / 25, random);
}

// They cover a point of the square one and a half times on average, so that the union has parts, holes and touching
// borders.
std::vector<Circle> discs(Int count, Random& random) {
  const double radius = static_cast<double>(half) * std::sqrt(1.5 / (std::numbers::pi * static_cast<double>(count)));
  return random_circles(count, std::llround(radius / 2) + 1, std::llround(radius * 3 / 2) + 1, random);
}

// Different planes in general position up to what integers of 20 bits allow.
std::vector<Normal> great_circles(Int count, Random& random) {
  std::set<Normal> seen;
  std::vector<Normal> result;
  while (result.size() < static_cast<std::size_t>(count)) {
    const Normal normal = rounded(random_direction(random));
    const Int divisor = std::gcd(std::gcd(normal[0], normal[1]), normal[2]);
    const Int sign = normal < Normal{} ? -1 : 1;
    Normal key = normal;
    for (Int& coordinate : key) coordinate /= sign * divisor;
    if (seen.insert(key).second) result.push_back(normal);
  }
  return result;
}

// Uniform on the sphere, shorter than a quarter of a turn, about 2.9 crossings per arc.
std::vector<Geodesic> geodesics(Int count, Random& random) {
  const double tangent = std::sqrt(117.3 / static_cast<double>(count));
  std::vector<Geodesic> result;
  while (result.size() < static_cast<std::size_t>(count)) {
    const Vector from = random_direction(random);
    Vector along = random_direction(random);
    const double height = dot(from, along);
    for (std::size_t k = 0; k < 3; ++k) along[k] -= height * from[k];
    const double norm = std::sqrt(dot(along, along));
    if (norm < 0x1p-10) continue;
    Vector to;
    for (std::size_t k = 0; k < 3; ++k) to[k] = from[k] + along[k] / norm * tangent;
    const auto a = rounded(from);
    const auto b = rounded(to);
    result.push_back({a[0], a[1], a[2], b[0], b[1], b[2]});
  }
  return result;
}

}  // namespace families
