// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/flow_scene_parts.h"

#include <cmath>
#include <string>

namespace quoin::cli {

std::vector<std::uint32_t> first_inputs(const Delaunay3& triangulation) {
  std::vector<std::uint32_t> first;
  for (std::uint32_t v = 0; v < triangulation.vertex_count(); ++v) first.push_back(triangulation.inputs(v)[0]);
  return first;
}

void cut_layer(SceneLayer& layer, std::uint32_t stop, const PageValues& stops, LayeredScene& scene) {
  const std::size_t width = static_cast<std::size_t>(layer.kind) + 1;
  while (!layer.begin.empty() && layer.begin.back() >= stop) {
    layer.begin.pop_back();
    layer.owners.pop_back();
    layer.vertices.resize(layer.vertices.size() - width);
  }
  const std::string last = stop > 0 ? "up to distance " + short_text(std::sqrt(stops.value(stop - 1))) : "none";
  scene.facts.emplace_back(layer.name, last + " only: more are too many for a page");
}

}  // namespace quoin::cli
