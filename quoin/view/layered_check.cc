// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <string>

#include "quoin/base/error.h"
#include "quoin/view/layered_page.h"

namespace quoin {

namespace {

[[noreturn]] void refuse(const std::string& what) {
  throw InputError("layered scene: " + what);
}

void require_below(const std::vector<std::uint32_t>& indices, std::size_t end, bool allows_never,
                   const std::string& what) {
  for (const std::uint32_t index : indices) {
    if (index < end || (allows_never && index == never_in_scene)) continue;
    refuse(what + " names number " + std::to_string(index) + " of " + std::to_string(end));
  }
}

void require_length(std::size_t length, std::size_t count, const std::string& what) {
  if (length != 0 && length != count)
    refuse(what + " are " + std::to_string(length) + ", not " + std::to_string(count));
}

void check_layer(const SceneLayer& layer, const LayeredScene& scene) {
  const std::string what = "layer '" + layer.name + "'";
  const std::size_t width = static_cast<std::size_t>(layer.kind) + 1;
  const std::size_t count = layer.vertices.size() / width;
  if (count * width != layer.vertices.size()) refuse(what + " ends within an element");
  require_below(layer.vertices, scene.point_count(), false, what);
  require_length(layer.begin.size(), count, what + ": beginnings");
  require_length(layer.end.size(), count, what + ": ends");
  require_length(layer.colors.size(), count, what + ": colours");
  require_length(layer.owners.size(), count, what + ": owners");
  require_below(layer.begin, scene.values.size(), false, what + ": a beginning");
  require_below(layer.end, scene.values.size(), true, what + ": an end");
  if (!std::isfinite(layer.size) || layer.size < 0) refuse(what + " has a size that is no size");
}

void check_values(const std::vector<double>& values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isnan(values[i])) refuse("value " + std::to_string(i) + " is no number");
    if (i > 0 && values[i] < values[i - 1]) refuse("value " + std::to_string(i) + " is less than the one before");
  }
}

void check_points(const std::vector<Point3>& points, std::size_t before) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point3& p = points[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      refuse("point " + std::to_string(before + i) + " is not finite");
  }
}

void check_pair(const ScenePair& pair, const LayeredScene& scene, const std::string& what) {
  const std::size_t values = scene.values.size();
  if (pair.birth >= values || (pair.death >= values && pair.death != never_in_scene))
    refuse(what + " is born or dies at a value that there is not");
  if (pair.death <= pair.birth) refuse(what + " dies before it is born");
  for (const std::uint32_t point : {pair.birth_point, pair.death_point}) {
    if (point >= scene.point_count() && point != never_in_scene)
      refuse(what + " is born or dies at a point that there is not");
  }
}

}  // namespace

void check_layered_scene(const LayeredScene& scene) {
  check_points(scene.points, 0);
  check_points(scene.near_points, scene.points.size());
  const std::size_t numbers = scene.point_numbers.size();
  if (numbers < scene.points.size() || numbers > scene.point_count())
    require_length(numbers, scene.point_count(), "numbers of points");
  check_values(scene.values);
  for (const SceneLayer& layer : scene.layers) check_layer(layer, scene);
  if (scene.value && *scene.value >= scene.values.size()) refuse("the first value is none of the values");
  for (const SceneCounts& counts : scene.counts) {
    for (const SceneCount& row : counts.rows) {
      if (row.at.size() != scene.values.size())
        refuse("'" + row.name + "' has " + std::to_string(row.at.size()) + " numbers for " +
               std::to_string(scene.values.size()) + " values");
    }
  }
  for (std::size_t i = 0; i < scene.pairs.size(); ++i) check_pair(scene.pairs[i], scene, "pair " + std::to_string(i));
}

}  // namespace quoin
