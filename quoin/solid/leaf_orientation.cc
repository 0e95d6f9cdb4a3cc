// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/leaf_orientation.h"

#include <algorithm>
#include <tuple>
#include <vector>

#include "quoin/solid/leaf_tiles.h"
#include "quoin/solid/one_sided_bands.h"

namespace quoin {

namespace {

struct Use {
  std::uint32_t a;
  std::uint32_t b;
  std::uint32_t tile;
  bool is_forward;
};

std::vector<FaceLink> links_of(const Leaf& leaf) {
  std::vector<Use> uses;
  uses.reserve(3 * leaf.tiles.size());
  for (std::uint32_t t = 0; t < leaf.tiles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = leaf.tiles[t][k];
      const std::uint32_t to = leaf.tiles[t][(k + 1) % 3];
      uses.push_back({std::min(from, to), std::max(from, to), t, from < to});
    }
  }
  std::sort(uses.begin(), uses.end(),
            [](const Use& x, const Use& y) { return std::tie(x.a, x.b, x.tile) < std::tie(y.a, y.b, y.tile); });
  std::vector<FaceLink> links;
  for (std::size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
    while (end < uses.size() && uses[end].a == uses[begin].a && uses[end].b == uses[begin].b) ++end;
    if (end - begin == 2)
      links.push_back({uses[begin].tile, uses[begin + 1].tile, uses[begin].is_forward != uses[begin + 1].is_forward});
  }
  return links;
}

}  // namespace

void find_one_sided_bands(const Leaf& leaf, std::size_t max_listed, MeshDiagnosis& diagnosis, const Context& context) {
  const Orientation orientation = orient_faces(leaf.tiles.size(), links_of(leaf), context);
  for (const std::vector<std::uint32_t>& tiles : orientation.one_sided_bands) {
    std::vector<std::uint32_t> faces;
    for (const std::uint32_t t : tiles) {
      if (faces.empty() || faces.back() != leaf.tile_face[t]) faces.push_back(leaf.tile_face[t]);
    }
    while (faces.size() > 1 && faces.front() == faces.back()) faces.pop_back();
    note(diagnosis.one_sided_bands, faces, max_listed);
  }
}

}  // namespace quoin
