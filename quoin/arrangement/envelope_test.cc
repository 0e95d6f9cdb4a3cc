// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/envelope.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>
#include <sstream>

#include "quoin/arrangement/envelope_test_support.h"
#include "quoin/base/error.h"

namespace quoin {
namespace {

using testing::CircularEnvelopeChecker;
using testing::EnvelopeCases;
using testing::LinearEnvelopeChecker;
using Members = std::vector<std::uint32_t>;

template <class F>
struct Scene {
  F family;
  PieceList<F> list;
  std::ostringstream log;
};
using LinearScene = Scene<LinearFamily>;
using CircularScene = Scene<CircularFamily>;

using Random = std::mt19937;

double pick(Random& random, std::size_t size) {
  return static_cast<double>(random() % size);
}

/// A small integer, or off one by almost nothing.
double pick_close(Random& random, std::size_t size) {
  const double value = pick(random, size);
  if (random() % 3 != 0) return value;
  return value == 0 ? 0x1p-60 : std::nextafter(value, random() % 2 == 0 ? -1 : 100);
}

void add_linear(LinearScene& scene, Random& random, const Point2& a, const Point2& b) {
  const std::size_t kind = random() % 8;
  scene.log << kind << ": " << a.x << ' ' << a.y << ", " << b.x << ' ' << b.y << '\n';
  if (kind == 0 || a == b) {
    scene.family.add_point(scene.list, a);
  } else if (kind == 1) {
    scene.family.add_ray(scene.list, a, b);
  } else if (kind == 2 && random() % 2 == 0) {
    scene.family.add_line(scene.list, a, b, "line");
  } else if (kind == 3) {
    const Rational third = Rational(1) / Rational(3);
    scene.family.add_segment(scene.list, RationalPoint2{Rational(a.x) + third, a.y}, RationalPoint2{b.x, third});
  } else {
    scene.family.add_segment(scene.list, a, b);
  }
}

void add_circular(CircularScene& scene, Random& random, const Point2& a, const Point2& b) {
  const std::size_t kind = random() % 8;
  const double size = 1 + pick(random, 3);
  scene.log << kind << ": " << a.x << ' ' << a.y << ", " << b.x << ' ' << b.y << "; " << size << '\n';
  if (kind == 0 || (a == b && kind < 4)) {
    scene.family.add_point(scene.list, a);
  } else if (kind < 3) {
    scene.family.add_segment(scene.list, a, b);
  } else if (kind == 3) {
    scene.family.add_bulge_arc(scene.list, a, b, random() % 2 == 0 ? size / 2 : -size / 2);
  } else if (kind == 4) {
    scene.family.add_circle(scene.list, RationalCircle{a.x, a.y, Rational(size)});
  } else {
    scene.family.add_circle(scene.list, a, size);
  }
}

TEST(Envelope, OfLinesSegmentsAndPointsAgreesWithItsDefinition) {
  Random random(1);
  EnvelopeCases cases;
  for (int round = 0; round < 2000; ++round) {
    LinearScene scene;
    const std::size_t size = 3 + random() % 5;
    const std::size_t count = random() % 9;
    for (std::size_t i = 0; i < count; ++i) {
      const Point2 a{pick(random, size), pick(random, size)};
      const Point2 b{random() % 5 == 0 ? a.x : pick(random, size), pick(random, size)};
      add_linear(scene, random, a, b);
    }
    SCOPED_TRACE("round " + std::to_string(round) + "\n" + scene.log.str());
    LinearEnvelopeChecker(scene.family, scene.list).check(cases);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(cases.gaps, 100U);
  EXPECT_GT(cases.overlaps, 100U);
  EXPECT_GT(cases.touches, 100U);
  EXPECT_GT(cases.common_points, 100U);
  EXPECT_GT(cases.jumps, 100U);
  EXPECT_GT(cases.at_infinity, 100U);
}

TEST(Envelope, OfCoordinatesAlmostOnAGridAgreesWithItsDefinition) {
  Random random(2);
  EnvelopeCases cases;
  for (int round = 0; round < 600; ++round) {
    LinearScene scene;
    scene.log.precision(17);
    for (int i = 0; i < 7; ++i) {
      const Point2 a{pick_close(random, 5), pick_close(random, 5)};
      add_linear(scene, random, a, {pick_close(random, 5), pick_close(random, 5)});
    }
    SCOPED_TRACE("round " + std::to_string(round) + "\n" + scene.log.str());
    LinearEnvelopeChecker(scene.family, scene.list).check(cases);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(cases.common_points, 10U);
}

TEST(Envelope, OfCirclesArcsAndSegmentsAgreesWithItsDefinition) {
  Random random(3);
  EnvelopeCases cases;
  for (int round = 0; round < 500; ++round) {
    CircularScene scene;
    scene.log.precision(17);
    const std::size_t size = 3 + random() % 6;
    const std::size_t count = random() % 8;
    const auto number = [&] { return round % 4 == 0 ? pick_close(random, size) : pick(random, size); };
    Point2 a{0, 0};
    Point2 b{1, 0};
    for (std::size_t i = 0; i < count; ++i) {
      if (random() % 4 != 0) {  // else the same points once more
        a = {number(), number()};
        b = {random() % 5 == 0 ? a.x : number(), number()};
      }
      add_circular(scene, random, a, b);
    }
    SCOPED_TRACE("round " + std::to_string(round) + "\n" + scene.log.str());
    CircularEnvelopeChecker(scene.family, scene.list).check(cases);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(cases.gaps, 50U);
  EXPECT_GT(cases.overlaps, 30U);
  EXPECT_GT(cases.touches, 30U);
  EXPECT_GT(cases.common_points, 50U);
  EXPECT_GT(cases.jumps, 30U);
}

TEST(Envelope, OfLinesIsConcaveWithOneIntervalForEachLineAtMost) {
  Random random(4);
  LinearScene scene;
  constexpr std::size_t count = 500;
  for (std::size_t i = 0; i < count; ++i) {
    // Tangents of a parabola show all of themselves.
    const double x = static_cast<double>(i) - 250;
    scene.family.add_line(scene.list, {x, -x * x}, {x + 1, -x * x - 2 * x}, "line");
    scene.family.add_line(scene.list, {x, pick(random, 1000)}, {x + 1, pick(random, 1000)}, "line");
  }
  for (const bool upper : {false, true}) {
    const Context context;
    const LinearEnvelope envelope =
        upper ? upper_envelope(scene.family, scene.list, context) : lower_envelope(scene.family, scene.list, context);
    EXPECT_LE(envelope.arc_count(), 2 * count);
    EXPECT_EQ(envelope.arc_count(), envelope.interval_count());
    for (std::size_t i = 1; i < envelope.interval_count(); ++i) {
      const Sign slopes = scene.family.compare_slopes(envelope.branch(i - 1), envelope.branch(i));
      ASSERT_EQ(slopes, upper ? Sign::negative : Sign::positive);
    }
  }
}

TEST(Envelope, OfManySegmentsIsSmall) {
  Random random(5);
  LinearScene scene;
  constexpr std::size_t count = 3000;
  for (std::size_t i = 0; i < count; ++i) {
    scene.family.add_segment(scene.list, Point2{pick(random, std::size_t{1} << 20), pick(random, std::size_t{1} << 20)},
                             Point2{pick(random, std::size_t{1} << 20), pick(random, std::size_t{1} << 20)});
  }
  const LinearEnvelope envelope = lower_envelope(scene.family, scene.list, Context());
  EXPECT_LT(envelope.breakpoint_count(), 4 * count);
  EXPECT_GT(envelope.breakpoint_count(), 10U);
}

/// Members by what the pieces were called before they were shuffled.
template <class F>
std::vector<Members> named_members(const Envelope<F>& envelope, const Members& names) {
  std::vector<Members> all;
  const auto add = [&](std::span<const std::uint32_t> members) {
    all.emplace_back();
    for (const std::uint32_t member : members) all.back().push_back(names[member]);
    std::ranges::sort(all.back());
  };
  for (std::size_t i = 0; i < envelope.interval_count(); ++i) {
    if (i > 0) add(envelope.at(i - 1));
    add(envelope.over(i));
  }
  return all;
}

TEST(Envelope, DoesNotDependOnTheOrderOfTheCurves) {
  Random random(6);
  for (int round = 0; round < 200; ++round) {
    CircularScene scene;
    for (int i = 0; i < 12; ++i) {
      add_circular(scene, random, {pick(random, 8), pick(random, 8)}, {pick(random, 8), pick(random, 8)});
    }
    const std::size_t pieces = scene.list.pieces.size();
    const std::size_t count = pieces + scene.list.lone_points.size();
    Members names(count);
    std::iota(names.begin(), names.end(), 0U);
    const CircularEnvelope before = lower_envelope(scene.family, scene.list, Context());
    const std::vector<Members> expected = named_members(before, names);
    std::shuffle(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(pieces), random);
    PieceList<CircularFamily> shuffled = scene.list;
    for (std::size_t i = 0; i < pieces; ++i) shuffled.pieces[i] = scene.list.pieces[names[i]];
    const CircularEnvelope after = lower_envelope(scene.family, shuffled, Context());
    ASSERT_EQ(named_members(after, names), expected) << scene.log.str();
    for (std::size_t i = 0; i < before.breakpoint_count(); ++i) {
      ASSERT_EQ(scene.family.compare_xy(before.point(i), after.point(i)), Sign::zero);
    }
  }
}

TEST(Envelope, UpperIsTheMirrorOfLower) {
  Random random(7);
  for (int round = 0; round < 300; ++round) {
    LinearScene scene;
    LinearScene mirror;
    for (int i = 0; i < 15; ++i) {
      const Point2 a{pick(random, 9), pick(random, 9)};
      const Point2 b{pick(random, 9), pick(random, 9)};
      if (a == b) continue;
      const auto add = [&](LinearScene& to, double sign) {
        if (i % 5 == 0) {
          to.family.add_ray(to.list, {a.x, sign * a.y}, {b.x, sign * b.y});
        } else {
          to.family.add_segment(to.list, Point2{a.x, sign * a.y}, Point2{b.x, sign * b.y});
        }
      };
      add(scene, 1);
      add(mirror, -1);
    }
    const LinearEnvelope upper = upper_envelope(scene.family, scene.list, Context());
    const LinearEnvelope lower = lower_envelope(mirror.family, mirror.list, Context());
    Members names(scene.list.pieces.size());
    std::iota(names.begin(), names.end(), 0U);
    ASSERT_EQ(named_members(upper, names), named_members(lower, names));
  }
}

TEST(Envelope, OfNothingIsOneGap) {
  const LinearScene scene;
  const LinearEnvelope envelope = lower_envelope(scene.family, scene.list, Context());
  EXPECT_EQ(envelope.breakpoint_count(), 0U);
  ASSERT_EQ(envelope.interval_count(), 1U);
  EXPECT_TRUE(envelope.is_gap(0));
  EXPECT_TRUE(envelope.branch(0).is_none());
}

TEST(Envelope, OfSeparateCirclesIsASkyline) {
  CircularScene scene;
  constexpr std::size_t count = 100;
  for (std::size_t i = 0; i < count; ++i) scene.family.add_circle(scene.list, {static_cast<double>(3 * i), 0}, 1);
  const CircularEnvelope envelope = upper_envelope(scene.family, scene.list, Context());
  EXPECT_EQ(envelope.arc_count(), count);
  EXPECT_EQ(envelope.breakpoint_count(), 2 * count);
  for (std::size_t i = 0; i < count; ++i) {
    EXPECT_TRUE(envelope.is_gap(2 * i));
    EXPECT_TRUE(CircularFamily::is_upper(envelope.branch(2 * i + 1)));
    EXPECT_EQ(envelope.at(2 * i).size(), 2U);  // both halves meet in an extreme
  }
}

TEST(Envelope, HidesOverlapsAtNoCost) {
  // Named one by one, the members of the nested segments would be eight million.
  LinearScene scene;
  constexpr int count = 4000;
  for (int i = 0; i < count; ++i) scene.family.add_segment(scene.list, Point2{-1.0 - i, 5}, Point2{1.0 + i, 5});
  scene.family.add_segment(scene.list, Point2{-2.0 * count, 0}, Point2{2.0 * count, 0});
  const LinearEnvelope envelope = lower_envelope(scene.family, scene.list, Context());
  EXPECT_EQ(envelope.arc_count(), 1U);
  EXPECT_EQ(envelope.breakpoint_count(), 2U);
}

TEST(Envelope, CanBeCancelled) {
  LinearScene scene;
  for (int i = 0; i < 1000; ++i) scene.family.add_segment(scene.list, Point2{-1.0 - i, 5}, Point2{1.0 + i, 6});
  Context context;
  context.cancel();
  EXPECT_THROW(lower_envelope(scene.family, scene.list, context), Cancelled);
}

}  // namespace
}  // namespace quoin
