// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/overlay/vertex_dissolving.h"

#include <algorithm>
#include <unordered_map>

namespace quoin::overlay {

namespace {

// One pass of a loop through a vertex.
struct Pass {
  std::uint32_t face;
  PointId before;
  PointId after;
};

std::vector<std::uint8_t> count_passes(const Constructions& table, const Brep& brep) {
  std::vector<std::uint8_t> passes(table.point_count(), 0);
  for (const PointId p : brep.loop_vertices) passes[p.value] = static_cast<std::uint8_t>(std::min(passes[p.value] + 1, 3));
  return passes;
}

bool planes_differ(const Constructions& table, const std::array<PointId, 3>& a, const std::array<PointId, 3>& b) {
  return std::any_of(b.begin(), b.end(),
                     [&](PointId p) { return table.orientation(a[0], a[1], a[2], p) != Sign::zero; });
}

// Of vertices passed twice: the edges on both sides lie in two different planes, hence on one line.
bool is_straight(const Constructions& table, const Brep& brep, const Pass& p, const Pass& q) {
  return p.before == q.after && p.after == q.before && p.before != p.after && p.face != q.face &&
         planes_differ(table, brep.face_planes[p.face], brep.face_planes[q.face]);
}

std::vector<bool> find_straight(const Constructions& table, const Brep& brep) {
  const std::vector<std::uint8_t> passes = count_passes(table, brep);
  std::vector<bool> straight(passes.size(), false);
  std::unordered_map<std::uint32_t, Pass> first_pass;
  for (std::uint32_t face = 0; face < brep.face_count(); ++face) {
    for (std::uint32_t l = brep.face_first_loop[face]; l < brep.face_first_loop[face + 1]; ++l) {
      const auto loop = brep.loop(l);
      for (std::size_t i = 0; i < loop.size(); ++i) {
        if (passes[loop[i].value] != 2) continue;
        const Pass pass{face, loop[i == 0 ? loop.size() - 1 : i - 1], loop[i + 1 == loop.size() ? 0 : i + 1]};
        const auto [other, is_first] = first_pass.try_emplace(loop[i].value, pass);
        if (!is_first && is_straight(table, brep, other->second, pass)) straight[loop[i].value] = true;
      }
    }
  }
  return straight;
}

}  // namespace

void dissolve_vertices(const Constructions& table, Brep& brep) {
  const std::vector<bool> straight = find_straight(table, brep);
  std::uint32_t kept = 0;
  std::uint32_t read = 0;
  for (std::size_t l = 0; l + 1 < brep.loop_begin.size(); ++l) {
    for (; read < brep.loop_begin[l + 1]; ++read) {
      const PointId p = brep.loop_vertices[read];
      if (!straight[p.value]) brep.loop_vertices[kept++] = p;
    }
    brep.loop_begin[l + 1] = kept;
  }
  brep.loop_vertices.resize(kept);
}

}  // namespace quoin::overlay
