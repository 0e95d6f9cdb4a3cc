// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <string_view>

#include "quoin/solid/brep.h"

namespace quoin {

/// Writes a boundary exactly: every coordinate as a rational, every face with its plane and loops. Text, lines,
/// described in docs/exact-text.md. @throws FileError
void write_exact_text(const std::filesystem::path& path, const Brep& boundary);
void write_exact_text(std::ostream& out, const Brep& boundary);

/// Reads it back without loss. @throws InputError with file and line
Brep read_exact_text(std::string_view text, const std::string& name);

}  // namespace quoin
