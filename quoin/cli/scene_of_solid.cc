// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/scene_of_solid.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "quoin/cli/summary.h"
#include "quoin/solid/query/shell_components.h"

namespace quoin::cli {

namespace {

// The plane of a face exactly where doubles hold its coefficients, else none: the view then shows it as rounded.
std::array<double, 4> plane_of(const Brep& b, std::uint32_t f) {
  const RationalPoint3 p = b.points.exact(b.face_planes[f][0]);
  const RationalPoint3 q = b.points.exact(b.face_planes[f][1]);
  const RationalPoint3 r = b.points.exact(b.face_planes[f][2]);
  const RationalPoint3 u{q.x - p.x, q.y - p.y, q.z - p.z};
  const RationalPoint3 v{r.x - p.x, r.y - p.y, r.z - p.z};
  const RationalPoint3 n{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
  const Rational exact[] = {n.x, n.y, n.z, n.x * p.x + n.y * p.y + n.z * p.z};
  std::array<double, 4> plane{};
  for (std::size_t k = 0; k < 4; ++k) {
    plane[k] = exact[k].to_double();
    if (!std::isfinite(plane[k]) || Rational(plane[k]) != exact[k]) return {};
  }
  return plane;
}

// Edges of triangles at which two different faces meet.
std::vector<std::array<std::uint32_t, 2>> edges_between_faces(const Triangulated& t) {
  struct Use {
    std::uint32_t a;
    std::uint32_t b;
    std::uint32_t face;
  };
  std::vector<Use> uses;
  uses.reserve(3 * t.triangles.size());
  for (std::size_t i = 0; i < t.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t p = t.triangles[i][k];
      const std::uint32_t q = t.triangles[i][(k + 1) % 3];
      uses.push_back({std::min(p, q), std::max(p, q), t.triangle_face[i]});
    }
  }
  std::sort(uses.begin(), uses.end(),
            [](const Use& x, const Use& y) { return std::tie(x.a, x.b, x.face) < std::tie(y.a, y.b, y.face); });
  std::vector<std::array<std::uint32_t, 2>> edges;
  for (std::size_t i = 0; i < uses.size();) {
    std::size_t j = i + 1;
    while (j < uses.size() && uses[j].a == uses[i].a && uses[j].b == uses[i].b) ++j;
    if (uses[i].face != uses[j - 1].face) edges.push_back({uses[i].a, uses[i].b});
    i = j;
  }
  return edges;
}

}  // namespace

ViewScene scene_of_solid(const Brep& boundary, const Triangulated& triangles, const std::string& title,
                         const Context& context) {
  ViewScene scene;
  scene.title = title;
  scene.origins = boundary.leaf_names;
  const nlohmann::ordered_json summary = summarize(boundary, context);
  for (const char* key : {"volume", "area", "vertices", "faces", "shells", "components", "closed", "manifold"}) {
    scene.facts.emplace_back(key, summary[key].dump());
  }
  const char* rounding[] = {"exact", "certified", "failed"};
  scene.facts.emplace_back("rounding", rounding[static_cast<int>(triangles.rounding)]);
  if (boundary.is_unbounded) scene.facts.emplace_back("extent", "unbounded: the material is outside");
  ViewPart part;
  part.name = title;
  part.vertices = triangles.vertices;
  part.triangles = triangles.triangles;
  part.triangle_face = triangles.triangle_face;
  part.edges = edges_between_faces(triangles);
  const std::vector<std::uint32_t> components = components_of_shells(boundary, context);
  for (std::uint32_t f = 0; f < boundary.face_count(); ++f) {
    const std::uint32_t first = boundary.face_first_origin[f];
    ViewFace face;
    face.plane = plane_of(boundary, f);
    face.origin = boundary.origins[first].leaf;
    face.origin_face = boundary.origins[first].face;
    face.piece = components[boundary.face_shells[f]];
    if (!boundary.face_colors.empty()) face.color = boundary.face_colors[f];
    part.faces.push_back(face);
    for (std::uint32_t o = first + 1; o < boundary.face_first_origin[f + 1]; ++o) {
      part.more_origins.push_back({f, boundary.origins[o].leaf, boundary.origins[o].face});
    }
  }
  scene.parts.push_back(std::move(part));
  return scene;
}

}  // namespace quoin::cli
