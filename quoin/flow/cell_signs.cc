// SPDX-License-Identifier: Apache-2.0
#include "quoin/flow/cell_signs.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "quoin/flow/face_formulas.h"
#include "quoin/flow/face_signs.h"
#include "quoin/number/fixed_int.h"

namespace quoin {

namespace {

using fixed_int_detail::Int128;
using flow::Vector;
using V = Vector<double>;

V minus(const Point3& a, const Point3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
/// The first number if it is true, else the second.
unsigned choose(bool is_first, unsigned first, unsigned second) {
  return second ^ ((first ^ second) & (0U - static_cast<unsigned>(is_first)));
}
double largest(const V& v) {
  return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
}
double square(const Point3& a, const Point3& b) {
  const V v = minus(a, b);
  return dot(v, v);
}

// With a, b, c the vectors from the first vertex and D their determinant: the circumcentre is N / 2D from there, and
// its barycentric numerators over 2 D^2 are N . (b x c), N . (c x a), N . (a x b), and 2 D^2 minus their sum.
//
// With coordinates up to M: minors are at most 2 M^2 with an error of 8 u M^2, D 6 M^3 with 46, squares 3 M^2 with 14.
// A term of N has 14 * 2 + 3 * 8 + 6 = 58 u M^4, three and their sums 204, |N| <= 18 M^4. N . minor: three terms of 204
// * 2 + 18 * 8 + 36 = 588 and sums: 1944 u M^6. The last: three of them, 1176 of 2 D^2, sums: 8000 u M^6 = 8.9e-13 M^6.
constexpr double centre_error = 9e-13;
constexpr double side_error = 2.3e-13;
// D |q|^2 - q . N for a vector q up to Q: 240 u M^3 Q^2 and 810 u M^4 Q, the difference 18 and 54 more: at most 864 u
// M^3 Q (M + Q) = 9.6e-14.
constexpr double sphere_error = 1.1e-13;
// Nothing overflows, and what underflows is far below the bounds.
constexpr double least_extent = 0x1p-140;
constexpr double most_extent = 0x1p140;

struct Sphere {
  V a;
  V b;
  V c;
  double aa;
  double bb;
  double cc;
  V bc;
  V ca;
  V ab;
  V n;
  double d;
  double m;

  explicit Sphere(const std::array<const Point3*, 4>& p)
      : a(minus(*p[1], *p[0])),
        b(minus(*p[2], *p[0])),
        c(minus(*p[3], *p[0])),
        aa(dot(a, a)),
        bb(dot(b, b)),
        cc(dot(c, c)),
        bc(cross(b, c)),
        ca(cross(c, a)),
        ab(cross(a, b)),
        n(bc * aa + ca * bb + ab * cc),
        d(dot(a, bc)),
        m(std::max({largest(a), largest(b), largest(c)})) {}
};

Vector<Int128> integers(const V& v, double scale) {
  const auto whole = [scale](double x) { return static_cast<Int128>(static_cast<std::int64_t>(x * scale)); };
  return {whole(v.x), whole(v.y), whole(v.z)};
}

/// The same in integers: at most 400 M^6, which fits up to M = 2^19.
struct IntegerSphere {
  Vector<Int128> bc;
  Vector<Int128> ca;
  Vector<Int128> ab;
  Vector<Int128> n;
  Int128 d;

  IntegerSphere(const std::array<const Point3*, 4>& p, double scale) {
    const Vector<Int128> a = integers(minus(*p[1], *p[0]), scale);
    const Vector<Int128> b = integers(minus(*p[2], *p[0]), scale);
    const Vector<Int128> c = integers(minus(*p[3], *p[0]), scale);
    bc = cross(b, c);
    ca = cross(c, a);
    ab = cross(a, b);
    n = bc * dot(a, a) + ca * dot(b, b) + ab * dot(c, c);
    d = dot(a, bc);
  }
  Sign centre_sign(unsigned facet) const {
    const Int128 one = dot(n, bc);
    const Int128 two = dot(n, ca);
    const Int128 three = dot(n, ab);
    switch (facet) {
      case 0:
        return sign_of(2 * d * d - one - two - three);
      case 1:
        return sign_of(one);
      case 2:
        return sign_of(two);
      default:
        return sign_of(three);
    }
  }
};
constexpr double most_integer = 0x1p19;

}  // namespace

CellSigns::CellSigns(const Delaunay3& triangulation)
    : cells_(triangulation.cells()),
      triangulation_(triangulation),
      signs_(triangulation.signs()),
      points_(triangulation.scaled_points().data()) {
  const PointExtent extent(triangulation.scaled_points());
  if (extent.grid == 0) return;
  // Coordinates, too, must be integers that doubles hold, so that their differences are.
  if (extent.largest / extent.grid > 0x1p52) return;
  to_grid_ = 1 / extent.grid;
  largest_exact_ = most_integer * extent.grid;
  const double most = std::max({extent.x, extent.y, extent.z}) / extent.grid;
  are_squares_exact_ = 9 * most * most < 0x1p52;
}

// The angle at the corner opposite to the longest side is acute if the squares of the other two are more than its own.
// Each square has an error of 5 u of itself, and both sums round: at most 8 u of the sum of all.
void CellSigns::set_corners(const Corners& p, const std::array<double, 3>& from_first, CellShape& shape) const {
  std::array<std::array<double, 4>, 4> length{};
  for (unsigned i = 1; i < 4; ++i) {
    length[i][0] = length[0][i] = from_first[i - 1];
    for (unsigned j = 1; j < i; ++j) length[i][j] = length[j][i] = square(*p[i], *p[j]);
  }
  const double error = are_squares_exact_ ? 0 : 1e-15;
  const double slack = are_squares_exact_ ? 0 : 0x1p-1000;
  unsigned corners = 0;
  unsigned rights = 0;
  for (unsigned i = 0; i < 4; ++i) {
    const unsigned j = (i + 1) & 3;
    const unsigned k = (i + 2) & 3;
    const unsigned l = (i + 3) & 3;
    const double behind_j = length[k][l];
    const double behind_k = length[l][j];
    const double behind_l = length[j][k];
    const double most = std::max({behind_j, behind_k, behind_l});
    // Without branches, which would be taken at random.
    const unsigned nearer = choose(behind_k > behind_j, k, j);
    const unsigned widest = choose(behind_l > std::max(behind_j, behind_k), l, nearer);
    const double sum = behind_j + behind_k + behind_l;
    const double value = sum - 2 * most;
    const double bound = error * sum + slack;
    unsigned corner = choose(value > bound, i, widest);
    bool is_right = false;
    if (!(std::fabs(value) > bound)) [[unlikely]]
      corner = close_corner(p, i, widest, is_right);
    corners |= corner << 2 * i;
    rights |= static_cast<unsigned>(is_right) << 2 * i;
  }
  shape.corner = static_cast<std::uint8_t>(corners);
  shape.right = static_cast<std::uint8_t>(rights);
}

unsigned CellSigns::close_corner(const Corners& p, unsigned facet, unsigned widest, bool& is_right) const {
  if (are_squares_exact_) {
    is_right = true;
    return widest;
  }
  for (unsigned i = 1; i < 4; ++i) {
    const unsigned corner = (facet + i) & 3;
    const unsigned j = i == 1 ? (facet + 2) & 3 : (facet + 1) & 3;
    const Sign sign = side_of_diametral_sphere(*p[j], *p[6 - facet - corner - j], *p[corner]);
    if (sign == Sign::positive) continue;
    is_right = sign == Sign::zero;
    return corner;
  }
  return facet;
}

Sign CellSigns::exact_centre_sign(const Corners& p, unsigned facet, double m) {
  ++undecided_.centres;
  if (is_on_grid(m)) return IntegerSphere(p, to_grid_).centre_sign(facet);
  const std::array<unsigned, 3>& slots = facet_slots[facet];
  return side_of_great_sphere({*p[slots[0]], *p[slots[1]], *p[slots[2]]}, *p[facet]);
}

bool CellSigns::is_exactly_on_sphere(std::uint32_t cell, const Corners& p, std::uint32_t vertex, double m) {
  ++undecided_.spheres;
  const V q = minus(points_[vertex], *p[0]);
  if (!is_on_grid(std::max(m, largest(q)))) return triangulation_.in_sphere(signs_, cell, vertex) == 0;
  const IntegerSphere sphere(p, to_grid_);
  const Vector<Int128> to = integers(q, to_grid_);
  return sphere.d * dot(to, to) == dot(to, sphere.n);
}

CellShape CellSigns::shape(std::uint32_t cell, unsigned tested, unsigned& spheres) {
  const TriangulationCell& t = cells_[cell];
  undecided_.centre_calls += 4;
  undecided_.sphere_calls += static_cast<unsigned>(std::popcount(tested));
  Corners p{};
  for (unsigned i = 0; i < 4; ++i) p[i] = &points_[t.vertices[i]];
  CellShape shape;
  const Sphere sphere(p);
  set_corners(p, {sphere.aa, sphere.bb, sphere.cc}, shape);
  const bool is_in_range = sphere.m >= least_extent && sphere.m <= most_extent;
  const double m3 = sphere.m * sphere.m * sphere.m;
  const double one = dot(sphere.n, sphere.bc);
  const double two = dot(sphere.n, sphere.ca);
  const double three = dot(sphere.n, sphere.ab);
  const std::array<double, 4> value{2 * sphere.d * sphere.d - (one + two + three), one, two, three};
  for (unsigned i = 0; i < 4; ++i) {
    const double bound = (i == 0 ? centre_error : side_error) * m3 * m3;
    Sign sign = sign_of(value[i]);
    if (!is_in_range || !(std::fabs(value[i]) > bound)) [[unlikely]]
      sign = exact_centre_sign(p, i, sphere.m);
    shape.centre = static_cast<std::uint8_t>(shape.centre | static_cast<unsigned>(to_int(sign) + 1) << 2 * i);
  }
  spheres = 0;
  for (unsigned i = 0; i < 4; ++i) {
    if ((tested >> i & 1) == 0) continue;
    const std::uint32_t mate = t.neighbours[i];
    const std::uint32_t vertex = cells_[mate >> 2].vertices[mate & 3];
    const V q = minus(points_[vertex], *p[0]);
    const double far = largest(q);
    const double power = sphere.d * dot(q, q) - dot(q, sphere.n);
    const bool is_certain =
        is_in_range && far >= least_extent && far <= most_extent && power > sphere_error * m3 * far * (sphere.m + far);
    if (is_certain) continue;
    if (is_exactly_on_sphere(cell, p, vertex, sphere.m)) spheres |= 1U << i;
  }
  return shape;
}

}  // namespace quoin
