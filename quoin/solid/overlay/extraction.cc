// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/overlay/extraction.h"

#include <algorithm>
#include <tuple>

#include "quoin/base/disjoint_sets.h"
#include "quoin/base/parallel.h"
#include "quoin/base/parallel_sort.h"
#include "quoin/kernel/projection.h"
#include "quoin/solid/overlay/emission.h"
#include "quoin/solid/overlay/face_loops.h"
#include "quoin/solid/overlay/kept_sheets.h"
#include "quoin/solid/overlay/shell_orientation.h"
#include "quoin/solid/overlay/touching_vertices.h"
#include "quoin/solid/overlay/vertex_dissolving.h"

namespace quoin::overlay {

namespace {

struct FaceEdge {
  std::uint32_t face;  // smallest sheet of the face
  DirectedEdge edge;
  friend auto operator<=>(const FaceEdge&, const FaceEdge&) = default;
};

// Merges kept sheets to maximal faces.
class FaceMerger {
 public:
  FaceMerger(const Sheets& sheets, const Fans& fans, const CellComplex& complex, const CellTruth& truth,
             const KeptSheets& kept, const Context& context)
      : sheets_(sheets),
        scene_(*sheets.scene),
        fans_(fans),
        complex_(complex),
        truth_(truth),
        kept_(kept),
        context_(context),
        faces_(sheets.count()),
        shells_(complex.patches.size()),
        in_face_(sheets.count(), 0),
        face_with_facet_(scene_.facets.size(), none) {
    for (const auto& leaf : scene_.leaves) has_colors_ = has_colors_ || !leaf->face_colors.empty();
  }

  FaceParts run() {
    join_flat_tiles();
    join_fans();
    gather_tile_edges();
    sort_parallel(context_, edges_);
    compose_faces();
    number_shells();
    parts_.sheets = &sheets_;
    parts_.complex = &complex_;
    parts_.kept = &kept_;
    parts_.is_in_composed = std::move(in_face_);
    return std::move(parts_);
  }

 private:
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
      parts_.composed.origins.push_back(origin(sheet));
      return;
    }
    const auto face = static_cast<std::uint32_t>(parts_.composed.face_planes.size());
    for (const std::uint32_t facet : sheets_.subdivision->covers_of(sheets_.region(sheet))) {
      if (face_with_facet_[facet] == face) continue;
      face_with_facet_[facet] = face;
      parts_.composed.origins.push_back(origin_of_facet(facet));
    }
  }

  Color color(const Origin& from) const { return scene_.color(from.leaf, from.face); }

  bool same_color(std::uint32_t a, std::uint32_t b) const {
    return !has_colors_ || color(origin(a)) == color(origin(b));
  }

  bool is_involved(std::uint32_t tile) const {
    const std::uint32_t facet = scene_.facet_of_tile[tile];
    return facet != none && sheets_.network->involved[facet];
  }

  void join_faces(std::uint32_t a, std::uint32_t b) {
    faces_.unite(a, b);
    in_face_[a] = in_face_[b] = 1;
  }

  // An edge between two kept tiles of one leaf of which none is involved; the others occur in fans.
  bool is_quiet(std::uint32_t tile, std::uint32_t neighbour) const {
    return !is_involved(tile) && !is_involved(neighbour) && kept_.is_kept(tile);
  }

  // Each leaf by itself, as all that is written here.
  void join_flat_tiles() {
    for_each_chunk(context_, scene_.leaves.size(), 1,
                   [&](const Chunk& chunk) { join_flat_tiles_of(static_cast<std::uint32_t>(chunk.index)); });
  }

  void join_flat_tiles_of(std::uint32_t leaf) {
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

  void join_fans() {
    std::vector<const Side*> kept;
    for (const Fan& fan : fans_.fans) {
      kept.clear();
      for (const Side& side : fans_.sides_of(fan)) {
        if (kept_.is_kept(side.sheet)) kept.push_back(&side);
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
    const bool a_reversed = kept_.is_reversed(a.sheet);
    const bool b_reversed = kept_.is_reversed(b.sheet);
    if ((a.forward != a_reversed) == (b.forward != b_reversed))
      return false;  // not one surface: cannot be, but costs nothing
    return same_color(a.sheet, b.sheet) && in_one_plane(sheets_, a.sheet, b.sheet) && faces_same_way(a, b);
  }

  // Of coplanar sheets on opposite sides of an edge, one traversed forward and one backward: normals agree unless the
  // surface folds back on itself, which would put them on the same side of the edge.
  static bool faces_same_way(const Side& a, const Side& b) { return a.rank != b.rank; }

  void add_edge(const Side& side) {
    const bool forward = side.forward != (kept_.is_reversed(side.sheet));
    in_face_[side.sheet] = 1;
    edges_.push_back({side.sheet, forward ? DirectedEdge{side.from, side.to} : DirectedEdge{side.to, side.from}});
  }

  // Boundary edges of tiles that are part of a larger face. All others are faces of their own.
  void gather_tile_edges() {
    std::vector<std::vector<FaceEdge>> parts(scene_.leaves.size());
    for_each_chunk(context_, scene_.leaves.size(), 1, [&](const Chunk& chunk) {
      const auto leaf = static_cast<std::uint32_t>(chunk.index);
      for (std::uint32_t tile = scene_.first_tile[leaf]; tile < scene_.first_tile[leaf + 1]; ++tile) {
        if (tile % 65536 == 0) context_.poll();
        if (in_face_[tile] != 0) gather_edges_of(tile, leaf, parts[leaf]);
      }
    });
    for (const auto& part : parts) edges_.insert(edges_.end(), part.begin(), part.end());
    for (FaceEdge& e : edges_) e.face = faces_.find(e.face);
  }

  void gather_edges_of(std::uint32_t tile, std::uint32_t leaf, std::vector<FaceEdge>& out) const {
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
      out.push_back({tile, kept_.is_reversed(tile) ? DirectedEdge{to, from} : DirectedEdge{from, to}});
    }
  }

  // Sheets of faces that consist of several, by the face.
  void group_members() {
    for (std::uint32_t s = 0; s < sheets_.count(); ++s) {
      if (in_face_[s] == 0 || !kept_.is_kept(s)) continue;
      const std::uint32_t face = faces_.find(s);
      if (face != s) {
        members_.push_back({face, s});
      } else {
        parts_.composed_sheets.push_back(s);
      }
    }
    sort_parallel(context_, members_);
  }

  void compose_faces() {
    group_members();
    auto edge = edges_.begin();
    auto member = members_.begin();
    std::vector<DirectedEdge> boundary;
    for (const std::uint32_t s : parts_.composed_sheets) {
      boundary.clear();
      for (; edge != edges_.end() && edge->face == s; ++edge) boundary.push_back(edge->edge);
      const std::array<PointId, 3> corners = sheets_.corners(s);
      add_plane(s, corners);
      add_origins(s);
      const auto first_member = member;
      for (; member != members_.end() && member->first == s; ++member) add_origins(member->second);
      sort_origins();
      add_loops(s, corners, boundary);
      add_inner_vertices(s, {first_member, member});
    }
  }

  void add_plane(std::uint32_t sheet, const std::array<PointId, 3>& corners) {
    Brep& composed = parts_.composed;
    composed.face_planes.push_back(kept_.is_reversed(sheet) ? std::array{corners[0], corners[2], corners[1]} : corners);
    if (has_colors_) composed.face_colors.push_back(color(origin(sheet)));
  }

  void sort_origins() {
    Brep& composed = parts_.composed;
    const auto first = composed.origins.begin() + composed.face_first_origin.back();
    std::sort(first, composed.origins.end());
    composed.origins.erase(std::unique(first, composed.origins.end()), composed.origins.end());
    composed.face_first_origin.push_back(static_cast<std::uint32_t>(composed.origins.size()));
  }

  void add_loops(std::uint32_t sheet, const std::array<PointId, 3>& corners, std::span<const DirectedEdge> boundary) {
    Brep& composed = parts_.composed;
    const unsigned axis = projection_axis(scene_.table, corners[0], corners[1], corners[2]);
    const Sign up = scene_.table.turn(corners[0], corners[1], corners[2], axis);
    const bool positive = (up == Sign::positive) != kept_.is_reversed(sheet);
    chain_loops(scene_.table, boundary, axis, positive, composed.loop_vertices, composed.loop_begin);
    composed.face_first_loop.push_back(static_cast<std::uint32_t>(composed.loop_begin.size() - 1));
  }

  // A face that is one tile has none.
  void add_inner_vertices(std::uint32_t sheet, std::span<const std::pair<std::uint32_t, std::uint32_t>> members) {
    if (members.empty() && !sheets_.is_region(sheet)) return;
    const Brep& composed = parts_.composed;
    const auto face = static_cast<std::uint32_t>(composed.face_count() - 1);
    if (face_with_point_.empty()) face_with_point_.assign(scene_.table.point_count(), none);
    for (std::uint32_t i = composed.loop_begin[composed.face_first_loop[face]]; i < composed.loop_vertices.size(); ++i)
      face_with_point_[composed.loop_vertices[i].value] = face;
    const auto add = [&](PointId p) {
      if (face_with_point_[p.value] == face) return;
      face_with_point_[p.value] = face;
      parts_.inner_vertices.push_back({face, p});
    };
    for_each_vertex(sheets_, sheet, add);
    for (const auto& [root, member] : members) for_each_vertex(sheets_, member, add);
  }

  // In the order of their first sheets, which is that of patches.
  void number_shells() {
    std::vector<std::uint32_t> number(shells_.size(), none);
    parts_.shell_of_patch.assign(shells_.size(), none);
    for (std::uint32_t p = 0; p < shells_.size(); ++p) {
      if (!kept_.is_kept_patch(p)) continue;
      std::uint32_t& shell = number[shells_.find(p)];
      if (shell == none) shell = parts_.shell_count++;
      parts_.shell_of_patch[p] = shell;
    }
  }

  const Sheets& sheets_;
  const Scene& scene_;
  const Fans& fans_;
  const CellComplex& complex_;
  const CellTruth& truth_;
  const KeptSheets& kept_;
  const Context& context_;
  DisjointSets faces_;                          // of sheets
  DisjointSets shells_;                         // of patches
  std::vector<std::uint8_t> in_face_;           // per sheet: its face is chained from edges
  std::vector<std::uint32_t> face_with_facet_;  // per facet: the last composed face that it is an origin of
  std::vector<std::uint32_t> face_with_point_;  // per point: the last composed face that was found to have it
  std::vector<FaceEdge> edges_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> members_;  // face, sheet
  bool has_colors_ = false;
  FaceParts parts_{};
};

}  // namespace

Brep extract_boundary(const Sheets& sheets, const Fans& fans, const CellComplex& complex, const CellTruth& truth,
                      const Context& context) {
  context.progress("boundary", 0);
  const KeptSheets kept(complex, truth);
  FaceParts parts = FaceMerger(sheets, fans, complex, truth, kept, context).run();
  std::vector<std::uint8_t> corners = corners_of_tile_faces(parts, context);
  dissolve_vertices(sheets.scene->table, corners, parts.composed);
  add_touching_vertices(parts, corners);
  Brep result = emit_boundary(parts, std::move(corners), context);
  result.is_unbounded = truth.is_unbounded;
  orient_shells(result, context);
  return result;
}

}  // namespace quoin::overlay
