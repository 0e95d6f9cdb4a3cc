// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "quoin/assembly/assembly.h"

namespace quoin::cli {

/// The plan as the report of `quoin assembly`; keys are documented in docs/command.md and stable.
nlohmann::ordered_json assembly_report(std::span<const AssemblyPart> parts, const AssemblyPlan& plan);

/// The same as lines for people; long lists are cut short and say so.
std::string assembly_text(std::span<const AssemblyPart> parts, const AssemblyPlan& plan);

/// "(0, 0, 1)".
std::string direction_text(const SphereDirection& direction);

/// "vertex", "edge", "face".
const char* name_of(MotionCell::Kind kind);

/// Three doubles along the direction: its integers where they are doubles, else of length one.
std::array<double, 3> rounded_direction(const SphereDirection& direction);

}  // namespace quoin::cli
