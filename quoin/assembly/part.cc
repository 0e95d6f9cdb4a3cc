// SPDX-License-Identifier: Apache-2.0
#include "quoin/assembly/part.h"

#include <cmath>
#include <limits>
#include <unordered_set>
#include <utility>

#include "quoin/assembly/stopwatch.h"
#include "quoin/base/error.h"

namespace quoin {

namespace {

/// Of rounded vertices a little larger, so that it holds the exact ones.
Box3 box_of(const Polytope& piece) {
  Box3 box;
  for (std::uint32_t v = 0; v < piece.vertex_count(); ++v) {
    const Point3& p = piece.vertex(v);
    if (!piece.is_rational()) {
      box.extend(p);
      continue;
    }
    Point3 low;
    Point3 high;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::nextafter(p[axis], -std::numeric_limits<double>::infinity());
      high[axis] = std::nextafter(p[axis], std::numeric_limits<double>::infinity());
    }
    box.extend(low);
    box.extend(high);
  }
  return box;
}

}  // namespace

AssemblyPart make_part(std::string name, std::vector<Polytope> pieces, const Context& context) {
  AssemblyPart part{std::move(name), std::move(pieces), {}, {}, {}, 0, 0};
  if (part.pieces.empty()) throw InputError("part '" + part.name + "' is empty");
  Stopwatch watch;
  for (const Polytope& piece : part.pieces) {
    if (piece.dimension() < 3) throw InputError("part '" + part.name + "': a piece is flat");
    context.poll();
    part.reflected.push_back(quoin::reflected(piece));
    const Box3 box = box_of(piece);
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
