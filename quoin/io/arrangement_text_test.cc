// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/arrangement_text.h"

#include <gtest/gtest.h>

#include <bit>
#include <random>
#include <sstream>
#include <string>

#include "quoin/arrangement/linear_editing.h"
#include "quoin/arrangement/test_geodesics.h"
#include "quoin/base/error.h"
#include "quoin/io/exact_words.h"

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

TEST(ExactWords, NumbersReadBack) {
  Random random(3);
  const auto check = [](double value) {
    const io::ExactNumber back = io::parse_exact(io::exact_word(value));
    ASSERT_TRUE(back.value.has_value()) << io::exact_word(value);
    ASSERT_EQ(*back.value, value) << io::exact_word(value);
  };
  for (const double value : {0.0, -0.0, 1.0, -1.0, 0.1, 1e15, 1e16, 0x1p53, 0x1p53 + 2, 0x1p60, 1e22,
                             123456789012345680000.0, 0x1p1023, 5e-324, -1e-310}) {
    check(value);
  }
  for (int i = 0; i < 20000; ++i) {
    const double value = std::bit_cast<double>((static_cast<std::uint64_t>(random()) << 32) | random());
    if (std::isfinite(value)) check(value);
  }
  for (int i = 0; i < 5000; ++i) {
    Integer p(static_cast<int>(random() % 2000) - 1000);
    for (auto k = random() % 5; k > 0; --k) p = p * Integer(static_cast<int>(random() % 100000) + 1);
    const Rational value(p, Integer(1 + static_cast<int>(random() % 40)));
    ASSERT_EQ(io::parse_exact(io::exact_word(value)).rational(), value) << value.to_string();
  }
  EXPECT_EQ(io::exact_word(Rational(Integer(1), Integer(3))), "1/3");
  EXPECT_EQ(io::exact_word(Rational(Integer(1), Integer(4))), "0.25");
  for (const char* word :
       {"", "nan", "inf", "1/0", "1e999", "1/", "--1", "1.5/2", "0x10", "1e", "99999999999999999x"}) {
    EXPECT_THROW(io::parse_exact(word), InputError) << word;
  }
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

LinearArrangement cross_and_ray(std::vector<std::string>& names) {
  LinearFamily family;
  PieceList<LinearFamily> list;
  family.add_segment(list, Point2{0, 0}, Point2{3, 1});
  family.add_segment(list, Point2{0, 1}, Point2{3, 0.5});
  family.add_ray(list, {1, 5}, {1, 6});
  family.add_point(list, {-1, 0.1});
  names = {"a b", "50%#", "", "\xC3\xA4"};
  return arrange(std::move(family), list, context);
}

TEST(ArrangementText, IsReadable) {
  std::vector<std::string> names;
  const LinearArrangement a = cross_and_ray(names);
  expect_round_trip(a, names);
  EXPECT_EQ(text_of(a, names),
            "quoin-arrangement 1 linear\n"
            "curves 4\nnames yes\nname a%20b\nname 50%25%23\nname \nname \xC3\xA4\n"
            "supports 3\nline 0 0 3 1\nline 0 1 3 0.5\nline 1 5 1 6\n"
            "vertices 8\npoint -1 0.1\npoint 0 0\npoint 0 1\npoint 1 5\nlast 2\ncrossing 0 1\npoint 3 0.5\npoint 3 1\n"
            "edges 5\nedge 0 1 5 +0\nedge 1 2 5 +1\nedge 2 3 4 +2\nedge 1 5 6 +1\nedge 0 5 7 +0\n"
            "faces 1\nmembers none\nend\n");
  std::vector<std::string> few(2);
  EXPECT_THROW(text_of(a, few), InputError);
}

std::string changed(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

void expect_refused(const std::string& text, const std::string& message) {
  try {
    read(text);
    FAIL() << "read without complaint; expected " << message;
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).substr(0, message.size()), message);
  }
}

TEST(ArrangementText, WrongLinesAreNamed) {
  std::vector<std::string> names;
  const std::string text = text_of(cross_and_ray(names));
  EXPECT_NO_THROW(read(text + "# a remark\n"));
  expect_refused("", "a.qarr:0: ");
  expect_refused(changed(text, " 1 linear", " 2 linear"), "a.qarr:1: this version");
  expect_refused(changed(text, "linear", "cubic"), "a.qarr:1: 'cubic' is no family");
  expect_refused(changed(text, "curves 4", "curves 4294967297"), "a.qarr:2: index 4294967297 is out of range");
  expect_refused(changed(text, "line 0 0 3 1", "line 0 0 0 0"), "a.qarr:5: line: its two points are equal");
  expect_refused(changed(text, "line 0 0 3 1", "line 0 nan 3 1"), "a.qarr:5: 'nan' is not a finite number");
  expect_refused(changed(text, "line 0 0 3 1", "circle 0 0 3 1"), "a.qarr:5: 'line' should stand here");
  expect_refused(changed(text, "vertices 8", "vertices 999999999"), "a.qarr:8: this count does not fit");
  expect_refused(changed(text, "crossing 0 1", "crossing 0 0"), "a.qarr:14: these lines are parallel");
  expect_refused(changed(text, "crossing 0 1", "crossing 0 7"), "a.qarr:14: index 7 is out of range");
  expect_refused(changed(text, "point 3 1\n", "point 3 2\n"), "a.qarr:22: its right end does not lie on it");
  expect_refused(changed(text, "edge 0 1 5 +0", "edge 0 5 1 +0"), "a.qarr:18: its left end is not before");
  expect_refused(changed(text, "edge 0 1 5 +0", "edge 0 1 5 0"), "a.qarr:18: '0' is no curve with a sign");
  expect_refused(changed(text, "edge 0 1 5 +0", "edge 0 1 5 +4"), "a.qarr:18: index 4 is out of range");
  expect_refused(changed(text, "edge 0 1 5 +0", "edge 0 1 5 +1 +0"), "a.qarr:18: its curves are not in order");
  expect_refused(changed(text, "point 0 1\n", "point 0 0\n"), "a.qarr:19: its left end does not lie on it");
  expect_refused(changed(text, "point -1 0.1\n", "point 2 1\n"),
                 "a.qarr:10: vertex 1 is out of order: it lies before vertex 0");
  expect_refused(changed(text, "point -1 0.1\n", "point 0 0\n"), "a.qarr:10: vertex 0 and vertex 1 are the same point");
  expect_refused(changed(text, "point -1 0.1\n", "last 1\n"), "a.qarr:9: no edge ends at this end of a line");
  expect_refused(changed(text, "faces 1", "faces 2"), "a.qarr:23: the edges make 1 faces");
  expect_refused(text + "more\n", "a.qarr:26: nothing should follow 'end'");
  expect_refused(text + text, "a.qarr:26: nothing should follow 'end'");
}

TEST(ArrangementText, EdgesThatMeetAreNamed) {
  const std::string head = "quoin-arrangement 1 linear\ncurves 2\nnames no\nsupports 2\n";
  expect_refused(head +
                     "line 0 0 2 2\nline 0 2 2 0\nvertices 4\npoint 0 0\npoint 0 2\npoint 2 0\npoint 2 2\nedges 2\n"
                     "edge 0 0 3 +0\nedge 1 1 2 +1\nfaces 1\nmembers none\nend\n",
                 "a.qarr:14: edge 0 and edge 1 meet where no vertex is");
  expect_refused(head +
                     "line 0 0 2 2\nline 1 1 2 0\nvertices 4\npoint 0 0\npoint 1 1\npoint 2 0\npoint 2 2\nedges 2\n"
                     "edge 0 0 3 +0\nedge 1 1 2 +1\nfaces 1\nmembers none\nend\n",
                 "a.qarr:13: edge 0 passes through vertex 1");
  expect_refused(head +
                     "line 0 0 2 2\nline 1 1 2 2\nvertices 2\npoint 0 0\npoint 2 2\nedges 2\n"
                     "edge 0 0 1 +0\nedge 1 0 1 +1\nfaces 1\nmembers none\nend\n",
                 "a.qarr:1");
  expect_refused(head +
                     "line 0 0 2 2\nline 0 0 2 0\nvertices 3\npoint 0 0\npoint 2 0\npoint 2 2\nedges 2\n"
                     "edge 0 0 2 +0\nedge 1 0 1 +1\nfaces 1\nmembers none\nend\n",
                 "a.qarr:13: edge 1 is not where its order is");
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
