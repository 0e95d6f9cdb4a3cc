// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/layer_layout.h"

#include <algorithm>
#include <numeric>
#include <random>

namespace quoin {

namespace {

std::uint32_t begin_of(const SceneLayer& layer, std::uint32_t i) {
  return layer.begin.empty() ? 0 : layer.begin[i];
}

/// The elements that are there at some value, by the first of those.
std::vector<std::uint32_t> order_of(const SceneLayer& layer, std::size_t values) {
  const std::size_t count = layer.vertices.size() / (static_cast<std::size_t>(layer.kind) + 1);
  std::vector<std::uint32_t> order;
  order.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (layer.end.empty() || layer.end[i] > begin_of(layer, i)) order.push_back(i);
  }
  if (layer.kind == SceneLayer::Kind::points) {
    std::mt19937_64 random(20);
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
  }
  if (layer.begin.empty()) return order;
  std::vector<std::size_t> place(values + 1, 0);
  for (const std::uint32_t i : order) ++place[layer.begin[i] + 1];
  std::partial_sum(place.begin(), place.end(), place.begin());
  std::vector<std::uint32_t> sorted(order.size());
  for (const std::uint32_t i : order) sorted[place[layer.begin[i]]++] = i;
  return sorted;
}

/// How many elements have begun, by value.
std::vector<std::uint32_t> shown_of(const SceneLayer& layer, const std::vector<std::uint32_t>& order,
                                    std::size_t values) {
  std::vector<std::uint32_t> shown(values, 0);
  for (const std::uint32_t i : order) ++shown[layer.begin[i]];
  std::partial_sum(shown.begin(), shown.end(), shown.begin());
  return shown;
}

}  // namespace

LaidOut lay_out(const SceneLayer& layer, std::size_t values) {
  const std::vector<std::uint32_t> order = order_of(layer, values);
  const std::size_t width = static_cast<std::size_t>(layer.kind) + 1;
  LaidOut made;
  for (const std::uint32_t i : order) {
    const auto first = layer.vertices.begin() + static_cast<std::ptrdiff_t>(width * i);
    made.vertices.insert(made.vertices.end(), first, first + static_cast<std::ptrdiff_t>(width));
    // For ever is beyond the last value.
    if (!layer.end.empty()) made.ends.push_back(std::min(layer.end[i], static_cast<std::uint32_t>(values)));
    if (!layer.owners.empty()) made.owners.push_back(layer.owners[i]);
    if (layer.colors.empty()) continue;
    const Color& color = layer.colors[i];
    made.colors.insert(made.colors.end(), {color.r, color.g, color.b, color.a});
  }
  if (!layer.begin.empty()) made.shown = shown_of(layer, order, values);
  return made;
}

}  // namespace quoin
