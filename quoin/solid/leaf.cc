// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/leaf.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "quoin/base/parallel.h"
#include "quoin/solid/brep.h"
#include "quoin/solid/leaf_crossings.h"
#include "quoin/solid/leaf_faces.h"
#include "quoin/solid/leaf_orientation.h"
#include "quoin/solid/leaf_tiles.h"
#include "quoin/solid/leaf_twins.h"
#include "quoin/solid/tile_edges.h"

namespace quoin {

namespace {

bool note_not_finite(std::span<const Point3> vertices, std::size_t max_listed, MeshDiagnosis& diagnosis) {
  for (std::uint32_t v = 0; v < vertices.size(); ++v) {
    const Point3& p = vertices[v];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) note(diagnosis.not_finite, v, max_listed);
  }
  return diagnosis.not_finite.count != 0;
}

// -0.0 becomes +0.0, so that equal points have equal bits.
std::vector<Point3> plain_zeros(const std::vector<Point3>& points) {
  std::vector<Point3> result(points.size());
  std::transform(points.begin(), points.end(), result.begin(), [](const Point3& p) {
    return Point3{p.x + 0.0, p.y + 0.0, p.z + 0.0};
  });
  return result;
}

void note_isolated_vertices(const Mesh& mesh, std::size_t max_listed, MeshDiagnosis& diagnosis) {
  std::vector<std::uint8_t> is_named(mesh.vertices.size(), 0);
  for (const std::uint32_t v : mesh.corners) is_named[v] = 1;
  for (std::uint32_t v = 0; v < is_named.size(); ++v) {
    if (is_named[v] == 0) note(diagnosis.isolated_vertices, v, max_listed);
  }
}

// Duplicates leave edges that are used too often; without such edges there is none.
void note_duplicates(const Leaf& leaf, std::size_t max_listed, MeshDiagnosis& diagnosis) {
  if (diagnosis.is_closed() && diagnosis.nonmanifold_edges.count == 0) return;
  std::vector<FacePair> pairs;  // one per pair of tiles
  std::vector<std::pair<Tile, std::uint32_t>> turned;
  for (std::uint32_t t = 0; t < leaf.tiles.size(); ++t) {
    Tile tile = leaf.tiles[t];
    std::rotate(tile.begin(), std::min_element(tile.begin(), tile.end()), tile.end());
    turned.push_back({tile, leaf.tile_face[t]});
  }
  std::sort(turned.begin(), turned.end());
  for (std::size_t i = 1; i < turned.size(); ++i) {
    if (turned[i].first == turned[i - 1].first) {
      pairs.push_back({turned[i - 1].second, turned[i].second});
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  for (const FacePair& pair : pairs) note(diagnosis.duplicate_faces, pair, max_listed);
}

// The apex of the tile on the other side of the halfedge.
std::uint32_t opposite_vertex(const Leaf& leaf, std::uint32_t halfedge) {
  const std::uint32_t twin = leaf.twins[halfedge];
  return leaf.tiles[twin / 3][(twin % 3 + 2) % 3];
}

// Coplanar neighbours that do not fold back on each other.
bool is_flat(const Leaf& leaf, const Constructions& points, std::uint32_t halfedge) {
  const Tile& s = leaf.tiles[halfedge / 3];
  const PointId apex{opposite_vertex(leaf, halfedge)};
  if (points.orientation(PointId{s[0]}, PointId{s[1]}, PointId{s[2]}, apex) != Sign::zero) return false;
  const PointId from{s[halfedge % 3]};
  const PointId to{s[(halfedge % 3 + 1) % 3]};
  const PointId own{s[(halfedge % 3 + 2) % 3]};
  for (unsigned axis = 0; axis < 3; ++axis) {
    const Sign turn = points.turn(from, to, own, axis);
    if (turn != Sign::zero) return points.turn(from, to, apex, axis) == -turn;
  }
  return false;
}

// Of most edges a product in doubles tells that they are not flat.
void mark_flat_edges(Leaf& leaf, const Constructions& points, const Context& context) {
  constexpr std::size_t grain = 16384;
  leaf.flat.assign(leaf.twins.size(), 0);
  const bool are_doubles = leaf.exact_vertices.empty();
  for_each_chunk(context, leaf.tiles.size(), grain, [&](const Chunk& chunk) {
    for (auto t = static_cast<std::uint32_t>(chunk.begin); t < chunk.end; ++t) {
      const TileEdges edges(leaf.vertices, leaf.tiles[t]);
      const Point3& base = leaf.vertices[leaf.tiles[t][0]];
      for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
        const std::uint32_t twin = leaf.twins[h];
        if (twin == Leaf::no_twin || h > twin) continue;
        const Vector3 d = TileEdges::difference(leaf.vertices[opposite_vertex(leaf, h)], base);
        const double height = TileEdges::dot(edges.normal, d);
        if (are_doubles && edges.is_certain_along(height, TileEdges::largest(d))) continue;
        if (is_flat(leaf, points, h)) leaf.flat[h] = leaf.flat[twin] = 1;
      }
    }
  });
}

// All but tiles and vertices.
LeafResult finish(const std::shared_ptr<Leaf>& leaf, Constructions points, LeafResult result,
                  const LeafOptions& options, const Context& context) {
  match_twins(*leaf, options.max_listed, result.diagnosis, context);
  if (result.diagnosis.misoriented_edges.count != 0)
    find_one_sided_bands(*leaf, options.max_listed, result.diagnosis, context);
  note_duplicates(*leaf, options.max_listed, result.diagnosis);
  mark_flat_edges(*leaf, points, context);
  leaf->tree = BoxTree(leaf->vertices, leaf->tiles, context);
  leaf->crosses_itself = true;
  if (options.find_crossings) find_self_crossings(*leaf, points, options.max_listed, result.diagnosis, context);
  if (!result.diagnosis.is_closed()) return result;
  if (!leaf->crosses_itself) {
    find_inverted_components(leaf, std::move(points), options.max_listed, result.diagnosis, context);
  }
  result.leaf = leaf;
  return result;
}

}  // namespace

LeafResult make_leaf(const Mesh& mesh, const LeafOptions& options, const Context& context) {
  return make_leaf(mesh, {}, options, context);
}

LeafResult make_leaf(const Mesh& mesh, std::vector<RationalPoint3> exact_vertices, const LeafOptions& options,
                     const Context& context) {
  LeafResult result;
  if (note_not_finite(mesh.vertices, options.max_listed, result.diagnosis)) return result;
  auto leaf = std::make_shared<Leaf>();
  leaf->vertices = plain_zeros(mesh.vertices);
  leaf->exact_vertices = std::move(exact_vertices);
  leaf->name = mesh.name;
  leaf->face_colors = mesh.face_colors;
  Constructions points =
      leaf->exact_vertices.empty() ? Constructions(leaf->vertices) : Constructions(leaf->exact_vertices);
  context.progress("faces", 0);
  MeshTiles tiles = make_tiles(mesh, points, options.max_listed, result.diagnosis, context);
  note_isolated_vertices(mesh, options.max_listed, result.diagnosis);
  leaf->tiles = std::move(tiles.tiles);
  leaf->tile_face = std::move(tiles.tile_face);
  return finish(leaf, std::move(points), std::move(result), options, context);
}

LeafResult make_leaf(const Brep& boundary, const std::string& name, const LeafOptions& options,
                     const Context& context) {
  LeafResult result;
  auto leaf = std::make_shared<Leaf>();
  leaf->exact_vertices = exact_points(boundary.points, context);
  Constructions points(leaf->exact_vertices);
  for (std::size_t v = 0; v < points.point_count(); ++v) leaf->vertices.push_back(points.rounded(PointId{v}));
  if (note_not_finite(leaf->vertices, options.max_listed, result.diagnosis)) return result;
  leaf->name = name;
  leaf->face_colors = boundary.face_colors;
  context.progress("faces", 0);
  MeshTiles tiles = make_tiles(boundary, points, options.max_listed, result.diagnosis, context);
  if (result.diagnosis.not_planar_faces.count + result.diagnosis.not_simple_faces.count != 0) return result;
  leaf->tiles = std::move(tiles.tiles);
  leaf->tile_face = std::move(tiles.tile_face);
  return finish(leaf, std::move(points), std::move(result), options, context);
}

}  // namespace quoin
