// SPDX-License-Identifier: Apache-2.0
// Clouds that layers.test.mjs looks at.
#include <cmath>
#include <fstream>
#include <numbers>

#include "make_pictures.h"
#include "quoin/base/error.h"
#include "quoin/view/layered_page.h"

namespace quoin {
namespace {

using Kind = SceneLayer::Kind;

/// A tetrahedron by a value: corners, edges at 1, triangles at 2 (of which the last at 3), all but the corners away
/// at 4.
LayeredScene tetrahedron() {
  LayeredScene scene;
  scene.title = "Four <points>";
  scene.facts = {{"Points", "4"}};
  scene.points = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}};
  scene.point_numbers = {10, 11, 12, 13};
  scene.values = {0, 1, 4, 9, 16};
  scene.value_name = "Value";
  scene.root_name = "Radius";
  const Color red{200, 40, 40, 255};
  const Color green{40, 170, 60, 255};
  scene.layers = {{.name = "Points", .kind = Kind::points, .vertices = {0, 1, 2, 3}, .color = {40, 90, 200, 255}},
                  {.name = "Edges",
                   .kind = Kind::segments,
                   .vertices = {0, 1, 0, 2, 0, 3, 1, 2, 1, 3, 2, 3},
                   .begin = std::vector<std::uint32_t>(6, 1),
                   .end = std::vector<std::uint32_t>(6, 4),
                   .color = {90, 90, 90, 255}},
                  {.name = "</script>",
                   .kind = Kind::triangles,
                   .vertices = {1, 2, 3, 0, 1, 2, 0, 1, 3, 0, 2, 3},
                   .begin = {3, 2, 2, 2},
                   .end = {4, 4, 4, 4},
                   .color = red},
                  {.name = "Critical", .kind = Kind::points, .vertices = {3}, .colors = {green}, .size = 24}};
  scene.counts = {
      {"Betti numbers", {{"Components", {4, 1, 1, 1, 1}}, {"Tunnels", {0, 3, 0, 0, 0}}, {"Voids", {0, 0, 0, 1, 0}}}}};
  scene.pairs = {{0, 0}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {1, 1, 2}, {1, 1, 2}, {1, 1, 2}, {2, 3, 4}};
  scene.value = 3;
  return scene;
}

/// Two saddles (owners 0 and 1) with surfaces that are hidden at first, and ways that join (owner 2) and lead to a
/// maximum (owner 3).
LayeredScene owned() {
  LayeredScene scene;
  scene.title = "Owned";
  scene.points = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
  scene.near_points = {{1, 2, 0.1}, {3, 2, 0.1}, {2, 2, 1}, {2, 2, 2}};
  scene.point_numbers = {0, 1, 2, 3, 17, 18, 0, 5};
  scene.values = {0, 1, 4, 9};
  scene.value_name = "Squared";
  scene.root_name = "Distance";
  scene.has_all_values = false;
  const Color green{43, 145, 96, 255};
  scene.layers = {{.name = "Points", .vertices = {0, 1, 2, 3}},
                  {.name = "Saddles",
                   .vertices = {4, 5},
                   .begin = {1, 2},
                   .color = green,
                   .owners = {0, 1},
                   .element_name = "Saddle"},
                  {.name = "Maxima",
                   .vertices = {7},
                   .begin = {3},
                   .color = {138, 91, 181, 255},
                   .owners = {3},
                   .element_name = "Maximum"},
                  {.name = "Surfaces",
                   .kind = Kind::triangles,
                   .vertices = {0, 4, 3, 4, 1, 0, 1, 2, 5},
                   .begin = {1, 1, 2},
                   .color = {120, 186, 150, 120},
                   .owners = {0, 0, 1},
                   .is_shown = false},
                  {.name = "Ways",
                   .kind = Kind::segments,
                   .vertices = {4, 6, 5, 6, 6, 7},
                   .begin = {1, 2, 1},
                   .owners = {0, 1, 2}}};
  scene.links = {{0, 2}, {1, 2}, {2, 3}};
  scene.pairs = {{0, 0}, {.degree = 2, .birth = 2, .death = 3, .birth_point = 5, .death_point = 7}};
  scene.value = 3;
  return scene;
}

/// Points of the plane and a triangle, without values.
LayeredScene flat() {
  LayeredScene scene;
  scene.title = "Flat";
  scene.points = {{0.1, 0.1, 0}, {1e6, 0, 0}, {0, 1e6, 0}};
  scene.layers = {{.name = "Points", .vertices = {0, 1, 2}},
                  {.name = "Triangles", .kind = Kind::triangles, .vertices = {0, 1, 2}, .color = {120, 160, 200, 255}}};
  return scene;
}

/// So many points on a torus, and the triangles of its grid, which come and go.
LayeredScene torus(std::uint32_t around, std::uint32_t across) {
  LayeredScene scene;
  scene.title = "Torus";
  scene.value_name = "Value";
  const std::uint32_t values = 1000;
  for (std::uint32_t i = 0; i < values; ++i) scene.values.push_back(i);
  SceneLayer points{.name = "Points"};
  SceneLayer triangles{.name = "Triangles", .kind = Kind::triangles, .color = {125, 158, 198, 255}};
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t k = 0; k < across; ++k) {
      const double u = 2 * std::numbers::pi * i / around;
      const double v = 2 * std::numbers::pi * k / across;
      const double r = 3 + std::cos(v);
      points.vertices.push_back(static_cast<std::uint32_t>(scene.points.size()));
      scene.points.push_back({r * std::cos(u), r * std::sin(u), std::sin(v)});
      const auto shade = static_cast<std::uint8_t>(127 + 120 * std::cos(3 * u + v));
      points.colors.push_back({shade, 90, static_cast<std::uint8_t>(255 - shade), 255});
      if (i % 2 != 0) continue;
      const auto at = [&](std::uint32_t a, std::uint32_t b) { return (i + a) % around * across + (k + b) % across; };
      triangles.vertices.insert(triangles.vertices.end(), {at(0, 0), at(2, 0), at(2, 1)});
      triangles.begin.push_back(i * (values - 1) / around);
      triangles.end.push_back(k % 3 == 0 ? never_in_scene : std::min(values - 1, i * (values - 1) / around + 300));
    }
  }
  scene.layers = {std::move(points), std::move(triangles)};
  scene.value = 500;
  return scene;
}

void write(const std::string& path, const LayeredScene& scene) {
  std::ofstream out(path, std::ios::binary);
  write_layered_page(out, scene);
  out.close();
  if (!out) throw FileError("cannot write '" + path + "'");
}

}  // namespace

void write_layers(const std::string& directory) {
  write(directory + "/layers.html", tetrahedron());
  write(directory + "/owned_layers.html", owned());
  write(directory + "/flat_layers.html", flat());
  write(directory + "/cloud.html", torus(1200, 450));
  write(directory + "/no_layers.html", {});
}

}  // namespace quoin
