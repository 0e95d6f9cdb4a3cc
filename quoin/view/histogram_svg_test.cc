// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/histogram_svg.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

namespace quoin {
namespace {

std::string drawn(const std::vector<Histogram>& histograms) {
  std::vector<NamedHistogram> named;
  for (const Histogram& histogram : histograms) named.push_back({"a <name>", &histogram});
  std::ostringstream out;
  write_histograms(out, named, "a & b");
  return out.str();
}

Histogram of(const std::vector<std::size_t>& values) {
  Histogram histogram;
  for (const std::size_t value : values) histogram.add(value);
  return histogram;
}

// Bars end with z, and nothing else does.
std::size_t bars(const std::string& text) {
  const std::string path = text.substr(text.find("class=\"bars\""));
  const std::string data = path.substr(0, path.find("\"/>"));
  return static_cast<std::size_t>(std::count(data.begin(), data.end(), 'z'));
}

TEST(HistogramSvg, ABarForEachValueThatOccurs) {
  const std::string text = drawn({of({2, 4, 4, 4, 5, 5, 7, 9})});
  EXPECT_NE(text.find("<title>a &amp; b</title>"), std::string::npos);
  EXPECT_NE(text.find(">a &lt;name&gt;<"), std::string::npos);
  EXPECT_NE(text.find(">8 values, mean 5, deviation 2, mode 4, median 4, most 9<"), std::string::npos);
  EXPECT_EQ(bars(text), 5U);
  EXPECT_EQ(text, drawn({of({9, 7, 5, 5, 4, 4, 4, 2})}));
  // 3 of 10 values at most: the bar of the mode reaches the top, that of a single one 0.3 of the decades.
  EXPECT_NE(text.find("V64h47.04V244z"), std::string::npos);
}

TEST(HistogramSvg, AnyValues) {
  for (const std::vector<Histogram>& histograms :
       {std::vector<Histogram>{}, {of({})}, {of({0})}, {of({1000000}), of({0, 1})}, {of({0, 79, 80, 81, 161})}}) {
    const std::string text = drawn(histograms);
    EXPECT_EQ(text.find("nan"), std::string::npos) << text;
    EXPECT_EQ(text.find("inf"), std::string::npos) << text;
    EXPECT_TRUE(text.ends_with("</svg>\n"));
  }
  EXPECT_EQ(bars(drawn({of({0, 79, 80, 81, 161})})), 4U);  // three values to a bar: 78 to 80 share one
}

}  // namespace
}  // namespace quoin
