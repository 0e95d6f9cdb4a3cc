// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/sphere_picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <set>
#include <sstream>

#include "quoin/arrangement/geodesic/geodesic_arrangement.h"
#include "quoin/base/error.h"
#include "quoin/number/rational.h"
#include "quoin/view/page.h"
#include "quoin/view/sphere_arrangement_picture.h"
#include "quoin/view/sphere_page.h"

namespace quoin {
namespace {

Vector3 unit(double x, double y, double z) {
  const double length = std::hypot(x, y, z);
  return {x / length, y / length, z / length};
}

SphereEdge great_circle(const Vector3& normal) {
  const Vector3 u = std::fabs(normal.z) > 0.5 ? unit(normal.z, 0, -normal.x) : unit(-normal.y, normal.x, 0);
  const Vector3 v{normal.y * u.z - normal.z * u.y, normal.z * u.x - normal.x * u.z, normal.x * u.y - normal.y * u.x};
  SphereEdge edge;
  for (int i = 0; i <= 48; ++i) {
    const double t = i * 3.14159265358979 / 24;
    const double c = std::cos(t);
    const double s = std::sin(t);
    edge.path.push_back(unit(c * u.x + s * v.x, c * u.y + s * v.y, c * u.z + s * v.z));
  }
  return edge;
}

TEST(FaceMap, IsThatOfEveryPixelAndAsksForFew) {
  std::mt19937 random(3);
  for (int round = 0; round < 30; ++round) {
    SpherePicture picture;
    std::vector<Vector3> normals;
    for (int i = 0; i < 1 + round % 5; ++i) {
      const auto pick = [&] { return static_cast<double>(random() % 7) - 3; };  // often through the poles
      Vector3 n{pick(), pick(), pick()};
      if (n == Vector3{}) n = {0, 0, 1};
      normals.push_back(unit(n.x, n.y, n.z));
      picture.edges.push_back(great_circle(normals.back()));
    }
    const auto face = [&](const Vector3& d) {
      std::uint32_t signs = 0;
      for (const Vector3& n : normals) signs = 2 * signs + (n.x * d.x + n.y * d.y + n.z * d.z > 0 ? 1U : 0U);
      return signs;
    };
    picture.faces.resize(32);
    std::size_t asked = 0;
    fill_face_map(picture, 512, [&](const std::vector<Vector3>& directions) {
      asked += directions.size();
      std::vector<std::uint32_t> faces;
      for (const Vector3& d : directions) faces.push_back(face(d));
      return faces;
    });
    check_picture(picture);
    for (std::size_t i = 0; i < picture.map.faces.size(); ++i) {
      ASSERT_EQ(picture.map.faces[i], face(picture.map.direction(i))) << "round " << round << ", pixel " << i;
    }
    EXPECT_LT(asked, picture.map.faces.size() / 5) << "round " << round;
  }
}

TEST(FaceMap, WithoutEdgesAsksOnce) {
  SpherePicture picture;
  picture.faces.resize(1);
  fill_face_map(picture, 64, [](const std::vector<Vector3>& directions) {
    EXPECT_EQ(directions.size(), 1U);
    return std::vector<std::uint32_t>{0};
  });
  EXPECT_EQ(picture.map.faces.size(), 64U * 32U);
  EXPECT_THROW(fill_face_map(picture, 2, {}), InputError);
}

TEST(SpherePicture, RefusesWhatItCannotShow) {
  SpherePicture picture;
  picture.points.push_back({{1, 1, 0}, {}, {}});
  EXPECT_THROW(check_picture(picture), InputError);
  picture.points[0].at = {0, 1, 0};
  EXPECT_NO_THROW(check_picture(picture));
  picture.map = {2, 1, {0, 0}};
  EXPECT_THROW(check_picture(picture), InputError);
  picture.faces.resize(1);
  EXPECT_NO_THROW(check_picture(picture));
  picture.map.height = 2;
  EXPECT_THROW(check_picture(picture), InputError);
}

TEST(SpherePage, HoldsThePictureAndNoMarkup) {
  SpherePicture picture;
  picture.title = "</title><script>";
  picture.faces.push_back({{3U, {}}, {"</script>", "\"", {{"<", "&"}}}});
  picture.map = {2, 1, {0, 0}};
  const auto page_of = [&] {
    std::ostringstream out;
    write_sphere_page(out, picture, "<title>@@QUOIN_TITLE@@</title><body><!--@@QUOIN_SCENE@@--></body>");
    return out.str();
  };
  const std::string page = page_of();
  EXPECT_EQ(page, page_of());
  EXPECT_NE(page.find("<title>&lt;/title>&lt;script></title>"), std::string::npos);
  EXPECT_NE(page.find("[\"\\u003c/script>\",\"\\u0022\",[[\"\\u003c\",\"&\"]],0]"), std::string::npos) << page;
  EXPECT_NE(page.find("id=\"quoin-map\">AAAAAAIAAAA=<"), std::string::npos) << "one run of two pixels";
}

GeodesicArrangement great_circles(std::mt19937& random, int count) {
  GeodesicFamily family;
  PieceList<GeodesicFamily> list;
  for (int i = 0; i < count; ++i) {
    const auto pick = [&] { return static_cast<double>(random() % 7) - 3; };
    Vector3 n{pick(), pick(), pick()};
    if (n == Vector3{}) n = {0, 0, 1};
    family.add_great_circle(list, SphereDirection(n));
  }
  return arrange(std::move(family), list, Context());
}

TEST(SphereArrangementPicture, FacesAreWhereTheSignsOfTheirCirclesSay) {
  std::mt19937 random(5);
  for (int round = 0; round < 8; ++round) {
    const GeodesicArrangement circles = great_circles(random, 1 + round % 6);
    const SpherePicture picture = sphere_picture_of(circles, {.title = "Circles"}, {}, 96);
    check_picture(picture);
    ASSERT_EQ(picture.faces.size(), circles.counts().faces);
    ASSERT_EQ(picture.edges.size(), circles.counts().edges);
    ASSERT_EQ(picture.points.size(), circles.counts().vertices);
    // Signs with regard to all edges' planes tell the faces of an arrangement of whole circles.
    std::map<std::vector<bool>, std::uint32_t> face_of_signs;
    for (std::size_t i = 0; i < picture.map.faces.size(); i += 3) {
      const Vector3 d = picture.map.direction(i);
      std::vector<bool> signs;
      double least = 1;
      for (std::size_t e = 0; e < circles.edge_count(); ++e) {
        const auto exact = circles.family().normal(circles.branch(dcel::EdgeId(e)));
        const Vector3 n =
            unit(Rational(exact[0]).to_double(), Rational(exact[1]).to_double(), Rational(exact[2]).to_double());
        const double side = n.x * d.x + n.y * d.y + n.z * d.z;
        least = std::min(least, std::fabs(side));
        signs.push_back(side > 0);
      }
      if (least < 1e-9) continue;
      const auto [at, is_new] = face_of_signs.emplace(signs, picture.map.faces[i]);
      ASSERT_EQ(at->second, picture.map.faces[i]) << "round " << round << ", pixel " << i;
    }
    std::set<std::uint32_t> seen;
    for (const auto& [signs, face] : face_of_signs) seen.insert(face);
    EXPECT_EQ(seen.size(), face_of_signs.size()) << "different signs, different faces";
  }
}

}  // namespace
}  // namespace quoin
