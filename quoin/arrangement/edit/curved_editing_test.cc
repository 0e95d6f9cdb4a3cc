// SPDX-License-Identifier: Apache-2.0
// Edits of arrangements of circles and on the sphere.
#include <array>

#include "quoin/arrangement/circular/circular_editing.h"
#include "quoin/arrangement/edit/editing_test_support.h"
#include "quoin/arrangement/geodesic/geodesic_editing.h"
#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"

namespace quoin {
namespace {

using namespace editing_test;

/// A circle, an arc of the axes' circle or a segment, all by small integers.
struct RoundCurve {
  int kind;
  std::array<int, 5> values;
};

std::string text(const RoundCurve& c) {
  std::string all = std::to_string(c.kind) + ":";
  for (const int v : c.values) all += ' ' + std::to_string(v);
  return all + '\n';
}

template <class Curve>
std::string list_text(const std::vector<Curve>& curves) {
  std::string all;
  for (const Curve& c : curves) all += text(c);
  return all;
}

void add(CircularFamily& family, PieceList<CircularFamily>& list, const RoundCurve& c) {
  const auto at = [&](int i) { return static_cast<double>(c.values[static_cast<std::size_t>(i)]); };
  const Point2 a{at(0), at(1)};
  if (c.kind == 0) {
    family.add_circle(list, a, at(2));
  } else if (c.kind == 1) {
    const double turns[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    const auto end = [&](int i) { return Point2{a.x + at(2) * turns[i % 4][0], a.y + at(2) * turns[i % 4][1]}; };
    const int from = c.values[3];
    family.add_arc(
        list, a, at(2), end(from), end(from + 1 + c.values[4] % 3),
        c.values[4] % 2 == 0 ? CircularFamily::Direction::counterclockwise : CircularFamily::Direction::clockwise);
  } else {
    family.add_segment(list, a, Point2{at(2), at(3) == at(1) && at(2) == at(0) ? at(3) + 1 : at(3)});
  }
}

RoundCurve random_curve_of(std::mt19937& random, CircularFamily*) {
  RoundCurve c{static_cast<int>(random() % 3), {}};
  for (int& v : c.values) v = static_cast<int>(random() % 4);
  if (c.kind < 2) c.values[2] = 1 + static_cast<int>(random() % 3);
  return c;
}

/// A great circle by its normal, or an arc between two directions.
struct SphereCurve {
  bool is_circle;
  std::array<int, 3> a;
  std::array<int, 3> b;
};

std::string text(const SphereCurve& c) {
  std::string all = c.is_circle ? "circle" : "arc";
  for (const int v : c.a) all += ' ' + std::to_string(v);
  for (const int v : c.b) all += ' ' + std::to_string(v);
  return all + '\n';
}

SphereDirection direction(const std::array<int, 3>& a) {
  return SphereDirection(Vector3{static_cast<double>(a[0]), static_cast<double>(a[1]), static_cast<double>(a[2])});
}

void add(GeodesicFamily& family, PieceList<GeodesicFamily>& list, const SphereCurve& c) {
  if (c.is_circle) {
    family.add_great_circle(list, direction(c.a));
  } else {
    family.add_arc(list, direction(c.a), direction(c.b));
  }
}

SphereCurve random_curve_of(std::mt19937& random, GeodesicFamily*) {
  SphereCurve c{random() % 4 == 0, {}, {}};
  const auto pick = [&] { return static_cast<int>(random() % 3) - 1; };
  const auto parallel = [&] {
    const auto& [x, y, z] = c.a;
    const auto& [u, v, w] = c.b;
    return y * w == z * v && z * u == x * w && x * v == y * u;
  };
  while (parallel()) {
    for (int& v : c.a) v = pick();
    for (int& v : c.b) v = pick();
  }
  return c;
}

template <CurveFamily F, class Curve>
Arrangement<F> swept_curves(const std::vector<Curve>& curves) {
  F family;
  PieceList<F> list;
  for (const Curve& c : curves) add(family, list, c);
  return arrange(std::move(family), list, Context());
}

/// As for lines: whatever is inserted and removed, what is left is what the sweep makes of the remaining curves.
template <CurveFamily F>
void edit_at_random(unsigned seed, int steps, std::size_t most) {
  std::mt19937 random(seed);
  using Curve = decltype(random_curve_of(random, static_cast<F*>(nullptr)));
  Arrangement<F> arrangement;
  std::vector<Curve> curves;
  std::vector<std::uint32_t> ids;
  for (int step = 0; step < steps; ++step) {
    if (curves.size() < 2 || (curves.size() < most && random() % 2 == 0)) {
      curves.push_back(random_curve_of(random, static_cast<F*>(nullptr)));
      F family;
      PieceList<F> list;
      add(family, list, curves.back());
      InsertOptions<typename F::Point> options;
      if (random() % 8 == 0) options.sweeps_from = 0;
      ids.push_back(insert(arrangement, family, list, Context(), options).value);
    } else {
      const std::size_t gone = random() % curves.size();
      remove_curve(arrangement, CurveId(std::size_t{ids[gone]}));
      curves.erase(curves.begin() + static_cast<std::ptrdiff_t>(gone));
      ids.erase(ids.begin() + static_cast<std::ptrdiff_t>(gone));
    }
    ASSERT_NO_THROW(dcel::check_links(arrangement.cells())) << step << "\n" << list_text(curves);
    if constexpr (F::Surface::has_unbounded_face) {
      ASSERT_EQ(check_outer(arrangement), "") << step << "\n" << list_text(curves);
    }
    Arrangement<F> copy = arrangement;
    renumber(copy, Context());
    std::vector<std::uint32_t> curve_of(arrangement.curve_count(), 0xFFFFFFFU);
    for (std::size_t i = 0; i < ids.size(); ++i) curve_of[ids[i]] = static_cast<std::uint32_t>(i);
    ASSERT_EQ(difference(copy, swept_curves<F>(curves), curve_of), "") << step << "\n" << list_text(curves);
    if (step % 100 == 99) {
      arrangement = Arrangement<F>();
      curves.clear();
      ids.clear();
    }
  }
}

TEST(CurvedEditing, CirclesArcsAndSegments) {
  for (unsigned seed = 61; seed < 64; ++seed)
    edit_at_random<CircularFamily>(seed, test_rounds(1000), 4 + 3 * (seed % 4));
}

TEST(CurvedEditing, ArcsOnTheSphere) {
  for (unsigned seed = 71; seed < 74; ++seed)
    edit_at_random<GeodesicFamily>(seed, test_rounds(1000), 4 + 3 * (seed % 4));
}

TEST(CurvedEditing, SingleEdgesOnTheSphereAreRefused) {
  GeodesicArrangement arrangement;
  ArrangementEditor<GeodesicFamily> editor(arrangement);
  EXPECT_THROW(editor.insert_vertex(GeodesicFamily::Point(), arrangement.cells().base_face), InputError);
}

}  // namespace
}  // namespace quoin
