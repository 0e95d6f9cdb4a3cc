// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/solid/brep.h"
#include "quoin/solid/topology_counts.h"

namespace quoin::cli {

/// A file in which rounding changed the topology.
struct TopologyChange {
  std::string file;
  std::shared_ptr<const Brep> resolved;  ///< what the file holds, or would
  Topology before;
  Topology after;
};

/// What changed, in words.
std::string describe_change(const Topology& before, const Topology& after);

/// The same file by file, with both counts and the volumes.
nlohmann::ordered_json as_json(const std::vector<TopologyChange>& changes, const Brep& boundary,
                               const Context& context);

}  // namespace quoin::cli
