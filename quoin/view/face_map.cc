// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include "quoin/base/error.h"
#include "quoin/view/sphere_picture.h"

namespace quoin {

namespace {

constexpr double pi = std::numbers::pi;
constexpr int deepest_cut = 40;

Vector3 middle(const Vector3& a, const Vector3& b) {
  const Vector3 sum{a.x + b.x, a.y + b.y, a.z + b.z};
  const double length = std::hypot(sum.x, sum.y, sum.z);
  return length > 0 ? Vector3{sum.x / length, sum.y / length, sum.z / length} : a;
}

/// Pixels that an edge comes near. Between the centres of two neighbours that are not near, no edge passes.
class NearPixels {
 public:
  NearPixels(std::uint32_t width, std::uint32_t height)
      : width_(width), height_(height), is_near_(std::size_t{width} * height) {}

  void add(const std::vector<Vector3>& path) {
    for (std::size_t i = 0; i + 1 < path.size(); ++i) add_arc(path[i], path[i + 1], 0);
  }
  bool is_near(std::size_t pixel) const { return is_near_[pixel]; }

 private:
  struct Place {
    double column;
    double row;
  };
  Place place(const Vector3& v) const {
    const double column = (std::atan2(v.y, v.x) / pi + 1) / 2 * static_cast<double>(width_);
    return {column, (0.5 - std::asin(std::clamp(v.z, -1.0, 1.0)) / pi) * static_cast<double>(height_)};
  }

  /// Cuts the arc until its ends are less than a pixel apart, in rows and, around the sphere, in columns. An arc over a
  /// pole never gets there: then all of the pole's row is near.
  void add_arc(const Vector3& a, const Vector3& b, int depth) {
    const Place pa = place(a);
    const Place pb = place(b);
    const double across = std::fabs(pa.column - pb.column);
    const bool is_short =
        std::min(across, static_cast<double>(width_) - across) < 0.5 && std::fabs(pa.row - pb.row) < 0.5;
    if (depth > 0 && (is_short || depth == deepest_cut)) {
      mark(pa, !is_short);
      mark(pb, !is_short);
      return;
    }
    const Vector3 m = middle(a, b);
    add_arc(a, m, depth + 1);
    add_arc(m, b, depth + 1);
  }

  void mark(const Place& p, bool is_whole_row) {
    const auto row = std::clamp(static_cast<long>(p.row), 0L, static_cast<long>(height_) - 1);
    const auto column = static_cast<long>(p.column);
    const long reach = is_whole_row ? static_cast<long>(width_ + 1) / 2 : 1;
    for (long j = std::max(0L, row - 1); j <= std::min(static_cast<long>(height_) - 1, row + 1); ++j) {
      for (long i = column - reach; i <= column + reach; ++i) {
        const long wrapped = ((i % width_) + width_) % width_;
        is_near_[static_cast<std::size_t>(j) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(wrapped)] =
            true;
      }
    }
  }

  long width_;
  long height_;
  std::vector<bool> is_near_;
};

/// Gives all pixels that hang together with `seed`, and are near no edge, its face.
void flood(FaceMap& map, const NearPixels& near, std::vector<bool>& is_known, std::size_t seed) {
  std::vector<std::size_t> pending{seed};
  const std::size_t width = map.width;
  const auto visit = [&](std::size_t pixel) {
    if (is_known[pixel] || near.is_near(pixel)) return;
    is_known[pixel] = true;
    map.faces[pixel] = map.faces[seed];
    pending.push_back(pixel);
  };
  is_known[seed] = true;
  while (!pending.empty()) {
    const std::size_t pixel = pending.back();
    pending.pop_back();
    const std::size_t column = pixel % width;
    visit(column == 0 ? pixel + width - 1 : pixel - 1);
    visit(column == width - 1 ? pixel + 1 - width : pixel + 1);
    if (pixel >= width) visit(pixel - width);
    if (pixel + width < map.faces.size()) visit(pixel + width);
  }
}

/// Face numbers while regions wait for theirs: the pixel that stands for them.
std::vector<std::size_t> pixels_to_ask(FaceMap& map, const NearPixels& near) {
  std::vector<std::size_t> asked;
  std::vector<bool> is_known(map.faces.size());
  for (std::size_t pixel = 0; pixel < map.faces.size(); ++pixel) {
    if (is_known[pixel]) continue;
    map.faces[pixel] = static_cast<std::uint32_t>(asked.size());
    asked.push_back(pixel);
    if (!near.is_near(pixel)) flood(map, near, is_known, pixel);
  }
  return asked;
}

}  // namespace

Vector3 FaceMap::direction(std::size_t pixel) const {
  const double longitude = (2 * (static_cast<double>(pixel % width) + 0.5) / width - 1) * pi;
  const std::size_t row = pixel / width;
  const double latitude = (0.5 - (static_cast<double>(row) + 0.5) / height) * pi;
  return {std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude), std::sin(latitude)};
}

void fill_face_map(SpherePicture& picture, std::uint32_t width, const LocateFaces& locate) {
  if (width < 4 || width > 8192)
    throw InputError("picture of a sphere: the width of the map is not between 4 and 8192");
  FaceMap& map = picture.map;
  map.width = width;
  map.height = width / 2;
  map.faces.assign(std::size_t{map.width} * map.height, FaceMap::no_face);
  NearPixels near(map.width, map.height);
  for (const SphereEdge& edge : picture.edges) near.add(edge.path);
  const std::vector<std::size_t> asked = pixels_to_ask(map, near);
  std::vector<Vector3> directions;
  directions.reserve(asked.size());
  for (const std::size_t pixel : asked) directions.push_back(map.direction(pixel));
  const std::vector<std::uint32_t> faces = locate(directions);
  if (faces.size() != asked.size()) throw InputError("picture of a sphere: not one face for each direction");
  for (std::uint32_t& face : map.faces) face = faces[face];
}

}  // namespace quoin
