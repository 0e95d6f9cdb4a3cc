// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/circular/circular_family.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "quoin/arrangement/circular/circular_exact.h"
#include "quoin/arrangement/circular/circular_oracle.h"
#include "quoin/arrangement/family_suite.h"
#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"

namespace quoin {
namespace {

using Random = std::mt19937_64;
using testing::CircularOracle;
using testing::FamilyCases;
using testing::LongPoint;
using testing::LongReal;

int pick(Random& random, int low, int high) {
  return low + static_cast<int>(random() % static_cast<std::uint64_t>(high - low + 1));
}

/// A family with one list of curves, the same curves backwards, and what reproduces them.
struct Scene {
  CircularFamily family;
  CircularFamily::Pieces list;
  CircularFamily::Pieces backwards;
  std::ostringstream log;

  void circle(const Point2& centre, double radius) {
    log << "circle " << centre.x << ' ' << centre.y << ' ' << radius << '\n';
    family.add_circle(list, centre, radius);
    family.add_circle(backwards, centre, radius);
    for (std::size_t i = backwards.pieces.size() - 2; i < backwards.pieces.size(); ++i) {
      backwards.pieces[i].reversed = !backwards.pieces[i].reversed;  // a circle has one direction
    }
  }
  void circle(const RationalCircle& c) {
    log << "circle " << c.x.to_string() << ' ' << c.y.to_string() << " r2 " << c.squared_radius.to_string() << '\n';
    family.add_circle(list, c);
    family.add_circle(backwards, c);
    for (std::size_t i = backwards.pieces.size() - 2; i < backwards.pieces.size(); ++i) {
      backwards.pieces[i].reversed = !backwards.pieces[i].reversed;
    }
  }
  void segment(const Point2& a, const Point2& b) {
    if (a == b) return;
    log << "segment " << a.x << ' ' << a.y << ' ' << b.x << ' ' << b.y << '\n';
    family.add_segment(list, a, b);
    family.add_segment(backwards, b, a);
  }
  void segment(const RationalPoint2& a, const RationalPoint2& b) {
    if (a == b) return;
    log << "segment " << a.x.to_string() << ' ' << a.y.to_string() << ' ' << b.x.to_string() << ' ' << b.y.to_string()
        << '\n';
    family.add_segment(list, a, b);
    family.add_segment(backwards, b, a);
  }
  void arc(const RationalCircle& c, const Point2& a, const Point2& b) {
    if (a == b) return;
    log << "arc " << c.x.to_string() << ' ' << c.y.to_string() << " r2 " << c.squared_radius.to_string() << " from "
        << a.x << ' ' << a.y << " to " << b.x << ' ' << b.y << '\n';
    const RationalPoint2 from{a.x, a.y};
    const RationalPoint2 to{b.x, b.y};
    family.add_arc(list, c, from, to, CircularFamily::Direction::counterclockwise);
    family.add_arc(backwards, c, to, from, CircularFamily::Direction::clockwise);
  }
  void bulge(const Point2& a, const Point2& b, double bulge) {
    if (a == b) return;
    log << "bulge " << a.x << ' ' << a.y << ' ' << b.x << ' ' << b.y << ' ' << bulge << '\n';
    family.add_bulge_arc(list, a, b, bulge);
    family.add_bulge_arc(backwards, b, a, -bulge);
  }
};

/// All predicates against the oracle.
class Checker {
 public:
  explicit Checker(const Scene& scene) : family_(scene.family), list_(scene.list), oracle_(scene.family) {
    for (const CircularPoint& p : list_.points) add(p);
    for (std::size_t i = 0; i < list_.pieces.size(); ++i) {
      for (std::size_t j = i + 1; j < list_.pieces.size(); ++j) add_crossings(list_.pieces[i], list_.pieces[j]);
    }
  }

  void check() {
    check_positions();
    check_order();
    check_beside();
  }

 private:
  void add(const CircularPoint& p) {
    points_.push_back(p);
    truth_.push_back(oracle_.point(p));
  }

  void add_crossings(const Piece& a, const Piece& b) {
    const CircularSupportId one = CircularFamily::support(a.branch);
    const CircularSupportId two = CircularFamily::support(b.branch);
    if (one == two) return;
    CircularPoint found[2];
    LongPoint expected[2];
    const int count = family_.crossings(one, two, found);
    const int expected_count =
        oracle_.meet(static_cast<std::uint32_t>(one.index()), static_cast<std::uint32_t>(two.index()), expected);
    ASSERT_EQ(count, expected_count) << "crossings of " << one.index() << " and " << two.index();
    if (a.curve == b.curve) return;
    for (int i = 0; i < count; ++i) {
      if (points_.size() > 40) return;
      add(found[i]);
    }
  }

  void check_positions() {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Point2 position = family_.position(points_[i]);
      const bool far = std::isnan(points_[i].x);
      const double bound = far ? 0x1p-46 * (std::fabs(position.x) + std::fabs(position.y)) : family_.error();
      ASSERT_LE(std::fabs((truth_[i].x - LongReal(position.x)).to_double()), bound);
      ASSERT_LE(std::fabs((truth_[i].y - LongReal(position.y)).to_double()), bound);
      if (points_[i].exact_x) {
        ASSERT_EQ((truth_[i].x - LongReal(position.x)).sign(), Sign::zero);
      }
      if (points_[i].exact_y) {
        ASSERT_EQ((truth_[i].y - LongReal(position.y)).sign(), Sign::zero);
      }
    }
  }

  void check_order() {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      for (std::size_t j = 0; j < points_.size(); ++j) {
        ASSERT_EQ(family_.compare_xy(points_[i], points_[j]), testing::compare_lexicographically(truth_[i], truth_[j]))
            << "points " << i << " and " << j;
        ASSERT_EQ(family_.compare_x(points_[i], points_[j]), (truth_[i].x - truth_[j].x).sign());
      }
    }
  }

  void check_beside() {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      std::vector<BranchId> through;
      for (const Piece& piece : list_.pieces) {
        if (!oracle_.is_in_range(piece.branch, truth_[i].x)) continue;
        if (family_.is_vertical(piece.branch)) {
          through.push_back(piece.branch);
          continue;
        }
        const Sign expected = (truth_[i].y - oracle_.y_at(piece.branch, truth_[i].x)).sign();
        ASSERT_EQ(family_.compare_y_at_x(points_[i], piece.branch), expected)
            << "point " << i << " branch " << piece.branch.index();
        if (expected == Sign::zero) through.push_back(piece.branch);
      }
      for (const int side : {1, -1}) check_beside(i, through, side);
    }
  }

  void check_beside(std::size_t i, const std::vector<BranchId>& through, int side) {
    const LongReal step = LongReal::power_of_two(-450);
    const LongReal x = side > 0 ? truth_[i].x + step : truth_[i].x - step;
    for (const BranchId a : through) {
      for (const BranchId b : through) {
        if (!family_.is_vertical(a) && !oracle_.is_in_range(a, x)) continue;
        if (!family_.is_vertical(b) && !oracle_.is_in_range(b, x)) continue;
        const Sign expected = oracle_.order_beside(a, b, truth_[i], side);
        const Sign found = side > 0 ? family_.compare_right(a, b, points_[i]) : family_.compare_left(a, b, points_[i]);
        ASSERT_EQ(found, expected) << "point " << i << " branches " << a.index() << " and " << b.index() << " side "
                                   << side;
        ASSERT_EQ(family_.same_branch(a, b), expected == Sign::zero);
      }
    }
  }

  const CircularFamily& family_;
  const CircularFamily::Pieces& list_;
  CircularOracle oracle_;
  std::vector<CircularPoint> points_;
  std::vector<LongPoint> truth_;
};

/// How the numbers of a scene are placed.
struct Placement {
  double scale = 1;
  double x = 0;
  double y = 0;
  Point2 operator()(double px, double py) const { return {x + scale * px, y + scale * py}; }
};

/// Circles and segments of small integers, many of them tangent, concentric, equal, with points in common.
void add_tiny(Scene& scene, Random& random, const Placement& place) {
  for (int i = pick(random, 2, 4); i > 0; --i) {
    scene.circle(place(pick(random, 0, 6), pick(random, 0, 6)), place.scale * pick(random, 1, 5));
  }
  for (int i = pick(random, 1, 4); i > 0; --i) {
    const int x = pick(random, -1, 8);
    const int end_x = random() % 3 == 0 ? x : pick(random, -1, 8);
    scene.segment(place(x, pick(random, -1, 8)), place(end_x, pick(random, -1, 8)));
  }
}

/// Circles around lattice points through lattice points, and arcs between such.
void add_lattice(Scene& scene, Random& random, const Placement& place) {
  static const int squares[] = {1, 2, 4, 5, 8, 9, 10, 13, 25, 50, 65};
  for (int i = pick(random, 2, 4); i > 0; --i) {
    const int cx = pick(random, 0, 6);
    const int cy = pick(random, 0, 6);
    const int square = squares[random() % 11];
    std::vector<Point2> on;
    for (int dx = -9; dx <= 9; ++dx) {
      for (int dy = -9; dy <= 9; ++dy) {
        if (dx * dx + dy * dy == square) on.push_back(place(cx + dx, cy + dy));
      }
    }
    const Point2 centre = place(cx, cy);
    const RationalCircle circle{centre.x, centre.y, Rational(place.scale) * Rational(place.scale) * Rational(square)};
    if (random() % 3 == 0) scene.circle(circle);
    for (int arcs = pick(random, 1, 2); arcs > 0; --arcs) {
      scene.arc(circle, on[random() % on.size()], on[random() % on.size()]);
    }
    if (random() % 2 == 0) scene.segment(on[random() % on.size()], place(pick(random, -1, 8), pick(random, -1, 8)));
  }
}

/// Right triangles 3, 4, 5 and 5, 12, 13: touching circles in general directions.
void add_pythagorean(Scene& scene, Random& random, const Placement& place) {
  static const int triples[][3] = {{3, 4, 5}, {4, 3, 5}, {5, 12, 13}, {12, 5, 13}, {6, 8, 10}, {0, 5, 5}, {5, 0, 5}};
  int x = 0;
  int y = 0;
  int radius = pick(random, 1, 12);
  scene.circle(place(x, y), place.scale * radius);
  for (int i = pick(random, 2, 4); i > 0; --i) {
    const int* triple = triples[random() % 7];
    const int before = radius;
    radius = random() % 2 == 0 ? std::max(1, std::abs(triple[2] - before)) : before + triple[2];
    x += random() % 2 == 0 ? triple[0] : -triple[0];
    y += random() % 2 == 0 ? triple[1] : -triple[1];
    scene.circle(place(x, y), place.scale * radius);
    // Touches the circle of radius triple[2].
    scene.segment(place(x + triple[0] - 2 * triple[1], y + triple[1] + 2 * triple[0]),
                  place(x + triple[0] + 2 * triple[1], y + triple[1] - 2 * triple[0]));
    if (random() % 2 == 0) scene.circle(place(x, y), place.scale * triple[2]);
  }
}

void add_random(Scene& scene, Random& random, const Placement& place) {
  std::uniform_real_distribution<double> real(0, 8);
  for (int i = pick(random, 2, 4); i > 0; --i)
    scene.circle(place(real(random), real(random)), place.scale * real(random));
  for (int i = pick(random, 1, 3); i > 0; --i) {
    scene.segment(place(real(random), real(random)), place(real(random), real(random)));
  }
}

void add_rational(Scene& scene, Random& random, const Placement& /*place*/) {
  const auto third = [&](int low, int high) { return Rational(Integer(pick(random, low, high)), Integer(3)); };
  for (int i = pick(random, 2, 3); i > 0; --i) {
    scene.circle(
        {third(0, 15), third(0, 15), Rational(Integer(pick(random, 1, 60)), Integer(random() % 2 == 0 ? 9 : 7))});
  }
  for (int i = pick(random, 1, 3); i > 0; --i) {
    scene.segment(RationalPoint2{third(0, 15), third(0, 15)}, RationalPoint2{third(0, 15), third(0, 15)});
  }
}

void add_bulges(Scene& scene, Random& random, const Placement& place) {
  static const double bulges[] = {1, -1, 0.5, -0.5, 0.25, 2, -3, 0, 0.3, 0.4142135623730951, 1e-3};
  for (int i = pick(random, 2, 4); i > 0; --i) {
    const Point2 from = place(pick(random, 0, 4), pick(random, 0, 4));
    const Point2 to = place(pick(random, 0, 4), pick(random, 0, 4));
    const double bulge = bulges[random() % 11];
    scene.bulge(from, to, bulge);
    if (random() % 3 == 0) scene.bulge(to, from, random() % 2 == 0 ? -bulge : bulge);
  }
}

/// Moved by a few units in the last place.
double nudged(Random& random, double value) {
  for (int i = pick(random, -3, 3); i != 0; i += i < 0 ? 1 : -1) {
    value = std::nextafter(value, i < 0 ? -1e300 : 1e300);
  }
  return value;
}

/// Circles and lines that nearly touch, nearly coincide, or nearly pass through one point.
void add_near(Scene& scene, Random& random, const Placement& place) {
  std::uniform_real_distribution<double> real(0, 4);
  const Point2 c = place(real(random), real(random));
  const double r = place.scale * (0.25 + real(random));
  const double angle = 1.6 * real(random);
  const Point2 n{std::cos(angle), std::sin(angle)};
  const auto circle = [&](double x, double y, double radius) {
    if (radius <= 0) return;
    const Point2 centre{nudged(random, x), nudged(random, y)};
    if (random() % 3 != 0) return scene.circle(centre, nudged(random, radius));
    const Rational third(Integer(1), Integer(3));
    const Rational size(radius);
    scene.circle({Rational(centre.x) + third * Rational(std::ldexp(centre.x, -52)), centre.y,
                  size * size * (Rational(1) + third * Rational(0x1p-52))});
  };
  scene.circle(c, r);
  for (int i = pick(random, 2, 3); i > 0; --i) {
    const double s =
        random() % 3 == 0 ? r * std::ldexp(1.0, pick(random, -12, 4)) : place.scale * (0.25 + real(random));
    switch (random() % 5) {
      case 0:
        circle(c.x + (r + s) * n.x, c.y + (r + s) * n.y, s);
        break;
      case 1:
        circle(c.x + (r - s) * n.x, c.y + (r - s) * n.y, s);
        break;
      case 2:
        circle(c.x, c.y, r);
        break;
      case 3: {
        const double turn = 1.6 * real(random);
        circle(c.x + r * n.x + s * std::cos(turn), c.y + r * n.y + s * std::sin(turn), s);
        break;
      }
      default:
        scene.segment(Point2{nudged(random, c.x + r * n.x - s * n.y), nudged(random, c.y + r * n.y + s * n.x)},
                      Point2{nudged(random, c.x + r * n.x + s * n.y), nudged(random, c.y + r * n.y - s * n.x)});
    }
  }
}

using Generator = void (*)(Scene&, Random&, const Placement&);

void check_scenes(const std::vector<Generator>& generators, const std::function<Placement(Random&)>& placement,
                  std::uint64_t seed, int count, FamilyCases* cases) {
  Random random(seed);
  CircularFamily previous;
  for (int i = 0; i < test_rounds(count); ++i) {
    Scene scene;
    scene.log.precision(17);
    const Placement place = placement(random);
    for (const Generator generator : generators) generator(scene, random, place);
    SCOPED_TRACE("scene " + std::to_string(i) + ":\n" + scene.log.str());
    Checker checker(scene);
    checker.check();
    testing::check_family_laws(scene.family, scene.list, cases, &previous);
    previous = scene.family;
    testing::check_reversed(scene.family, scene.list, scene.backwards);
    if (::testing::Test::HasFailure()) return;
  }
}

Placement unplaced(Random& /*random*/) {
  return {};
}

TEST(CircularFamily, TinyIntegers) {
  FamilyCases cases;
  check_scenes({add_tiny}, unplaced, 1, 150, &cases);
  EXPECT_GE(cases.touching, test_cases(100U));
  EXPECT_GE(cases.vertical, test_cases(100U));
  EXPECT_GE(cases.overlapping, test_cases(5U));
  EXPECT_GE(cases.common_end, test_cases(100U));
  EXPECT_GE(cases.multiple, test_cases(50U));
  EXPECT_GE(cases.reversed, test_cases(100U));
  EXPECT_GE(cases.met_by_sweep, test_cases(100U));
}

TEST(CircularFamily, CirclesAndArcsThroughLatticePoints) {
  FamilyCases cases;
  check_scenes({add_lattice}, unplaced, 2, 100, &cases);
  EXPECT_GE(cases.overlapping, test_cases(5U));
  EXPECT_GE(cases.multiple, test_cases(50U));
}

TEST(CircularFamily, TouchingCirclesInGeneralDirections) {
  FamilyCases cases;
  check_scenes({add_pythagorean}, unplaced, 3, 60, &cases);
  EXPECT_GE(cases.touching, test_cases(100U));
}

TEST(CircularFamily, FarFromTheOrigin) {
  const auto far = [](Random& random) {
    return Placement{1, std::ldexp(1.0, pick(random, 20, 40)), -std::ldexp(1.0, pick(random, 20, 40))};
  };
  FamilyCases cases;
  check_scenes({add_tiny, add_lattice}, far, 4, 25, &cases);
  EXPECT_GE(cases.touching, test_cases(20U));
}

TEST(CircularFamily, ScaledByPowersOfTwo) {
  const auto scaled = [](Random& random) { return Placement{std::ldexp(1.0, pick(random, -60, 60)), 0, 0}; };
  FamilyCases cases;
  check_scenes({add_tiny}, scaled, 5, 60, &cases);
  EXPECT_GE(cases.touching, test_cases(20U));
}

TEST(CircularFamily, RandomDoubles) {
  FamilyCases cases;
  check_scenes({add_random}, unplaced, 6, 60, &cases);
  check_scenes({add_random, add_tiny}, unplaced, 7, 20, &cases);
  EXPECT_GE(cases.crossing, test_cases(300U));
}

TEST(CircularFamily, NearlyDegenerateDoubles) {
  const auto anywhere = [](Random& random) {
    const double far = random() % 2 == 0 ? 0 : std::ldexp(1.0, pick(random, 0, 30));
    return Placement{std::ldexp(1.0, pick(random, -10, 10)), far, -far};
  };
  FamilyCases cases;
  check_scenes({add_near}, unplaced, 12, 150, &cases);
  check_scenes({add_near}, anywhere, 13, 60, &cases);
  EXPECT_GE(cases.crossing, test_cases(100U));
}

TEST(CircularFamily, RationalSupports) {
  FamilyCases cases;
  check_scenes({add_rational}, unplaced, 8, 60, &cases);
  check_scenes({add_rational, add_tiny, add_lattice}, unplaced, 9, 15, &cases);
  EXPECT_GE(cases.crossing, test_cases(300U));
}

TEST(CircularFamily, Bulges) {
  FamilyCases cases;
  check_scenes({add_bulges}, unplaced, 10, 80, &cases);
  check_scenes({add_bulges, add_tiny}, unplaced, 11, 15, &cases);
  EXPECT_GE(cases.overlapping, test_cases(5U));
}

}  // namespace
}  // namespace quoin
