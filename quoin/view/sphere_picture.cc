// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/sphere_picture.h"

#include <cmath>

#include "quoin/base/error.h"

namespace quoin {

namespace {

[[noreturn]] void refuse(const char* kind, std::size_t index, const std::string& what) {
  throw InputError("picture of a sphere: " + std::string(kind) + ' ' + std::to_string(index) + ' ' + what);
}

void check_direction(const Vector3& v, const char* kind, std::size_t index) {
  if (!(std::fabs(std::hypot(v.x, v.y, v.z) - 1) <= 1e-6))
    refuse(kind, index, "has a direction that is no unit vector");
}

}  // namespace

void check_picture(const SpherePicture& picture) {
  for (std::size_t i = 0; i < picture.points.size(); ++i) check_direction(picture.points[i].at, "point", i);
  for (std::size_t i = 0; i < picture.edges.size(); ++i) {
    for (const Vector3& v : picture.edges[i].path) check_direction(v, "edge", i);
  }
  const FaceMap& map = picture.map;
  if (map.faces.size() != std::size_t{map.width} * map.height) {
    throw InputError("picture of a sphere: a map of " + std::to_string(map.width) + " by " +
                     std::to_string(map.height) + " pixels has " + std::to_string(map.faces.size()) + " faces");
  }
  for (std::size_t i = 0; i < map.faces.size(); ++i) {
    if (map.faces[i] != FaceMap::no_face && map.faces[i] >= picture.faces.size()) {
      refuse("pixel", i, "names face " + std::to_string(map.faces[i]) + " of " + std::to_string(picture.faces.size()));
    }
  }
}

}  // namespace quoin
