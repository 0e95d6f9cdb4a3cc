// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/summary.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "quoin/solid/measure.h"
#include "quoin/solid/topology_counts.h"

namespace quoin::cli {

using Json = nlohmann::ordered_json;

namespace {

// A polygon with n corners in l loops has n + 2 l - 4 triangles for one outer loop; a loop of one vertex adds two.
std::size_t triangle_count(const Brep& b) {
  std::size_t count = 0;
  for (std::size_t f = 0; f < b.face_count(); ++f) {
    const std::uint32_t first = b.face_first_loop[f];
    const std::uint32_t end = b.face_first_loop[f + 1];
    count += b.loop_begin[end] - b.loop_begin[first] + 2 * (end - first) - 4;
    for (std::uint32_t l = first; l < end; ++l) count -= b.loop(l).size() == 1 ? 1 : 0;
  }
  return count;
}

constexpr std::size_t short_boundary = 2000;  // corners up to which the exact volume is worked out
constexpr std::size_t short_number = 60;      // digits up to which it is printed

Json as_json(const std::optional<Bounds>& box) {
  if (!box) return nullptr;
  return {{box->lo.x, box->lo.y, box->lo.z}, {box->hi.x, box->hi.y, box->hi.z}};
}

Json summarize_topology(const Brep& boundary) {
  const TopologyCounts counts = count_topology(boundary);
  Json s;
  s["vertices"] = counts.vertices;
  s["edges"] = counts.edges;
  s["faces"] = counts.faces;
  s["triangles"] = triangle_count(boundary);
  s["shells"] = boundary.shells.size();
  s["voids"] =
      std::count_if(boundary.shells.begin(), boundary.shells.end(), [](const Shell& shell) { return shell.is_void; });
  s["components"] = boundary.component_count;
  s["closed"] = counts.is_closed();
  s["manifold"] = counts.is_manifold();
  s["nonmanifold_edges"] = counts.nonmanifold_edges;
  s["nonmanifold_vertices"] = counts.nonmanifold_vertices;
  s["unbounded"] = boundary.is_unbounded;
  return s;
}

void add_extent(Json& s, const Brep& boundary, const Context& context) {
  s["area"] = surface_area(boundary, context);
  s["bounds"] = as_json(bounds(boundary));
  s["inputs"] = boundary.leaf_names;
}

Vector3 difference(const Point3& a, const Point3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

// Twice the area of a polygon, by its fan.
double twice_area(const Mesh& mesh, std::size_t face) {
  const std::span<const std::uint32_t> corners = mesh.face(face);
  Vector3 sum;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const Point3& apex = mesh.vertices[corners[0]];
    const Vector3 a = difference(mesh.vertices[corners[i - 1]], apex);
    const Vector3 b = difference(mesh.vertices[corners[i]], apex);
    sum = {sum.x + a.y * b.z - a.z * b.y, sum.y + a.z * b.x - a.x * b.z, sum.z + a.x * b.y - a.y * b.x};
  }
  return std::hypot(sum.x, sum.y, sum.z);
}

std::optional<Bounds> bounds_of(const Mesh& mesh) {
  if (mesh.corners.empty()) return std::nullopt;
  const Point3& first = mesh.vertices[mesh.corners[0]];
  Bounds box{first, first};
  for (const std::uint32_t v : mesh.corners) {
    const Point3& p = mesh.vertices[v];
    box.lo = {std::min(box.lo.x, p.x), std::min(box.lo.y, p.y), std::min(box.lo.z, p.z)};
    box.hi = {std::max(box.hi.x, p.x), std::max(box.hi.y, p.y), std::max(box.hi.z, p.z)};
  }
  return box;
}

template <class Element>
std::size_t count_distinct(std::vector<Element> elements) {
  std::sort(elements.begin(), elements.end());
  return static_cast<std::size_t>(std::unique(elements.begin(), elements.end()) - elements.begin());
}

std::size_t edge_count(const Mesh& mesh) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  edges.reserve(mesh.corners.size());
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const std::span<const std::uint32_t> corners = mesh.face(f);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::uint32_t next = corners[(i + 1) % corners.size()];
      if (corners[i] != next) edges.emplace_back(std::min(corners[i], next), std::max(corners[i], next));
    }
  }
  return count_distinct(std::move(edges));
}

}  // namespace

Json summarize(const Brep& boundary, const Context& context) {
  Json s = summarize_topology(boundary);
  s["volume"] = rounded_volume(boundary, context);
  if (boundary.loop_vertices.size() <= short_boundary) {
    const std::string exact = volume(boundary, context).to_string();
    if (exact.size() <= short_number) s["exact_volume"] = exact;
  }
  add_extent(s, boundary, context);
  return s;
}

Json summarize_centroid(const Brep& boundary, const Context& context) {
  const std::optional<RationalPoint3> centre = centroid(boundary, context);
  if (!centre) return nullptr;
  return {centre->x.to_double(), centre->y.to_double(), centre->z.to_double()};
}

Json summarize_surface(const Brep& boundary, const Context& context) {
  Json s = summarize_topology(boundary);
  s["volume"] = nullptr;
  add_extent(s, boundary, context);
  return s;
}

Json summarize_surface(const Mesh& mesh, const MeshDiagnosis& diagnosis) {
  double area = 0;
  std::size_t triangles = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    area += 0.5 * twice_area(mesh, f);
    triangles += std::max<std::size_t>(mesh.face(f).size(), 2) - 2;
  }
  Json s;
  s["vertices"] = count_distinct(mesh.corners);
  s["edges"] = edge_count(mesh);
  s["faces"] = mesh.face_count();
  s["triangles"] = triangles;
  for (const char* of_solids : {"shells", "voids", "components"}) s[of_solids] = nullptr;
  s["closed"] = diagnosis.is_closed();
  s["manifold"] = false;
  s["nonmanifold_edges"] = diagnosis.nonmanifold_edges.count;
  s["nonmanifold_vertices"] = nullptr;
  s["unbounded"] = false;
  s["volume"] = nullptr;
  s["area"] = area;
  s["bounds"] = as_json(bounds_of(mesh));
  s["inputs"] = {mesh.name};
  return s;
}

std::string as_text(const Json& summary) {
  std::string text;
  for (const auto& [key, value] : summary.items()) {
    std::string name = key;
    std::replace(name.begin(), name.end(), '_', ' ');
    text += name + std::string(name.size() < 22 ? 22 - name.size() : 1, ' ') +
            (value.is_string() ? value.get<std::string>() : value.dump()) + "\n";
  }
  return text;
}

}  // namespace quoin::cli
