// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/summary.h"

#include <algorithm>

#include "quoin/solid/measure.h"
#include "quoin/solid/topology_counts.h"

namespace quoin::cli {

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

}  // namespace

nlohmann::ordered_json summarize(const Brep& boundary, const Context& context) {
  const TopologyCounts counts = count_topology(boundary);
  nlohmann::ordered_json s;
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
  s["volume"] = rounded_volume(boundary, context);
  if (boundary.loop_vertices.size() <= short_boundary) {
    const std::string exact = volume(boundary, context).to_string();
    if (exact.size() <= short_number) s["exact_volume"] = exact;
  }
  s["area"] = surface_area(boundary, context);
  if (const auto box = bounds(boundary)) {
    s["bounds"] = {{box->lo.x, box->lo.y, box->lo.z}, {box->hi.x, box->hi.y, box->hi.z}};
  } else {
    s["bounds"] = nullptr;
  }
  s["inputs"] = boundary.leaf_names;
  return s;
}

std::string as_text(const nlohmann::ordered_json& summary) {
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
