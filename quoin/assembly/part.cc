// SPDX-License-Identifier: Apache-2.0
#include "quoin/assembly/part.h"

#include <unordered_set>
#include <utility>

#include "quoin/assembly/stopwatch.h"
#include "quoin/base/error.h"

namespace quoin {

namespace {

Polytope reflected(const Polytope& piece, const Context& context) {
  std::vector<Point3> points;
  points.reserve(piece.vertex_count());
  for (std::uint32_t v = 0; v < piece.vertex_count(); ++v) {
    const Point3& p = piece.vertex(v);
    points.push_back({-p.x, -p.y, -p.z});
  }
  return Polytope::hull_of(points, context);
}

}  // namespace

AssemblyPart make_part(std::string name, std::vector<Polytope> pieces, const Context& context) {
  AssemblyPart part{std::move(name), std::move(pieces), {}, {}, {}, 0, 0};
  if (part.pieces.empty()) throw InputError("part '" + part.name + "' is empty");
  Stopwatch watch;
  for (const Polytope& piece : part.pieces) {
    if (piece.dimension() < 3) throw InputError("part '" + part.name + "': a piece is flat");
    part.reflected.push_back(reflected(piece, context));
    Box3 box;
    for (std::uint32_t v = 0; v < piece.vertex_count(); ++v) box.extend(piece.vertex(v));
    part.piece_boxes.push_back(box);
    part.box.extend(box);
  }
  part.reflection_seconds = watch.lap();
  return part;
}

void require_distinct_parts(std::span<const AssemblyPart> parts) {
  if (parts.empty()) throw InputError("an assembly without parts");
  std::unordered_set<std::string> names;
  for (const AssemblyPart& part : parts) {
    if (!names.insert(part.name).second) throw InputError("two parts have the name '" + part.name + "'");
  }
}

}  // namespace quoin
