// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "quoin/solid/leaf.h"

namespace quoin::cli {

/// One line per kind of finding, with the first elements.
std::vector<std::string> describe(const MeshDiagnosis& diagnosis);

/// The same of an exact boundary, whose faces are not mended.
std::vector<std::string> describe_boundary(const MeshDiagnosis& diagnosis);

/// What is said of an input without faces.
inline constexpr const char* no_faces = "no face has an area, so this is the empty solid";

/// "3 WHAT: 0 4 7", at most eight elements.
std::string describe(const std::string& what, std::span<const std::uint32_t> elements);

/// The kinds of findings that occur, by the names of the members of MeshDiagnosis, each with `count` and `elements`.
nlohmann::ordered_json as_json(const MeshDiagnosis& diagnosis);

/// Renames the faces: `name` holds a new index per face.
void rename_faces(MeshDiagnosis& diagnosis, std::span<const std::uint32_t> name);

}  // namespace quoin::cli
