// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/exit_sides.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "quoin/base/parallel.h"
#include "quoin/solid/leaf.h"
#include "quoin/solid/leaf_crossings.h"

namespace quoin {

namespace {

constexpr std::uint32_t none = 0xFFFFFFFFU;

// Six times the signed volume of some triangles with a reference point, the sum of the sizes of all products in it, and
// the triangles' box.
struct Bulk {
  double volume = 0;
  double size = 0;
  Point3 lo{HUGE_VAL, HUGE_VAL, HUGE_VAL};
  Point3 hi{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};

  void add(const Point3& reference, const std::array<Point3, 3>& corners) {
    std::array<Point3, 3> d;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        d[i][k] = corners[i][k] - reference[k];
        lo[k] = std::min(lo[k], corners[i][k]);
        hi[k] = std::max(hi[k], corners[i][k]);
      }
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const double left = d[1][(k + 1) % 3] * d[2][(k + 2) % 3];
      const double right = d[1][(k + 2) % 3] * d[2][(k + 1) % 3];
      volume += d[0][k] * (left - right);
      size += std::fabs(d[0][k]) * (std::fabs(left) + std::fabs(right));
    }
  }

  void add(const Bulk& other) {
    volume += other.volume;
    size += other.size;
    for (std::size_t k = 0; k < 3; ++k) {
      lo[k] = std::min(lo[k], other.lo[k]);
      hi[k] = std::max(hi[k], other.hi[k]);
    }
  }

  // A product of three differences has a relative error of at most 6 half units in the last place, and each of the up
  // to `terms` additions after it one more, of at most `size` each; twice that covers the rounding of `size` too. A
  // product of two that underflows is off by 2^-1075 more, times a third factor of at most the box's extent; infinite
  // sizes and extents decide nothing.
  bool has_sign(bool is_negative, std::size_t terms) const {
    const double extent = std::max({hi.x - lo.x, hi.y - lo.y, hi.z - lo.z, 1.0});
    const double count = static_cast<double>(terms);
    const double error = (count + 8) * std::numeric_limits<double>::epsilon() * size + count * extent * 0x1p-1072;
    return is_negative ? volume < -error : volume > error;
  }
};

bool are_boxes_disjoint(std::vector<Bulk> shells) {
  std::sort(shells.begin(), shells.end(), [](const Bulk& a, const Bulk& b) { return a.lo.x < b.lo.x; });
  for (std::size_t i = 0; i < shells.size(); ++i) {
    for (std::size_t j = i + 1; j < shells.size() && shells[j].lo.x <= shells[i].hi.x; ++j) {
      const auto meet = [&](std::size_t k) {
        return shells[i].lo[k] <= shells[j].hi[k] && shells[j].lo[k] <= shells[i].hi[k];
      };
      if (meet(1) && meet(2)) return false;
    }
  }
  return true;
}

class SideCheck {
 public:
  SideCheck(const Brep& boundary, const std::vector<Point3>& positions, std::span<const Tile> triangles,
            std::span<const std::uint32_t> triangle_face, const Context& context)
      : b_(boundary), positions_(positions), triangles_(triangles), triangle_face_(triangle_face), context_(context) {}

  bool is_evident() const {
    const std::vector<Bulk> shells = bulks();
    for (std::size_t s = 0; s < shells.size(); ++s) {
      if (!shells[s].has_sign(b_.shells[s].is_void, 3 * triangles_.size())) return false;
    }
    return are_boxes_disjoint(shells);
  }

  bool have_right_windings() const {
    Mesh mesh;
    mesh.vertices = positions_;
    for (Tile t : triangles_) {
      if (b_.is_unbounded) std::swap(t[1], t[2]);
      mesh.add_face(t);
    }
    LeafResult result = make_leaf(mesh, {.max_listed = 0, .find_crossings = false}, context_);
    if (!result.leaf) return false;
    find_inverted_components(result.leaf, Constructions(result.leaf->vertices), 0, result.diagnosis, context_);
    return result.diagnosis.inverted_components.count == 0;
  }

 private:
  std::uint32_t shell(std::size_t t) const { return b_.face_shells[triangle_face_[t]]; }

  std::vector<Bulk> bulks() const {
    const std::vector<std::uint32_t> references = first_vertices();
    // Every chunk sums for every shell, so many shells are summed at once.
    const std::size_t grain = b_.shells.size() <= 16 ? 16384 : std::max<std::size_t>(triangles_.size(), 1);
    std::vector<std::vector<Bulk>> parts(chunk_count(triangles_.size(), grain));
    for_each_chunk(context_, triangles_.size(), grain, [&](const Chunk& chunk) {
      std::vector<Bulk>& part = parts[chunk.index];
      part.resize(b_.shells.size());
      for (std::size_t t = chunk.begin; t < chunk.end; ++t) {
        const Tile& tile = triangles_[t];
        part[shell(t)].add(positions_[references[shell(t)]],
                           {positions_[tile[0]], positions_[tile[1]], positions_[tile[2]]});
      }
    });
    std::vector<Bulk> sums(b_.shells.size());
    for (const std::vector<Bulk>& part : parts) {
      for (std::size_t s = 0; s < sums.size(); ++s) sums[s].add(part[s]);
    }
    return sums;
  }

  std::vector<std::uint32_t> first_vertices() const {
    std::vector<std::uint32_t> first(b_.shells.size(), none);
    std::size_t missing = first.size();
    for (std::size_t t = 0; t < triangles_.size() && missing > 0; ++t) {
      std::uint32_t& vertex = first[shell(t)];
      if (vertex != none) continue;
      vertex = triangles_[t][0];
      --missing;
    }
    return first;
  }

  const Brep& b_;
  const std::vector<Point3>& positions_;
  std::span<const Tile> triangles_;
  std::span<const std::uint32_t> triangle_face_;
  const Context& context_;
};

}  // namespace

bool are_sides_kept(const Brep& boundary, const std::vector<Point3>& positions, std::span<const Tile> triangles,
                    std::span<const std::uint32_t> triangle_face, const Context& context) {
  const SideCheck check(boundary, positions, triangles, triangle_face, context);
  return check.is_evident() || check.have_right_windings();
}

bool are_sides_evident(const Brep& boundary, const std::vector<Point3>& positions, std::span<const Tile> triangles,
                       std::span<const std::uint32_t> triangle_face, const Context& context) {
  return SideCheck(boundary, positions, triangles, triangle_face, context).is_evident();
}

}  // namespace quoin
