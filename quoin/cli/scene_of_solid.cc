// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/scene_of_solid.h"

#include <algorithm>
#include <bit>
#include <tuple>
#include <unordered_set>

#include "quoin/cli/summary.h"
#include "quoin/solid/query/shell_components.h"

namespace quoin::cli {

namespace {

// Points that span the planes of faces, as the view wants them: vertices where they are such.
class PlanePoints {
 public:
  explicit PlanePoints(ViewPart& part) : part_(part), by_place_(part.vertices.size(), Hash{this}, Equal{this}) {
    for (std::uint32_t v = 0; v < part.vertices.size(); ++v) by_place_.insert(v);
  }

  std::uint32_t index_of(const Point3& point) {
    const auto next = static_cast<std::uint32_t>(part_.vertices.size() + part_.plane_points.size());
    part_.plane_points.push_back(point);
    const auto [found, is_new] = by_place_.insert(next);
    if (!is_new) part_.plane_points.pop_back();
    return *found;
  }

 private:
  struct Hash {
    const PlanePoints* points;
    std::size_t operator()(std::uint32_t index) const {
      std::size_t hash = 0;
      // Adding zero makes -0 hash as 0.
      for (std::size_t k = 0; k < 3; ++k) {
        hash = (hash ^ std::bit_cast<std::uint64_t>(points->at(index)[k] + 0.0)) * 0x9E3779B97F4A7C15U;
        hash ^= hash >> 29;
      }
      return hash;
    }
  };
  struct Equal {
    const PlanePoints* points;
    bool operator()(std::uint32_t a, std::uint32_t b) const { return points->at(a) == points->at(b); }
  };

  const Point3& at(std::uint32_t index) const {
    const std::size_t vertices = part_.vertices.size();
    return index < vertices ? part_.vertices[index] : part_.plane_points[index - vertices];
  }

  ViewPart& part_;
  std::unordered_set<std::uint32_t, Hash, Equal> by_place_;
};

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
  const char* rounding[] = {"exact", "certified", "changed the topology", "failed"};
  scene.facts.emplace_back("rounding", rounding[static_cast<int>(triangles.rounding)]);
  if (boundary.is_unbounded) scene.facts.emplace_back("extent", "unbounded: the material is outside");
  ViewPart part;
  part.name = title;
  part.vertices = triangles.vertices;
  part.triangles = triangles.triangles;
  part.triangle_face = triangles.triangle_face;
  part.edges = edges_between_faces(triangles);
  PlanePoints plane_points(part);
  const std::vector<std::uint32_t> components = components_of_shells(boundary, context);
  for (std::uint32_t f = 0; f < boundary.face_count(); ++f) {
    const std::uint32_t first = boundary.face_first_origin[f];
    ViewFace face;
    const auto& [p, q, r] = boundary.face_planes[f];  // explicit points, which rounding leaves as they are
    part.face_spans.push_back({plane_points.index_of(boundary.points.rounded(p)),
                               plane_points.index_of(boundary.points.rounded(q)),
                               plane_points.index_of(boundary.points.rounded(r))});
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
