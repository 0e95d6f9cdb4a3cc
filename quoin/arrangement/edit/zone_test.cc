// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/edit/zone.h"

#include "quoin/arrangement/edit/editing_test_support.h"
#include "quoin/arrangement/location/naive_locator.h"

namespace quoin {
namespace {

using namespace editing_test;

const Mix mixes[] = {{3, false, true}, {4, true, false}, {5, true, true}, {9, false, false}};

/// The cells at the ends of every step, and between them, are those that naive location finds.
TEST(Zone, StepsAreWhereTheySay) {
  std::mt19937 random(31);
  for (int round = 0; round < 3000; ++round) {
    const Mix& mix = mixes[round % 4];
    std::vector<GridCurve> curves;
    for (int i = 0; i < round % 9; ++i) curves.push_back(random_curve(random, mix));
    LinearArrangement arrangement = swept(curves);
    const GridCurve c = random_curve(random, {mix.size, mix.unbounded, false});
    LinearFamily family;
    PieceList<LinearFamily> list;
    add(family, list, c);
    ArrangementEditor<LinearFamily> editor(arrangement);
    const auto shift = editor.family().absorb(family);
    const Piece& piece = list.pieces[0];
    const ZonePiece<LinearPoint> path{LinearFamily::shifted(piece.branch, shift),
                                      LinearFamily::shifted(list.points[piece.left], shift),
                                      LinearFamily::shifted(list.points[piece.right], shift)};
    const auto steps = zone_steps(arrangement, path);
    SCOPED_TRACE(text(curves) + "along " + text(c));
    ASSERT_EQ(arrangement.family().compare_xy(steps.front().left, path.left), Sign::zero);
    ASSERT_EQ(arrangement.family().compare_xy(steps.back().right, path.right), Sign::zero);
    bool meets = false;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const auto& step = steps[i];
      ASSERT_EQ(arrangement.family().compare_xy(step.left, step.right), Sign::negative);
      if (i > 0) {
        ASSERT_EQ(step.at_left, steps[i - 1].at_right);
        ASSERT_FALSE(step.at_left.is_face());
      }
      for (const auto& end : {std::pair(step.left, step.at_left), std::pair(step.right, step.at_right)}) {
        meets = meets || !end.second.is_face();
        if (!end.first.is_end()) {
          ASSERT_EQ(NaiveLocator<LinearFamily>(arrangement).locate(end.first), end.second);
        }
      }
      if (step.left.is_end() || step.right.is_end()) continue;
      const RationalPoint2 p = arrangement.family().exact(step.left);
      const RationalPoint2 q = arrangement.family().exact(step.right);
      const Rational half = Rational(1) / Rational(2);
      const LinearPoint middle = editor.family().point(RationalPoint2{(p.x + q.x) * half, (p.y + q.y) * half});
      const Location cell = NaiveLocator<LinearFamily>(arrangement).locate(middle);
      if (step.overlapped.is_none()) {
        ASSERT_EQ(cell, Location(step.face));
      } else {
        ASSERT_EQ(cell, Location(step.overlapped));
      }
    }
    ASSERT_EQ(meets_anything(arrangement, path), meets);
    ASSERT_EQ(arrangement.counts().edges, swept(curves).counts().edges) << "the walk changes nothing";
  }
}

}  // namespace
}  // namespace quoin
