// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <random>
#include <string>
#include <vector>

#include "quoin/base/test_rounds.h"

#include "quoin/solid/overlay/contacts.h"

namespace quoin::overlay {
namespace {

using Triangle = std::array<Point3, 3>;

struct Exact {
  std::array<RationalPoint3, 3> p;
  RationalPoint3 normal;
  explicit Exact(const Triangle& t)
      : p{exact_point(t[0]), exact_point(t[1]), exact_point(t[2])}, normal(cross((p[1] - p[0]), (p[2] - p[0]))) {}
  bool contains(const RationalPoint3& q) const {  // closed; q anywhere
    if (dot(normal, (q - p[0])).sign() != Sign::zero) return false;
    for (std::size_t k = 0; k < 3; ++k) {
      const RationalPoint3 side = cross((p[(k + 1) % 3] - p[k]), (q - p[k]));
      if (dot(side, normal).sign() == Sign::negative) return false;
    }
    return true;
  }
};

// The closed triangles' common points, by definition: a corner of one in the other, an edge of one through the other,
// or, in one plane, two edges that cross. Corners given as shared are not counted, nor what lies on a shared edge.
bool meet_by_definition(const Triangle& s, const Triangle& t) {
  const Exact a(s);
  const Exact b(t);
  const auto is_corner = [](const Exact& x, const RationalPoint3& q) {
    return q == x.p[0] || q == x.p[1] || q == x.p[2];
  };
  std::vector<RationalPoint3> common;
  for (const auto& [x, y] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    for (const RationalPoint3& q : x->p) {
      if (y->contains(q)) common.push_back(q);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const RationalPoint3& u = x->p[k];
      const RationalPoint3 d = (x->p[(k + 1) % 3] - u);
      const Rational rise = dot(y->normal, d);
      if (rise.sign() != Sign::zero) {
        const Rational at = dot(y->normal, (y->p[0] - u)) / rise;
        if (at.sign() == Sign::negative || at > Rational(1)) continue;
        const RationalPoint3 q{u.x + at * d.x, u.y + at * d.y, u.z + at * d.z};
        if (y->contains(q)) common.push_back(q);
        continue;
      }
      for (std::size_t j = 0; j < 3; ++j) {  // edges that cross in one plane
        const RationalPoint3& v = y->p[j];
        const RationalPoint3 e = (y->p[(j + 1) % 3] - v);
        const RationalPoint3 n = cross(d, e);
        if (dot(n, n).sign() == Sign::zero || dot(n, (v - u)).sign() != Sign::zero) continue;
        const Rational at = dot(cross((v - u), e), n) / dot(n, n);
        const RationalPoint3 q{u.x + at * d.x, u.y + at * d.y, u.z + at * d.z};
        if (x->contains(q) && y->contains(q)) common.push_back(q);
      }
    }
  }
  // All but shared corners, and points of the edge between two shared corners.
  std::vector<RationalPoint3> shared;
  for (const RationalPoint3& q : a.p) {
    if (is_corner(b, q)) shared.push_back(q);
  }
  for (const RationalPoint3& q : common) {
    bool is_shared = is_corner(a, q) && is_corner(b, q);
    if (shared.size() == 2) {
      const RationalPoint3 n = cross((shared[1] - shared[0]), (q - shared[0]));
      is_shared = is_shared || dot(n, n).sign() == Sign::zero;
    }
    if (!is_shared) return true;
  }
  // Two triangles in one plane that share an edge may overlap with no other point found above only if they are equal.
  return false;
}

bool has_area(const Triangle& t) {
  const Exact x(t);
  return dot(x.normal, x.normal).sign() != Sign::zero;
}

// The library's answer; equal corners get equal ids.
bool meets(const Triangle& s, const Triangle& t) {
  std::vector<Point3> points;
  const auto id = [&](const Point3& p) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (points[i] == p) return PointId{i};
    }
    points.push_back(p);
    return PointId{points.size() - 1};
  };
  const Corners a{id(s[0]), id(s[1]), id(s[2])};
  const Corners b{id(t[0]), id(t[1]), id(t[2])};
  return have_contacts(Constructions(points), a, b);
}

bool share_all(const Triangle& s, const Triangle& t) {
  int count = 0;
  for (const Point3& p : s) count += p == t[0] || p == t[1] || p == t[2] ? 1 : 0;
  return count == 3;
}

void compare(const Triangle& s, const Triangle& t) {
  if (!has_area(s) || !has_area(t) || share_all(s, t)) return;
  const bool expected = meet_by_definition(s, t);
  const auto print = [](const Triangle& x) {
    std::string text;
    for (const Point3& p : x)
      text += "(" + std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + ")";
    return text;
  };
  ASSERT_EQ(meets(s, t), expected) << print(s) << " " << print(t);
  ASSERT_EQ(meets(t, s), expected) << print(t) << " " << print(s);
  ASSERT_EQ(meets({s[1], s[2], s[0]}, {t[2], t[1], t[0]}), expected) << print(s) << " " << print(t);
}

// All triangles on the corners of a cube against each other: every degenerate configuration of that grid.
TEST(Contacts, AllTrianglesOfTheUnitCube) {
  std::vector<Point3> corners;
  for (int i = 0; i < 8; ++i) corners.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2 & 1)});
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i < 8; ++i) {
    for (std::size_t j = i + 1; j < 8; ++j) {
      for (std::size_t k = j + 1; k < 8; ++k) triangles.push_back({corners[i], corners[j], corners[k]});
    }
  }
  for (const Triangle& s : triangles) {
    for (const Triangle& t : triangles) {
      compare(s, t);
      if (HasFatalFailure()) return;
    }
  }
}

TEST(Contacts, RandomTrianglesOnSmallGrids) {
  std::mt19937_64 random(17);
  for (const int size : {2, 3, 4}) {
    std::uniform_int_distribution<int> coordinate(0, size);
    for (const bool flat : {false, true}) {
      for (int repeat = 0; repeat < test_rounds(4000); ++repeat) {
        const auto point = [&] {
          return Point3{double(coordinate(random)), double(coordinate(random)),
                        flat ? 0.0 : double(coordinate(random))};
        };
        compare({point(), point(), point()}, {point(), point(), point()});
        if (HasFatalFailure()) return;
      }
    }
  }
}

}  // namespace
}  // namespace quoin::overlay
