// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/topology_report.h"

#include "quoin/solid/measure.h"

namespace quoin::cli {

namespace {

using Json = nlohmann::ordered_json;

void add_change(std::string& text, const char* what, std::size_t before, std::size_t after) {
  if (before == after) return;
  text += (text.empty() ? "" : ", ") + std::to_string(after) + " " + what + " instead of " + std::to_string(before);
}

Json as_json(const Topology& topology) {
  return {{"components", topology.components},
          {"shells", topology.shells},
          {"voids", topology.voids},
          {"manifold", topology.is_manifold},
          {"handles", topology.handles}};
}

}  // namespace

std::string describe_change(const Topology& before, const Topology& after) {
  if (after.shells == 0) return "nothing is left of it (components before: " + std::to_string(before.components) + ")";
  std::string text;
  add_change(text, "components", before.components, after.components);
  add_change(text, "shells", before.shells, after.shells);
  add_change(text, "voids", before.voids, after.voids);
  if (before.is_manifold != after.is_manifold) {
    text += (text.empty() ? "" : ", ");
    text += after.is_manifold ? "it no longer touches itself" : "it comes to touch itself";
  } else {
    add_change(text, "handles", before.handles, after.handles);
  }
  return text;
}

Json as_json(const std::vector<TopologyChange>& changes, const Brep& boundary, const Context& context) {
  Json json = Json::array();
  for (const TopologyChange& change : changes) {
    Json before = as_json(change.before);
    Json after = as_json(change.after);
    before["volume"] = rounded_volume(boundary, context);
    after["volume"] = rounded_volume(*change.resolved, context);
    json.push_back({{"file", change.file}, {"before", std::move(before)}, {"after", std::move(after)}});
  }
  return json;
}

}  // namespace quoin::cli
