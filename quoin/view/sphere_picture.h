// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "quoin/kernel/point.h"
#include "quoin/view/planar_picture.h"

namespace quoin {

struct SphereFace {
  PictureFill fill{};
  PictureText text{};
};

struct SphereEdge {
  std::vector<Vector3> path{};  ///< unit vectors; between consecutive ones runs the shorter great arc
  EdgeStyle style = EdgeStyle::plain;
  PictureFill stroke{};
  PictureText text{};
};

struct SpherePoint {
  Vector3 at{};  ///< unit vector
  PictureFill fill{};
  PictureText text{};
};

/// Which face is where: a rectangle of longitudes and latitudes, row by row from the north pole, longitudes from -pi.
///
/// Pixel (i, j) stands for the direction of its centre: longitude (2 (i + 1/2) / width - 1) pi, latitude
/// (1/2 - (j + 1/2) / height) pi; x points to longitude 0, z to the north pole. So a face may have any number of
/// boundaries, or none, and nothing needs triangles.
struct FaceMap {
  static constexpr std::uint32_t no_face = 0xFFFFFFFFU;

  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<std::uint32_t> faces{};  ///< indices into SpherePicture::faces, or no_face

  Vector3 direction(std::size_t pixel) const;
};

/// Something to look at on the unit sphere.
struct SpherePicture {
  std::string title{};
  std::vector<ViewFact> facts{};
  std::vector<SphereFace> faces{};
  std::vector<SphereEdge> edges{};
  std::vector<SpherePoint> points{};
  std::vector<std::string> categories{};
  FaceMap map{};
};

/// Faces that hold directions, one for each: indices into SpherePicture::faces, or FaceMap::no_face.
using LocateFaces = std::function<std::vector<std::uint32_t>(const std::vector<Vector3>&)>;

/// Makes the map of a picture whose edges are there: asks for the face of every pixel near an edge, and once for each
/// region of pixels that no edge comes near. `locate` is called once.
///
/// O(pixels + length of edges in pixels), besides locating.
void fill_face_map(SpherePicture& picture, std::uint32_t width, const LocateFaces& locate);

/// @throws InputError  a direction is not of unit length (within 1e-6), the map's size does not fit its faces, or names
///                     a face that is not there; says which. O(size).
void check_picture(const SpherePicture& picture);

}  // namespace quoin
