// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace quoin::cli {

/// All of a file, or of standard input for "-". Polls, also while nothing comes. @throws FileError; Cancelled
std::string read_all(const std::string& name);

/// The name for people: that of the file, or "standard input".
std::string shown(const std::string& name);

}  // namespace quoin::cli
