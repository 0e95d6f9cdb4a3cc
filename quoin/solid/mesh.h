// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "quoin/kernel/point.h"

namespace quoin {

/// Red, green, blue, opacity, each 0 to 255.
struct Color {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;
  std::uint8_t a = 255;
  friend constexpr bool operator==(const Color&, const Color&) = default;
};

/// Polygons over shared vertices, as files hold them: no promise about closedness, orientation or crossings.
///
/// Face f has the corners corners[face_begin[f]] ... corners[face_begin[f + 1] - 1], counterclockwise seen from
/// outside.
struct Mesh {
  std::vector<Point3> vertices;            ///< finite; unit of the file
  std::vector<std::uint32_t> corners;      ///< indices into vertices
  std::vector<std::size_t> face_begin{0};  ///< face_count() + 1 offsets into corners
  std::vector<Color> face_colors;          ///< empty, or one per face
  std::string name;                        ///< of the object, for reports; may be empty

  std::size_t face_count() const { return face_begin.size() - 1; }
  std::span<const std::uint32_t> face(std::size_t f) const {
    return {corners.data() + face_begin[f], face_begin[f + 1] - face_begin[f]};
  }
  void add_face(std::span<const std::uint32_t> face_corners) {
    corners.insert(corners.end(), face_corners.begin(), face_corners.end());
    face_begin.push_back(corners.size());
  }
};

}  // namespace quoin
