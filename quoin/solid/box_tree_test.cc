// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/box_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "quoin/solid/shapes.h"

namespace quoin {
namespace {

const Context context;

struct Soup {
  std::vector<Point3> vertices;
  std::vector<Tile> tiles;
};

// Small tiles, many of them flat or equal, on a grid of few positions when `coarse`.
Soup soup(std::size_t count, double scale, bool coarse, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> fine(-1, 1);
  std::uniform_int_distribution<int> grid(-3, 3);
  Soup result;
  for (std::uint32_t t = 0; t < count; ++t) {
    const Point3 at = coarse ? Point3{double(grid(random)), double(grid(random)), double(grid(random))}
                             : Point3{fine(random), fine(random), fine(random)};
    for (int k = 0; k < 3; ++k) {
      const double size = coarse ? 1 : 0.1;
      const auto shift = [&] { return coarse ? double(grid(random) / 2) : size * fine(random); };
      result.vertices.push_back({scale * (at.x + shift()), scale * (at.y + shift()), scale * (at.z + shift())});
    }
    result.tiles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  return result;
}

bool boxes_meet(const Soup& a, const Tile& s, const Soup& b, const Tile& t) {
  for (std::size_t k = 0; k < 3; ++k) {
    const auto lo = [&](const Soup& x, const Tile& i) {
      return std::min({x.vertices[i[0]][k], x.vertices[i[1]][k], x.vertices[i[2]][k]});
    };
    const auto hi = [&](const Soup& x, const Tile& i) {
      return std::max({x.vertices[i[0]][k], x.vertices[i[1]][k], x.vertices[i[2]][k]});
    };
    if (lo(a, s) > hi(b, t) || lo(b, t) > hi(a, s)) return false;
  }
  return true;
}

// Every pair of the definition is reported, and none twice.
void expect_all_pairs(std::vector<TilePair> found, const std::vector<TilePair>& needed) {
  std::sort(found.begin(), found.end());
  EXPECT_TRUE(std::adjacent_find(found.begin(), found.end()) == found.end());
  for (const TilePair& pair : needed) {
    EXPECT_TRUE(std::binary_search(found.begin(), found.end(), pair)) << pair.a << "/" << pair.b;
  }
}

// Labels leave out exactly the pairs that share one.
void expect_pairs_without_common_label(const BoxTree& tree, std::size_t count) {
  std::vector<Tile> labels;
  for (std::uint32_t t = 0; t < count; ++t) {
    const std::uint32_t third = t % 3 == 0 ? BoxTree::no_label : 20 + t % 5;
    labels.push_back(Tile{100 + t / 2, BoxTree::no_label, third});
  }
  const auto is_kept = [&](const TilePair& pair) {
    for (const std::uint32_t a : labels[pair.a]) {
      for (const std::uint32_t b : labels[pair.b]) {
        if (a == b && a != BoxTree::no_label) return false;
      }
    }
    return true;
  };
  std::vector<TilePair> expected = tree.self_pairs(context);
  std::erase_if(expected, [&](const TilePair& pair) { return !is_kept(pair); });
  const auto all = [](const TilePair&) { return true; };
  EXPECT_EQ(tree.self_pairs({labels, {}}, all, context), expected);
  const auto odd = [](const TilePair& pair) { return pair.a % 2 != 0; };
  std::erase_if(expected, [&](const TilePair& pair) { return !odd(pair); });
  EXPECT_EQ(tree.self_pairs({labels, {}}, odd, context), expected);
  for (Tile& label : labels) label[1] = 7 + label[0] % 3;  // shared by all tiles of some nodes
  expected = tree.self_pairs(context);
  std::erase_if(expected, [&](const TilePair& pair) { return !is_kept(pair); });
  EXPECT_EQ(tree.self_pairs({labels, {}}, all, context), expected);
  for (Tile& label : labels) label[1] = 7;
  EXPECT_TRUE(tree.self_pairs({labels, {}}, all, context).empty());
}

TEST(BoxTree, QueriesMissNothing) {
  for (const double scale : {1.0, 1e-300, 1e300, 5e-324}) {
    for (const bool coarse : {false, true}) {
      for (const std::size_t count : {0U, 1U, 9U, 300U}) {
        SCOPED_TRACE(::testing::Message() << "scale " << scale << " coarse " << coarse << " count " << count);
        const Soup a = soup(count, scale, coarse, 1);
        const Soup b = soup(count, scale, coarse, 2);
        const BoxTree tree_a(a.vertices, a.tiles, context);
        const BoxTree tree_b(b.vertices, b.tiles, context);
        std::vector<TilePair> between;
        std::vector<TilePair> within;
        for (std::uint32_t i = 0; i < count; ++i) {
          for (std::uint32_t j = 0; j < count; ++j) {
            if (boxes_meet(a, a.tiles[i], b, b.tiles[j])) between.push_back({i, j});
            if (i < j && boxes_meet(a, a.tiles[i], a, a.tiles[j])) within.push_back({i, j});
          }
        }
        expect_all_pairs(BoxTree::pairs(tree_a, tree_b, context), between);
        expect_all_pairs(tree_a.self_pairs(context), within);
        expect_pairs_without_common_label(tree_a, count);
      }
    }
  }
}

TEST(BoxTree, PairsAreTheSameOnAnyNumberOfThreads) {
  const Soup a = soup(5000, 1, false, 3);
  std::vector<TilePair> expected;
  for (const unsigned threads : {1U, 2U, 4U}) {
    const Context several({.threads = threads});
    const std::vector<TilePair> pairs = BoxTree(a.vertices, a.tiles, several).self_pairs(several);
    if (expected.empty()) expected = pairs;
    EXPECT_EQ(pairs, expected);
  }
}

TEST(BoxTree, LinesAndBoxesMissNothing) {
  const Soup a = soup(400, 1, false, 4);
  const BoxTree tree(a.vertices, a.tiles, context);
  for (std::uint32_t i = 0; i < 400; i += 7) {
    const Point3& p = a.vertices[a.tiles[i][0]];
    for (unsigned axis = 0; axis < 3; ++axis) {
      std::vector<std::uint32_t> out;
      tree.tiles_on_line(axis, {p[(axis + 1) % 3], p[(axis + 2) % 3]}, {p[(axis + 1) % 3], p[(axis + 2) % 3]}, out);
      EXPECT_NE(std::find(out.begin(), out.end(), i), out.end());
    }
    std::vector<std::uint32_t> out;
    tree.tiles_in_box(p, p, out);
    EXPECT_NE(std::find(out.begin(), out.end(), i), out.end());
  }
}

}  // namespace
}  // namespace quoin
