// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/overlay/extraction.h"

#include <algorithm>
#include <tuple>

#include "quoin/base/disjoint_sets.h"
#include "quoin/kernel/projection.h"
#include "quoin/solid/overlay/face_loops.h"
#include "quoin/solid/overlay/shell_orientation.h"
#include "quoin/solid/overlay/vertex_dissolving.h"

namespace quoin::overlay {

namespace {

// What becomes of a patch.
enum class Fate : std::uint8_t { dropped, kept, reversed };

struct FaceEdge {
  std::uint32_t face;  // smallest sheet of the face
  DirectedEdge edge;
  friend auto operator<=>(const FaceEdge&, const FaceEdge&) = default;
};

class Extractor {
 public:
  Extractor(const Sheets& sheets, const Fans& fans, const CellComplex& complex, const CellTruth& truth,
            const Context& context)
      : sheets_(sheets),
        scene_(*sheets.scene),
        fans_(fans),
        complex_(complex),
        truth_(truth),
        context_(context),
        faces_(sheets.count()),
        shells_(complex.patches.size()),
        in_face_(sheets.count(), false) {}

  Brep run() {
    decide_patches();
    join_flat_tiles();
    join_fans();
    gather_tile_edges();
    std::sort(edges_.begin(), edges_.end());
    context_.poll();
    emit_faces();
    brep_.is_unbounded = truth_.is_unbounded;
    for (const auto& leaf : scene_.leaves) brep_.leaf_names.push_back(leaf->name);
    dissolve_vertices(scene_.table, brep_);
    compact_points();
    orient_shells(brep_);
    return std::move(brep_);
  }

 private:
  void decide_patches() {
    for (const Patch& patch : complex_.patches) {
      const bool front = truth_.inside[patch.front] != 0;
      const bool back = truth_.inside[patch.back] != 0;
      fates_.push_back(front == back ? Fate::dropped : back ? Fate::kept : Fate::reversed);
    }
    for (const auto& leaf : scene_.leaves) has_colors_ = has_colors_ || !leaf->face_colors.empty();
  }

  Fate fate(std::uint32_t sheet) const {
    const std::uint32_t patch = complex_.patch_of[sheet];
    return patch == none ? Fate::dropped : fates_[patch];
  }

  Origin origin_of_tile(std::uint32_t tile, std::uint32_t leaf) const {
    return {leaf, scene_.leaves[leaf]->tile_face[tile - scene_.first_tile[leaf]]};
  }

  Origin origin_of_facet(std::uint32_t facet) const {
    return origin_of_tile(scene_.facets[facet].tile, scene_.facets[facet].leaf);
  }

  // Of a region, that of the first facet that covers it: its colour is seen.
  Origin origin(std::uint32_t sheet) const {
    if (!sheets_.is_region(sheet)) return origin_of_tile(sheet, sheets_.leaf(sheet));
    return origin_of_facet(sheets_.subdivision->covers_of(sheets_.region(sheet))[0]);
  }

  void add_origins(std::uint32_t sheet) {
    if (!sheets_.is_region(sheet)) {
      brep_.origins.push_back(origin(sheet));
      return;
    }
    for (const std::uint32_t facet : sheets_.subdivision->covers_of(sheets_.region(sheet))) {
      brep_.origins.push_back(origin_of_facet(facet));
    }
  }

  Color color(const Origin& from) const {
    const auto& colors = scene_.leaves[from.leaf]->face_colors;
    return colors.empty() ? Color{200, 200, 200, 255} : colors[from.face];
  }

  bool same_color(std::uint32_t a, std::uint32_t b) const {
    return !has_colors_ || color(origin(a)) == color(origin(b));
  }

  bool is_involved(std::uint32_t tile) const {
    const std::uint32_t facet = scene_.facet_of_tile[tile];
    return facet != none && sheets_.network->involved[facet];
  }

  void join_faces(std::uint32_t a, std::uint32_t b) {
    faces_.unite(a, b);
    in_face_[a] = in_face_[b] = true;
  }

  // An edge between two kept tiles of one leaf of which none is involved; the others occur in fans.
  bool is_quiet(std::uint32_t tile, std::uint32_t neighbour) const {
    return !is_involved(tile) && !is_involved(neighbour) && fate(tile) != Fate::dropped;
  }

  void join_flat_tiles() {
    for (std::uint32_t leaf = 0; leaf < scene_.leaves.size(); ++leaf) {
      const Leaf& l = *scene_.leaves[leaf];
      const std::uint32_t first = scene_.first_tile[leaf];
      for (std::uint32_t h = 0; h < l.twins.size(); ++h) {
        if (h % 65536 == 0) context_.poll();
        if (l.flat[h] == 0 || l.twins[h] < h) continue;
        const std::uint32_t a = first + h / 3;
        const std::uint32_t b = first + l.twins[h] / 3;
        if (is_quiet(a, b) && same_color(a, b)) join_faces(a, b);
      }
    }
  }

  void join_fans() {
    std::vector<const Side*> kept;
    for (const Fan& fan : fans_.fans) {
      kept.clear();
      for (const Side& side : fans_.sides_of(fan)) {
        if (fate(side.sheet) != Fate::dropped) kept.push_back(&side);
      }
      if (kept.empty()) continue;
      join_shells(kept);
      if (kept.size() == 2 && is_flat(*kept[0], *kept[1])) {
        join_faces(kept[0]->sheet, kept[1]->sheet);
        continue;
      }
      for (const Side* side : kept) add_edge(*side);
    }
  }

  // Neighbours in the fan that enclose material belong to one shell.
  void join_shells(const std::vector<const Side*>& kept) {
    for (std::size_t i = 0; i < kept.size(); ++i) {
      const Side& here = *kept[i];
      const Side& after = *kept[i + 1 == kept.size() ? 0 : i + 1];
      const Patch& patch = complex_.patches[complex_.patch_of[here.sheet]];
      const std::uint32_t between = here.forward ? patch.front : patch.back;
      if (truth_.inside[between] != 0) shells_.unite(complex_.patch_of[here.sheet], complex_.patch_of[after.sheet]);
    }
  }

  bool is_flat(const Side& a, const Side& b) const {
    const bool a_reversed = fate(a.sheet) == Fate::reversed;
    const bool b_reversed = fate(b.sheet) == Fate::reversed;
    if ((a.forward != a_reversed) == (b.forward != b_reversed))
      return false;  // not one surface: cannot be, but costs nothing
    return same_color(a.sheet, b.sheet) && in_one_plane(sheets_, a.sheet, b.sheet) && faces_same_way(a, b);
  }

  // Of coplanar sheets on opposite sides of an edge, one traversed forward and one backward: normals agree unless the
  // surface folds back on itself, which would put them on the same side of the edge.
  static bool faces_same_way(const Side& a, const Side& b) { return a.rank != b.rank; }

  void add_edge(const Side& side) {
    const bool forward = side.forward != (fate(side.sheet) == Fate::reversed);
    in_face_[side.sheet] = true;
    edges_.push_back({side.sheet, forward ? DirectedEdge{side.from, side.to} : DirectedEdge{side.to, side.from}});
  }

  // Boundary edges of tiles that are part of a larger face. All others are faces of their own.
  void gather_tile_edges() {
    for (std::uint32_t leaf = 0; leaf < scene_.leaves.size(); ++leaf) {
      const std::uint32_t first = scene_.first_tile[leaf];
      for (std::uint32_t tile = first; tile < scene_.first_tile[leaf + 1]; ++tile) {
        if (tile % 65536 == 0) context_.poll();
        if (in_face_[tile]) gather_edges_of(tile, leaf);
      }
    }
    for (FaceEdge& e : edges_) e.face = faces_.find(e.face);
  }

  void gather_edges_of(std::uint32_t tile, std::uint32_t leaf) {
    const Leaf& l = *scene_.leaves[leaf];
    const std::uint32_t first = scene_.first_tile[leaf];
    const std::array<PointId, 3> corners = scene_.corners(tile, leaf);
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t h = 3 * (tile - first) + k;
      if (l.twins[h] == Leaf::no_twin) continue;
      const std::uint32_t other = first + l.twins[h] / 3;
      if (!is_quiet(tile, other) || (l.flat[h] != 0 && same_color(tile, other))) continue;
      const PointId from = corners[k];
      const PointId to = corners[(k + 1) % 3];
      edges_.push_back({tile, fate(tile) == Fate::reversed ? DirectedEdge{to, from} : DirectedEdge{from, to}});
    }
  }

  void emit_faces() {
    group_members();
    reserve_faces();
    auto edge = edges_.begin();
    std::vector<DirectedEdge> boundary;
    for (std::uint32_t s = 0; s < sheets_.count(); ++s) {
      if (s % 65536 == 0) context_.poll();
      if (fate(s) == Fate::dropped) continue;
      if (!in_face_[s]) {
        emit_tile(s);
      } else if (faces_.find(s) == s) {
        boundary.clear();
        for (; edge != edges_.end() && edge->face == s; ++edge) boundary.push_back(edge->edge);
        emit_face(s, boundary);
      }
    }
  }

  void reserve_faces() {
    std::size_t faces = 0;
    std::size_t origins = 0;
    for (std::uint32_t s = 0; s < sheets_.count(); ++s) {
      if (fate(s) == Fate::dropped) continue;
      ++origins;
      if (!in_face_[s] || faces_.find(s) == s) ++faces;
    }
    brep_.face_planes.reserve(faces);
    brep_.face_shells.reserve(faces);
    brep_.face_first_loop.reserve(faces + 1);
    brep_.face_first_origin.reserve(faces + 1);
    brep_.loop_begin.reserve(faces + 1);
    brep_.loop_vertices.reserve(3 * faces + edges_.size());
    brep_.origins.reserve(origins);
    if (has_colors_) brep_.face_colors.reserve(faces);
  }

  // Sheets of faces that consist of several, by the face.
  void group_members() {
    for (std::uint32_t s = 0; s < sheets_.count(); ++s) {
      if (in_face_[s] && fate(s) != Fate::dropped && faces_.find(s) != s) members_.push_back({faces_.find(s), s});
    }
    std::sort(members_.begin(), members_.end());
  }

  void begin_face(std::uint32_t sheet, const std::array<PointId, 3>& corners, const Origin& from) {
    const bool reversed = fate(sheet) == Fate::reversed;
    brep_.face_planes.push_back(reversed ? std::array{corners[0], corners[2], corners[1]} : corners);
    brep_.face_shells.push_back(shell_of(complex_.patch_of[sheet]));
    if (has_colors_) brep_.face_colors.push_back(color(from));
  }

  void end_face() {
    brep_.face_first_loop.push_back(static_cast<std::uint32_t>(brep_.loop_begin.size() - 1));
    brep_.face_first_origin.push_back(static_cast<std::uint32_t>(brep_.origins.size()));
  }

  void emit_tile(std::uint32_t tile) {
    while (tile >= scene_.first_tile[leaf_ + 1]) ++leaf_;  // tiles come in order
    const Origin from{leaf_, scene_.leaves[leaf_]->tile_face[tile - scene_.first_tile[leaf_]]};
    begin_face(tile, scene_.corners(tile, leaf_), from);
    brep_.origins.push_back(from);
    const std::array<PointId, 3>& loop = brep_.face_planes.back();
    brep_.loop_vertices.insert(brep_.loop_vertices.end(), loop.begin(), loop.end());
    brep_.loop_begin.push_back(static_cast<std::uint32_t>(brep_.loop_vertices.size()));
    end_face();
  }

  void emit_face(std::uint32_t sheet, std::span<const DirectedEdge> boundary) {
    const std::array<PointId, 3> corners = sheets_.corners(sheet);
    begin_face(sheet, corners, origin(sheet));
    add_origins(sheet);
    auto member = std::lower_bound(members_.begin(), members_.end(), std::pair(sheet, 0U));
    for (; member != members_.end() && member->first == sheet; ++member) add_origins(member->second);
    const auto first_origin = brep_.origins.begin() + brep_.face_first_origin.back();
    std::sort(first_origin, brep_.origins.end());
    brep_.origins.erase(std::unique(first_origin, brep_.origins.end()), brep_.origins.end());
    const unsigned axis = projection_axis(scene_.table, corners[0], corners[1], corners[2]);
    const Sign up = scene_.table.turn(corners[0], corners[1], corners[2], axis);
    const bool positive = (up == Sign::positive) != (fate(sheet) == Fate::reversed);
    chain_loops(scene_.table, boundary, axis, positive, brep_.loop_vertices, brep_.loop_begin);
    end_face();
  }

  std::uint32_t shell_of(std::uint32_t patch) {
    const std::uint32_t root = shells_.find(patch);
    if (shell_number_.empty()) shell_number_.assign(shells_.size(), none);
    if (shell_number_[root] == none) {
      shell_number_[root] = static_cast<std::uint32_t>(brep_.shells.size());
      brep_.shells.push_back({false});
    }
    return shell_number_[root];
  }

  // Keeps only the points that loops or planes name, explicit ones first.
  void compact_points() {
    const Constructions& table = scene_.table;
    std::vector<std::uint32_t> number(table.point_count(), none);
    for (const PointId p : brep_.loop_vertices) number[p.value] = 0;
    for (const auto& plane : brep_.face_planes) {
      for (const PointId p : plane) number[p.value] = 0;
    }
    std::vector<PointId> kept;
    for (std::uint32_t p = 0; p < number.size(); ++p) {
      if (number[p] == none) continue;
      number[p] = static_cast<std::uint32_t>(kept.size());
      kept.push_back(PointId{p});
    }
    brep_.points = table.subset(kept);
    for (PointId& p : brep_.loop_vertices) p = PointId{number[p.value]};
    for (auto& plane : brep_.face_planes) {
      for (PointId& p : plane) p = PointId{number[p.value]};
    }
  }

  const Sheets& sheets_;
  const Scene& scene_;
  const Fans& fans_;
  const CellComplex& complex_;
  const CellTruth& truth_;
  const Context& context_;
  DisjointSets faces_;         // of sheets
  DisjointSets shells_;        // of patches
  std::vector<bool> in_face_;  // per sheet: its face is chained from edges
  std::vector<Fate> fates_;    // per patch
  std::vector<FaceEdge> edges_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> members_;  // face, sheet
  std::vector<std::uint32_t> shell_number_;
  std::uint32_t leaf_ = 0;  // of the tile emitted last
  bool has_colors_ = false;
  Brep brep_;
};

}  // namespace

Brep extract_boundary(const Sheets& sheets, const Fans& fans, const CellComplex& complex, const CellTruth& truth,
                      const Context& context) {
  context.progress("boundary", 0);
  return Extractor(sheets, fans, complex, truth, context).run();
}

}  // namespace quoin::overlay
