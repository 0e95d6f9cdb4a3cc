// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/leaf_crossings.h"

#include <algorithm>
#include <utility>

#include "quoin/base/disjoint_sets.h"
#include "quoin/solid/leaf_tiles.h"
#include "quoin/solid/overlay/contacts.h"
#include "quoin/solid/overlay/winding.h"
#include "quoin/solid/patch_certificate.h"
#include "quoin/solid/star_certificate.h"

namespace quoin {

namespace {

// Whether tiles meet outside what they share, by the orientations that also place contacts in the overlay.
class SelfCrossings {
 public:
  SelfCrossings(const Leaf& leaf, const Constructions& points, const Context& context)
      : leaf_(leaf),
        points_(points),
        patches_(find_patches(leaf, points, context)),
        certified_(certify_stars(leaf, patches_.is_seam, context)) {}

  const std::vector<std::uint8_t>& patches() const { return patches_.is_patch; }

  // Tiles that share a certified vertex meet in nothing else.
  std::vector<Tile> certified_corners() const {
    std::vector<Tile> result = leaf_.tiles;
    for (Tile& tile : result) {
      for (std::uint32_t& v : tile) v = certified_[v] != 0 ? v : BoxTree::no_label;
    }
    return result;
  }

  bool meet(const TilePair& pair) const {
    const overlay::Corners a = corners(pair.a);
    const overlay::Corners b = corners(pair.b);
    if (overlay::have_equal_corners(points_, a, b)) return true;  // one spot, two vertices
    if (overlay::have_same_corners(a, b)) return true;
    return !overlay::are_separated(points_, a, b) && overlay::have_contacts(points_, a, b);
  }

 private:
  overlay::Corners corners(std::uint32_t tile) const {
    const Tile& t = leaf_.tiles[tile];
    return {PointId{t[0]}, PointId{t[1]}, PointId{t[2]}};
  }

  const Leaf& leaf_;
  const Constructions& points_;
  Patches patches_;
  std::vector<std::uint8_t> certified_;  // per vertex
};

}  // namespace

void find_self_crossings(Leaf& leaf, const Constructions& points, std::size_t max_listed, MeshDiagnosis& diagnosis,
                         const Context& context) {
  context.progress("self-crossings", 0);
  const SelfCrossings crossings(leaf, points, context);
  const std::vector<Tile> labels = crossings.certified_corners();
  const std::vector<TilePair> pairs = leaf.tree.self_pairs(
      {labels, crossings.patches()}, [&](const TilePair& pair) { return crossings.meet(pair); }, context);
  std::vector<FacePair> all;
  for (const TilePair& pair : pairs) {
    const auto [a, b] = std::minmax(leaf.tile_face[pair.a], leaf.tile_face[pair.b]);
    all.push_back({a, b});
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  leaf.crosses_itself = !all.empty();
  for (const FacePair& pair : all) note(diagnosis.crossing_faces, pair, max_listed);
}

void find_inverted_components(const std::shared_ptr<const Leaf>& leaf, Constructions points, std::size_t max_listed,
                              MeshDiagnosis& diagnosis, const Context& context) {
  DisjointSets components(leaf->tiles.size());
  for (std::uint32_t h = 0; h < leaf->twins.size(); ++h) {
    if (leaf->twins[h] != Leaf::no_twin && leaf->twins[h] > h) components.unite(h / 3, leaf->twins[h] / 3);
  }
  const overlay::Scene scene = overlay::make_unpaired_scene(leaf, std::move(points));
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
