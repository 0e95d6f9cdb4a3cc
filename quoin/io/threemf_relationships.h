// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "quoin/base/context.h"

namespace quoin::io {

/// The path of the model in a 3MF package, without a slash in front, from the text of the package's relationships
/// (`_rels/.rels`); nothing where none of them is of the type of 3MF models.
/// @throws InputError  the text is not well formed, or two relationships name different models, or one names none
std::optional<std::string> threemf_model_path(std::string_view text, const std::string& name, const Context& context);

}  // namespace quoin::io
