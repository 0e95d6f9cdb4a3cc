// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace quoin {

/// What web/ builds, one page each: HTML with the markers of page_format.h. Empty where the view was not built in.
/// Defined in generated files, or in no_templates.cc.
std::string_view built_page_template();
std::string_view built_picture_template();
std::string_view built_sphere_template();
std::string_view built_plan_template();
std::string_view built_layers_template();

}  // namespace quoin
