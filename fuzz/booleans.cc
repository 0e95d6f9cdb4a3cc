// SPDX-License-Identifier: Apache-2.0
//
// Booleans of two or three tetrahedra and boxes on a grid of a few points, where nearly everything is degenerate.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "fuzz/promise.h"
#include "fuzz/targets.h"
#include "quoin/solid/check.h"
#include "quoin/solid/measure.h"
#include "quoin/solid/shapes.h"
#include "quoin/solid/solid.h"

namespace quoin::fuzz {

namespace {

Point3 point(Bytes& in) {
  const double x = in.next() % 5;
  const double y = in.next() % 5;
  return {x, y, static_cast<double>(in.next() % 5)};
}

Mesh tetrahedron(Bytes& in) {
  Mesh mesh;
  for (int i = 0; i < 4; ++i) mesh.vertices.push_back(point(in));
  for (const std::array<std::uint32_t, 3>& face :
       {std::array{0U, 2U, 1U}, std::array{0U, 1U, 3U}, std::array{1U, 2U, 3U}, std::array{2U, 0U, 3U}}) {
    mesh.add_face(face);
  }
  return shapes::approximate_volume(mesh) < 0 ? shapes::reversed(mesh) : mesh;
}

Mesh box(Bytes& in) {
  const Point3 p = point(in);
  const Point3 q = point(in);
  const Point3 lo{std::min(p.x, q.x), std::min(p.y, q.y), std::min(p.z, q.z)};
  return shapes::box(lo,
                     {std::max({p.x, q.x, lo.x + 1}), std::max({p.y, q.y, lo.y + 1}), std::max({p.z, q.z, lo.z + 1})});
}

Rational checked_volume(const Solid& s, const Context& context) {
  for (const std::string& violation : check_boundary(s.boundary(), 10, context)) {
    std::fprintf(stderr, "%s\n", violation.c_str());
    require(false, "a boundary is valid");
  }
  return volume(s.boundary(), context);
}

}  // namespace

void booleans(std::span<const std::uint8_t> bytes) {
  Bytes in(bytes);
  const Context context({.threads = 1});
  std::vector<Solid> solids;
  const std::uint8_t kinds = in.next();
  for (unsigned i = 0; i < (kinds < 128 ? 2U : 3U); ++i) {
    const Mesh mesh = ((kinds >> i) & 1U) != 0 ? tetrahedron(in) : box(in);
    const LeafResult result = make_leaf(mesh, {}, context);
    if (!result.leaf) return;  // a flat tetrahedron
    solids.push_back(Solid::from_leaf(result.leaf, context));
  }
  const Solid first = solids[0];
  const Solid rest = unite(std::span(solids).subspan(1), context);
  const std::array<Solid, 2> both{first, rest};
  const Rational a = checked_volume(first, context);
  const Rational b = checked_volume(rest, context);
  const Rational together = checked_volume(unite(both, context), context);
  const Rational common = checked_volume(intersect(both, context), context);
  const Rational difference = checked_volume(subtract(first, {&rest, 1}, context), context);
  const Rational either = checked_volume(symmetric_difference(both, context), context);
  require(together + common == a + b, "union and intersection have the volumes of both together");
  require(difference == a - common, "the difference lacks the intersection");
  require(either == together - common, "the symmetric difference is the union without the intersection");
  const std::array<Solid, 2> cut{first, complement(rest, context)};
  require(checked_volume(intersect(cut, context), context) == difference, "A - B is A without B");
}

}  // namespace quoin::fuzz
