// SPDX-License-Identifier: Apache-2.0
// Writes the solids whose Minkowski sums are measured, as OFF files.
//
//   make_sum_inputs FOLDER
//
// Look-alikes of the models in CGAL's manual, with the same numbers of triangles. Coordinates are multiples of 2^-16,
// as modellers write few digits; but for torus_full and ball_full, which are full doubles.
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include "quoin/io/mesh_file.h"
#include "quoin/solid/exit.h"
#include "quoin/solid/shapes.h"
#include "quoin/solid/solid.h"

namespace {

using quoin::Mesh;
using quoin::Point3;
using quoin::Solid;
namespace shapes = quoin::shapes;

struct ProfilePoint {
  double radius;
  double z;
};

Mesh on_grid(Mesh mesh) {
  for (Point3& p : mesh.vertices) {
    for (std::size_t axis = 0; axis < 3; ++axis) p[axis] = std::round(p[axis] * 0x1p16) * 0x1p-16;
  }
  return mesh;
}

/// A surface of revolution, its profile from the lower end of the axis to the upper one: slices * 2 * points triangles.
Mesh revolved(const std::vector<ProfilePoint>& profile, double bottom, double top, std::uint32_t slices) {
  Mesh mesh;
  mesh.vertices.push_back({0, 0, bottom});
  for (const ProfilePoint& p : profile) {
    for (std::uint32_t i = 0; i < slices; ++i) {
      const double angle = 2 * std::numbers::pi * i / slices;
      mesh.vertices.push_back({p.radius * std::cos(angle), p.radius * std::sin(angle), p.z});
    }
  }
  mesh.vertices.push_back({0, 0, top});
  const auto last = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
  const auto ring = [&](std::size_t r, std::uint32_t i) {
    return 1 + static_cast<std::uint32_t>(r) * slices + i % slices;
  };
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) { mesh.add_face(std::array{a, b, c}); };
  for (std::uint32_t i = 0; i < slices; ++i) {
    add(0, ring(0, i + 1), ring(0, i));
    for (std::size_t r = 0; r + 1 < profile.size(); ++r) {
      add(ring(r, i), ring(r, i + 1), ring(r + 1, i));
      add(ring(r, i + 1), ring(r + 1, i + 1), ring(r + 1, i));
    }
    add(ring(profile.size() - 1, i), ring(profile.size() - 1, i + 1), last);
  }
  return on_grid(mesh);
}

/// A stem under a cap that is hollow from below: 384 triangles.
Mesh mushroom() {
  std::vector<ProfilePoint> profile{{0.5, 0}, {0.42, 0.6}, {0.4, 1.2}, {0.42, 1.75}, {1.1, 1.6}, {1.6, 1.3}};
  for (int i = 0; i < 6; ++i) {
    const double angle = std::numbers::pi / 2 * i / 6;
    profile.push_back({1.75 * std::cos(angle), 1.4 + 1.3 * std::sin(angle)});
  }
  return revolved(profile, 0, 2.75, 16);
}

/// A cup on a foot: 900 triangles.
Mesh cup() {
  std::vector<ProfilePoint> profile{{1, 0}, {1, 0.15}, {0.3, 0.3}, {0.25, 0.8}, {0.3, 1.2}};
  for (int i = 1; i <= 10; ++i) {
    const double angle = std::numbers::pi / 2 * i / 10;
    profile.push_back({1.5 * std::sin(angle) + 0.05, 2.8 - 1.5 * std::cos(angle)});
  }
  for (int i = 10; i >= 1; --i) {
    const double angle = std::numbers::pi / 2 * i / 10;
    profile.push_back({1.35 * std::sin(angle), 2.81 - 1.35 * std::cos(angle)});
  }
  return revolved(profile, 0, 2.81 - 1.36, 18);
}

/// A pyramid on each face of an icosahedron: 60 triangles.
Mesh star() {
  const Mesh core = shapes::icosahedron(0.5);
  Mesh mesh;
  mesh.vertices = core.vertices;
  for (std::size_t f = 0; f < core.face_count(); ++f) {
    const auto c = core.face(f);
    Point3 tip;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      tip[axis] = core.vertices[c[0]][axis] + core.vertices[c[1]][axis] + core.vertices[c[2]][axis];
    }
    const auto apex = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back(tip);
    for (std::size_t k = 0; k < 3; ++k) mesh.add_face(std::array{c[k], c[(k + 1) % 3], apex});
  }
  return on_grid(mesh);
}

Solid solid_of(const Mesh& mesh, const quoin::Context& context) {
  return Solid::from_leaf(quoin::make_leaf(mesh, {}, context).leaf, context);
}

/// A hollowed half of an ellipsoid with a handle, of rounded coordinates.
Mesh spoon(const quoin::Context& context) {
  const auto bowl = [](double size) {
    return shapes::scaled(shapes::uv_sphere(14, 8, 1), {1.4 * size, size, 0.6 * size});
  };
  const Solid outer = solid_of(on_grid(bowl(1)), context);
  const Solid inner = solid_of(on_grid(bowl(0.85)), context);
  const Solid upper = solid_of(shapes::box({-2, -2, 0}, {2, 2, 2}), context);
  const Solid handle = solid_of(shapes::box({1.25, -0.125, -0.125}, {4, 0.125, 0}), context);
  const std::vector<Solid> parts{quoin::subtract(outer, std::vector<Solid>{inner, upper}, context), handle};
  const Solid whole = quoin::unite(parts, context);
  quoin::ExitOptions exit;
  exit.precision = quoin::Precision::binary32;
  const quoin::Triangulated t = quoin::triangulate_boundary(whole.boundary(), exit, context);
  Mesh mesh;
  mesh.vertices = t.vertices;
  for (const auto& triangle : t.triangles) mesh.add_face(triangle);
  return mesh;
}

void write_all(const std::filesystem::path& folder) {
  const quoin::Context context;
  const auto write = [&](const std::string& name, const Mesh& mesh) {
    quoin::write_mesh(folder / (name + ".off"), quoin::MeshFormat::off, mesh, context);
  };
  write("mushroom", mushroom());
  write("cup", cup());
  write("star", star());
  write("spoon", spoon(context));
  write("cube", shapes::triangulated(shapes::box({-0.25, -0.25, -0.25}, {0.25, 0.25, 0.25})));
  write("ball", on_grid(shapes::geodesic_sphere(7, 0.25)));
  write("small_ball", on_grid(shapes::geodesic_sphere(3, 0.25)));
  write("brick", shapes::triangulated(shapes::box({0, 0, 0}, {10, 20, 5})));
  write("round_corner", on_grid(shapes::uv_sphere(32, 16, 2)));
  write("torus", on_grid(shapes::torus(32, 16, 2, 0.75)));
  for (const std::size_t n : {16U, 32U, 64U, 128U}) {
    write("torus_" + std::to_string(n), on_grid(shapes::torus(n, n / 2, 2, 0.75)));
  }
  write("torus_full", shapes::torus(32, 16, 2, 0.75));
  write("ball_full", shapes::geodesic_sphere(3, 0.25));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "make_sum_inputs FOLDER\n");
    return 2;
  }
  try {
    write_all(argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
