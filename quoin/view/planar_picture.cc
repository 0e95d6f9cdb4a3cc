// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/planar_picture.h"

#include <cmath>
#include <numbers>

#include "quoin/base/error.h"

namespace quoin {

namespace {

/// Coordinates beyond this size leave no room for the arithmetic of drawing.
constexpr double largest_coordinate = 1e150;

bool is_usable(const Point2& p) {
  return std::fabs(p.x) <= largest_coordinate && std::fabs(p.y) <= largest_coordinate;
}

[[noreturn]] void refuse(const char* kind, std::size_t index, const char* what) {
  throw InputError("picture: " + std::string(kind) + ' ' + std::to_string(index) + ' ' + what);
}

void check_path(const PicturePath& path, const char* kind, std::size_t index) {
  if (!is_usable(path.start)) refuse(kind, index, "has a coordinate that is not finite or beyond 1e150");
  for (const PathStep& step : path.steps) {
    if (!is_usable(step.to) || !is_usable(step.center)) {
      refuse(kind, index, "has a coordinate that is not finite or beyond 1e150");
    }
    if (step.is_arc() && !(std::fabs(step.sweep) <= 2.001 * std::numbers::pi && step.to != step.center)) {
      refuse(kind, index, "has an arc without radius or of more than a full turn");
    }
  }
}

}  // namespace

PictureBox shown_box(const PlanarPicture& picture) {
  if (picture.box && !picture.box->is_empty()) {
    const PictureBox& box = *picture.box;
    return box.width() > 0 && box.height() > 0 ? box : box.enlarged(0.05);
  }
  PictureBox box;
  for (const PictureFace& face : picture.faces) {
    for (const PicturePath& ring : face.rings) add_to(box, ring);
  }
  for (const PictureEdge& edge : picture.edges) add_to(box, edge.path);
  for (const PicturePoint& point : picture.points) box.add(point.at);
  return box.enlarged(0.05);
}

void check_picture(const PlanarPicture& picture) {
  for (std::size_t i = 0; i < picture.faces.size(); ++i) {
    for (const PicturePath& ring : picture.faces[i].rings) check_path(ring, "face", i);
  }
  for (std::size_t i = 0; i < picture.edges.size(); ++i) check_path(picture.edges[i].path, "edge", i);
  for (std::size_t i = 0; i < picture.points.size(); ++i) {
    if (!is_usable(picture.points[i].at)) refuse("point", i, "has a coordinate that is not finite or beyond 1e150");
  }
  if (picture.box && (!is_usable(picture.box->low) || !is_usable(picture.box->high)) && !picture.box->is_empty()) {
    throw InputError("picture: its box is not finite");
  }
}

}  // namespace quoin
