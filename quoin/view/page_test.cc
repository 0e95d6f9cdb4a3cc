// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/page.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <random>
#include <sstream>

#include "quoin/base/error.h"
#include "quoin/view/base64.h"
#include "quoin/view/page_format.h"

namespace quoin {
namespace {

constexpr std::string_view bare_template = "<title>@@QUOIN_TITLE@@</title><body><!--@@QUOIN_SCENE@@--></body>";

std::string page_of(const ViewScene& scene) {
  std::ostringstream out;
  write_page(out, scene, bare_template);
  return out.str();
}

/// The text of the script element with that id.
std::string element(const std::string& page, const std::string& id) {
  const std::size_t at = page.find("id=\"" + id + "\">");
  if (at == std::string::npos) return "missing";
  const std::size_t begin = page.find('>', at) + 1;
  return page.substr(begin, page.find("</script", begin) - begin);
}

/// What the header says of one array of the first part.
struct ArrayHeader {
  std::string type;
  std::size_t length = 0;
  std::string block;
};

ArrayHeader array_header(const std::string& page, const std::string& key) {
  const std::string header = element(page, "quoin-scene");
  const std::size_t at = header.find('"' + key + "\":{\"type\":\"");
  if (at == std::string::npos) return {"missing", 0, ""};
  const std::string rest = header.substr(at + key.size() + 12);
  const auto after = [&](const std::string& name) { return rest.substr(rest.find(name) + name.size()); };
  const std::string block = after("\"block\":");
  return {rest.substr(0, 3 - (rest[2] == '"' ? 1 : 0)), std::stoul(after("\"length\":")),
          "quoin-block-" + block.substr(0, block.find('}'))};
}

std::string decode_base64(std::string_view text) {
  const std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0;
  int count = 0;
  for (const char c : text) {
    if (c == '=') break;
    bits = bits << 6 | static_cast<unsigned>(digits.find(c));
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes.push_back(static_cast<char>(bits >> count & 255U));
  }
  return bytes;
}

template <class Value>
std::vector<Value> array(const std::string& page, const std::string& key) {
  const std::string bytes = decode_base64(element(page, array_header(page, key).block));
  std::vector<Value> values(bytes.size() / sizeof(Value));
  if (!values.empty()) std::memcpy(values.data(), bytes.data(), values.size() * sizeof(Value));
  return values;
}

ViewPart triangle(const Point3& a, const Point3& b, const Point3& c) {
  ViewPart part;
  part.name = "triangle";
  part.vertices = {a, b, c};
  part.triangles = {{0, 1, 2}};
  part.triangle_face = {0};
  part.faces = {ViewFace{.plane = {0, 0, 1, 0.1}, .origin = 7}};
  part.edges = {{0, 1}, {1, 2}, {0, 2}};
  return part;
}

ViewScene scene_of(ViewPart part) {
  ViewScene scene;
  scene.title = "test";
  scene.parts.push_back(std::move(part));
  return scene;
}

TEST(Page, HoldsEveryArray) {
  ViewPart part = triangle({0, 0, 0}, {4, 0, 0}, {0, 2, 0});
  part.faces[0].color = Color{1, 2, 3, 4};
  part.plane_texts = {"z = 1/10"};
  part.face_spans = {{0, 1, 3}};
  part.plane_points = {{0, 1e-30, 0}};
  part.more_origins = {{0, 300, 5}};
  const std::string page = page_of(scene_of(part));
  const std::string header = element(page, "quoin-scene");
  EXPECT_NE(header.find("\"center\":[2,1,0],\"scale\":4"), std::string::npos) << header;
  EXPECT_EQ(array<float>(page, "vertices"), (std::vector<float>{-.5, -.25, 0, .5, -.25, 0, -.5, .25, 0}));
  EXPECT_EQ(array<std::uint8_t>(page, "triangles"), (std::vector<std::uint8_t>{0, 1, 2}));
  EXPECT_EQ(array<std::uint8_t>(page, "edges"), (std::vector<std::uint8_t>{0, 1, 1, 2, 0, 2}));
  EXPECT_EQ(array<double>(page, "planes"), (std::vector<double>{0, 0, 1, 0.1}));
  EXPECT_EQ(array<std::uint8_t>(page, "faceSpans"), (std::vector<std::uint8_t>{0, 1, 3}));
  EXPECT_EQ(array<double>(page, "planePoints"), (std::vector<double>{0, 1e-30, 0}));
  EXPECT_NE(header.find("\"faceCount\":1"), std::string::npos) << header;
  EXPECT_EQ(array<std::uint8_t>(page, "faceOrigins"), (std::vector<std::uint8_t>{7}));
  EXPECT_EQ(array<std::uint8_t>(page, "colors"), (std::vector<std::uint8_t>{1, 2, 3, 4}));
  EXPECT_EQ(array<std::uint16_t>(page, "moreOrigins"), (std::vector<std::uint16_t>{0, 300, 5}));
  EXPECT_EQ(array<char>(page, "planeTexts"), (std::vector<char>{'z', ' ', '=', ' ', '1', '/', '1', '0'}));
  EXPECT_EQ(array<std::uint32_t>(page, "planeTextEnds"), (std::vector<std::uint32_t>{8}));
  EXPECT_EQ(array_header(page, "facePieces").type, "missing") << "zeros are not written";
}

/// Whatever the page holds gives back the double: small integers through floats, everything else as it is.
TEST(Page, KeepsCoordinatesExactly) {
  std::mt19937_64 random(11);
  const std::vector<double> magnitudes{1, 1e-300, 5e-324, 1e300, std::numeric_limits<double>::max(), 1e9};
  for (int round = 0; round < 600; ++round) {
    const double magnitude = magnitudes[static_cast<std::size_t>(round) % magnitudes.size()];
    const auto coordinate = [&]() -> double {
      if (round % 5 == 0) return static_cast<double>(static_cast<int>(random() % 64) - 32);
      return (static_cast<double>(random() % 2001) / 1000 - 1) * magnitude;
    };
    const auto point = [&] { return Point3{coordinate(), coordinate(), coordinate()}; };
    const ViewPart part = triangle(point(), point(), point());
    const std::string page = page_of(scene_of(part));
    const std::string header = element(page, "quoin-scene");
    std::istringstream frame(header.substr(header.find("\"center\":[") + 10));
    double center[3];
    double scale = 0;
    std::string numbers;
    std::getline(frame, numbers, ']');
    std::sscanf(numbers.c_str(), "%lf,%lf,%lf", &center[0], &center[1], &center[2]);
    std::string rest;
    std::getline(frame, rest, ':');
    std::getline(frame, rest, ',');
    scale = std::strtod(rest.c_str(), nullptr);
    const bool is_float = array_header(page, "vertices").type == "f32";
    const auto floats = array<float>(page, "vertices");
    const auto doubles = array<double>(page, "vertices");
    for (std::size_t i = 0; i < 9; ++i) {
      const double kept = is_float ? center[i % 3] + scale * double{floats[i]} : doubles[i];
      ASSERT_EQ(kept, part.vertices[i / 3][i % 3]) << "round " << round << ", coordinate " << i << "\n" << header;
    }
  }
}

TEST(Page, NarrowestWidthHoldsTheIndices) {
  for (const std::size_t count : {3U, 256U, 257U, 65536U, 65537U}) {
    ViewPart part;
    part.name = "fan";
    part.vertices.resize(count, Point3{1, 2, 3});
    const auto last = static_cast<std::uint32_t>(count - 1);
    part.triangles = {{0, last, 1}};
    part.triangle_face = {0};
    part.faces.resize(1);
    const std::string page = page_of(scene_of(part));
    const std::string type = array_header(page, "triangles").type;
    EXPECT_EQ(type, count <= 256 ? "u8" : count <= 65536 ? "u16" : "u32") << count;
  }
}

TEST(Page, NamesCannotEndTheirElement) {
  const std::string evil = "</script><!--<script>\"\\\n\x01 ü & \xFF";
  ViewPart part = triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  part.name = evil;
  part.facts = {{evil, evil}};
  part.plane_texts = {evil};
  ViewScene scene = scene_of(part);
  scene.title = "</title><script>alert(1)</script>&amp;";
  scene.origins = {evil};
  scene.facts = {{evil, evil}};
  scene.unit = evil;
  const std::string page = page_of(scene);
  const std::string header = element(page, "quoin-scene");
  EXPECT_EQ(header.find('<'), std::string::npos);
  EXPECT_EQ(header.back(), '}');
  EXPECT_NE(header.find("\\u003c/script>\\u003c!--\\u003cscript>\\u0022\\u005c\\u000a\\u0001"), std::string::npos);
  EXPECT_NE(page.find("<title>&lt;/title>&lt;script>alert(1)&lt;/script>&amp;amp;</title>"), std::string::npos);
}

TEST(Page, OfAnEmptySceneIsAPage) {
  const std::string page = page_of({});
  EXPECT_NE(page.find("<title>Quoin</title>"), std::string::npos);
  EXPECT_NE(page.find("\"center\":[0,0,0],\"scale\":1,\"origins\":[],\"parts\":[]}"), std::string::npos);
  EXPECT_EQ(page_of(scene_of({})).find("quoin-block"), std::string::npos) << "a part of nothing has no arrays";
}

TEST(Page, DoesNotDependOnTheStream) {
  ViewPart part = triangle({0.1, 1e6, 0}, {123456, 0, 0}, {0, 1, 1e-9});
  std::ostringstream out;
  out << std::hex << std::showbase << std::fixed;
  out.precision(2);
  write_page(out, scene_of(part), bare_template);
  EXPECT_EQ(out.str(), page_of(scene_of(part)));
}

TEST(Page, RefusesWhatItCannotShowAndNamesIt) {
  const auto refusal = [](auto change) -> std::string {
    ViewPart part = triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    change(part);
    try {
      page_of(scene_of(part));
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal([](ViewPart&) {}), "accepted");
  EXPECT_EQ(refusal([&](ViewPart& p) { p.vertices[2].y = nan; }), "view: part 'triangle': vertex 2 is not finite");
  EXPECT_EQ(refusal([](ViewPart& p) { p.triangles[0][1] = 3; }),
            "view: part 'triangle': triangle 0 names vertex 3 of 3");
  EXPECT_EQ(refusal([](ViewPart& p) { p.triangle_face[0] = 1; }),
            "view: part 'triangle': triangle 0 names face 1 of 1");
  EXPECT_EQ(refusal([](ViewPart& p) { p.triangle_face.clear(); }),
            "view: part 'triangle': 1 triangles, but faces given for 0");
  EXPECT_EQ(refusal([](ViewPart& p) { p.edges[1][0] = 9; }), "view: part 'triangle': edge 1 names vertex 9 of 3");
  EXPECT_EQ(refusal([&](ViewPart& p) { p.faces[0].plane[3] = nan; }),
            "view: part 'triangle': the plane of face 0 is not finite");
  EXPECT_EQ(refusal([](ViewPart& p) {
              p.plane_texts = {"", ""};
            }),
            "view: part 'triangle': 1 faces, but 2 texts of planes");
  EXPECT_EQ(refusal([](ViewPart& p) {
              p.more_origins = {{4, 0, 0}};
            }),
            "view: part 'triangle': further origin 0 names face 4 of 1");
}

TEST(Page, IsBuiltInOrSaysThatItIsNot) {
  std::ostringstream out;
  if (has_view()) {
    write_page(out, scene_of(triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0})));
    EXPECT_NE(out.str().find("<!doctype html>"), std::string::npos);
    EXPECT_EQ(out.str().find("@@QUOIN"), std::string::npos);
    EXPECT_EQ(out.str().find("src=\"http"), std::string::npos);
  } else {
    EXPECT_THROW(write_page(out, {}), Error);
    EXPECT_EQ(out.str(), "");
  }
}

TEST(Base64, IsThatOfTheBytesForEveryLength) {
  std::mt19937 random(5);
  for (std::size_t length = 0; length < 7000; length += length < 40 ? 1 : 611) {
    std::string bytes;
    for (std::size_t i = 0; i < length; ++i) bytes.push_back(static_cast<char>(random()));
    std::ostringstream out;
    Base64Writer writer(out);
    for (const char c : bytes) writer.put(static_cast<std::uint8_t>(c));
    writer.finish();
    EXPECT_EQ(out.str().size(), (length + 2) / 3 * 4);
    EXPECT_EQ(decode_base64(out.str()), bytes) << length;
  }
}

}  // namespace
}  // namespace quoin
