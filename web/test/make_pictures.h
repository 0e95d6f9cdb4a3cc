// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace quoin {

/// Writes the pages and drawings that pictures.test.mjs looks at.
void write_pictures(const std::string& directory);
/// Writes those that plan.test.mjs looks at.
void write_plans(const std::string& directory);
/// Writes those that layers.test.mjs looks at.
void write_layers(const std::string& directory);

}  // namespace quoin
