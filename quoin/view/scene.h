// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "quoin/kernel/point.h"
#include "quoin/solid/mesh.h"

namespace quoin {

/// A line of the view's panel, as people read it: {"Volume", "8000 mm³"}.
using ViewFact = std::pair<std::string, std::string>;

/// A face as the view shows it; its triangles are those of the part that name it in `triangle_face`.
struct ViewFace {
  /// (a, b, c, d): a x + b y + c z = d with (a, b, c) pointing outward, of any length. All zero: not known; the view
  /// then shows the plane of ViewPart::face_spans, or else of the triangle that was picked, as rounded.
  std::array<double, 4> plane{};
  std::uint32_t origin = 0;       ///< index into ViewScene::origins; faces without a colour are coloured by it
  std::uint32_t origin_face = 0;  ///< index of the face in that input
  std::uint32_t piece = 0;        ///< faces of a part with equal number move together in the exploded view
  std::optional<Color> color{};
};

/// A further input face that a face lies on, besides the one its ViewFace names.
struct ViewOrigin {
  std::uint32_t face;         ///< index into ViewPart::faces
  std::uint32_t origin;       ///< index into ViewScene::origins
  std::uint32_t origin_face;  ///< index of the face in that input
};

/// One object of the scene, which can be hidden and shown by its name.
struct ViewPart {
  std::string name{};
  std::vector<Point3> vertices{};                         ///< finite
  std::vector<std::array<std::uint32_t, 3>> triangles{};  ///< counterclockwise seen from outside
  std::vector<std::uint32_t> triangle_face{};             ///< index into faces, one per triangle
  std::vector<ViewFace> faces{};
  std::vector<std::string> plane_texts{};  ///< empty, or per face: the exact equation, shown as it stands
  /// Empty, or per face: three points that span its plane exactly, counterclockwise seen from outside. Indices into
  /// `vertices` and, from its size on, into `plane_points`. The view works out the exact equation from them.
  std::vector<std::array<std::uint32_t, 3>> face_spans{};
  std::vector<Point3> plane_points{};                 ///< finite; of `face_spans`
  std::vector<ViewOrigin> more_origins{};             ///< in any order
  std::vector<std::array<std::uint32_t, 2>> edges{};  ///< edges of faces, drawn as lines; not those inside faces
  std::vector<ViewFact> facts{};
};

/// What a page of the view shows.
struct ViewScene {
  std::string title{};
  std::string unit{};                  ///< of the coordinates, for lengths: "mm"; may be empty
  std::vector<std::string> origins{};  ///< names of the inputs; the view names those beyond its end by their number
  std::vector<ViewFact> facts{};       ///< of the whole scene
  std::vector<ViewPart> parts{};
};

}  // namespace quoin
