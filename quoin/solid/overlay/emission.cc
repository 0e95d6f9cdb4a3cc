// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/overlay/emission.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <optional>
#include <utility>

#include "quoin/base/parallel.h"

namespace quoin::overlay {

namespace {

constexpr std::size_t grain = 8192;

// How much of each array a part of the sheets makes; then where it begins.
struct Place {
  std::uint32_t faces = 0;
  std::uint32_t loops = 0;
  std::uint32_t vertices = 0;
  std::uint32_t origins = 0;
  std::uint32_t composed = 0;
};

bool is_tile_face(const FaceParts& parts, std::uint32_t sheet) {
  return parts.is_in_composed[sheet] == 0 && parts.kept->is_kept(sheet);
}

// Calls tile(sheet, leaf) and composed(index) in the order of faces.
template <class VisitTile, class VisitComposed>
void for_each_face(const FaceParts& parts, const Chunk& chunk, const VisitTile& tile, const VisitComposed& composed) {
  const std::vector<std::uint32_t>& first_tile = parts.sheets->scene->first_tile;
  const std::vector<std::uint32_t>& roots = parts.composed_sheets;
  auto root = std::lower_bound(roots.begin(), roots.end(), static_cast<std::uint32_t>(chunk.begin));
  std::uint32_t leaf = 0;
  for (auto s = static_cast<std::uint32_t>(chunk.begin); s < chunk.end; ++s) {
    if (is_tile_face(parts, s)) {
      while (s >= first_tile[leaf + 1]) ++leaf;
      tile(s, leaf);
    } else if (root != roots.end() && *root == s) {
      composed(static_cast<std::uint32_t>(root++ - roots.begin()));
    }
  }
}

class Emitter {
 public:
  Emitter(const FaceParts& parts, std::vector<std::uint8_t> used, const Context& context)
      : parts_(parts),
        scene_(*parts.sheets->scene),
        sheet_count_(parts.sheets->count()),
        context_(context),
        used_(std::move(used)) {
    for (const auto& leaf : scene_.leaves) has_colors_ = has_colors_ || !leaf->face_colors.empty();
  }

  Brep run() {
    count();
    run_both(
        context_, [&] { number_points(); }, [&] { resize(); });
    for_each_chunk(context_, sheet_count_, grain, [&](const Chunk& chunk) { fill(chunk); });
    for (const auto& leaf : scene_.leaves) brep_.leaf_names.push_back(leaf->name);
    return std::move(brep_);
  }

 private:
  Place composed_size(std::uint32_t index) const {
    const Brep& c = parts_.composed;
    const std::uint32_t first = c.face_first_loop[index];
    const std::uint32_t end = c.face_first_loop[index + 1];
    return {1, end - first, c.loop_begin[end] - c.loop_begin[first],
            c.face_first_origin[index + 1] - c.face_first_origin[index], 1};
  }

  void count() {
    places_.resize(chunk_count(sheet_count_, grain) + 1);
    for_each_chunk(context_, sheet_count_, grain, [&](const Chunk& chunk) {
      Place& place = places_[chunk.index];
      for_each_face(
          parts_, chunk, [&](std::uint32_t, std::uint32_t) { place.faces += 1; },
          [&](std::uint32_t index) {
            const Place size = composed_size(index);
            place.loops += size.loops;
            place.vertices += size.vertices;
            place.origins += size.origins;
            place.composed += 1;
          });
      place.loops += place.faces;
      place.vertices += 3 * place.faces;
      place.origins += place.faces;
      place.faces += place.composed;
    });
    add_up();
  }

  void add_up() {
    Place sum;
    for (Place& place : places_) {
      const Place size = place;
      place = sum;
      sum.faces += size.faces;
      sum.loops += size.loops;
      sum.vertices += size.vertices;
      sum.origins += size.origins;
      sum.composed += size.composed;
    }
  }

  // Keeps the points that loops or planes name, in their order, explicit ones first.
  void number_points() {
    for (const PointId p : parts_.composed.loop_vertices) used_[p.value] = 1;
    for (const auto& plane : parts_.composed.face_planes) {
      for (const PointId p : plane) used_[p.value] = 1;
    }
    number_.resize(used_.size());
    std::vector<PointId> kept;
    kept.reserve(static_cast<std::size_t>(std::count(used_.begin(), used_.end(), 1)));
    for (std::uint32_t p = 0; p < used_.size(); ++p) {
      if (used_[p] == 0) continue;
      number_[p] = static_cast<std::uint32_t>(kept.size());
      kept.push_back(PointId{p});
    }
    used_ = {};
    brep_.points = scene_.table.subset(kept);
  }

  void resize() {
    const Place& all = places_.back();
    const auto of_faces = [&] {
      brep_.face_planes.resize(all.faces);
      brep_.face_shells.resize(all.faces);
      brep_.face_first_loop.resize(std::size_t{all.faces} + 1);
      if (has_colors_) brep_.face_colors.resize(all.faces);
    };
    const auto of_parts = [&] {
      brep_.face_first_origin.resize(std::size_t{all.faces} + 1);
      brep_.loop_begin.resize(std::size_t{all.loops} + 1);
      brep_.loop_vertices.resize(all.vertices);
      brep_.origins.resize(all.origins);
    };
    run_both(context_, of_faces, of_parts);  // touching fresh memory takes longer than writing to it
    brep_.shells.assign(parts_.shell_count, Shell{false});
  }

  void fill(const Chunk& chunk) {
    Place at = places_[chunk.index];
    for_each_face(
        parts_, chunk, [&](std::uint32_t s, std::uint32_t leaf) { fill_tile(s, leaf, at); },
        [&](std::uint32_t index) { fill_composed(index, at); });
  }

  PointId renamed(PointId p) const { return PointId{number_[p.value]}; }

  void fill_tile(std::uint32_t tile, std::uint32_t leaf, Place& at) {
    std::array<PointId, 3> corners = scene_.corners(tile, leaf);
    for (PointId& p : corners) p = renamed(p);
    if (parts_.kept->is_reversed(tile)) std::swap(corners[1], corners[2]);
    brep_.face_planes[at.faces] = corners;
    std::copy(corners.begin(), corners.end(), brep_.loop_vertices.begin() + at.vertices);
    brep_.origins[at.origins] = {leaf, scene_.leaves[leaf]->tile_face[tile - scene_.first_tile[leaf]]};
    at.vertices += 3;
    at.origins += 1;
    at.loops += 1;
    brep_.loop_begin[at.loops] = at.vertices;
    end_face(tile, brep_.origins[at.origins - 1], at);
  }

  void fill_composed(std::uint32_t index, Place& at) {
    const Brep& c = parts_.composed;
    for (std::size_t k = 0; k < 3; ++k) brep_.face_planes[at.faces][k] = renamed(c.face_planes[index][k]);
    for (std::uint32_t l = c.face_first_loop[index]; l < c.face_first_loop[index + 1]; ++l) {
      for (const PointId p : c.loop(l)) brep_.loop_vertices[at.vertices++] = renamed(p);
      brep_.loop_begin[++at.loops] = at.vertices;
    }
    const auto first = c.origins.begin() + c.face_first_origin[index];
    const auto end = c.origins.begin() + c.face_first_origin[index + 1];
    std::copy(first, end, brep_.origins.begin() + at.origins);
    at.origins += static_cast<std::uint32_t>(end - first);
    if (has_colors_) brep_.face_colors[at.faces] = c.face_colors[index];
    end_face(parts_.composed_sheets[index], std::nullopt, at);
  }

  void end_face(std::uint32_t sheet, const std::optional<Origin>& seen, Place& at) {
    brep_.face_shells[at.faces] = parts_.shell_of_patch[parts_.complex->patch_of[sheet]];
    if (has_colors_ && seen) brep_.face_colors[at.faces] = color(*seen);
    at.faces += 1;
    brep_.face_first_loop[at.faces] = at.loops;
    brep_.face_first_origin[at.faces] = at.origins;
  }

  Color color(const Origin& from) const { return scene_.color(from.leaf, from.face); }

  const FaceParts& parts_;
  const Scene& scene_;
  std::size_t sheet_count_;
  const Context& context_;
  std::vector<std::uint8_t> used_;  // per point of the table
  bool has_colors_ = false;
  std::vector<Place> places_;          // per chunk of sheets, and the end
  std::vector<std::uint32_t> number_;  // per point of the table: in the result
  Brep brep_;
};

}  // namespace

std::vector<std::uint8_t> corners_of_tile_faces(const FaceParts& parts, const Context& context) {
  const Scene& scene = *parts.sheets->scene;
  std::vector<std::uint8_t> result(scene.table.point_count(), 0);
  for_each_chunk(context, parts.sheets->count(), grain, [&](const Chunk& chunk) {
    for_each_face(
        parts, chunk,
        [&](std::uint32_t s, std::uint32_t leaf) {
          // Several chunks may mark one point.
          for (const PointId p : scene.corners(s, leaf)) {
            std::atomic_ref(result[p.value]).store(1, std::memory_order_relaxed);
          }
        },
        [](std::uint32_t) {});
  });
  return result;
}

Brep emit_boundary(const FaceParts& parts, std::vector<std::uint8_t> used, const Context& context) {
  return Emitter(parts, std::move(used), context).run();
}

}  // namespace quoin::overlay
