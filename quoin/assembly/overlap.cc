// SPDX-License-Identifier: Apache-2.0
#include "quoin/assembly/overlap.h"

#include <array>

#include "quoin/polytope/convex_boundary.h"
#include "quoin/polytope/hull.h"
#include "quoin/solid/measure.h"

namespace quoin {

namespace {

Solid solid_of(const Polytope& piece, const Context& context) {
  std::vector<RationalPoint3> points;
  for (std::uint32_t v = 0; v < piece.vertex_count(); ++v) points.push_back(piece.exact_vertex(v));
  const Brep boundary = convex_boundary(convex_hull(points, context), points, "piece");
  return Solid::of_leaf(make_leaf(boundary, "piece", {}, context).leaf);
}

}  // namespace

Solid solid_of(const AssemblyPart& part, const Context& context) {
  std::vector<Solid> pieces;
  for (const Polytope& piece : part.pieces) pieces.push_back(solid_of(piece, context));
  return unite(pieces, context);
}

Rational common_volume(const AssemblyPart& a, const AssemblyPart& b, const Context& context) {
  const Solid common = intersect(std::array{solid_of(a, context), solid_of(b, context)}, context);
  return volume(common.boundary(), context);
}

std::string describe_overlaps(std::span<const AssemblyPart> parts, std::span<const OverlappingParts> overlaps,
                              std::size_t most, const Context& context) {
  std::string text;
  for (std::size_t k = 0; k < overlaps.size() && k < most; ++k) {
    const AssemblyPart& a = parts[overlaps[k].first];
    const AssemblyPart& b = parts[overlaps[k].second];
    text += "\n  " + a.name + " and " + b.name + " overlap in a volume of " + common_volume(a, b, context).to_string();
  }
  if (overlaps.size() > most) text += "\n  and " + std::to_string(overlaps.size() - most) + " more pairs";
  return text;
}

}  // namespace quoin
