// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "arrangement_families.h"

namespace families {

namespace {

constexpr Int half = Int{1} << 20;

Int cross(const Point& a, const Point& b) {
  return a[0] * b[1] - a[1] * b[0];
}

bool is_upper(const Point& p) {
  return p[1] > 0 || (p[1] == 0 && p[0] > 0);
}

bool is_before(const Point& a, const Point& b) {
  return is_upper(a) != is_upper(b) ? is_upper(a) : cross(a, b) > 0;
}

// A polygon that sees all of itself from the origin: strictly increasing angles, less than pi apart.
Polygon star(Int count, Int radius, Random& random) {
  while (true) {
    Polygon result;
    while (result.size() < static_cast<std::size_t>(count)) {
      const Int x = random.between(-radius, radius);
      const Int y = random.between(-radius, radius);
      const Int square = x * x + y * y;
      if (square <= radius * radius && 16 * square >= radius * radius) result.push_back({x, y});
    }
    std::sort(result.begin(), result.end(), is_before);
    bool is_strict = true;
    for (std::size_t i = 0; i < result.size(); ++i) {
      is_strict = is_strict && cross(result[i], result[(i + 1) % result.size()]) > 0;
    }
    if (is_strict) return result;
  }
}

}  // namespace

// With 8 to 20 vertices; they cover a point of the square one and a half times on average, so that the union has many
// parts and holes.
std::vector<Polygon> star_polygons(Int count, Random& random) {
  const Int radius = std::llround(static_cast<double>(half) * std::sqrt(4 / static_cast<double>(count))) + 8;
  std::vector<Polygon> result;
  for (Int i = 0; i < count; ++i) {
    const Int x = random.between(-half, half);
    const Int y = random.between(-half, half);
    result.push_back(star(random.between(8, 20), radius, random));
    for (Point& p : result.back()) {
      p[0] += x;
      p[1] += y;
    }
  }
  return result;
}

// A bar with long teeth of different lengths: upwards, or turned, to the right.
Polygon comb(Int vertices, bool is_turned, Random& random) {
  constexpr Int spacing = 4096;
  const Int teeth = std::max<Int>(1, (vertices - 4) / 4);
  Polygon result{{-spacing, -spacing}, {teeth * spacing, -spacing}, {teeth * spacing, 0}};
  for (Int i = teeth - 1; i >= 0; --i) {
    const Int length = random.between(8 * spacing, 16 * spacing);
    const Int left = i * spacing;
    const Int right = left + spacing / 4;
    result.insert(result.end(), {{right, 0}, {right, length}, {left, length}, {left, 0}});
  }
  result.push_back({-spacing, 0});
  if (is_turned) {
    for (Point& p : result) p = {p[1], -p[0]};
  }
  return result;
}

namespace {

// A bottom and a right bar with teeth upwards and to the right, `span` long and far apart.
Polygon coarse_fork(Int teeth, Int gap, Int thickness, Int span) {
  const Int far = 2 * span;
  Polygon result{{-gap, -gap}, {far, -gap}};
  for (Int j = 0; j < teeth; ++j) {
    const Int y = j * teeth * gap;
    result.insert(result.end(), {{far, y}, {far + span, y}, {far + span, y + thickness}, {far, y + thickness}});
  }
  result.insert(result.end(), {{far, span + gap}, {far - gap, span + gap}, {far - gap, 0}});
  for (Int i = teeth - 1; i >= 0; --i) {
    const Int x = i * teeth * gap;
    result.insert(result.end(), {{x + thickness, 0}, {x + thickness, span}, {x, span}, {x, 0}});
  }
  result.push_back({-gap, 0});
  return result;
}

// A bottom and a left bar whose teeth are close together: the upward ones end where the coarse fork remains in place,
// the others where it is moved so far to the left that its other teeth come to lie there.
Polygon fine_fork(Int teeth, Int gap, Int thickness, Int span) {
  const Int left = -4 * span;
  const Int bottom = -2 * span;
  const Int end = (teeth + 1) * gap;
  Polygon result{{left - gap, bottom - gap}, {end, bottom - gap}, {end, bottom}};
  for (Int i = teeth - 1; i >= 0; --i) {
    const Int x = i * gap;
    result.insert(result.end(), {{x + thickness, bottom}, {x + thickness, 0}, {x, 0}, {x, bottom}});
  }
  result.push_back({left, bottom});
  for (Int j = 0; j < teeth; ++j) {
    const Int y = j * gap;
    result.insert(result.end(), {{left, y}, {-2 * span, y}, {-2 * span, y + thickness}, {left, y + thickness}});
  }
  result.insert(result.end(), {{left, end}, {left - gap, end}});
  return result;
}

}  // namespace

// Two forks with t teeth each way whose Minkowski sum is a lattice of t^2 times t^2 strips: about t^4 holes.
Polygon fork(Int vertices, bool is_fine) {
  constexpr Int gap = 64;
  const Int teeth = std::max<Int>(1, (vertices - 6) / 8);
  const Int span = teeth * teeth * gap;
  return is_fine ? fine_fork(teeth, gap, gap / 4, span) : coarse_fork(teeth, gap, gap / 4, span);
}

std::vector<Point> queries(Int count, Random& random) {
  std::vector<Point> result;
  for (Int i = 0; i < count; ++i) {
    const Int x = random.between(-half, half);
    result.push_back({x, random.between(-half, half)});
  }
  return result;
}

}  // namespace families
