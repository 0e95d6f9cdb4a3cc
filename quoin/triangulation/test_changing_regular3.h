// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <tuple>
#include <vector>

#include "quoin/kernel/predicates3.h"
#include "quoin/triangulation/canonical_cells.h"
#include "quoin/triangulation/changing_regular3.h"
#include "quoin/triangulation/regular3.h"
#include "quoin/triangulation/test_changing3.h"
#include "quoin/triangulation/test_clouds.h"

/// Regular triangulations of space that change, beside those that do not.
namespace quoin::testing {

inline std::string reproduce(const std::vector<WeightedPoint3>& sites) {
  std::string text;
  char buffer[160];
  for (const auto& [p, weight] : sites) {
    std::snprintf(buffer, sizeof buffer, "{{%a, %a, %a}, %a}, ", p.x, p.y, p.z, weight);
    text += buffer;
  }
  return text;
}

struct SiteWeightFamily {
  const char* name;
  double (*weight)(Random&);
};

/// From those that hide nothing to those that hide nearly all.
inline const std::vector<SiteWeightFamily>& site_weight_families() {
  static const std::vector<SiteWeightFamily> families{
      {"zero", [](Random&) { return 0.0; }},
      {"equal", [](Random&) { return 0.375; }},
      {"integers within 3", [](Random& r) { return small_integer(r, 3); }},
      {"within a quarter", [](Random& r) { return unit(r) / 4; }},
      {"one of three", [](Random& r) { return r() % 3 == 0 ? 2.0 : 0.0; }},
      {"a few ulps about 1", [](Random& r) { return 1 + std::ldexp(small_integer(r, 6), -52); }},
      {"any finite double", [](Random& r) { return any_finite(r); }},
      {"subnormal", [](Random& r) { return small_integer(r, 2) * 0x1p-1074; }},
      {"huge", [](Random& r) { return std::ldexp(small_integer(r, 5), 1020); }}};
  return families;
}

inline std::vector<WeightedPoint3> weighted(const std::vector<Point3>& points, const SiteWeightFamily& family,
                                            Random& random) {
  std::vector<WeightedPoint3> sites;
  for (const Point3& p : points) sites.push_back({p, family.weight(random)});
  return sites;
}

inline std::vector<Point3> points_of(const std::vector<WeightedPoint3>& sites) {
  std::vector<Point3> points;
  for (const WeightedPoint3& site : sites) points.push_back(site.point);
  return points;
}

inline std::vector<double> weights_of(const std::vector<WeightedPoint3>& sites) {
  std::vector<double> weights;
  for (const WeightedPoint3& site : sites) weights.push_back(site.weight);
  return weights;
}

/// Each point, as often as it is there, sorted.
inline std::vector<std::array<double, 4>> listed(const ChangingRegular3& changing) {
  std::vector<std::array<double, 4>> list;
  for (std::uint32_t v = 0; v < changing.id_count(); ++v) {
    const Point3 p = changing.lives(v) ? changing.point(v) : Point3();
    for (std::uint32_t k = 0; k < changing.multiplicity(v); ++k) list.push_back({p.x, p.y, p.z, changing.weight(v)});
  }
  std::ranges::sort(list);
  return list;
}

/// Vertices are of the cells that they know, hidden points in them.
inline void expect_cells_are_known(const ChangingRegular3& changing) {
  for (std::uint32_t v = 0; v < changing.id_count(); ++v) {
    if (!changing.lives(v)) continue;
    const auto& corners = changing.cells()[changing.cell_of(v)].vertices;
    if (!changing.is_hidden(v)) {
      ASSERT_NE(std::ranges::find(corners, v), corners.end());
      continue;
    }
    ASSERT_NE(corners[3], vertex_at_infinity);
    for (const auto& [a, b, c] : facet_slots) {
      const Sign side = orientation(changing.point(corners[a]), changing.point(corners[b]), changing.point(corners[c]),
                                    changing.point(v));
      ASSERT_NE(side, Sign::negative);
    }
  }
  ASSERT_EQ(changing.cells()[changing.cell_of(vertex_at_infinity)].vertices[3], vertex_at_infinity);
}

/// The cells are those of the points, byte by byte, and so are the points that are hidden.
inline void expect_same(const ChangingRegular3& changing, const std::vector<WeightedPoint3>& sites) {
  std::vector<std::array<double, 4>> given;
  for (const auto& [p, weight] : sites) given.push_back({p.x, p.y, p.z, weight});
  std::ranges::sort(given);
  ASSERT_EQ(listed(changing), given);
  if (sites.empty()) {
    ASSERT_EQ(changing.dimension(), -1);
    ASSERT_TRUE(changing.cells().empty() && changing.flat_cells().empty() && changing.line().empty());
    return;
  }
  const Context context({.threads = 1});
  const Regular3 regular(points_of(sites), weights_of(sites), context);
  ASSERT_EQ(changing.dimension(), regular.dimension());
  CellArray expected(regular.cells().begin(), regular.cells().end());
  sort_cells(expected, regular.dimension());
  const NumberedCells numbered = changing.canonical_cells(context);
  ASSERT_TRUE(are_same_cells(numbered.cells, expected));
  ASSERT_EQ(numbered.ids.size(), regular.vertex_count());
  std::size_t shown = 0;
  for (std::uint32_t i = 0; i < numbered.ids.size(); ++i) {
    const std::uint32_t v = numbered.ids[i];
    ASSERT_EQ(changing.point(v), regular.point(i));
    ASSERT_EQ(changing.weight(v), regular.weight(i));
    ASSERT_EQ(changing.is_hidden(v), regular.is_hidden(i));
    shown += regular.is_hidden(i) ? 0 : 1;
  }
  std::size_t hidden = 0;
  for (std::uint32_t v = 0; v < changing.id_count(); ++v) hidden += changing.is_hidden(v) ? 1 : 0;
  ASSERT_EQ(hidden, changing.hidden_count());
  ASSERT_EQ(hidden + shown, changing.vertex_count());
  ASSERT_EQ(changing.dimension() < 2, !changing.line().empty());
  if (changing.dimension() == 3) expect_cells_are_known(changing);
}

}  // namespace quoin::testing
