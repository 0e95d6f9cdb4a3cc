// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace quoin::page_format {

// What stands in a page, for write_page and for web/src/scene_data.ts, which reads it:
//
//   <script type="application/json" id="quoin-scene">HEADER</script>
//   <script type="text/plain" id="quoin-block-0">BASE64</script>
//   <script type="text/plain" id="quoin-block-1">BASE64</script> ...
//
// HEADER is one JSON object: format, version, title, unit, facts, center (3 numbers), scale (a power of two), origins,
// parts. A part has name, facts, faceCount, and arrays: an object of {type, length, block} by key. A block is the
// elements of that type (u8, u16, u32, f32, f64), little-endian, in base64. Keys, of which one that is absent holds
// zeros only:
//
//   vertices       3 per vertex; f64: coordinates; f32: those of center + scale * value, which then is exact
//   triangles      3 indices per triangle
//   triangleFaces  1 face index per triangle
//   edges          2 vertex indices per edge
//   planes         4 per face
//   faceSpans      3 per face: of vertices, and beyond their number of planePoints (f64, 3 per point)
//   faceOrigins, faceOriginFaces, facePieces  1 per face
//   colors         4 per face (red, green, blue, opacity), with colored: 1 per face, 0 where there is no colour
//   moreOrigins    3 per entry: face, origin, face of the origin
//   planeTexts     UTF-8 of all texts, with planeTextEnds: where in it the text of each face ends

inline constexpr int version = 1;
inline constexpr std::string_view title_marker = "@@QUOIN_TITLE@@";
inline constexpr std::string_view scene_marker = "<!--@@QUOIN_SCENE@@-->";

}  // namespace quoin::page_format
