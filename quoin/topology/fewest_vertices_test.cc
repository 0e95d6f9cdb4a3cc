// SPDX-License-Identifier: Apache-2.0
// How few vertices a closed surface can have (H14): the bound, which surfaces attain it, and which do not, by looking
// at all triangulations that there are.
#include <gtest/gtest.h>

#include <bit>
#include <optional>
#include <tuple>
#include <utility>

#include "quoin/topology/manifold.h"
#include "quoin/topology/test_complexes.h"

namespace quoin {
namespace {

using namespace test_complexes;

/// The least n for which n vertices have enough pairs for the edges of a surface.
std::uint32_t bound(std::int64_t euler) {
  std::int64_t n = 4;
  while ((2 * n - 7) * (2 * n - 7) < 49 - 24 * euler) ++n;
  return static_cast<std::uint32_t>(n);
}

/// Triangulations of closed surfaces in which vertex 0 is next to all others, in ascending order around it.
/// Each is found once: the first edge that has one triangle gets its other one.
class SurfaceSearch {
 public:
  SurfaceSearch(std::uint32_t vertices, std::int64_t euler) : vertices_(vertices), most_(2 * (vertices - euler)) {
    for (std::uint32_t v = 1; v < vertices; ++v) turn({0, v, v + 1 < vertices ? v + 1 : 1});
  }

  /// `visit` gets the triangles and says whether to go on.
  template <class Visit>
  bool each(const Visit& visit) {
    const std::optional<std::pair<std::uint32_t, std::uint32_t>> open = first_open_edge();
    if (!open) return count_ != most_ || visit(triangles());
    for (std::uint32_t c = 0; c < vertices_ && count_ < most_; ++c) {
      const std::array<std::uint32_t, 3> t{open->first, open->second, c};
      if (!fits(t)) continue;
      turn(t);
      const bool goes_on = each(visit);
      turn(t);
      if (!goes_on) return false;
    }
    return true;
  }

 private:
  static constexpr std::uint32_t most_vertices = 10;

  /// Adds a triangle, or takes it away.
  void turn(std::array<std::uint32_t, 3> t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [a, b, c] = std::tuple{t[i], t[(i + 1) % 3], t[(i + 2) % 3]};
      apexes_[a][b] ^= 1U << c;
      apexes_[b][a] ^= 1U << c;
    }
    const bool is_added = (apexes_[t[0]][t[1]] >> t[2] & 1) != 0;
    count_ += is_added ? 1 : -1;
  }

  std::optional<std::pair<std::uint32_t, std::uint32_t>> first_open_edge() const {
    for (std::uint32_t a = 0; a < vertices_; ++a)
      for (std::uint32_t b = a + 1; b < vertices_; ++b)
        if (std::popcount(apexes_[a][b]) == 1) return std::pair{a, b};
    return std::nullopt;
  }

  /// No edge gets a third triangle, and links are paths, or circles that have all that is around their vertex.
  bool fits(std::array<std::uint32_t, 3> t) const {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [a, b, c] = std::tuple{t[i], t[(i + 1) % 3], t[(i + 2) % 3]};
      if (b == c || std::popcount(apexes_[b][c]) == 2 || (apexes_[b][c] >> a & 1) != 0) return false;
      if (is_closed(a)) return false;
      if (closes_a_part(a, b, c)) return false;
    }
    return true;
  }

  bool is_closed(std::uint32_t a) const {
    bool is_around = false;
    for (std::uint32_t b = 0; b < vertices_; ++b) {
      if (std::popcount(apexes_[a][b]) == 1) return false;
      is_around |= apexes_[a][b] != 0;
    }
    return is_around;
  }

  /// Whether b and c are the ends of one path around a, and a has other neighbours.
  bool closes_a_part(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    std::uint32_t path = 1U << b;
    for (std::uint32_t grown = 0; grown != path;) {
      grown = path;
      for (std::uint32_t v = 0; v < vertices_; ++v)
        if ((path >> v & 1) != 0) path |= apexes_[a][v];
    }
    if ((path >> c & 1) == 0) return false;
    for (std::uint32_t v = 0; v < vertices_; ++v)
      if (apexes_[a][v] != 0 && (path >> v & 1) == 0) return true;
    return false;
  }

  SimplexList triangles() const {
    SimplexList list;
    for (std::uint32_t a = 0; a < vertices_; ++a)
      for (std::uint32_t b = a + 1; b < vertices_; ++b)
        for (std::uint32_t c = b + 1; c < vertices_; ++c)
          if ((apexes_[a][b] >> c & 1) != 0) list.add(std::array{a, b, c});
    return list;
  }

  std::uint32_t vertices_;
  std::int64_t most_;
  std::int64_t count_ = 0;
  std::array<std::array<std::uint32_t, most_vertices>, most_vertices> apexes_{};  ///< of triangles at an edge, as bits
};

/// The class of a connected closed surface.
SurfaceClass class_of(const SimplexList& list) {
  const SimplicialComplex surface = closure(list);
  const std::vector<SurfaceClass> classes = classify_surface(surface, Context());
  EXPECT_EQ(classes.size(), 1U);
  EXPECT_EQ(classes.front().boundary_loops, 0U);
  EXPECT_EQ(classes.front().euler_characteristic, surface.euler_characteristic());
  return classes.front();
}

/// How many triangulations with a vertex next to all others can be oriented, and how many cannot.
std::pair<std::size_t, std::size_t> orientable_and_not(std::uint32_t vertices, std::int64_t euler) {
  std::pair<std::size_t, std::size_t> counts;
  SurfaceSearch(vertices, euler).each([&](const SimplexList& list) {
    const SurfaceClass found = class_of(list);
    EXPECT_EQ(found.euler_characteristic, euler);
    ++(found.is_orientable ? counts.first : counts.second);
    return true;
  });
  return counts;
}

/// Whether the search finds a surface that is orientable, or one that is not.
bool exists(std::uint32_t vertices, std::int64_t euler, bool is_orientable) {
  return !SurfaceSearch(vertices, euler).each([&](const SimplexList& list) {
    return class_of(list).is_orientable != is_orientable;
  });
}

TEST(FewestVertices, OfSurfacesThatAttainTheBound) {
  const std::vector<std::pair<std::int64_t, std::uint32_t>> listed{{2, 4},  {1, 6},  {0, 7},  {-1, 8},
                                                                   {-2, 9}, {-3, 9}, {-4, 10}};
  for (const auto& [euler, vertices] : listed) EXPECT_EQ(bound(euler), vertices);
  for (const SimplexList& list : {sphere(2), six_vertex_projective_plane(), seven_vertex_torus()}) {
    const SimplicialComplex surface = closure(list);
    EXPECT_EQ(surface.count(0), bound(surface.euler_characteristic()));
  }
  EXPECT_TRUE(exists(bound(-2), -2, false));
  EXPECT_TRUE(exists(bound(-3), -3, false));
  EXPECT_TRUE(exists(bound(-4), -4, false));
}

TEST(FewestVertices, OfSurfacesThatNeedOneMore) {
  // With as few vertices as the bound allows, one has all others around it: these have more than n (n - 2) / 2 edges.
  for (const std::int64_t euler : {0, -1, -2}) {
    const std::int64_t n = bound(euler);
    EXPECT_GT(6 * (n - euler), n * (n - 2));
  }
  using Counts = std::pair<std::size_t, std::size_t>;
  // Seven vertices: tori alone, two for each order around a vertex, so 7! / 42 in all; no Klein bottle.
  EXPECT_EQ(orientable_and_not(7, 0), (Counts{2, 0}));
  EXPECT_TRUE(exists(8, 0, false));
  EXPECT_EQ(orientable_and_not(8, -1), (Counts{0, 0}));
  EXPECT_TRUE(exists(9, -1, false));
  // Nine: none of genus 2, though many with four projective planes.
  const Counts of_nine = orientable_and_not(9, -2);
  EXPECT_EQ(of_nine.first, 0U);
  EXPECT_GT(of_nine.second, 0U);
  EXPECT_TRUE(exists(10, -2, true));
}

// What the search finds where the answer is known by hand: pyramids on both sides of a square, cut in two ways; the one
// projective plane.
TEST(FewestVertices, TheSearchFindsEachSurfaceOnce) {
  using Counts = std::pair<std::size_t, std::size_t>;
  EXPECT_EQ(orientable_and_not(4, 2), (Counts{1, 0}));
  EXPECT_EQ(orientable_and_not(5, 2), (Counts{2, 0}));
  EXPECT_EQ(orientable_and_not(6, 1), (Counts{0, 1}));
}

}  // namespace
}  // namespace quoin
