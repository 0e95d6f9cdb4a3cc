// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/leaf_crossings.h"

#include <algorithm>

#include "quoin/base/disjoint_sets.h"
#include "quoin/base/parallel.h"
#include "quoin/solid/leaf_tiles.h"
#include "quoin/solid/overlay/contacts.h"
#include "quoin/solid/overlay/winding.h"
#include "quoin/solid/star_certificate.h"

namespace quoin {

namespace {

// Whether tiles meet outside what they share, by the orientations that also place contacts in the overlay.
class SelfCrossings {
 public:
  SelfCrossings(const Leaf& leaf, const Constructions& points, const Context& context)
      : leaf_(leaf), points_(points), certified_(certify_stars(leaf, context)) {}

  // Tiles that share a certified vertex meet in nothing else.
  std::vector<Tile> certified_corners() const {
    std::vector<Tile> result = leaf_.tiles;
    for (Tile& tile : result) {
      for (std::uint32_t& v : tile) v = certified_[v] != 0 ? v : BoxTree::no_label;
    }
    return result;
  }

  bool meet(const TilePair& pair) const {
    const Tile& s = leaf_.tiles[pair.a];
    const Tile& t = leaf_.tiles[pair.b];
    std::size_t shared = 0;
    std::array<bool, 3> is_shared{};
    for (std::size_t j = 0; j < 3; ++j) {
      if (t[j] != s[0] && t[j] != s[1] && t[j] != s[2]) continue;
      is_shared[j] = true;
      ++shared;
    }
    if (have_equal_corners(s, t)) return true;  // one spot, two vertices
    if (shared == 3) return true;
    Sign first = Sign::zero;
    bool one_side = true;
    bool in_plane = false;
    for (std::size_t j = 0; j < 3; ++j) {
      if (is_shared[j]) continue;
      const Sign side = points_.orientation(PointId{s[0]}, PointId{s[1]}, PointId{s[2]}, PointId{t[j]});
      if (side == Sign::zero) in_plane = true;
      if (first == Sign::zero) first = side;
      if (side != first) one_side = false;
    }
    if (one_side && !in_plane) return false;
    return meet_generally(s, t);
  }

 private:
  bool have_equal_corners(const Tile& s, const Tile& t) const {
    for (const std::uint32_t p : s) {
      for (const std::uint32_t q : t) {
        if (p != q && leaf_.vertices[p] == leaf_.vertices[q]) return true;
      }
    }
    return false;
  }

  bool meet_generally(const Tile& s, const Tile& t) const {
    const std::array<PointId, 3> a{PointId{s[0]}, PointId{s[1]}, PointId{s[2]}};
    const std::array<PointId, 3> b{PointId{t[0]}, PointId{t[1]}, PointId{t[2]}};
    return overlay::have_contacts(points_, a, b);
  }

  const Leaf& leaf_;
  const Constructions& points_;
  std::vector<std::uint8_t> certified_;  // per vertex
};

}  // namespace

void find_self_crossings(Leaf& leaf, const Constructions& points, std::size_t max_listed, MeshDiagnosis& diagnosis,
                         const Context& context) {
  context.progress("self-crossings", 0);
  const SelfCrossings crossings(leaf, points, context);
  const std::vector<TilePair> pairs = leaf.tree.self_pairs(crossings.certified_corners(), context);
  constexpr std::size_t grain = 4096;
  std::vector<std::vector<FacePair>> found(chunk_count(pairs.size(), grain));
  for_each_chunk(context, pairs.size(), grain, [&](const Chunk& chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      if (!crossings.meet(pairs[i])) continue;
      const auto [a, b] = std::minmax(leaf.tile_face[pairs[i].a], leaf.tile_face[pairs[i].b]);
      found[chunk.index].push_back({a, b});
    }
  });
  std::vector<FacePair> all;
  for (const auto& part : found) all.insert(all.end(), part.begin(), part.end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  leaf.crosses_itself = !all.empty();
  for (const FacePair& pair : all) note(diagnosis.crossing_faces, pair, max_listed);
}

void find_inverted_components(const std::shared_ptr<const Leaf>& leaf, std::size_t max_listed, MeshDiagnosis& diagnosis,
                              const Context& context) {
  DisjointSets components(leaf->tiles.size());
  for (std::uint32_t h = 0; h < leaf->twins.size(); ++h) {
    if (leaf->twins[h] != Leaf::no_twin && leaf->twins[h] > h) components.unite(h / 3, leaf->twins[h] / 3);
  }
  const std::shared_ptr<const Leaf> leaves[] = {leaf};
  const overlay::Scene scene = overlay::make_unpaired_scene(leaves);
  const overlay::Subdivision nothing_cut;
  const overlay::Sheets sheets{&scene, nullptr, &nothing_cut};
  for (std::uint32_t t = 0; t < leaf->tiles.size(); ++t) {
    if (components.find(t) != t) continue;
    context.poll();
    const overlay::SheetWinding winding = overlay::winding_at(sheets, t);
    const int number = winding.windings.empty() ? 0 : winding.windings[0].number;
    if (number != (winding.in_front ? 0 : 1)) note(diagnosis.inverted_components, leaf->tile_face[t], max_listed);
  }
}

}  // namespace quoin
