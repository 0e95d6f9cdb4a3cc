// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/arrangement_text.h"

#include <gtest/gtest.h>

#include <random>
#include <sstream>
#include <string>

#include "quoin/arrangement/geodesic/test_geodesics.h"
#include "quoin/arrangement/linear/linear_editing.h"
#include "quoin/base/error.h"

namespace quoin {
namespace {

using Random = std::mt19937;

const Context context({.threads = 1});

template <class What>
std::string text_of(const What& what, std::span<const std::string> names = {}) {
  std::ostringstream out;
  write_arrangement_text(out, what, names);
  return out.str();
}

AnyArrangementText read(const std::string& text) {
  return read_arrangement_text(text, "a.qarr", context);
}

std::string rewritten(const AnyArrangementText& any) {
  return std::visit(
      [](const auto& read) {
        return read.members ? text_of(*read.set(), read.names) : text_of(read.arrangement, read.names);
      },
      any);
}

void expect_same_counts(const dcel::Counts& a, const dcel::Counts& b) {
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.isolated_vertices, b.isolated_vertices);
  EXPECT_EQ(a.edges, b.edges);
  EXPECT_EQ(a.faces, b.faces);
  EXPECT_EQ(a.unbounded_faces, b.unbounded_faces);
}

template <class F>
void expect_round_trip(const Arrangement<F>& a, std::span<const std::string> names = {}) {
  const std::string text = text_of(a, names);
  try {
    const AnyArrangementText any = read(text);
    const auto& back = std::get<ArrangementText<F>>(any);
    expect_same_counts(back.arrangement.counts(), a.counts());
    EXPECT_EQ(back.arrangement.counts().boundaries, a.counts().boundaries);
    EXPECT_EQ(back.arrangement.counts().components, a.counts().components);
    EXPECT_EQ(back.arrangement.curve_count(), a.curve_count());
    EXPECT_TRUE(std::ranges::equal(back.names, names));
    EXPECT_NO_THROW(dcel::check_links(back.arrangement.cells()));
    ASSERT_EQ(rewritten(any), text);
  } catch (const InputError& error) {
    FAIL() << error.what() << "\n" << text;
  }
}

/// A set with members drawn at random.
template <class F>
PolygonSet<F> random_set(Random& random, const Arrangement<F>& a) {
  const auto bits = [&]<class Id>(std::size_t count, Id) {
    const auto weight = 1 + random() % 4;
    std::vector<bool> result(count);
    for (std::size_t i = 0; i < count; ++i) result[i] = a.cells().is_real(Id(i)) && random() % weight == 0;
    return result;
  };
  std::vector<bool> vertices = bits(a.vertex_count(), dcel::VertexId());
  std::vector<bool> edges = bits(a.edge_count(), dcel::EdgeId());
  return PolygonSet<F>(a, std::move(vertices), std::move(edges), bits(a.face_count(), dcel::FaceId()));
}

template <class F>
void expect_set_round_trip(const PolygonSet<F>& set) {
  const std::string text = text_of(set);
  try {
    const AnyArrangementText any = read(text);
    const auto& back = std::get<ArrangementText<F>>(any);
    ASSERT_TRUE(back.members.has_value());
    const PolygonSet<F> again = *back.set();
    // A set that lost its last ray keeps the frame at infinity, which counts as a component until it is built anew.
    expect_same_counts(again.arrangement().counts(), set.arrangement().counts());
    EXPECT_EQ(again.is_regular(), set.is_regular());
    ASSERT_EQ(text_of(again), text);
    const PolygonSet<F>* both[] = {&set, &again};
    EXPECT_TRUE(combine<F>(both, SetOperation::symmetric_difference, Regularity::plain, context).is_empty()) << text;
  } catch (const InputError& error) {
    FAIL() << error.what() << "\n" << text;
  }
}

/// Coordinates that coincide often, or any.
double coordinate(Random& random, bool is_coarse) {
  if (is_coarse) return static_cast<double>(random() % 7) - 3;
  return std::ldexp(static_cast<double>(random()) - 0x1p31, -static_cast<int>(random() % 40));
}
Point2 some_point(Random& random, bool is_coarse) {
  const double x = coordinate(random, is_coarse);
  return {x, coordinate(random, is_coarse)};
}
RationalPoint2 rational_point(Random& random) {
  const auto number = [&] {
    return Rational(Integer(static_cast<int>(random() % 13) - 6), Integer(1 + static_cast<int>(random() % 4)));
  };
  const Rational x = number();
  return {x, number()};
}

LinearArrangement random_lines(Random& random, bool is_coarse, bool has_rationals) {
  LinearFamily family;
  PieceList<LinearFamily> list;
  const std::size_t count = random() % 9;
  while (list.curve_count < count) {
    const Point2 a = some_point(random, is_coarse);
    const Point2 b = some_point(random, is_coarse);
    if (a == b) continue;
    switch (random() % 6) {
      case 0:
        family.add_ray(list, a, b);
        break;
      case 1:
        family.add_line(list, a, b, "line");
        break;
      case 2:
        family.add_point(list, a);
        break;
      case 3: {
        const RationalPoint2 p = rational_point(random);
        const RationalPoint2 q = rational_point(random);
        if (has_rationals && !(p == q)) family.add_segment(list, p, q);
        break;
      }
      default:
        family.add_segment(list, a, b);
    }
  }
  return arrange(std::move(family), list, context);
}

CircularArrangement random_circles(Random& random, bool is_coarse, bool has_rationals) {
  CircularFamily family;
  PieceList<CircularFamily> list;
  const std::size_t count = random() % 8;
  while (list.curve_count < count) {
    const Point2 a = some_point(random, is_coarse);
    const Point2 b = some_point(random, is_coarse);
    if (a == b) continue;
    switch (random() % 6) {
      case 0:
        family.add_segment(list, a, b);
        break;
      case 1:
        family.add_point(list, a);
        break;
      case 2:
        if (has_rationals) family.add_bulge_arc(list, a, b, 0.25 * (static_cast<double>(random() % 17) - 8));
        break;
      case 3: {
        const RationalPoint2 p = rational_point(random);
        if (has_rationals)
          family.add_circle(list, RationalCircle{p.x, p.y, Rational(1 + static_cast<int>(random() % 6))});
        break;
      }
      default:  // touch often
        family.add_circle(list, a, is_coarse ? 1 + static_cast<double>(random() % 3) : std::fabs(b.x) + 1);
    }
  }
  return arrange(std::move(family), list, context);
}

GeodesicArrangement random_geodesics(test_geodesics::Directions& directions) {
  using test_geodesics::Triple;
  GeodesicFamily family;
  PieceList<GeodesicFamily> list;
  std::vector<Triple> few;
  for (int i = 0; i < 5; ++i) few.push_back(directions.next());
  const std::size_t count = directions.below(9);
  while (list.curve_count < count) {
    const Triple& s = few[directions.below(few.size())];
    const Triple& t = few[directions.below(few.size())];
    const Triple normal = test_geodesics::cross_product(s, t);
    if (directions.below(6) == 0) family.add_point(list, s);
    if (test_geodesics::is_zero(normal)) continue;
    switch (directions.below(5)) {
      case 0:
        family.add_great_circle(list, normal);
        break;
      case 1:
        family.add_arc(list, s, s, normal);
        break;
      case 2:
        family.add_arc(list, s, t, test_geodesics::opposite(normal));
        break;
      default:
        family.add_arc(list, s, t, normal);
    }
  }
  return arrange(std::move(family), list, context);
}

TEST(ArrangementText, LinearRoundTrips) {
  for (unsigned seed = 0; seed < 3000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    expect_round_trip(random_lines(random, seed % 3 != 0, seed % 2 == 0));
    if (HasFailure()) return;
  }
}

TEST(ArrangementText, CircularRoundTrips) {
  for (unsigned seed = 0; seed < 3000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    expect_round_trip(random_circles(random, seed % 3 != 0, seed % 2 == 0));
    if (HasFailure()) return;
  }
}

TEST(ArrangementText, GeodesicRoundTrips) {
  for (const auto draw : test_geodesics::all_draws) {
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
      SCOPED_TRACE(test_geodesics::named(draw, seed));
      test_geodesics::Directions directions(draw, seed);
      expect_round_trip(random_geodesics(directions));
      if (HasFailure()) return;
    }
  }
}

TEST(ArrangementText, SetsRoundTrip) {
  for (unsigned seed = 0; seed < 1500; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    expect_set_round_trip(random_set(random, random_lines(random, seed % 3 != 0, seed % 2 == 0)));
    if (HasFailure()) return;
    expect_set_round_trip(random_set(random, random_circles(random, seed % 3 != 0, seed % 2 == 0)));
    if (HasFailure()) return;
    test_geodesics::Directions directions(test_geodesics::all_draws[seed % 7], seed);
    expect_set_round_trip(random_set(random, random_geodesics(directions)));
    if (HasFailure()) return;
  }
  expect_set_round_trip(LinearPolygonSet());
  expect_set_round_trip(CircularPolygonSet().complement());
  expect_set_round_trip(GeodesicPolygonSet().complement());
}

// What edits leave behind is written as if it had been built anew.
TEST(ArrangementText, EditedArrangementsAreInOrder) {
  for (unsigned seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    LinearArrangement a = random_lines(random, true, false);
    for (int step = 0; step < 4; ++step) {
      if (a.curve_count() > 0 && random() % 3 == 0) {
        remove_curve(a, CurveId(random() % a.curve_count()));
      } else {
        LinearFamily family;
        PieceList<LinearFamily> list;
        const Point2 p = some_point(random, true);
        const Point2 q = some_point(random, true);
        if (p == q) continue;
        if (random() % 2 == 0) {
          family.add_segment(list, p, q);
        } else {
          family.add_ray(list, p, q);
        }
        insert(a, family, list, context);
      }
      expect_round_trip(a);
      LinearArrangement again = a;
      renumber(again, context);
      EXPECT_EQ(text_of(again), text_of(a));
      if (HasFailure()) return;
    }
  }
}

/// Every prefix, and bytes changed: refused, or read as what is written the same again.
void check_damage(const std::string& text, unsigned seed) {
  const auto try_it = [](const std::string& damaged) {
    try {
      const std::string once = rewritten(read(damaged));
      EXPECT_EQ(rewritten(read(once)), once) << damaged;
    } catch (const InputError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with("a.qarr:")) << error.what() << "\n" << damaged;
    }
  };
  for (std::size_t size = 0; size + 1 < text.size(); ++size) {
    if (text.compare(size, std::string::npos, "\n") == 0) continue;
    EXPECT_THROW(read(text.substr(0, size)), InputError) << size;
  }
  Random random(seed);
  const std::string likely = "0123456789 -+/.e\n:";
  for (std::size_t at = 0; at < text.size(); ++at) {
    std::string damaged = text;
    damaged[at] = random() % 4 == 0 ? static_cast<char>(random()) : likely[random() % likely.size()];
    try_it(damaged);
  }
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  for (std::size_t skipped = 0; skipped < lines.size(); ++skipped) {  // a line gone, a line twice
    std::string without;
    std::string twice;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (i != skipped) without += lines[i] + "\n";
      twice += lines[i] + "\n" + (i == skipped ? lines[i] + "\n" : "");
    }
    EXPECT_THROW(read(without), InputError) << lines[skipped];
    try_it(twice);
  }
}

TEST(ArrangementText, DamagedTextsAreRefused) {
  for (unsigned seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    check_damage(text_of(random_lines(random, true, true)), seed);
    check_damage(text_of(random_set(random, random_circles(random, true, true))), seed);
    test_geodesics::Directions directions(test_geodesics::Draw::tiny, seed);
    check_damage(text_of(random_set(random, random_geodesics(directions))), seed);
  }
}

}  // namespace
}  // namespace quoin
