// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "quoin/kernel/point.h"
#include "quoin/solid/mesh.h"

namespace quoin::shapes {

// Closed meshes to test, measure and show with. All are oriented outward, share their vertices, and do not cross
// themselves. Coordinates are the nearest doubles of the named shape, up to a few units in the last place; a face with
// more than three corners is exactly planar, so a shape whose rounded quads would be skew comes as triangles. Equal
// arguments give equal bytes on one machine. Every function throws InputError when an argument is out of the range its
// comment states.

/// Which way an axis-parallel shape points, or a shape turns.
enum class Axis : std::uint8_t { x, y, z };

/// The box with the opposite corners `low` < `high`: 8 vertices, 6 quads.
Mesh box(const Point3& low, const Point3& high);
/// The cube [0, side]^3.
Mesh cube(double side = 1);

/// A regular n-gon in z = 0, n >= 3, with its first corner at (radius, 0), raised to z = height: n quads and 2 n-gons.
Mesh prism(std::size_t n, double radius, double height);
/// The same without polygons of more than four corners in its caps: a fan of 2n triangles about the two centres, n
/// quads.
Mesh cylinder(std::size_t n, double radius, double height);
/// A fan of n >= 3 triangles up to the apex (0, 0, height), over one n-gon in z = 0.
Mesh pyramid(std::size_t n, double radius, double height);

/// Alternate corners of the cube [-radius, radius]^3 (exact).
Mesh tetrahedron(double radius = 1);
/// Corners at distance `radius` on the axes (exact).
Mesh octahedron(double radius = 1);
/// Twelve corners at distance `radius` from the origin.
Mesh icosahedron(double radius = 1);

/// Icosahedron whose faces are divided into frequency^2 triangles each, pushed out to the radius: 20 frequency^2
/// triangles.
Mesh geodesic_sphere(std::size_t frequency, double radius = 1);
/// Sphere of meridians and parallels: slices >= 3, stacks >= 2, 2 slices (stacks - 1) triangles, poles on the z axis.
Mesh uv_sphere(std::size_t slices, std::size_t stacks, double radius = 1);
/// Torus about the z axis, n >= 3 around the axis, m >= 3 around the tube, 0 < tube < ring: 2 n m triangles.
Mesh torus(std::size_t n, std::size_t m, double ring, double tube);

/// The square beams whose removal from the cube [0, 3^level]^3 leaves the Menger sponge of that level (level >= 1), all
/// of them.
///
/// 3 (1 + 9 + ... + 9^(level - 1)) boxes with integer coordinates that stick out by `overshoot` >= 0 at both ends; with
/// 0 their ends lie in the cube's faces. What is left has the volume 20^level.
std::vector<Mesh> menger_beams(unsigned level, double overshoot = 0);

/// Each coordinate plus that of `by`, rounded. Axis-parallel boxes and upright prisms keep planar faces in any case;
/// other polygons only where the sums are exact.
Mesh translated(Mesh mesh, const Vector3& by);
/// Each coordinate times that of `by`, all > 0, rounded. Same remark.
Mesh scaled(Mesh mesh, const Vector3& by);
/// Turned counterclockwise about a coordinate axis, coordinates rounded; the result is triangulated, as its polygons
/// would be skew.
Mesh rotated(Mesh mesh, Axis axis, double radians);
/// Coordinates permuted cyclically so that what pointed along z points along `axis` (exact).
Mesh pointing_along(Mesh mesh, Axis axis);
/// Convex faces as fans of triangles about their first corner.
Mesh triangulated(const Mesh& mesh);
/// Inside out.
Mesh reversed(const Mesh& mesh);
/// All meshes in one, one after the other; names and colours are dropped.
Mesh joined(const std::vector<Mesh>& meshes);
/// Triangulated, each coordinate moved by less than `amount` and rounded: the noisy twin of a mesh with coincidences.
Mesh jittered(const Mesh& mesh, double amount, std::uint64_t seed);

/// Six-fold signed volume is summed over fans in plain doubles: good to about 1e-12 of the mesh's bounding box.
double approximate_volume(const Mesh& mesh);

}  // namespace quoin::shapes
