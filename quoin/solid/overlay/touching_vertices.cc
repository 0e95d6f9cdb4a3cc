// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/overlay/touching_vertices.h"

#include <algorithm>
#include <utility>

namespace quoin::overlay {

namespace {

// Behind the loops that the faces have.
void append_loops(Brep& brep, const std::vector<InnerVertex>& touching) {
  Brep result;
  auto next = touching.begin();
  for (std::uint32_t face = 0; face < brep.face_count(); ++face) {
    for (std::uint32_t l = brep.face_first_loop[face]; l < brep.face_first_loop[face + 1]; ++l) {
      const auto loop = brep.loop(l);
      result.loop_vertices.insert(result.loop_vertices.end(), loop.begin(), loop.end());
      result.loop_begin.push_back(static_cast<std::uint32_t>(result.loop_vertices.size()));
    }
    for (; next != touching.end() && next->face == face; ++next) {
      result.loop_vertices.push_back(next->point);
      result.loop_begin.push_back(static_cast<std::uint32_t>(result.loop_vertices.size()));
    }
    result.face_first_loop.push_back(static_cast<std::uint32_t>(result.loop_count()));
  }
  brep.loop_vertices = std::move(result.loop_vertices);
  brep.loop_begin = std::move(result.loop_begin);
  brep.face_first_loop = std::move(result.face_first_loop);
}

}  // namespace

void add_touching_vertices(FaceParts& parts, std::vector<std::uint8_t>& is_corner) {
  if (parts.inner_vertices.empty()) return;
  for (const PointId p : parts.composed.loop_vertices) is_corner[p.value] = 1;
  std::vector<InnerVertex> touching;
  std::copy_if(parts.inner_vertices.begin(), parts.inner_vertices.end(), std::back_inserter(touching),
               [&](const InnerVertex& v) { return is_corner[v.point.value] != 0; });
  parts.inner_vertices = {};
  if (!touching.empty()) append_loops(parts.composed, touching);
}

}  // namespace quoin::overlay
