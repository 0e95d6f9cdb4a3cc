// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/polytope_report.h"

#include <utility>

#include "quoin/base/error.h"
#include "quoin/cli/planar.h"
#include "quoin/cli/summary.h"

namespace quoin::cli {

using Json = nlohmann::ordered_json;

Json cell_counts(std::size_t vertices, std::size_t edges, std::size_t facets) {
  return {{"vertices", vertices}, {"edges", edges}, {"facets", facets}};
}

int report_flat(int dimension, const std::string& what, Json details, std::vector<std::string> warnings,
                const Options& options) {
  const std::string flat = what + " in one " + (dimension == 2 ? "plane" : dimension == 1 ? "line" : "place");
  if (!options.outputs.empty()) throw InputError(flat + ", which bounds no solid that a file could hold");
  warnings.push_back(flat);
  const std::string text = as_text(details);
  print_report(std::move(details), text, warnings, options);
  return 0;
}

}  // namespace quoin::cli
