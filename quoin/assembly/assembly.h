// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "quoin/assembly/disassembly.h"
#include "quoin/assembly/infinitesimal.h"
#include "quoin/assembly/motion_space.h"
#include "quoin/assembly/pair_regions.h"
#include "quoin/assembly/part.h"
#include "quoin/assembly/partition.h"

namespace quoin {

/// What is asked of an assembly.
struct AssemblyQuestion {
  bool solutions = true;       ///< all directions in which it comes apart in two
  bool infinitesimal = false;  ///< what can begin to move
  bool sequence = false;       ///< how it comes apart altogether
  PartitionOptions partition{};
  DisassemblyOptions disassembly{};
};

/// What came of it.
struct AssemblyPlan {
  PairRegions pairs;
  std::vector<RegionGroup> groups;           ///< of `space`
  std::unique_ptr<const MotionSpace> space;  ///< null without solutions, and where pruned
  std::optional<Partition> partition;
  std::optional<InfinitesimalFreedom> infinitesimal;
  std::optional<Disassembly> disassembly;
  PhaseTimes times;
};

/// All of it. Exact, by translations to infinity, two sets at a time; parts may touch and slide along one another.
/// @throws InputError  no parts, two of one name, or overlapping ones, with each pair and its volume; Cancelled
AssemblyPlan analyse_assembly(std::span<const AssemblyPart> parts, const AssemblyQuestion& question,
                              const Context& context);

}  // namespace quoin
