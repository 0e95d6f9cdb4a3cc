// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/usual_columns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>

#include "quoin/base/error.h"
#include "quoin/io/point_file.h"

namespace quoin {
namespace {

using Kind = io::ColumnPart::Kind;

const Context context;

PointFile read(const std::string& bytes, const std::string& name, bool weights = false) {
  return read_points(bytes, name, {.format = {}, .weights = weights}, context);
}

/// Two points, what each kind of column holds in them, and what follows from it.
struct Sample {
  std::array<const char*, 2> coordinates{"0.5 -2 3", "4 5 6"};
  std::array<const char*, 2> intensity{"-10.5", "300"};
  std::array<const char*, 2> colors{"255 0 7", "0 1 1"};
  std::array<const char*, 2> normals{"0.6 -0.8 0", "0 0 1"};
};

/// Lines of the columns that the letters name: i, c, n.
std::string table(const std::string& order, char separator) {
  const Sample sample;
  std::string text;
  for (std::size_t row = 0; row < 2; ++row) {
    text += sample.coordinates[row];
    for (const char c : order)
      text += std::string(" ") + (c == 'i' ? sample.intensity : c == 'c' ? sample.colors : sample.normals)[row];
    text += "\n";
  }
  std::ranges::replace(text, ' ', separator);
  return text;
}

void expect_kept(const PointFile& file, const std::string& order) {
  const auto has = [&](char c) { return order.find(c) != std::string::npos; };
  EXPECT_EQ(file.points, (std::vector<Point3>{{0.5, -2, 3}, {4, 5, 6}}));
  EXPECT_EQ(file.intensities, has('i') ? std::vector<double>({-10.5, 300}) : std::vector<double>());
  EXPECT_EQ(file.colors, has('c') ? std::vector<Color>({{255, 0, 7}, {0, 1, 1}}) : std::vector<Color>());
  EXPECT_EQ(file.normals, has('n') ? std::vector<Vector3>({{0.6, -0.8, 0}, {0, 0, 1}}) : std::vector<Vector3>());
  EXPECT_EQ(file.report.warnings, std::vector<std::string>());
}

TEST(UsualColumns, EveryOrderIsTold) {
  for (const char* order :
       {"", "i", "c", "n", "ic", "ci", "in", "ni", "cn", "nc", "icn", "inc", "cin", "nic", "cni", "nci"}) {
    SCOPED_TRACE(order);
    expect_kept(read(table(order, ' '), "a.xyz"), order);
    expect_kept(read("2\n" + table(order, ' '), "a.pts"), order);
    expect_kept(read(table(order, ','), "a.csv"), order);
    expect_kept(read(table(order, ';'), "a.csv"), order);
    std::string weighted = table(order, ' ');
    weighted.insert(weighted.find('\n'), " 8");
    weighted.insert(weighted.size() - 1, " -9");
    const PointFile file = read(weighted, "a.xyz", true);
    expect_kept(file, order);
    EXPECT_EQ(file.weights, (std::vector<double>{8, -9}));
  }
}

TEST(UsualColumns, OtherNumbersOfColumnsAreNotKept) {
  for (const auto& [line, lost] :
       {std::pair("1 2 3 4 5", 2), std::pair("1 2 3 4 5 6 7 8", 5), std::pair("1 2 3 4 5 6 7 8 9 10 11", 8)}) {
    EXPECT_EQ(read(line, "a.xyz").report.warnings,
              std::vector<std::string>{std::to_string(lost) + " columns are not kept"});
  }
}

TEST(UsualColumns, ADoubtIsTold) {
  const std::string bytes = "1 2 3 9 255 0 1\n4 5 6 8 0 0 1\n";
  const PointFile cloud = read(bytes, "a.xyz");
  EXPECT_EQ(cloud.intensities, (std::vector<double>{9, 8}));
  EXPECT_EQ(cloud.colors, (std::vector<Color>{{255, 0, 1}, {0, 0, 1}}));
  EXPECT_EQ(
      cloud.report.warnings,
      std::vector<std::string>{"columns without names are taken for an intensity (4), colours (5 to 7), but could "
                               "be colours (4 to 6), an intensity (7); names in the first line tell"});
  const PointFile scan = read("2\n" + bytes, "a.pts");  // of which this is the order
  EXPECT_EQ(scan.intensities, cloud.intensities);
  EXPECT_TRUE(scan.report.warnings.empty());
  const PointFile named = read("x y z r g b i\n" + bytes, "a.xyz");
  EXPECT_EQ(named.intensities, (std::vector<double>{1, 1}));
  EXPECT_EQ(named.colors, (std::vector<Color>{{9, 255, 0}, {8, 0, 0}}));
  EXPECT_TRUE(named.report.warnings.empty());
}

TEST(UsualColumns, WhatIsOfNoKindIsNotKept) {
  const PointFile file = read("1 2 3 10 20 30 0.25 7.5 0 0\n4 5 6 40 50 60 0.5 0 1 0\n", "a.xyz");
  EXPECT_EQ(file.colors, (std::vector<Color>{{10, 20, 30}, {40, 50, 60}}));
  EXPECT_TRUE(file.normals.empty());
  ASSERT_EQ(file.report.warnings.size(), 2U);  // the intensity could be the last one
  EXPECT_EQ(file.report.warnings[1],
            "columns 8 to 10 are no colours from 0 to 255 and no normals of length 1, or a second time: not kept");
  const PointFile twice = read("1 2 3 0 0 1 0 0.6 0.8\n", "a.xyz");
  EXPECT_EQ(twice.normals, (std::vector<Vector3>{{0, 0, 1}}));
  EXPECT_EQ(twice.report.warnings,
            std::vector<std::string>{
                "columns 7 to 9 are no colours from 0 to 255 and no normals of length 1, or a second time: not kept"});
}

TEST(UsualColumns, WhatIsNotFiniteSaysNothing) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double inf = std::numeric_limits<double>::infinity();
  const std::vector<double> values{nan, 0.5, 0, 10, 20, 30, 0, 0, 1, 1, inf, 2};
  const io::UsualColumns told = io::usual_columns(values, 6);
  ASSERT_EQ(told.parts.size(), 2U);
  EXPECT_EQ(told.parts[0].kind, Kind::normals);
  EXPECT_EQ(told.parts[1].kind, Kind::colors);
  EXPECT_TRUE(told.instead.empty());
}

}  // namespace
}  // namespace quoin
