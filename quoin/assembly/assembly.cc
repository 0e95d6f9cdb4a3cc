// SPDX-License-Identifier: Apache-2.0
#include "quoin/assembly/assembly.h"

#include "quoin/assembly/overlap.h"
#include "quoin/assembly/stopwatch.h"
#include "quoin/base/error.h"

namespace quoin {

namespace {

constexpr std::size_t most_overlaps_named = 20;

void find_solutions(AssemblyPlan& plan, const AssemblyQuestion& question, const Context& context) {
  if (question.partition.prune) {
    plan.partition = partition(plan.pairs, question.partition, plan.times, context);
    return;
  }
  plan.groups = unite_pairs(plan.pairs, MotionKind::infinite, plan.times, context);
  if (question.partition.announce) question.partition.announce(estimate(plan.groups));
  Stopwatch watch;
  plan.space = std::make_unique<MotionSpace>(plan.pairs.part_count, plan.groups, context);
  plan.times.motion_space += watch.lap();
  plan.partition = partition(*plan.space, question.partition, plan.times, context);
}

}  // namespace

AssemblyPlan analyse_assembly(std::span<const AssemblyPart> parts, const AssemblyQuestion& question,
                              const Context& context) {
  require_distinct_parts(parts);
  AssemblyPlan plan;
  for (const AssemblyPart& part : parts) {
    plan.times.maps += part.map_seconds;
    plan.times.reflections += part.reflection_seconds;
  }
  std::vector<OverlappingParts> overlaps;
  plan.pairs = project_pairs(parts, overlaps, plan.times, context);
  if (!overlaps.empty()) {
    throw InputError("parts overlap" + describe_overlaps(parts, overlaps, most_overlaps_named, context));
  }
  if (question.solutions) find_solutions(plan, question, context);
  if (question.infinitesimal) plan.infinitesimal = infinitesimal_freedom(plan.pairs, question.partition, context);
  if (question.sequence) {
    plan.disassembly = disassemble(plan.pairs, plan.space.get(), question.disassembly, context);
  }
  return plan;
}

}  // namespace quoin
