// SPDX-License-Identifier: Apache-2.0
// Writes the pages that the browser test looks at: view_pages DIRECTORY [--large]
#include <cmath>
#include <fstream>
#include <iostream>
#include <map>
#include <numbers>

#include "make_pictures.h"
#include "quoin/base/error.h"
#include "quoin/view/page.h"

namespace {

using namespace quoin;
using Corner = std::uint32_t;

/// Appends a face as a fan of triangles and its edges; the plane is that of its first three corners.
void add_face(ViewPart& part, const std::vector<Corner>& corners, ViewFace face) {
  const Point3 &a = part.vertices[corners[0]], &b = part.vertices[corners[1]], &c = part.vertices[corners[2]];
  const Vector3 u{b.x - a.x, b.y - a.y, b.z - a.z};
  const Vector3 v{c.x - a.x, c.y - a.y, c.z - a.z};
  const Vector3 n{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
  face.plane = {n.x, n.y, n.z, n.x * a.x + n.y * a.y + n.z * a.z};
  const auto index = static_cast<std::uint32_t>(part.faces.size());
  part.faces.push_back(face);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::size_t next = (i + 1) % corners.size();
    if (corners[i] < corners[next]) part.edges.push_back({corners[i], corners[next]});
    if (i + 2 >= corners.size()) continue;
    part.triangles.push_back({corners[0], corners[i + 1], corners[i + 2]});
    part.triangle_face.push_back(index);
  }
}

/// Faces in the order x low, x high, y low, y high, z low, z high.
void add_box(ViewPart& part, Point3 low, Point3 high, const ViewFace& face, bool is_void = false) {
  const auto first = static_cast<Corner>(part.vertices.size());
  for (unsigned i = 0; i < 8; ++i) {
    part.vertices.push_back({i & 1U ? high.x : low.x, i & 2U ? high.y : low.y, i & 4U ? high.z : low.z});
  }
  const std::vector<std::vector<Corner>> quads{{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                               {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  for (std::uint32_t f = 0; f < quads.size(); ++f) {
    std::vector<Corner> corners;
    for (const Corner c : quads[f]) corners.insert(is_void ? corners.begin() : corners.end(), first + c);
    ViewFace numbered = face;
    numbered.origin_face = f;
    add_face(part, corners, numbered);
  }
}

/// Prism over a regular polygon around (x, y).
void add_prism(ViewPart& part, unsigned sides, double x, double y, double radius, double low, double high,
               const ViewFace& face) {
  const auto first = static_cast<Corner>(part.vertices.size());
  for (unsigned i = 0; i < 2 * sides; ++i) {
    const double angle = 2 * std::numbers::pi * (i % sides) / sides;
    part.vertices.push_back({x + radius * std::cos(angle), y + radius * std::sin(angle), i < sides ? low : high});
  }
  std::vector<Corner> bottom;
  std::vector<Corner> top;
  for (unsigned i = 0; i < sides; ++i) {
    bottom.insert(bottom.begin(), first + i);
    top.push_back(first + sides + i);
    const unsigned j = (i + 1) % sides;
    add_face(part, {first + i, first + j, first + sides + j, first + sides + i}, face);
  }
  add_face(part, bottom, face);
  add_face(part, top, face);
}

/// A cube of side 20 with a cubic cavity, whose top face and bottom face come from a second input.
ViewScene small() {
  ViewScene scene{"Block with a cavity", "mm", {"block.stl", "tool <b>&amp;.stl"}, {{"Volume", "7936 mm³"}}, {}};
  ViewPart part;
  part.name = "block";
  add_box(part, {0, 0, 0}, {20, 20, 20}, {});
  for (const std::uint32_t face : {3U, 5U}) part.faces[face].origin = 1;
  add_box(part, {8, 8, 8}, {12, 12, 12}, ViewFace{.origin = 1}, true);
  part.plane_texts.resize(part.faces.size());
  part.plane_texts[2] = "3 y = 1/3 − 1/3";
  part.more_origins = {{2, 1, 77}};
  part.facts = {{"Shells", "2"}, {"Genus", "0"}};
  scene.parts.push_back(std::move(part));
  return scene;
}

/// Several parts, given colours, transparency, an edge and a vertex shared by pieces, coordinates that floats do not
/// hold.
ViewScene assembly() {
  ViewScene scene{"Assembly", "mm", {"base.scad", "pins.3mf", "cover.stl", "knob.stl"}, {{"Parts", "5"}}, {}};
  ViewPart base{.name = "base plate"};
  add_box(base, {-40.1, -25.3, 0}, {40.1, 25.3, 8.7}, {});
  ViewPart pins{.name = "pins"};
  for (const int i : {-1, 1}) {
    for (const int j : {-1, 1}) {
      ViewFace face{.origin = 1, .piece = static_cast<std::uint32_t>(i + 1 + (j + 1) / 2)};
      add_prism(pins, 36, 30.1 * i, 16.2 * j, 4.4, 8.7, 27.9, face);
    }
  }
  ViewPart cover{.name = "cover"};
  add_box(cover, {-40.1, -25.3, 28}, {40.1, 25.3, 32.1}, ViewFace{.origin = 2, .color = Color{90, 170, 210, 90}});
  ViewPart knob{.name = "knob"};
  add_prism(knob, 64, 0, 0, 11.7, 32.1, 44.3, ViewFace{.origin = 3});
  ViewPart stair{.name = "two cubes that share an edge"};
  add_box(stair, {-8, -8, 8.7}, {0, 0, 16.7}, ViewFace{.origin = 0, .color = Color{225, 120, 120, 255}});
  add_box(stair, {0, 0, 8.7}, {8, 8, 16.7}, ViewFace{.origin = 0, .piece = 1, .color = Color{120, 190, 130, 255}});
  for (ViewPart* part : {&base, &pins, &cover, &knob, &stair}) scene.parts.push_back(std::move(*part));
  return scene;
}

/// A wavy ball of 2 n (n - 1) triangles, each a face of its own unless `is_smooth`.
ViewScene ball(std::uint32_t n) {
  ViewScene scene{"A million triangles", "", {"ball.ply"}, {}, {}};
  ViewPart part{.name = "ball"};
  const std::uint32_t rings = n;
  const std::uint32_t around = n;
  const auto place = [&](double u, double v) {
    const double r = 50 + 2 * std::sin(14 * u) * std::sin(9 * v) + 7 * std::sin(3 * v);
    return Point3{r * std::sin(v) * std::cos(u), r * std::sin(v) * std::sin(u), r * std::cos(v)};
  };
  part.vertices.push_back(place(0, 0));
  for (std::uint32_t i = 1; i < rings; ++i) {
    for (std::uint32_t j = 0; j < around; ++j) {
      part.vertices.push_back(place(2 * std::numbers::pi * j / around, std::numbers::pi * i / rings));
    }
  }
  part.vertices.push_back(place(0, std::numbers::pi));
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return 1 + (i - 1) * around + j % around; };
  const auto last = static_cast<Corner>(part.vertices.size() - 1);
  for (std::uint32_t j = 0; j < around; ++j) {
    add_face(part, {0, at(1, j), at(1, j + 1)}, {});
    add_face(part, {last, at(rings - 1, j + 1), at(rings - 1, j)}, {});
    for (std::uint32_t i = 1; i + 1 < rings; ++i) {
      add_face(part, {at(i, j), at(i + 1, j), at(i + 1, j + 1)}, {});
      add_face(part, {at(i, j), at(i + 1, j + 1), at(i, j + 1)}, {});
    }
  }
  scene.parts.push_back(std::move(part));
  return scene;
}

/// A tetrahedron whose faces come with points that span their planes; one of those is no vertex of it.
ViewScene spanned() {
  ViewScene scene{"Spanned planes", "mm", {"wedge.off"}, {}, {}};
  ViewPart part{.name = "wedge"};
  part.vertices = {{0, 0, 0}, {3.5, 0, 0}, {0, 2, 0}, {0, 0, 0.1}};
  part.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  part.triangle_face = {0, 1, 2, 3};
  part.faces.resize(4);
  part.edges = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
  part.face_spans = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  ViewPart exact = part;  // upper plane: 4 (x - 5) + 7 y + 56 z = 14
  exact.name = "short";
  for (Point3& p : exact.vertices) p.x += 5;
  exact.vertices[3].z = 0.25;
  exact.plane_points = {{12, -2, 0}};
  exact.face_spans[3] = {4, 2, 3};
  scene.parts.push_back(std::move(part));
  scene.parts.push_back(std::move(exact));
  return scene;
}

/// Far from the origin and tiny: single precision alone would show nothing.
ViewScene far_away() {
  ViewScene scene{"Far away", "m", {}, {}, {}};
  ViewPart part{.name = "grain"};
  add_box(part, {1e9, 1e9, -1e9}, {1e9 + 0.5, 1e9 + 0.25, -1e9 + 0.5}, {});
  scene.parts.push_back(std::move(part));
  return scene;
}

void write(const std::string& path, const ViewScene& scene) {
  std::ofstream out(path, std::ios::binary);
  write_page(out, scene);
  out.close();
  if (!out) throw FileError("cannot write '" + path + "'");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::cerr << "usage: view_pages DIRECTORY [--large]\n";
    return 2;
  }
  try {
    const std::string directory = argv[1];
    write(directory + "/small.html", small());
    write(directory + "/assembly.html", assembly());
    write(directory + "/spanned.html", spanned());
    write(directory + "/far.html", far_away());
    write(directory + "/empty.html", ViewScene{.title = "Nothing"});
    write_pictures(directory);
    write_plans(directory);
    write_layers(directory);
    if (argc > 2 && std::string_view(argv[2]) == "--large") write(directory + "/large.html", ball(708));
  } catch (const Error& error) {
    std::cerr << "view_pages: " << error.what() << '\n';
    return 1;
  }
}
