// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "quoin/assembly/pair_regions.h"
#include "quoin/assembly/part.h"
#include "quoin/kernel/rational_point.h"
#include "quoin/polytope/hull.h"

/// Assemblies for tests, and an oracle that shares nothing with what it tests but the convex hull of points.
namespace quoin::test_assemblies {

using Points = std::vector<Point3>;
using Pieces = std::vector<Points>;
using Random = std::mt19937_64;

inline const Context one_thread({.threads = 1});

inline AssemblyPart part(const std::string& name, const Pieces& pieces) {
  std::vector<Polytope> polytopes;
  for (const Points& piece : pieces) polytopes.push_back(Polytope::hull_of(piece, one_thread));
  return make_part(name, std::move(polytopes), one_thread);
}

inline Points box(const Point3& low, const Point3& high) {
  Points points;
  for (unsigned i = 0; i < 8; ++i) {
    points.push_back({(i & 1U) != 0 ? high.x : low.x, (i & 2U) != 0 ? high.y : low.y, (i & 4U) != 0 ? high.z : low.z});
  }
  return points;
}

/// Section 3.4 of the notes: six parts of 3, 5 (pyramids as tetrahedra) or 8 (tetrahedra alone) pieces; red, green,
/// yellow, turquoise, purple, blue are +z, -z, +x, -x, +y, -y.
inline std::vector<Pieces> split_star_pieces(int pieces_per_part) {
  const Point3 top{0, 0, 2};
  const Point3 a{1, 1, 1};
  const Point3 b{1, -1, 1};
  const Point3 c{-1, -1, 1};
  const Point3 d{-1, 1, 1};
  const Point3 right{2, 0, 0};
  const Point3 left{-2, 0, 0};
  Pieces red;
  if (pieces_per_part == 8) {
    red = {{{0, 0, 0}, top, a, b}, {{0, 0, 0}, top, b, c}, {{0, 0, 0}, top, c, d}, {{0, 0, 0}, top, d, a}};
  } else {
    red = {{{0, 0, 0}, top, a, b, c, d}};
  }
  if (pieces_per_part == 3) {
    red.push_back({{2, 0, 2}, top, a, right, b});
    red.push_back({{-2, 0, 2}, top, d, left, c});
  } else {
    red.push_back({{2, 0, 2}, top, a, b});
    red.push_back({{2, 0, 2}, right, a, b});
    red.push_back({{-2, 0, 2}, top, c, d});
    red.push_back({{-2, 0, 2}, left, c, d});
  }
  std::vector<Pieces> parts;
  for (int times = 0; times < 3; ++times) {
    for (const bool is_back : {false, true}) {
      Pieces pieces = red;
      for (Points& piece : pieces) {
        for (Point3& p : piece) {
          if (is_back) p = {p.x, -p.y, -p.z};
          for (int k = 0; k < times; ++k) p = {p.z, p.x, p.y};
        }
      }
      parts.push_back(std::move(pieces));
    }
  }
  return parts;
}

inline const std::array<const char*, 6> split_star_names{"R", "G", "Y", "T", "P", "B"};

inline std::vector<AssemblyPart> assembled(const std::vector<Pieces>& parts) {
  std::vector<AssemblyPart> result;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    result.push_back(part(parts.size() == 6 ? split_star_names[p] : "part " + std::to_string(p), parts[p]));
  }
  return result;
}

/// Section 3.5 of the notes.
inline std::vector<Pieces> peg(bool has_floor) {
  Pieces block{box({1, -2, 0}, {2, 2, 2}), box({-2, -2, 0}, {-1, 2, 2}), box({-1, 1, 0}, {1, 2, 2}),
               box({-1, -2, 0}, {1, -1, 2})};
  if (has_floor) block.push_back(box({-2, -2, -1}, {2, 2, 0}));
  return {{box({-1, -1, 0}, {1, 1, 2})}, block};
}

/// Two hooks through one another.
inline std::vector<Pieces> hooks() {
  return {{box({0, 0, -1}, {10, 2, 1}), box({0, 0, -1}, {2, 8, 1}), box({0, 6, -1}, {10, 8, 1}),
           box({8, 4, -1}, {10, 8, 1})},
          {box({4, 3, -4}, {6, 5, 4}), box({-6, 3, 2}, {6, 5, 4}), box({-6, 3, -4}, {6, 5, -2}),
           box({-6, 3, 0}, {-4, 5, 4})}};
}

inline std::vector<Pieces> stack(int count) {
  std::vector<Pieces> parts;
  for (int i = 0; i < count; ++i) parts.push_back({box({0, 0, double(i)}, {2, 2, double(i + 1)})});
  return parts;
}

/// The six tetrahedra of each of some cubes, dealt out to parts: contacts of every kind.
inline std::vector<Pieces> dealt_tetrahedra(Random& random, int cubes_along_x, std::size_t parts) {
  std::vector<Pieces> result(parts);
  const auto deal = [&](const Points& piece) { result[random() % parts].push_back(piece); };
  std::array<int, 3> axes{0, 1, 2};
  for (int x = 0; x < cubes_along_x; ++x) {
    std::sort(axes.begin(), axes.end());
    do {
      Point3 at{double(x), 0, 0};
      Points piece{at};
      for (const int axis : axes) {
        at[static_cast<unsigned>(axis)] += 1;
        piece.push_back(at);
      }
      deal(piece);
    } while (std::next_permutation(axes.begin(), axes.end()));
  }
  std::erase_if(result, [](const Pieces& pieces) { return pieces.empty(); });
  return result;
}

inline RationalPoint3 rational(const SphereDirection& d) {
  return {Rational(d.integer(0)), Rational(d.integer(1)), Rational(d.integer(2))};
}

/// Whether the open ray {t d, t > 0} meets the interior of the hull of all differences of points of two pieces, which
/// have to be doubles: by cutting the line with each facet's half-space, in rationals.
inline bool hits(const Points& moving, const Points& other, const RationalPoint3& d) {
  Points differences;
  for (const Point3& q : other) {
    for (const Point3& p : moving) differences.push_back({q.x - p.x, q.y - p.y, q.z - p.z});
  }
  const ConvexHull hull = convex_hull(differences, one_thread);
  Rational low(0);
  bool has_high = false;
  Rational high(0);
  for (std::size_t f = 0; f < hull.facet_count(); ++f) {
    const auto corners = hull.facet(f);
    const RationalPoint3 a = exact_point(differences[corners[0]]);
    const RationalPoint3 n = cross(exact_point(differences[corners[1]]) - a, exact_point(differences[corners[2]]) - a);
    const Rational rate = dot(n, d);
    const Rational level = dot(n, a);
    // Inside: t rate < level.
    if (rate.sign() == Sign::zero) {
      if (level.sign() != Sign::positive) return false;
      continue;
    }
    const Rational at = level / rate;
    if (rate.sign() == Sign::positive) {
      high = has_high ? std::min(high, at) : at;
      has_high = true;
    } else {
      low = std::max(low, at);
    }
  }
  return has_high && low < high;
}

inline bool hits(const Pieces& moving, const Pieces& other, const RationalPoint3& d) {
  return std::any_of(moving.begin(), moving.end(), [&](const Points& p) {
    return std::any_of(other.begin(), other.end(), [&](const Points& q) { return hits(p, q, d); });
  });
}

inline PairRegions pairs_of(const std::vector<AssemblyPart>& parts) {
  std::vector<OverlappingParts> overlaps;
  PhaseTimes times;
  return project_pairs(parts, overlaps, times, one_thread);
}

inline SphereDirection direction(std::int64_t x, std::int64_t y, std::int64_t z) {
  return SphereDirection(std::array<std::int64_t, 3>{x, y, z}).primitive();
}

/// Small integers, so that special directions are common.
inline SphereDirection random_direction(Random& random) {
  for (;;) {
    const auto number = [&] { return static_cast<std::int64_t>(random() % 9) - 4; };
    const std::int64_t x = number();
    const std::int64_t y = number();
    const SphereDirection d(std::array<std::int64_t, 3>{x, y, number()});
    if (d.is_valid()) return d.primitive();
  }
}

inline std::string text_of(const SphereDirection& d) {
  return d.integer(0).to_string() + " " + d.integer(1).to_string() + " " + d.integer(2).to_string();
}

}  // namespace quoin::test_assemblies
