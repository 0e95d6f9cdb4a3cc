// SPDX-License-Identifier: Apache-2.0
//
// Writes the inputs of the benchmarks as OFF files 0000.off, 0001.off, ... into a directory, in the order in which the
// operation takes them.
//
//   make_inputs spheres FREQUENCY DIRECTORY        two overlapping geodesic spheres, 20 FREQUENCY^2 triangles each
//   make_inputs cubes COUNT DIRECTORY              cubes turned about a common axis
//   make_inputs drills COUNT DIRECTORY             a plate, and prisms with 32 sides to drill through it
//   make_inputs coplanar|noisy NUMBER DIRECTORY    model NUMBER of 20 with faces in common planes, or its noisy twin
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <numbers>

#include "quoin/io/mesh_file.h"
#include "quoin/solid/shapes.h"

namespace {

using namespace quoin;

std::vector<Mesh> spheres(std::size_t frequency) {
  const Mesh sphere = shapes::geodesic_sphere(frequency);
  return {sphere, shapes::translated(sphere, {0.9, 0.17, 0.31})};
}

Mesh centred_cube() {
  return shapes::triangulated(shapes::box({-1, -1, -1}, {1, 1, 1}));
}

std::vector<Mesh> turned_cubes(std::size_t count) {
  std::vector<Mesh> result;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = std::numbers::pi / 2 * static_cast<double>(i) / static_cast<double>(count);
    result.push_back(shapes::rotated(centred_cube(), shapes::Axis::z, angle));
  }
  return result;
}

std::vector<Mesh> drills(std::size_t count) {
  const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(2 * count))));
  const auto rows = (count + columns - 1) / columns;
  std::vector<Mesh> result{shapes::triangulated(
      shapes::box({0, 0, 0}, {static_cast<double>(4 * columns), static_cast<double>(4 * rows), 10}))};
  const Mesh drill = shapes::triangulated(shapes::prism(32, 1.25, 12));
  for (std::size_t i = 0; i < count; ++i) {
    const auto x = static_cast<double>(4 * (i % columns) + 2);
    const auto y = static_cast<double>(4 * (i / columns) + 2);
    result.push_back(shapes::translated(drill, {x, y, -1}));
  }
  return result;
}

// A box whose faces are n x n quads each: coincident faces of two such boxes share n^2 quads.
Mesh checked_box(std::uint32_t n) {
  Mesh mesh;
  std::vector<std::uint32_t> number((n + 1) * (n + 1) * (n + 1), ~0U);
  const auto vertex = [&](std::array<std::uint32_t, 3> at) {
    std::uint32_t& id = number[(at[2] * (n + 1) + at[1]) * (n + 1) + at[0]];
    if (id == ~0U) {
      id = static_cast<std::uint32_t>(mesh.vertices.size());
      mesh.vertices.push_back({double(at[0]) / n, double(at[1]) / n, double(at[2]) / n});
    }
    return id;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const bool upper : {false, true}) {
      for (std::uint32_t i = 0; i < n; ++i) {
        for (std::uint32_t j = 0; j < n; ++j) {
          const auto corner = [&](std::uint32_t u, std::uint32_t v) {
            std::array<std::uint32_t, 3> at{};
            at[axis] = upper ? n : 0;
            at[(axis + 1) % 3] = i + u;
            at[(axis + 2) % 3] = j + v;
            return vertex(at);
          };
          std::array<std::uint32_t, 4> quad{corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
          if (!upper) std::swap(quad[1], quad[3]);
          mesh.add_face(quad);
        }
      }
    }
  }
  return shapes::triangulated(mesh);
}

// Four families at five sizes: boxes that share a face, boxes that overlap in faces, prisms on one another, and a solid
// with its copy.
std::vector<Mesh> coplanar(std::size_t number) {
  const std::size_t size = 1 + number / 4;
  const Mesh box = checked_box(static_cast<std::uint32_t>(8 * size));
  switch (number % 4) {
    case 0:
      return {box, shapes::translated(box, {1, 0, 0})};
    case 1:
      return {box, shapes::translated(box, {0.5, 0.25, 0})};
    case 2: {
      const Mesh prism = shapes::triangulated(shapes::prism(48 * size, 2, 1));
      return {prism, shapes::translated(shapes::triangulated(shapes::prism(36 * size, 1.5, 1)), {0.125, 0, 1})};
    }
    default:
      return {shapes::torus(16 * size, 12 * size, 2, 0.75), shapes::torus(16 * size, 12 * size, 2, 0.75)};
  }
}

std::vector<Mesh> noisy(std::size_t number) {
  std::vector<Mesh> meshes = coplanar(number);
  for (std::size_t i = 0; i < meshes.size(); ++i) meshes[i] = shapes::jittered(meshes[i], 1e-3, number + 100 * i);
  return meshes;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "make_inputs spheres|cubes|drills|coplanar|noisy NUMBER DIRECTORY\n");
    return 2;
  }
  const auto number = static_cast<std::size_t>(std::atol(argv[2]));
  const auto is = [&](const char* name) { return std::strcmp(argv[1], name) == 0; };
  std::vector<Mesh> meshes;
  if (is("spheres")) meshes = spheres(number);
  if (is("cubes")) meshes = turned_cubes(number);
  if (is("drills")) meshes = drills(number);
  if (is("coplanar")) meshes = coplanar(number);
  if (is("noisy")) meshes = noisy(number);
  if (meshes.empty()) {
    std::fprintf(stderr, "make_inputs: no inputs are called %s\n", argv[1]);
    return 2;
  }
  const Context context;
  const std::filesystem::path directory(argv[3]);
  std::filesystem::create_directories(directory);
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    char name[32];
    std::snprintf(name, sizeof name, "%04zu.off", i);
    write_mesh(directory / name, MeshFormat::off, meshes[i], context);
  }
  return 0;
}
