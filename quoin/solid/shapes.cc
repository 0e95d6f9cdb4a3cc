// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <map>
#include <numbers>
#include <random>
#include <utility>

#include "quoin/base/error.h"

namespace quoin::shapes {
namespace {

void require(bool condition, const char* what) {
  if (!condition) throw InputError(what);
}

std::uint32_t index(std::size_t i) {
  return static_cast<std::uint32_t>(i);
}

void add(Mesh& mesh, std::initializer_list<std::size_t> corners) {
  for (std::size_t corner : corners) mesh.corners.push_back(index(corner));
  mesh.face_begin.push_back(mesh.corners.size());
}

/// Corner i of n on a circle; the four axis points are exact, so that opposite corners mirror each other.
Point2 on_circle(std::size_t i, std::size_t n, double radius) {
  const double turn = static_cast<double>(4 * i % n) / static_cast<double>(n) * std::numbers::pi / 2;
  const double c = radius * std::cos(turn);
  const double s = radius * std::sin(turn);
  switch (4 * i / n) {
    case 0:
      return {c, s};
    case 1:
      return {-s, c};
    case 2:
      return {-c, -s};
    default:
      return {s, -c};
  }
}

void add_ring(Mesh& mesh, std::size_t n, double radius, double z) {
  for (std::size_t i = 0; i < n; ++i) {
    const Point2 p = on_circle(i, n, radius);
    mesh.vertices.push_back({p.x, p.y, z});
  }
}

void add_side_quads(Mesh& mesh, std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) add(mesh, {i, (i + 1) % n, n + (i + 1) % n, n + i});
}

void require_ring(std::size_t n, double radius, double height) {
  require(n >= 3, "a regular polygon needs at least three corners");
  require(radius > 0 && height > 0, "radius and height must be positive");
}

Point3 pushed_out(const Point3& p, double radius) {
  const double length = std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
  return {p.x / length * radius, p.y / length * radius, p.z / length * radius};
}

/// Divides the triangles of a convex polyhedron about the origin; vertices on edges and corners are shared.
class Subdivision {
 public:
  Subdivision(const Mesh& coarse, std::size_t frequency, double radius)
      : coarse_(coarse), frequency_(frequency), radius_(radius) {}

  Mesh run() {
    for (const Point3& p : coarse_.vertices) fine_.vertices.push_back(pushed_out(p, radius_));
    for (std::size_t f = 0; f < coarse_.face_count(); ++f) divide(coarse_.face(f));
    return std::move(fine_);
  }

 private:
  using Weights = std::array<std::size_t, 3>;

  std::uint32_t add_vertex(std::span<const std::uint32_t> corners, const Weights& weights) {
    Point3 sum;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point3& p = coarse_.vertices[corners[k]];
      const double w = static_cast<double>(weights[k]);
      sum = {sum.x + w * p.x, sum.y + w * p.y, sum.z + w * p.z};
    }
    fine_.vertices.push_back(pushed_out(sum, radius_));
    return index(fine_.vertices.size() - 1);
  }

  /// First of the frequency - 1 vertices on the edge from the smaller to the larger index.
  std::uint32_t edge_vertices(std::uint32_t low, std::uint32_t high) {
    const auto [entry, is_new] = edges_.try_emplace({low, high}, index(fine_.vertices.size()));
    const std::array<std::uint32_t, 3> corners{low, high, low};
    if (is_new) {
      for (std::size_t t = 1; t < frequency_; ++t) add_vertex(corners, {frequency_ - t, t, 0});
    }
    return entry->second;
  }

  std::uint32_t on_edge(std::uint32_t from, std::uint32_t to, std::size_t steps) {
    if (from < to) return index(edge_vertices(from, to) + steps - 1);
    return index(edge_vertices(to, from) + (frequency_ - steps) - 1);
  }

  /// The vertex `row` steps down from corner 0 and `column` steps from the edge 0-1 towards the edge 0-2.
  std::uint32_t vertex(std::span<const std::uint32_t> c, std::size_t row, std::size_t column) {
    const Weights weights{frequency_ - row, row - column, column};
    for (std::size_t k = 0; k < 3; ++k) {
      if (weights[k] == frequency_) return c[k];
    }
    if (column == 0) return on_edge(c[0], c[1], row);
    if (column == row) return on_edge(c[0], c[2], row);
    if (row == frequency_) return on_edge(c[1], c[2], column);
    return add_vertex(c, weights);
  }

  void divide(std::span<const std::uint32_t> corners) {
    std::vector<std::uint32_t> upper{vertex(corners, 0, 0)};
    for (std::size_t row = 1; row <= frequency_; ++row) {
      std::vector<std::uint32_t> lower;
      for (std::size_t column = 0; column <= row; ++column) lower.push_back(vertex(corners, row, column));
      for (std::size_t column = 0; column < row; ++column) {
        add(fine_, {upper[column], lower[column], lower[column + 1]});
        if (column + 1 < row) add(fine_, {upper[column], lower[column + 1], upper[column + 1]});
      }
      upper = std::move(lower);
    }
  }

  const Mesh& coarse_;
  std::size_t frequency_;
  double radius_;
  Mesh fine_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> edges_;
};

/// Quads a, b, c, d as two triangles each.
void add_split_quad(Mesh& mesh, std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
  add(mesh, {a, b, c});
  add(mesh, {a, c, d});
}

}  // namespace

Mesh box(const Point3& low, const Point3& high) {
  require(low.x < high.x && low.y < high.y && low.z < high.z, "a box needs low < high on every axis");
  Mesh mesh;
  for (std::size_t i = 0; i < 8; ++i) {
    mesh.vertices.push_back(
        {(i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y, (i & 4) != 0 ? high.z : low.z});
  }
  add(mesh, {0, 2, 3, 1});
  add(mesh, {4, 5, 7, 6});
  add(mesh, {0, 1, 5, 4});
  add(mesh, {2, 6, 7, 3});
  add(mesh, {0, 4, 6, 2});
  add(mesh, {1, 3, 7, 5});
  return mesh;
}

Mesh cube(double side) {
  return box({0, 0, 0}, {side, side, side});
}

Mesh prism(std::size_t n, double radius, double height) {
  require_ring(n, radius, height);
  Mesh mesh;
  add_ring(mesh, n, radius, 0);
  add_ring(mesh, n, radius, height);
  add_side_quads(mesh, n);
  for (std::size_t i = 0; i < n; ++i) mesh.corners.push_back(index(n - 1 - i));
  mesh.face_begin.push_back(mesh.corners.size());
  for (std::size_t i = 0; i < n; ++i) mesh.corners.push_back(index(n + i));
  mesh.face_begin.push_back(mesh.corners.size());
  return mesh;
}

Mesh cylinder(std::size_t n, double radius, double height) {
  require_ring(n, radius, height);
  Mesh mesh;
  add_ring(mesh, n, radius, 0);
  add_ring(mesh, n, radius, height);
  mesh.vertices.push_back({0, 0, 0});
  mesh.vertices.push_back({0, 0, height});
  add_side_quads(mesh, n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    add(mesh, {2 * n, next, i});
    add(mesh, {2 * n + 1, n + i, n + next});
  }
  return mesh;
}

Mesh pyramid(std::size_t n, double radius, double height) {
  require_ring(n, radius, height);
  Mesh mesh;
  add_ring(mesh, n, radius, 0);
  mesh.vertices.push_back({0, 0, height});
  for (std::size_t i = 0; i < n; ++i) add(mesh, {i, (i + 1) % n, n});
  for (std::size_t i = 0; i < n; ++i) mesh.corners.push_back(index(n - 1 - i));
  mesh.face_begin.push_back(mesh.corners.size());
  return mesh;
}

Mesh tetrahedron(double radius) {
  require(radius > 0, "radius must be positive");
  const double r = radius;
  Mesh mesh;
  mesh.vertices = {{r, r, r}, {r, -r, -r}, {-r, r, -r}, {-r, -r, r}};
  add(mesh, {0, 1, 2});
  add(mesh, {0, 3, 1});
  add(mesh, {0, 2, 3});
  add(mesh, {1, 3, 2});
  return mesh;
}

Mesh octahedron(double radius) {
  require(radius > 0, "radius must be positive");
  const double r = radius;
  Mesh mesh;
  mesh.vertices = {{r, 0, 0}, {0, r, 0}, {-r, 0, 0}, {0, -r, 0}, {0, 0, r}, {0, 0, -r}};
  for (std::size_t i = 0; i < 4; ++i) {
    add(mesh, {i, (i + 1) % 4, 4});
    add(mesh, {(i + 1) % 4, i, 5});
  }
  return mesh;
}

Mesh icosahedron(double radius) {
  require(radius > 0, "radius must be positive");
  constexpr double g = std::numbers::phi;
  Mesh mesh;
  mesh.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                   {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  constexpr std::array<std::array<std::size_t, 3>, 20> faces{
      {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
       {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
       {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
  for (Point3& p : mesh.vertices) p = pushed_out(p, radius);
  for (const auto& f : faces) add(mesh, {f[0], f[1], f[2]});
  return mesh;
}

Mesh geodesic_sphere(std::size_t frequency, double radius) {
  require(frequency >= 1 && frequency <= 10000, "frequency must be from 1 to 10000");
  require(radius > 0, "radius must be positive");
  const Mesh coarse = icosahedron();
  return Subdivision(coarse, frequency, radius).run();
}

Mesh uv_sphere(std::size_t slices, std::size_t stacks, double radius) {
  require(slices >= 3 && stacks >= 2, "a sphere needs at least three slices and two stacks");
  require(radius > 0, "radius must be positive");
  Mesh mesh;
  for (std::size_t k = 1; k < stacks; ++k) {
    const Point2 p =
        on_circle(k, 2 * stacks, radius);  // x: height above the equator's plane, y: distance from the axis
    add_ring(mesh, slices, p.y, -p.x);
  }
  const std::size_t south = mesh.vertices.size();
  mesh.vertices.push_back({0, 0, -radius});
  mesh.vertices.push_back({0, 0, radius});
  const std::size_t last = (stacks - 2) * slices;
  for (std::size_t i = 0; i < slices; ++i) {
    const std::size_t next = (i + 1) % slices;
    add(mesh, {south, next, i});
    add(mesh, {south + 1, last + i, last + next});
    for (std::size_t ring = 0; ring < last; ring += slices) {
      add_split_quad(mesh, ring + i, ring + next, ring + slices + next, ring + slices + i);
    }
  }
  return mesh;
}

Mesh torus(std::size_t n, std::size_t m, double ring, double tube) {
  require(n >= 3 && m >= 3, "a torus needs at least three sections and three sides");
  require(tube > 0 && ring > tube, "a torus needs 0 < tube < ring");
  Mesh mesh;
  for (std::size_t k = 0; k < m; ++k) {
    const Point2 p = on_circle(k, m, tube);
    add_ring(mesh, n, ring + p.x, p.y);
  }
  for (std::size_t k = 0; k < m; ++k) {
    const std::size_t a = k * n;
    const std::size_t b = (k + 1) % m * n;
    for (std::size_t i = 0; i < n; ++i) add_split_quad(mesh, a + i, a + (i + 1) % n, b + (i + 1) % n, b + i);
  }
  return mesh;
}

std::vector<Mesh> menger_beams(unsigned level, double overshoot) {
  require(level >= 1 && level <= 6, "level must be from 1 to 6");
  require(overshoot >= 0, "overshoot must not be negative");
  double side = 1;
  for (unsigned i = 0; i < level; ++i) side *= 3;
  std::vector<Mesh> beams;
  for (double width = side / 3; width >= 1; width /= 3) {
    for (double x = width; x < side; x += 3 * width) {
      for (double y = width; y < side; y += 3 * width) {
        const Mesh beam = box({x, y, -overshoot}, {x + width, y + width, side + overshoot});
        for (Axis axis : {Axis::x, Axis::y, Axis::z}) beams.push_back(pointing_along(beam, axis));
      }
    }
  }
  return beams;
}

Mesh translated(Mesh mesh, const Vector3& by) {
  for (Point3& p : mesh.vertices) p = {p.x + by.x, p.y + by.y, p.z + by.z};
  return mesh;
}

Mesh scaled(Mesh mesh, const Vector3& by) {
  require(by.x > 0 && by.y > 0 && by.z > 0, "factors must be positive");
  for (Point3& p : mesh.vertices) p = {p.x * by.x, p.y * by.y, p.z * by.z};
  return mesh;
}

Mesh rotated(Mesh mesh, Axis axis, double radians) {
  const double c = std::cos(radians);
  const double s = std::sin(radians);
  const std::size_t u = (static_cast<std::size_t>(axis) + 1) % 3;
  const std::size_t v = (static_cast<std::size_t>(axis) + 2) % 3;
  for (Point3& p : mesh.vertices) {
    const double pu = p[u];
    const double pv = p[v];
    p[u] = c * pu - s * pv;
    p[v] = s * pu + c * pv;
  }
  return triangulated(mesh);
}

Mesh pointing_along(Mesh mesh, Axis axis) {
  for (Point3& p : mesh.vertices) {
    if (axis == Axis::x) p = {p.z, p.x, p.y};
    if (axis == Axis::y) p = {p.y, p.z, p.x};
  }
  return mesh;
}

Mesh triangulated(const Mesh& mesh) {
  Mesh result;
  result.vertices = mesh.vertices;
  result.name = mesh.name;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t k = 2; k < face.size(); ++k) {
      add(result, {face[0], face[k - 1], face[k]});
      if (!mesh.face_colors.empty()) result.face_colors.push_back(mesh.face_colors[f]);
    }
  }
  return result;
}

Mesh reversed(const Mesh& mesh) {
  Mesh result = mesh;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    std::reverse(result.corners.begin() + static_cast<std::ptrdiff_t>(mesh.face_begin[f]),
                 result.corners.begin() + static_cast<std::ptrdiff_t>(mesh.face_begin[f + 1]));
  }
  return result;
}

Mesh joined(const std::vector<Mesh>& meshes) {
  Mesh result;
  for (const Mesh& mesh : meshes) {
    const std::size_t shift = result.vertices.size();
    result.vertices.insert(result.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
      for (std::uint32_t corner : mesh.face(f)) result.corners.push_back(index(shift + corner));
      result.face_begin.push_back(result.corners.size());
    }
  }
  return result;
}

Mesh jittered(const Mesh& mesh, double amount, std::uint64_t seed) {
  Mesh result = triangulated(mesh);
  std::mt19937_64 random(seed);
  const auto offset = [&] { return (static_cast<double>(random() >> 11) * 0x1p-52 - 1) * amount; };
  for (Point3& p : result.vertices) {
    for (std::size_t axis = 0; axis < 3; ++axis) p[axis] += offset();
  }
  return result;
}

double approximate_volume(const Mesh& mesh) {
  double six_volumes = 0;
  const Point3 o = mesh.vertices.empty() ? Point3{} : mesh.vertices[0];
  const auto relative = [&](std::uint32_t v) {
    const Point3& p = mesh.vertices[v];
    return Point3{p.x - o.x, p.y - o.y, p.z - o.z};
  };
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t k = 2; k < face.size(); ++k) {
      const Point3 a = relative(face[0]);
      const Point3 b = relative(face[k - 1]);
      const Point3 c = relative(face[k]);
      six_volumes += a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x);
    }
  }
  return six_volumes / 6;
}

}  // namespace quoin::shapes
