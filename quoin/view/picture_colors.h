// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "quoin/solid/mesh.h"

namespace quoin {

enum class PictureTheme : unsigned char { light, dark };

/// Fill of faces of a category: ten quiet hues, then hues a golden angle apart. Light on light paper, deep on dark, so
/// that text and lines in ink are read on them.
Color fill_color(std::size_t category, PictureTheme theme);
/// Of lines and points of a category: the same hue, strong enough on paper and on fills.
Color line_color(std::size_t category, PictureTheme theme);

}  // namespace quoin
