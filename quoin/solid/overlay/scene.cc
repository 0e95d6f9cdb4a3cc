// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/overlay/scene.h"

#include <algorithm>
#include <iterator>
#include <numeric>

#include "quoin/base/error.h"
#include "quoin/base/parallel.h"
#include "quoin/solid/overlay/point_merger.h"

namespace quoin::overlay {

namespace {

struct LeafPair {
  std::uint32_t a;
  std::uint32_t b;
};

bool boxes_meet(const std::array<float, 6>& a, const std::array<float, 6>& b) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (a[k] > b[k + 3] || b[k] > a[k + 3]) return false;
  }
  return true;
}

// Leaves whose boxes meet, by a sweep along x; in ascending order.
std::vector<LeafPair> leaf_pairs(std::span<const std::shared_ptr<const Leaf>> leaves) {
  std::vector<std::array<float, 6>> boxes;
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < leaves.size(); ++i) {
    boxes.push_back(leaves[i]->tree.bounds());
    if (!leaves[i]->tiles.empty()) order.push_back(i);
  }
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) { return boxes[i][0] < boxes[j][0]; });
  std::vector<LeafPair> result;
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t j = i + 1; j < order.size() && boxes[order[j]][0] <= boxes[order[i]][3]; ++j) {
      if (boxes_meet(boxes[order[i]], boxes[order[j]])) {
        result.push_back({std::min(order[i], order[j]), std::max(order[i], order[j])});
      }
    }
  }
  for (const std::uint32_t i : order) {
    if (leaves[i]->crosses_itself) result.push_back({i, i});
  }
  std::sort(result.begin(), result.end(), [](LeafPair x, LeafPair y) { return x.a != y.a ? x.a < y.a : x.b < y.b; });
  return result;
}

std::vector<TilePair> tile_pairs(const Scene& scene, LeafPair leaves, const Context& context) {
  const Leaf& a = *scene.leaves[leaves.a];
  const Leaf& b = *scene.leaves[leaves.b];
  std::vector<TilePair> pairs =
      leaves.a == leaves.b ? a.tree.self_pairs(context) : BoxTree::pairs(a.tree, b.tree, context);
  for (TilePair& pair : pairs) {
    pair.a += scene.first_tile[leaves.a];
    pair.b += scene.first_tile[leaves.b];
  }
  return pairs;
}

std::uint32_t add_facet(Scene& scene, std::uint32_t tile, std::uint32_t leaf) {
  std::uint32_t& facet = scene.facet_of_tile[tile];
  if (facet == none) {
    facet = static_cast<std::uint32_t>(scene.facets.size());
    scene.facets.push_back({tile, leaf, {}});
  }
  return facet;
}

void find_pairs(Scene& scene, const Context& context) {
  const std::vector<LeafPair> meeting = leaf_pairs(scene.leaves);
  std::vector<std::vector<TilePair>> found(meeting.size());
  for_each_chunk(context, meeting.size(), 1,
                 [&](const Chunk& chunk) { found[chunk.index] = tile_pairs(scene, meeting[chunk.index], context); });
  for (std::size_t i = 0; i < meeting.size(); ++i) {
    for (const TilePair& pair : found[i]) {
      const std::uint32_t a = add_facet(scene, pair.a, meeting[i].a);
      scene.pairs.push_back({a, add_facet(scene, pair.b, meeting[i].b)});
    }
  }
}

// Tiles at edges where not exactly two tiles meet take part in the order of sides about that edge.
void add_facets_without_twin(Scene& scene) {
  for (std::uint32_t leaf = 0; leaf < scene.leaves.size(); ++leaf) {
    if (scene.leaves[leaf]->has_all_twins) continue;
    const std::vector<std::uint32_t>& twins = scene.leaves[leaf]->twins;
    for (std::size_t h = 0; h < twins.size(); ++h) {
      if (twins[h] == Leaf::no_twin) add_facet(scene, scene.first_tile[leaf] + static_cast<std::uint32_t>(h / 3), leaf);
    }
  }
}

// Lets the smallest id of each set of equal facet vertices stand for all of them.
void merge_vertices(Scene& scene) {
  std::vector<std::uint32_t> used;
  used.reserve(3 * scene.facets.size());
  for (const Facet& facet : scene.facets) {
    const Leaf& leaf = *scene.leaves[facet.leaf];
    for (const std::uint32_t v : leaf.tiles[facet.tile - scene.first_tile[facet.leaf]]) {
      used.push_back(scene.first_vertex[facet.leaf] + v);
    }
  }
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  PointMerger merger(scene.table);
  for (const std::uint32_t v : used) {
    const PointId first = merger.insert(PointId{v});
    if (first.value == v) continue;
    scene.merged[v] = first.value;
    scene.shared[first.value] = true;
  }
}

// Of leaves over rational points and others.
Constructions rational_table(const Scene& scene) {
  std::vector<RationalPoint3> points;
  points.reserve(scene.first_vertex.back());
  for (const auto& leaf : scene.leaves) {
    points.insert(points.end(), leaf->exact_vertices.begin(), leaf->exact_vertices.end());
    if (!leaf->exact_vertices.empty()) continue;
    std::transform(leaf->vertices.begin(), leaf->vertices.end(), std::back_inserter(points), exact_point);
  }
  return Constructions(std::move(points));
}

Constructions gather_vertices(const Scene& scene) {
  for (const auto& leaf : scene.leaves) {
    if (!leaf->exact_vertices.empty()) return rational_table(scene);
  }
  std::vector<Point3> points;
  // With room for contacts, so that adding some moves nothing.
  points.reserve(scene.first_vertex.back() + scene.first_vertex.back() / 16);
  for (const auto& leaf : scene.leaves) points.insert(points.end(), leaf->vertices.begin(), leaf->vertices.end());
  return Constructions(std::move(points));
}

void number_leaves(Scene& scene) {
  std::uint64_t vertices = 0;
  std::uint64_t tiles = 0;
  for (const auto& leaf : scene.leaves) {
    scene.first_vertex.push_back(static_cast<std::uint32_t>(vertices));
    scene.first_tile.push_back(static_cast<std::uint32_t>(tiles));
    vertices += leaf->vertices.size();
    tiles += leaf->tiles.size();
    if (vertices >= 0x7FFFFFFFU || tiles >= 0x2AAAAAAAU)
      throw InputError("more than 700 million triangles in one operation");
  }
  scene.first_vertex.push_back(static_cast<std::uint32_t>(vertices));
  scene.first_tile.push_back(static_cast<std::uint32_t>(tiles));
}

void number_elements(Scene& scene) {
  scene.facet_of_tile.assign(scene.tile_count(), none);
  scene.merged.resize(scene.first_vertex.back());
  std::iota(scene.merged.begin(), scene.merged.end(), 0U);
  scene.shared.assign(scene.first_vertex.back(), false);
}

}  // namespace

std::uint32_t Scene::leaf_of_tile(std::uint32_t tile) const {
  const auto after = std::upper_bound(first_tile.begin(), first_tile.end(), tile);
  return static_cast<std::uint32_t>(after - first_tile.begin() - 1);
}

std::array<PointId, 3> Scene::corners(std::uint32_t tile, std::uint32_t leaf) const {
  const Tile& local = leaves[leaf]->tiles[tile - first_tile[leaf]];
  std::array<PointId, 3> result;
  for (std::size_t k = 0; k < 3; ++k) result[k] = PointId{merged[first_vertex[leaf] + local[k]]};
  return result;
}

Color Scene::color(std::uint32_t leaf, std::uint32_t face) const {
  const std::vector<Color>& colors = leaves[leaf]->face_colors;
  return colors.empty() ? Color{200, 200, 200, 255} : colors[face];
}

Scene::Halfedge Scene::twin(std::uint32_t tile, std::uint32_t edge, std::uint32_t leaf) const {
  const std::uint32_t opposite = leaves[leaf]->twins[3 * (tile - first_tile[leaf]) + edge];
  if (opposite == Leaf::no_twin) return {none, 0};
  return {first_tile[leaf] + opposite / 3, opposite % 3};
}

Scene make_unpaired_scene(std::span<const std::shared_ptr<const Leaf>> leaves, const Context& context) {
  Scene scene;
  scene.leaves = leaves;
  number_leaves(scene);
  run_both(
      context, [&] { scene.table = gather_vertices(scene); }, [&] { number_elements(scene); });
  return scene;
}

Scene make_unpaired_scene(const std::shared_ptr<const Leaf>& leaf, Constructions table) {
  Scene scene;
  scene.leaves = {&leaf, 1};
  number_leaves(scene);
  scene.table = std::move(table);
  number_elements(scene);
  return scene;
}

Scene make_scene(std::span<const std::shared_ptr<const Leaf>> leaves, const Context& context) {
  Scene scene = make_unpaired_scene(leaves, context);
  context.progress("pairs", 0);
  find_pairs(scene, context);
  add_facets_without_twin(scene);
  merge_vertices(scene);
  for (Facet& facet : scene.facets) facet.corners = scene.corners(facet.tile, facet.leaf);
  return scene;
}

}  // namespace quoin::overlay
