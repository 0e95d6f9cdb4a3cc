// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "quoin/solid/mesh.h"
#include "quoin/view/picture_path.h"
#include "quoin/view/scene.h"

namespace quoin {

/// What a cell of a picture says of itself; every part may be left out.
struct PictureText {
  std::string name{};             ///< "Face 3": in tooltips and cards
  std::string label{};            ///< written into the picture where there is room
  std::vector<ViewFact> facts{};  ///< lines of the card, as people read them
};

/// How a cell is coloured: by a category, whose colour the palette chooses for light and dark, or by a colour as it is.
struct PictureFill {
  std::optional<std::uint32_t> category{};
  std::optional<Color> color{};  ///< goes before the category

  bool is_none() const { return !category && !color; }
};

/// A region between closed curves, by the even-odd rule: holes need no orientation, and an edge that is passed twice
/// bounds nothing.
struct PictureFace {
  std::vector<PicturePath> rings{};  ///< each is closed by a straight step where it ends elsewhere than it began
  bool is_outside = false;           ///< also whatever lies outside all rings, as far as the picture reaches
  PictureFill fill{};
  PictureText text{};
};

enum class EdgeStyle : std::uint8_t { plain, strong, faint, dashed };

struct PictureEdge {
  PicturePath path{};
  EdgeStyle style = EdgeStyle::plain;
  PictureFill stroke{};
  PictureText text{};
};

struct PicturePoint {
  Point2 at{};
  double size = 1;  ///< of the usual radius
  PictureFill fill{};
  PictureText text{};
};

/// Something to look at in the plane, y upward: faces, over them edges, over them points, each in the order given.
///
/// Numbers are rounded, and nothing here is tied to how it was computed.
struct PlanarPicture {
  std::string title{};
  std::vector<ViewFact> facts{};
  std::vector<PictureFace> faces{};
  std::vector<PictureEdge> edges{};
  std::vector<PicturePoint> points{};
  std::vector<std::string> categories{};  ///< names for the legend; categories beyond its end have none
  std::optional<PictureBox> box{};        ///< what is shown; else all edges, points and rings
};

/// What the picture shows: its box, or one around everything in it with a margin.
PictureBox shown_box(const PlanarPicture& picture);

/// @throws InputError  a coordinate is not finite, or an arc has no radius; names the cell. O(n).
void check_picture(const PlanarPicture& picture);

}  // namespace quoin
