// SPDX-License-Identifier: Apache-2.0
//
// About an edge with direction d, a sheet with normal n extends along h = s (n x d), s = +1 for a forward side and -1
// for a backward one. For two sheets, d . (h1 x h2) = |d|^2 s1 s2 d . (n1 x n2) and h1 . h2 = |d|^2 s1 s2 n1 . n2, so
// the order about the edge needs no constructed point.
#include "quoin/solid/overlay/fans.h"

#include <algorithm>
#include <tuple>

#include "quoin/base/error.h"
#include "quoin/base/parallel.h"

namespace quoin::overlay {

namespace {

class FanBuilder {
 public:
  FanBuilder(const Sheets& sheets, Scene& scene, const Context& context)
      : sheets_(sheets), scene_(scene), context_(context) {}

  Fans run() {
    gather_sides();
    context_.poll();
    sort_sides();
    context_.poll();
    group_sides();
    order_fans();
    return std::move(fans_);
  }

 private:
  void add_side(PointId tail, PointId head, std::uint32_t sheet) {
    const bool forward = tail < head;
    fans_.sides.push_back({forward ? tail : head, forward ? head : tail, sheet, forward});
  }

  void add_loop(std::span<const PointId> loop, std::uint32_t sheet) {
    if (loop.size() == 1) return;
    for (std::size_t i = 0; i < loop.size(); ++i) add_side(loop[i], loop[i + 1 == loop.size() ? 0 : i + 1], sheet);
  }

  void gather_sides() {
    const Subdivision& cut = *sheets_.subdivision;
    for (std::uint32_t r = 0; r < cut.region_count(); ++r) {
      const auto sheet = static_cast<std::uint32_t>(sheets_.tile_count() + r);
      for (std::uint32_t l = cut.region_first_loop[r]; l < cut.region_first_loop[r + 1]; ++l)
        add_loop(cut.loop(l), sheet);
    }
    for (std::uint32_t f = 0; f < scene_.facets.size(); ++f) {
      if (!sheets_.network->involved[f]) continue;
      const Facet& facet = scene_.facets[f];
      if (!sheets_.network->cut[f]) add_loop(facet.corners, facet.tile);
      add_uninvolved_neighbours(facet);
    }
  }

  void add_uninvolved_neighbours(const Facet& facet) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const Scene::Halfedge twin = scene_.twin(facet.tile, k, facet.leaf);
      if (twin.tile == none) continue;
      const std::uint32_t other = scene_.facet_of_tile[twin.tile];
      if (other != none && sheets_.network->involved[other]) continue;
      const std::array<PointId, 3> corners = scene_.corners(twin.tile, facet.leaf);
      add_side(corners[twin.edge], corners[(twin.edge + 1) % 3], twin.tile);
    }
  }

  // By edge, sheet and direction: counted into one bucket per smaller end, then each bucket by itself.
  void sort_sides() {
    constexpr std::size_t grain = 1024;
    std::vector<std::uint32_t> first(scene_.table.point_count() + 1, 0);
    for (const Side& side : fans_.sides) ++first[side.from.index() + 1];
    for (std::size_t p = 0; p + 1 < first.size(); ++p) first[p + 1] += first[p];
    std::vector<Side> sorted(fans_.sides.size());
    std::vector<std::uint32_t> fill(first.begin(), first.end() - 1);
    for (const Side& side : fans_.sides) sorted[fill[side.from.index()]++] = side;
    fans_.sides.swap(sorted);
    for_each_chunk(context_, fill.size(), grain, [&](const Chunk& chunk) {
      for (std::size_t p = chunk.begin; p < chunk.end; ++p) {
        std::sort(fans_.sides.begin() + first[p], fans_.sides.begin() + first[p + 1], [](const Side& a, const Side& b) {
          return std::tie(a.to, a.sheet, a.forward) < std::tie(b.to, b.sheet, b.forward);
        });
      }
    });
  }

  void group_sides() {
    const std::vector<Side>& sides = fans_.sides;
    for (std::uint32_t i = 0; i < sides.size();) {
      std::uint32_t j = i + 1;
      while (j < sides.size() && sides[j].from == sides[i].from && sides[j].to == sides[i].to) ++j;
      fans_.fans.push_back({i, j - i, is_plain(i, j)});
      i = j;
    }
  }

  bool is_plain(std::uint32_t first, std::uint32_t end) {
    if (end - first != 2) return false;
    Side& a = fans_.sides[first];
    Side& b = fans_.sides[first + 1];
    if (a.forward == b.forward) return false;
    windings_across(sheets_, a.sheet, across_a_);
    windings_across(sheets_, b.sheet, across_b_);
    if (across_a_ != across_b_) return false;
    const bool crosses_itself = std::any_of(across_a_.begin(), across_a_.end(),
                                            [&](const Winding& w) { return scene_.leaves[w.leaf]->crosses_itself; });
    if (crosses_itself && is_involved(a) && is_involved(b) && plane(a) != plane(b)) return false;
    a.rank = 0;
    b.rank = 1;
    return true;
  }

  bool is_involved(const Side& side) const {
    const std::uint32_t facet = sheets_.facet(side.sheet);
    return facet != none && sheets_.network->involved[facet];
  }

  void order_fans() {
    std::vector<std::uint32_t> general;
    for (std::uint32_t f = 0; f < fans_.fans.size(); ++f) {
      if (!fans_.fans[f].is_plain) general.push_back(f);
    }
    scene_.table.resize_lines(general.size());
    for_each_chunk(context_, general.size(), 256, [&](const Chunk& chunk) {
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) order(fans_.fans[general[i]], LineId{i});
    });
  }

  PlaneId plane(const Side& side) const { return PlaneId{sheets_.facet(side.sheet)}; }

  // Sets the line along the edge; positive when it runs from the smaller to the larger end, zero when all sides share a
  // plane.
  Sign set_line(std::span<const Side> sides, LineId line) {
    const auto other = std::find_if(sides.begin() + 1, sides.end(),
                                    [&](const Side& s) { return !in_one_plane(sheets_, sides[0].sheet, s.sheet); });
    if (other == sides.end()) return Sign::zero;
    Constructions& table = scene_.table;
    table.set_line(line, plane(sides[0]), plane(*other));
    for (unsigned axis = 0; axis < 3; ++axis) {
      const Sign component = table.component(line, axis);
      if (component != Sign::zero) return component * table.compare(sides[0].to, sides[0].from, axis);
    }
    return Sign::zero;
  }

  void order(const Fan& fan, LineId line) {
    const std::span<Side> sides(fans_.sides.data() + fan.first, fan.count);
    const Sign direction = set_line(sides, line);
    const auto turn = [&](const Side& a, const Side& b) {
      if (direction == Sign::zero || plane(a) == plane(b)) return Sign::zero;
      const Sign sign = direction * scene_.table.triple(line, plane(a), plane(b));
      return a.forward == b.forward ? sign : -sign;
    };
    const auto is_opposite = [&](const Side& a, const Side& b) {
      const Sign sign = plane(a) == plane(b) ? Sign::positive : scene_.table.dot(plane(a), plane(b));
      return (a.forward == b.forward ? sign : -sign) == Sign::negative;
    };
    const Side reference = sides[0];
    struct Keyed {
      int half;  // 0 along the reference, 1 left of it, 2 opposite, 3 right of it
      Side side;
    };
    std::vector<Keyed> keyed;
    for (const Side& side : sides) {
      const Sign sign = turn(reference, side);
      const int half = sign == Sign::positive ? 1 : sign == Sign::negative ? 3 : is_opposite(reference, side) ? 2 : 0;
      keyed.push_back({half, side});
    }
    const auto before = [&](const Keyed& a, const Keyed& b) {
      if (a.half != b.half) return a.half < b.half;
      return turn(a.side, b.side) == Sign::positive;
    };
    std::stable_sort(keyed.begin(), keyed.end(), before);
    std::uint32_t rank = 0;
    for (std::size_t i = 0; i < keyed.size(); ++i) {
      if (i > 0 && before(keyed[i - 1], keyed[i])) ++rank;
      sides[i] = keyed[i].side;
      sides[i].rank = rank;
    }
  }

  const Sheets& sheets_;
  Scene& scene_;
  const Context& context_;
  Fans fans_;
  std::vector<Winding> across_a_;
  std::vector<Winding> across_b_;
};

}  // namespace

Fans make_fans(const Sheets& sheets, Scene& scene, const Context& context) {
  context.progress("order about edges", 0);
  return FanBuilder(sheets, scene, context).run();
}

}  // namespace quoin::overlay
