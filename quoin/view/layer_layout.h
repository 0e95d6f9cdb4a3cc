// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "quoin/view/layered_scene.h"

namespace quoin {

/// What a page holds of a layer: its elements by the values from which on they are there; see layered_page.h.
struct LaidOut {
  std::vector<std::uint32_t> vertices;
  std::vector<std::uint32_t> shown;   ///< how many elements have begun, by value; empty: all from the first on
  std::vector<std::uint32_t> ends;    ///< those that stay have the number of values
  std::vector<std::uint32_t> colors;  ///< four for each element
  std::vector<std::uint32_t> owners;
};

/// Of a layer that check_layered_scene allows. O(size).
LaidOut lay_out(const SceneLayer& layer, std::size_t values);

}  // namespace quoin
