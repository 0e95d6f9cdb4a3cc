// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "quoin/view/planar_picture.h"

namespace quoin {

/// What a picture's page says of its cells, as JSON: for write_picture_page and write_sphere_page, and for
/// web/src/cells/data.ts, which reads it.
///
/// A cell is [name, label, [[fact, value], ...], colour], where the colour is an index into "colors", or -1. "colors"
/// holds [fill on light, fill on dark, line on light, line on dark] each; "legend" [name, colour].
class CellsJson {
 public:
  explicit CellsJson(std::ostream& out) : out_(out) {}

  /// Members "title", "facts" and "legend".
  void write_head(const std::string& title, const std::vector<ViewFact>& facts,
                  const std::vector<std::string>& categories);
  void write_cell(const PictureText& text, const PictureFill& fill);
  /// Member "colors": after all cells, whose colours it holds.
  void write_colors();

 private:
  int color_of(const PictureFill& fill);

  std::ostream& out_;
  std::map<std::uint64_t, int> indices_;  // by category, or by colour beyond 2^32
  std::vector<PictureFill> colors_;
};

}  // namespace quoin
