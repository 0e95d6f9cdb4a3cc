// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/edit/insert.h"

#include "quoin/arrangement/edit/editing_test_support.h"
#include "quoin/base/test_rounds.h"

namespace quoin {
namespace {

using namespace editing_test;

const Mix mixes[] = {{3, false, false}, {4, false, true}, {3, true, false}, {5, true, true}, {12, false, false}};

TEST(Insert, CurveByCurveEqualsTheSweep) {
  std::mt19937 random(11);
  for (int round = 0; round < 1500; ++round) {
    const Mix& mix = mixes[round % 5];
    std::vector<GridCurve> curves;
    LinearArrangement arrangement;
    const int count = 1 + round % 12;
    for (int i = 0; i < count; ++i) {
      curves.push_back(random_curve(random, mix));
      insert_one(arrangement, curves.back());
      ASSERT_NO_THROW(dcel::check_links(arrangement.cells())) << text(curves);
      ASSERT_EQ(check_outer(arrangement), "") << text(curves);
    }
    renumber(arrangement, Context());
    ASSERT_EQ(difference(arrangement, swept(curves), identity(curves.size())), "") << round << "\n" << text(curves);
  }
}

/// Several pieces a curve, which may run along itself.
TEST(Insert, Polylines) {
  std::mt19937 random(13);
  for (int round = 0; round < 300; ++round) {
    LinearFamily all;
    PieceList<LinearFamily> all_pieces;
    LinearArrangement arrangement;
    const unsigned size = 3 + static_cast<unsigned>(round) % 4;
    const int count = 1 + round % 4;
    for (int i = 0; i < count; ++i) {
      std::vector<Point2> vertices;
      while (vertices.size() < 5) {
        const Point2 p{static_cast<double>(random() % size), static_cast<double>(random() % size)};
        if (vertices.empty() || (vertices.back() != p && (vertices.size() < 4 || vertices[0] != p)))
          vertices.push_back(p);
      }
      LinearFamily family;
      PieceList<LinearFamily> list;
      family.add_polyline(list, vertices, round % 2 == 0);
      all.add_polyline(all_pieces, vertices, round % 2 == 0);
      insert(arrangement, family, list, Context());
      ASSERT_NO_THROW(dcel::check_links(arrangement.cells())) << round;
    }
    renumber(arrangement, Context());
    const LinearArrangement expected = arrange(std::move(all), all_pieces, Context());
    ASSERT_EQ(difference(arrangement, expected, identity(arrangement.curve_count())), "") << round;
  }
}

TEST(Insert, EveryOrderGivesTheSame) {
  std::mt19937 random(5);
  for (int round = 0; round < 60; ++round) {
    const Mix& mix = mixes[round % 5];
    std::vector<GridCurve> curves;
    for (int i = 0; i < 4; ++i) curves.push_back(random_curve(random, mix));
    const LinearArrangement expected = swept(curves);
    std::vector<std::uint32_t> order = identity(4);
    do {
      LinearArrangement arrangement;
      for (const std::uint32_t i : order) insert_one(arrangement, curves[i]);
      renumber(arrangement, Context());
      ASSERT_EQ(difference(arrangement, expected, order), "") << text(curves);
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

TEST(Insert, SweepsAndZonesMix) {
  std::mt19937 random(17);
  for (int round = 0; round < 400; ++round) {
    const Mix& mix = mixes[round % 5];
    std::vector<GridCurve> curves;
    for (int i = 0; i < 3; ++i) curves.push_back(random_curve(random, mix));
    LinearArrangement arrangement = swept(curves);
    for (int batch = 0; batch < 4; ++batch) {
      LinearFamily family;
      PieceList<LinearFamily> list;
      for (int i = 0; i < 4; ++i) {
        curves.push_back(random_curve(random, mix));
        add(family, list, curves.back());
      }
      InsertOptions<LinearPoint> options;
      options.sweeps_from = random() % 2 == 0 ? 0 : 32;
      insert(arrangement, family, list, Context(), options);
      ASSERT_NO_THROW(dcel::check_links(arrangement.cells())) << text(curves);
    }
    renumber(arrangement, Context());
    ASSERT_EQ(difference(arrangement, swept(curves), identity(curves.size())), "") << text(curves);
  }
}

/// Insertions and removals; the arrangement of the curves that are left is what the sweep makes of them.
void edit_at_random(unsigned seed, const Mix& mix, int steps) {
  std::mt19937 random(seed);
  LinearArrangement arrangement;
  std::vector<GridCurve> curves;
  std::vector<std::uint32_t> ids;
  for (int step = 0; step < steps; ++step) {
    if (curves.size() < 2 || (curves.size() < 14 && random() % 2 == 0)) {
      curves.push_back(random_curve(random, mix));
      ids.push_back(insert_one(arrangement, curves.back()).value);
    } else {
      const std::size_t gone = random() % curves.size();
      remove_curve(arrangement, CurveId(std::size_t{ids[gone]}));
      curves.erase(curves.begin() + static_cast<std::ptrdiff_t>(gone));
      ids.erase(ids.begin() + static_cast<std::ptrdiff_t>(gone));
    }
    ASSERT_NO_THROW(dcel::check_links(arrangement.cells())) << step << "\n" << text(curves);
    ASSERT_EQ(check_outer(arrangement), "") << step << "\n" << text(curves);
    LinearArrangement copy = arrangement;
    renumber(copy, Context());
    std::vector<std::uint32_t> curve_of(arrangement.curve_count(), 0xFFFFFFFU);
    for (std::size_t i = 0; i < ids.size(); ++i) curve_of[ids[i]] = static_cast<std::uint32_t>(i);
    ASSERT_EQ(difference(copy, swept(curves), curve_of), "") << step << "\n" << text(curves);
    if (step % 200 == 199) arrangement = std::move(copy);
  }
}

TEST(Insert, RandomEditsOfSegments) {
  edit_at_random(1, {4, false, false}, test_rounds(3000));
  edit_at_random(2, {7, false, false}, test_rounds(2000));
}

TEST(Insert, RandomEditsOfLinesAndRays) {
  edit_at_random(3, {3, true, false}, test_rounds(3000));
  edit_at_random(4, {6, true, false}, test_rounds(2000));
}

}  // namespace
}  // namespace quoin
