// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>
#include <utility>

#include "arrangement_families.h"

namespace families {

namespace {

constexpr Int half = Int{1} << 20;  // of the side of the square that most families fill

Point random_point(Random& random) {
  const Int x = random.between(-half, half);
  return {x, random.between(-half, half)};
}

// Uniform in direction, of this length up to rounding.
Point random_vector(double length, Random& random) {
  while (true) {
    const double x = random.signed_unit();
    const double y = random.signed_unit();
    const double norm = std::sqrt(x * x + y * y);
    if (norm > 1 || norm < 0x1p-10) continue;
    return {std::llround(x / norm * length), std::llround(y / norm * length)};
  }
}

}  // namespace

// Half of the segments lead from near the left to near the right side, the others from bottom to top: of two segments
// of the same half one in two crosses, of different halves almost all. 1,000 segments have about 372,000 crossings.
std::vector<Segment> long_segments(Int count, Random& random) {
  constexpr Int strip = half / 50;
  std::vector<Segment> result;
  for (Int i = 0; i < count; ++i) {
    const Int low = -half + random.between(0, strip);
    const Int from = random.between(-half, half);
    const Int high = half - random.between(0, strip);
    const Int to = random.between(-half, half);
    result.push_back(i % 2 == 0 ? Segment{low, from, high, to} : Segment{from, low, to, high});
  }
  return result;
}

// So long that there are about two crossings per segment, whatever the number.
std::vector<Segment> short_segments(Int count, Random& random) {
  const double length = 2 * static_cast<double>(half) * std::sqrt(2 * std::numbers::pi / static_cast<double>(count));
  std::vector<Segment> result;
  for (Int i = 0; i < count; ++i) {
    const Point from = random_point(random);
    const Point vector = random_vector(length, random);
    result.push_back({from[0], from[1], from[0] + vector[0], from[1] + vector[1]});
  }
  return result;
}

// The edges of a grid of cells x cells quadrilaterals, upright or turned by the smaller angle of a triangle with sides
// 3, 4, 5; corners move by a quarter of a cell at most in x and in y, so that edges remain disjoint. The corners of the
// turned one reach 3/2 of the others.
std::vector<Segment> perturbed_grid(Int cells, bool is_turned, Random& random) {
  const Int step = 2 * half / (cells + 1);
  const Int along = is_turned ? 4 * step / 5 : step;
  const Int across = is_turned ? 3 * step / 5 : 0;
  std::vector<Point> corners;
  for (Int j = 0; j <= cells; ++j) {
    for (Int i = 0; i <= cells; ++i) {
      const Int x = ((2 * i - cells) * along - (2 * j - cells) * across) / 2 + random.between(-step / 4, step / 4);
      const Int y = ((2 * i - cells) * across + (2 * j - cells) * along) / 2 + random.between(-step / 4, step / 4);
      corners.push_back({x, y});
    }
  }
  std::vector<Segment> result;
  const auto add = [&](Int from, Int to) {
    const Point& a = corners[static_cast<std::size_t>(from)];
    const Point& b = corners[static_cast<std::size_t>(to)];
    result.push_back({a[0], a[1], b[0], b[1]});
  };
  for (Int j = 0; j <= cells; ++j) {
    for (Int i = 0; i <= cells; ++i) {
      const Int at = j * (cells + 1) + i;
      if (i < cells) add(at, at + 1);
      if (j < cells) add(at, at + cells + 1);
    }
  }
  return result;
}

namespace {

// A side of a cell of a map, cut at `cuts` places, which are multiples of 1/64 of the side: the odd ones if its owner
// is left of it, the even ones if not, so that the two owners of a border never cut it at the same place.
void add_side(Point from, Point to, bool is_odd, std::size_t cuts, Random& random, std::vector<Segment>& out) {
  std::set<Int> places;
  while (places.size() < cuts) places.insert(is_odd ? 2 * random.between(0, 31) + 1 : 2 * random.between(1, 31));
  places.insert(64);
  const Point part{(to[0] - from[0]) / 64, (to[1] - from[1]) / 64};
  Int last = 0;
  for (const Int place : places) {
    out.push_back(
        {from[0] + last * part[0], from[1] + last * part[1], from[0] + place * part[0], from[1] + place * part[1]});
    last = place;
  }
}

}  // namespace

// A map of cells x cells quadrilaterals in which every cell writes its own border as 18 segments. Up to 256 cells the
// map is within +-2^20.
std::vector<Segment> coverage(Int cells, Int noise, Random& random) {
  constexpr Int step = 8192;
  std::vector<Point> corners;
  for (Int j = 0; j <= cells; ++j) {
    for (Int i = 0; i <= cells; ++i) {
      const Int x = (2 * i - cells) * step / 2 + 64 * random.between(-32, 32);
      corners.push_back({x, (2 * j - cells) * step / 2 + 64 * random.between(-32, 32)});
    }
  }
  const auto corner = [&](Int i, Int j) { return corners[static_cast<std::size_t>(j * (cells + 1) + i)]; };
  std::vector<Segment> result;
  for (Int j = 0; j < cells; ++j) {
    for (Int i = 0; i < cells; ++i) {
      add_side(corner(i, j), corner(i + 1, j), true, 4, random, result);
      add_side(corner(i + 1, j), corner(i + 1, j + 1), true, 3, random, result);
      add_side(corner(i + 1, j + 1), corner(i, j + 1), false, 4, random, result);
      add_side(corner(i, j + 1), corner(i, j), false, 3, random, result);
    }
  }
  if (noise == 0) return result;
  for (Segment& segment : result) {
    for (Int& coordinate : segment) coordinate += random.between(-noise, noise);
  }
  return result;
}

// Five directions on a grid so small that segments overlap and many meet in a point.
std::vector<Segment> lattice(Int count, Random& random) {
  constexpr std::array<Point, 5> directions{{{1, 0}, {0, 1}, {1, 1}, {1, -1}, {2, 1}}};
  const Int side = std::max<Int>(4, std::llround(2.0 * std::sqrt(static_cast<double>(count))));
  std::vector<Segment> result;
  for (Int i = 0; i < count; ++i) {
    const Point& direction = directions[static_cast<std::size_t>(random.between(0, 4))];
    const Int x = random.between(0, side);
    const Int y = random.between(0, side);
    const Int steps = random.between(1, std::max<Int>(1, side / 4));
    result.push_back({x, y, x + steps * direction[0], y + steps * direction[1]});
  }
  return result;
}

// All through the origin, in different directions.
std::vector<Segment> pencil(Int count, Random& random) {
  std::set<Point> seen;
  std::vector<Segment> result;
  while (result.size() < static_cast<std::size_t>(count)) {
    Int x = random.between(0, half / 16);
    Int y = random.between(-half / 16, half / 16);
    const Int divisor = std::gcd(x, y);
    if (divisor == 0) continue;
    x /= divisor;
    y /= divisor;
    if (x == 0) y = 1;
    if (!seen.insert({x, y}).second) continue;
    const Int forth = random.between(1, 16);
    const Int back = -random.between(1, 16);
    result.push_back({forth * x, forth * y, back * x, back * y});
  }
  return result;
}

// Nearly parallel, one unit apart at least, the whole band two units per segment high; in random order.
std::vector<Segment> band(Int count, Random& random) {
  std::vector<Segment> result;
  for (Int i = 0; i < count; ++i) {
    const Int y = 2 * i - count;
    const Int left = -half + random.between(0, half / 8);
    const Int right = half - random.between(0, half / 8);
    const Int rise = random.between(0, 1);
    result.push_back({left, y + rise, right, y + random.between(0, 1)});
  }
  for (std::size_t i = result.size(); i > 1; --i) {
    std::swap(result[i - 1], result[static_cast<std::size_t>(random.between(0, static_cast<Int>(i) - 1))]);
  }
  return result;
}

}  // namespace families
