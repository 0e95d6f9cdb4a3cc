// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "quoin/cli/options.h"
#include "quoin/cli/streams.h"
#include "quoin/cli/targets.h"
#include "quoin/io/arrangement_text.h"

namespace quoin::cli {

/// Writes an arrangement or a set of the plane to the outputs that hold one exactly, .qarr.
template <class ArrangementOrSet>
void write_exact_targets(const ArrangementOrSet& what, const std::vector<std::string>& names, const Options& options) {
  for (const Target& target : targets_of(options)) {
    if (target.kind != Target::Kind::planar_exact) continue;
    if (target.is_stream()) {
      write_arrangement_text(data_stream(), what, names);
      flush_standard_output();
    } else {
      write_arrangement_text(std::filesystem::path(target.name), what, names);
    }
  }
}

}  // namespace quoin::cli
