// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/layered_page.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <sstream>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"

namespace quoin {
namespace {

constexpr std::string_view bare_template = "<title>@@QUOIN_TITLE@@</title><!--@@QUOIN_SCENE@@--></html>";

std::string page_of(const LayeredScene& scene) {
  std::ostringstream out;
  write_layered_page(out, scene, bare_template);
  return out.str();
}

/// What stands in a page, read by the rules that its format states.
class ReadPage {
 public:
  explicit ReadPage(const LayeredScene& scene) : page_(page_of(scene)) {
    header = nlohmann::json::parse(between("id=\"quoin-layers\">"));
  }

  template <class Number>
  std::vector<Number> array(const nlohmann::json& told) const {
    const std::string bytes = decoded(between("id=\"quoin-block-" + told["block"].dump() + "\">"));
    std::vector<Number> numbers(told["length"].get<std::size_t>());
    const std::size_t width = std::stoul(told["type"].get<std::string>().substr(1)) / 8;
    EXPECT_EQ(bytes.size(), numbers.size() * width) << told;
    EXPECT_LE(width, sizeof(Number)) << told;
    if (bytes.size() != numbers.size() * width || width > sizeof(Number)) return {};
    for (std::size_t i = 0; i < numbers.size(); ++i) std::memcpy(&numbers[i], bytes.data() + i * width, width);
    return numbers;
  }

  nlohmann::json header;

 private:
  std::string between(const std::string& mark) const {
    const std::size_t at = page_.find(mark);
    EXPECT_NE(at, std::string::npos) << mark;
    return page_.substr(at + mark.size(), page_.find("</script>", at) - at - mark.size());
  }

  static std::string decoded(const std::string& text) {
    static constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
      if (c == '=') break;
      bits = bits << 6 | static_cast<std::uint32_t>(digits.find(c));
      count += 6;
      if (count < 8) continue;
      count -= 8;
      bytes += static_cast<char>(bits >> count & 0xFFU);
    }
    return bytes;
  }

  std::string page_;
};

std::vector<std::uint32_t> some(std::mt19937& random, std::size_t count, std::uint32_t end) {
  std::vector<std::uint32_t> numbers;
  for (std::size_t i = 0; i < count; ++i) numbers.push_back(static_cast<std::uint32_t>(random() % end));
  return numbers;
}

SceneLayer random_layer(std::mt19937& random, std::uint32_t points, std::uint32_t values) {
  SceneLayer layer{.name = "layer " + std::to_string(random() % 100), .kind = SceneLayer::Kind(random() % 3)};
  const std::size_t count = random() % 40;
  layer.vertices = some(random, count * (static_cast<std::size_t>(layer.kind) + 1), points);
  if (random() % 4 != 0) layer.begin = some(random, count, values);
  if (random() % 3 != 0) {
    layer.end = some(random, count, values);
    for (std::uint32_t& end : layer.end) end = random() % 4 == 0 ? never_in_scene : end;
  }
  if (random() % 2 == 0) layer.owners = some(random, count, 1000);
  if (random() % 2 == 0) {
    for (const std::uint32_t c : some(random, count, 1U << 24))
      layer.colors.push_back({std::uint8_t(c), std::uint8_t(c >> 8), std::uint8_t(c >> 16), 255});
  }
  return layer;
}

LayeredScene random_scene(std::mt19937& random) {
  LayeredScene scene;
  const bool is_whole = random() % 2 == 0;
  for (std::uint32_t i = 0; i < 1 + random() % 30; ++i) {
    const auto number = [&] {
      return is_whole ? double(random() % 9) : std::ldexp(double(random()), int(random() % 80) - 60);
    };
    scene.points.push_back({number(), number(), number()});
  }
  for (std::uint32_t i = 0; i < 1 + random() % 12; ++i) scene.values.push_back(double(random() % 20));
  std::ranges::sort(scene.values);
  for (std::uint32_t i = 0; i < random() % 5; ++i)
    scene.layers.push_back(
        random_layer(random, std::uint32_t(scene.points.size()), std::uint32_t(scene.values.size())));
  return scene;
}

/// What is there at a value: vertices, colour and owner of each element.
using Elements = std::multiset<std::vector<std::uint32_t>>;

void add(Elements& elements, const std::vector<std::uint32_t>& vertices, std::size_t width, std::size_t i,
         const std::vector<std::uint8_t>& colors, const std::vector<std::uint32_t>& owners) {
  std::vector<std::uint32_t> element(vertices.begin() + std::ptrdiff_t(width * i),
                                     vertices.begin() + std::ptrdiff_t(width * (i + 1)));
  for (std::size_t k = 0; k < 4 && !colors.empty(); ++k) element.push_back(colors[4 * i + k]);
  if (!owners.empty()) element.push_back(owners[i]);
  elements.insert(std::move(element));
}

Elements expected_at(const SceneLayer& layer, std::uint32_t value) {
  Elements elements;
  std::vector<std::uint8_t> colors;
  for (const Color& c : layer.colors) colors.insert(colors.end(), {c.r, c.g, c.b, c.a});
  const std::size_t width = static_cast<std::size_t>(layer.kind) + 1;
  for (std::size_t i = 0; width * i < layer.vertices.size(); ++i) {
    if (!layer.begin.empty() && layer.begin[i] > value) continue;
    if (!layer.end.empty() && layer.end[i] <= value) continue;
    add(elements, layer.vertices, width, i, colors, layer.owners);
  }
  return elements;
}

TEST(LayeredPage, DrawsAtEachValueWhatIsThere) {
  std::mt19937 random(3);
  for (int round = 0; round < test_rounds(60); ++round) {
    const LayeredScene scene = random_scene(random);
    const ReadPage page(scene);
    ASSERT_EQ(page.array<double>(page.header["values"]), scene.values);
    ASSERT_EQ(page.header["layers"].size(), scene.layers.size());
    for (std::size_t l = 0; l < scene.layers.size(); ++l) {
      const nlohmann::json& told = page.header["layers"][l];
      const auto list = [&](const char* key) {
        return told.contains(key) ? page.array<std::uint32_t>(told[key]) : std::vector<std::uint32_t>();
      };
      const std::size_t width = static_cast<std::size_t>(scene.layers[l].kind) + 1;
      const auto vertices = list("vertices");
      const auto shown = list("shown");
      const auto ends = list("ends");
      const auto owners = list("owners");
      const auto colors =
          told.contains("colors") ? page.array<std::uint8_t>(told["colors"]) : std::vector<std::uint8_t>();
      for (std::uint32_t value = 0; value < scene.values.size(); ++value) {
        const std::size_t begun = shown.empty() ? vertices.size() / width : shown[value];
        Elements drawn;
        for (std::size_t i = 0; i < begun; ++i) {
          if (ends.empty() || ends[i] > value) add(drawn, vertices, width, i, colors, owners);
        }
        ASSERT_EQ(drawn, expected_at(scene.layers[l], value)) << "round " << round << ", layer " << l << ", " << value;
      }
    }
  }
}

TEST(LayeredPage, KeepsEveryCoordinate) {
  std::mt19937 random(4);
  for (int round = 0; round < test_rounds(40); ++round) {
    const LayeredScene scene = random_scene(random);
    const ReadPage page(scene);
    const nlohmann::json& told = page.header["points"];
    const bool is_single = told["type"] == "f32";
    const auto singles = is_single ? page.array<float>(told) : std::vector<float>();
    const auto doubles = is_single ? std::vector<double>() : page.array<double>(told);
    for (std::size_t i = 0; i < 3 * scene.points.size(); ++i) {
      const double center = page.header["center"][i % 3];
      const double scale = page.header["scale"];
      ASSERT_EQ(is_single ? center + scale * double{singles[i]} : doubles[i], scene.points[i / 3][i % 3]) << round;
    }
  }
}

LayeredScene segment() {
  LayeredScene scene;
  scene.title = "A </script> title";
  scene.points = {{0, 0, 0}, {1, 0, 0}};
  scene.values = {0, 0, 0.25, std::numeric_limits<double>::infinity()};
  scene.layers = {{.name = "</script>",
                   .kind = SceneLayer::Kind::segments,
                   .vertices = {0, 1},
                   .begin = {2},
                   .end = {3},
                   .colors = {{1, 2, 3, 4}}}};
  scene.counts = {{"Betti numbers", {{"Components", {2, 2, 1, 1}}}}};
  scene.pairs = {{0, 0}, {0, 1, 2}};
  scene.pairs_left_out = 7;
  scene.point_numbers = {5, 9};
  scene.value = 1;
  return scene;
}

TEST(LayeredPage, HoldsWhatGoesWithTheValue) {
  const ReadPage page(segment());
  const nlohmann::json& header = page.header;
  EXPECT_EQ(header["title"], "A </script> title");
  EXPECT_EQ(header["layers"][0]["name"], "</script>");
  EXPECT_EQ(header["value"], 1);
  EXPECT_EQ(header["pairsLeftOut"], 7);
  EXPECT_EQ(page.array<std::uint32_t>(header["pairs"]), (std::vector<std::uint32_t>{0, 0, never_in_scene, 0, 1, 2}));
  EXPECT_EQ(page.array<std::uint32_t>(header["pointNumbers"]), (std::vector<std::uint32_t>{5, 9}));
  EXPECT_EQ(page.array<std::uint32_t>(header["counts"][0]["rows"][0]["at"]), (std::vector<std::uint32_t>{2, 2, 1, 1}));
  EXPECT_EQ(page_of(segment()), page_of(segment()));
  EXPECT_EQ(page_of(segment()).find("</script> title"), std::string::npos);
  EXPECT_EQ(ReadPage({}).header["layers"].size(), 0U);
  EXPECT_FALSE(ReadPage({}).header.contains("value"));
}

TEST(LayeredPage, TellsNearPointsOwnersAndLinks) {
  LayeredScene scene = segment();
  scene.near_points = {{0.1, 0.2, 0.3}, {0.5, 3, 0}};
  scene.point_numbers = {5, 9, 0};
  scene.layers[0].vertices = {1, 3};
  scene.layers[0].owners = {7};
  scene.layers[0].element_name = "Saddle";
  scene.links = {{7, 8}, {8, 2}};
  scene.pairs[1].death_point = 2;
  scene.has_all_values = false;
  const ReadPage page(scene);
  const nlohmann::json& header = page.header;
  const auto near = page.array<float>(header["nearPoints"]);
  for (std::size_t i = 0; i < 6; ++i) {
    const double told = double(header["center"][i % 3]) + double(header["scale"]) * double{near[i]};
    EXPECT_NEAR(told, scene.near_points[i / 3][i % 3], 1e-6) << i;
  }
  EXPECT_EQ(page.array<std::uint32_t>(header["links"]), (std::vector<std::uint32_t>{7, 8, 8, 2}));
  EXPECT_EQ(page.array<std::uint32_t>(header["pairPoints"]),
            (std::vector<std::uint32_t>{never_in_scene, never_in_scene, never_in_scene, 2}));
  EXPECT_EQ(page.array<std::uint32_t>(header["layers"][0]["owners"]), (std::vector<std::uint32_t>{7}));
  EXPECT_EQ(header["layers"][0]["elementName"], "Saddle");
  EXPECT_EQ(header["hasAllValues"], false);
  for (const char* key : {"nearPoints", "links", "pairPoints"}) EXPECT_FALSE(ReadPage(segment()).header.contains(key));
}

TEST(LayeredPage, ShowsAFairSampleOfPointsFirst) {
  LayeredScene scene;
  SceneLayer layer;
  for (std::uint32_t i = 0; i < 4000; ++i) {
    scene.points.push_back({double(i), 0, 0});
    layer.vertices.push_back(i);
  }
  scene.layers = {layer};
  const ReadPage page(scene);
  const auto order = page.array<std::uint32_t>(page.header["layers"][0]["vertices"]);
  std::map<std::uint32_t, int> of_tenth;
  for (std::size_t i = 0; i < 400; ++i) ++of_tenth[order[i] / 400];
  for (std::uint32_t tenth = 0; tenth < 10; ++tenth) EXPECT_NEAR(of_tenth[tenth], 40, 30) << tenth;
}

TEST(LayeredPage, RefusesWhatIsOutOfRange) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::vector<std::function<void(LayeredScene&)>> faults{
      [](LayeredScene& s) { s.points[1].y = infinity; },
      [](LayeredScene& s) { s.points[1].z = std::numeric_limits<double>::quiet_NaN(); },
      [](LayeredScene& s) { s.point_numbers.pop_back(); },
      [](LayeredScene& s) { s.values[1] = std::numeric_limits<double>::quiet_NaN(); },
      [](LayeredScene& s) { s.values[1] = 0.5; },
      [](LayeredScene& s) { s.layers[0].vertices[1] = 2; },
      [](LayeredScene& s) { s.layers[0].vertices.push_back(0); },
      [](LayeredScene& s) { s.layers[0].begin[0] = 4; },
      [](LayeredScene& s) { s.layers[0].begin.push_back(0); },
      [](LayeredScene& s) { s.layers[0].end[0] = 4; },
      [](LayeredScene& s) { s.layers[0].end.push_back(0); },
      [](LayeredScene& s) { s.layers[0].colors.push_back({}); },
      [](LayeredScene& s) {
        s.layers[0].owners = {1, 2};
      },
      [](LayeredScene& s) {
        s.near_points = {{0, 0, infinity}};
      },
      [](LayeredScene& s) { s.point_numbers.push_back(3); },
      [](LayeredScene& s) { s.pairs[1].birth_point = 2; },
      [](LayeredScene& s) { s.pairs[1].death_point = 2; },
      [](LayeredScene& s) { s.layers[0].size = -1; },
      [](LayeredScene& s) { s.layers[0].size = infinity; },
      [](LayeredScene& s) { s.value = 4; },
      [](LayeredScene& s) { s.counts[0].rows[0].at.pop_back(); },
      [](LayeredScene& s) { s.pairs[0].birth = 4; },
      [](LayeredScene& s) { s.pairs[1].death = 4; },
      [](LayeredScene& s) { s.pairs[1].death = 1; }};
  for (std::size_t k = 0; k < faults.size(); ++k) {
    LayeredScene scene = segment();
    faults[k](scene);
    EXPECT_THROW(page_of(scene), InputError) << "fault " << k;
  }
}

}  // namespace
}  // namespace quoin
