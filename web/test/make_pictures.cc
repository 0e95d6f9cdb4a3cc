// SPDX-License-Identifier: Apache-2.0
// Pictures that pictures.test.mjs looks at.
#include "make_pictures.h"

#include <cmath>
#include <fstream>
#include <numbers>
#include <random>

#include "quoin/arrangement/linear/linear_arrangement.h"
#include "quoin/base/error.h"
#include "quoin/view/arrangement_picture.h"
#include "quoin/view/picture_page.h"
#include "quoin/view/picture_svg.h"
#include "quoin/view/sphere_page.h"

namespace quoin {
namespace {

template <class Write>
void write_file(const std::string& path, const Write& write) {
  std::ofstream out(path, std::ios::binary);
  write(out);
  out.close();
  if (!out) throw FileError("cannot write '" + path + "'");
}

void write_both(const std::string& stem, const PlanarPicture& picture) {
  write_file(stem + ".html", [&](std::ostream& out) { write_picture_page(out, picture); });
  write_file(stem + ".svg", [&](std::ostream& out) { write_svg(out, picture); });
}

/// A square with a hole that holds another square, and a triangle beside it.
PlanarPicture nested() {
  LinearFamily family;
  PieceList<LinearFamily> list;
  family.add_polyline(list, {{0, 0}, {10, 0}, {10, 10}, {0, 10}}, true);
  family.add_polyline(list, {{2, 2}, {8, 2}, {8, 8}, {2, 8}}, true);
  family.add_polyline(list, {{4, 4}, {6, 4}, {6, 6}, {4, 6}}, true);
  family.add_polyline(list, {{12, 0}, {18, 0}, {15, 8}}, true);
  family.add_point(list, {1, 9}, "mark");
  const LinearArrangement squares = arrange(std::move(family), list, Context());
  ArrangementPictureOptions options{.title = "Nested <b>squares</b> & more"};
  options.face = [&](dcel::FaceId f) -> CellLook {
    if (squares.cells()[f].is_unbounded) return {};
    const auto depth = static_cast<std::uint32_t>(f.index() % 3);
    return {
        {depth, {}}, {"", "part " + std::to_string(f.index()), {{"Material", depth == 0 ? "steel <1>" : "brass"}}}, {}};
  };
  options.curve_name = [](CurveId curve) { return "ring " + std::to_string(curve.index()); };
  options.number_vertices = true;
  PlanarPicture picture = picture_of(squares, options);
  picture.categories = {"steel", "brass", "wood"};
  return picture;
}

PlanarPicture lines() {
  LinearFamily family;
  PieceList<LinearFamily> list;
  std::mt19937 random(5);
  const auto pick = [&] { return static_cast<double>(random() % 1000); };
  for (int i = 0; i < 16; ++i) family.add_line(list, {pick(), pick()}, {pick(), pick()}, "line");
  for (int i = 0; i < 6; ++i) family.add_ray(list, Point2{pick(), pick()}, Point2{pick(), pick()});
  return picture_of(arrange(std::move(family), list, Context()), {.title = "Lines and rays", .number_faces = true});
}

PlanarPicture circles() {
  PlanarPicture picture{.title = "Circles"};
  const double third = 2 * std::numbers::pi / 3;
  // Two unit circles, each through the centre of the other.
  const Point2 low{0.5, -std::sqrt(0.75)};
  const Point2 high{0.5, std::sqrt(0.75)};
  const PicturePath right_inside{low, {arc_to(high, {0, 0}, third)}};
  const PicturePath left_inside{high, {arc_to(low, {1, 0}, third)}};
  const PicturePath left_outside{high, {arc_to(low, {0, 0}, 2 * third)}};
  const PicturePath right_outside{low, {arc_to(high, {1, 0}, 2 * third)}};
  const auto face = [&](const PicturePath& a, const PicturePath& b, std::uint32_t category, const char* label) {
    PicturePath ring = a;
    append(ring, b);
    picture.faces.push_back({{ring}, false, {category, {}}, {"", label, {}}});
  };
  face(left_outside, reversed(left_inside), 0, "left");
  face(right_inside, left_inside, 1, "both");
  face(right_outside, reversed(right_inside), 2, "right");
  for (const PicturePath& path : {right_inside, left_inside, left_outside, right_outside}) {
    picture.edges.push_back({path, EdgeStyle::plain, {}, {}});
  }
  picture.points = {{low, 1, {}, {"", "low", {}}}, {high, 1, {}, {"", "high", {}}}};
  return picture;
}

/// Thousands of cells.
PlanarPicture many() {
  LinearFamily family;
  PieceList<LinearFamily> list;
  std::mt19937 random(6);
  const auto pick = [&] { return static_cast<double>(random() % 100000); };
  for (int i = 0; i < 500; ++i) {
    const Point2 a{pick(), pick()};
    family.add_segment(list, a, Point2{a.x + pick() / 3 - 16000, a.y + pick() / 3 - 16001});
  }
  return picture_of(arrange(std::move(family), list, Context()), {.title = "Many cells", .number_faces = true});
}

SphereEdge great_circle(const Vector3& u, const Vector3& v, const std::string& name) {
  SphereEdge edge{{}, EdgeStyle::plain, {}, {name, "", {{"Curve", name}}}};
  for (int i = 0; i <= 360; ++i) {
    const double t = i * std::numbers::pi / 180;
    const double c = std::cos(t);
    const double s = std::sin(t);
    edge.path.push_back({c * u.x + s * v.x, c * u.y + s * v.y, c * u.z + s * v.z});
  }
  return edge;
}

/// Three coordinate planes cut the sphere into octants; a circle of latitude makes two faces of the first.
SpherePicture octants() {
  SpherePicture picture;
  picture.title = "Octants";
  picture.facts = {{"Faces", "9"}};
  const Vector3 x{1, 0, 0};
  const Vector3 y{0, 1, 0};
  const Vector3 z{0, 0, 1};
  picture.edges = {great_circle(x, y, "Equator"), great_circle(y, z, "Plane x = 0"), great_circle(z, x, "Plane y = 0")};
  SphereEdge circle{{}, EdgeStyle::strong, {4U, {}}, {"Small circle", "", {}}};
  const double diagonal = 1 / std::sqrt(3.0);
  const Vector3 u{std::sqrt(0.5), -std::sqrt(0.5), 0};
  const Vector3 v{1 / std::sqrt(6.0), 1 / std::sqrt(6.0), -2 / std::sqrt(6.0)};
  for (int i = 0; i <= 180; ++i) {
    const double t = i * std::numbers::pi / 90;
    const double c = 0.3 * std::cos(t);
    const double s = 0.3 * std::sin(t);
    const double h = std::sqrt(1 - 0.09) * diagonal;
    circle.path.push_back({h + c * u.x + s * v.x, h + c * u.y + s * v.y, h + c * u.z + s * v.z});
  }
  picture.edges.push_back(circle);
  for (std::uint32_t f = 0; f < 8; ++f) {
    const std::string signs = std::string(f & 1U ? "+" : "-") + (f & 2U ? "+" : "-") + (f & 4U ? "+" : "-");
    picture.faces.push_back({{f, {}}, {"Face " + std::to_string(f), signs, {{"Signs", signs}}}});
  }
  picture.faces.push_back({{{}, Color{240, 220, 90}}, {"Face 8", "cap", {{"Material", "gold <leaf>"}}}});
  const std::vector<Vector3> poles{x, y, z, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  for (const Vector3& p : poles) picture.points.push_back({p, {}, {"", "", {{"Edges", "4"}}}});
  picture.points[0].text.label = "x";
  picture.points[1].text.label = "y";
  picture.points[2].text.label = "z";
  fill_face_map(picture, 2048, [&](const std::vector<Vector3>& directions) {
    std::vector<std::uint32_t> faces;
    for (const Vector3& d : directions) {
      const bool is_cap = (d.x + d.y + d.z) * diagonal > std::sqrt(1 - 0.09);
      faces.push_back(is_cap ? 8U : (d.x > 0 ? 1U : 0U) + (d.y > 0 ? 2U : 0U) + (d.z > 0 ? 4U : 0U));
    }
    return faces;
  });
  return picture;
}

/// Nothing but one face.
SpherePicture bare_sphere() {
  SpherePicture picture;
  picture.title = "One face";
  picture.faces = {{{0U, {}}, {"Face 0", "all", {}}}};
  fill_face_map(picture, 64, [](const std::vector<Vector3>& d) { return std::vector<std::uint32_t>(d.size(), 0); });
  return picture;
}

}  // namespace

void write_pictures(const std::string& directory) {
  write_both(directory + "/nested", nested());
  write_both(directory + "/lines", lines());
  write_both(directory + "/circles", circles());
  write_both(directory + "/many", many());
  write_both(directory + "/blank", {});
  const auto write_sphere = [&](const std::string& name, const SpherePicture& picture) {
    write_file(directory + "/" + name + ".html", [&](std::ostream& out) { write_sphere_page(out, picture); });
  };
  write_sphere("octants", octants());
  write_sphere("bare_sphere", bare_sphere());
  write_sphere("no_sphere", {});
}

}  // namespace quoin
