// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/built_templates.h"

// For a library without the browser view; cmake/QuoinView.cmake says which it is.
#ifndef QUOIN_HAS_VIEW
namespace quoin {

std::string_view built_page_template() {
  return {};
}
std::string_view built_picture_template() {
  return {};
}
std::string_view built_sphere_template() {
  return {};
}
std::string_view built_plan_template() {
  return {};
}
std::string_view built_layers_template() {
  return {};
}

}  // namespace quoin
#endif
