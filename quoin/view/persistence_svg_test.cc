// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/persistence_svg.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <vector>

#include "quoin/base/error.h"

namespace quoin {
namespace {

using Intervals = std::vector<PersistenceInterval>;

std::string diagram(const Intervals& intervals) {
  std::ostringstream out;
  write_persistence_diagram(out, intervals, "a <title> & more");
  return out.str();
}
std::string barcode(const Intervals& intervals) {
  std::ostringstream out;
  write_barcode(out, intervals, "bars");
  return out.str();
}
std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
  return found;
}

TEST(PersistenceSvg, APointAndABarForEachInterval) {
  const Intervals intervals{{1, 3, 5}, {0, 0}, {0, 0, 1}, {0, 0, 2}};
  const std::string points = diagram(intervals);
  EXPECT_NE(points.find("a &lt;title&gt; &amp; more"), std::string::npos);
  EXPECT_NE(points.find(">H0: 3<"), std::string::npos);
  EXPECT_NE(points.find(">H1: 1<"), std::string::npos);
  EXPECT_EQ(count(points, "h0"), 4U + 2U);  // two in the legend
  // Birth 3 of 0 to 5 is at three fifths of the 560 pixels, death 5 at the top.
  EXPECT_NE(points.find("M400 64h0"), std::string::npos);
  const std::string bars = barcode(intervals);
  EXPECT_EQ(count(bars, "H") - count(bars, ">H"), 4U);
  EXPECT_NE(bars.find("M400 106H624"), std::string::npos);  // the fourth of rows of 12
  EXPECT_EQ(bars, barcode({intervals[3], intervals[0], intervals[1], intervals[2]}));
}

TEST(PersistenceSvg, AnyRangeOfValues) {
  const double huge = 1.7e308;
  for (const Intervals& intervals : {Intervals{}, Intervals{{0, 7}}, Intervals{{0, 0}}, Intervals{{0, 5e-324, 1e-323}},
                                     Intervals{{0, -huge, huge}, {3, 0}}, Intervals{{0, huge, huge}},
                                     Intervals{{0, 1, std::nextafter(1.0, 2.0)}}, Intervals{{12, 1e-300, 2e-300}}}) {
    for (const std::string& text : {diagram(intervals), barcode(intervals)}) {
      EXPECT_EQ(text.find("nan"), std::string::npos) << text;
      EXPECT_EQ(text.find("inf"), std::string::npos) << text;
      EXPECT_TRUE(text.ends_with("</svg>\n"));
    }
  }
}

TEST(PersistenceSvg, RefusesWhatIsNoInterval) {
  const double none = std::nan("");
  for (const PersistenceInterval& bad :
       {PersistenceInterval{0, none, 1}, {0, 1, none}, {0, 2, 1}, {-1, 0, 1}, {0, INFINITY, INFINITY}}) {
    EXPECT_THROW(diagram({bad}), InputError);
    EXPECT_THROW(barcode({bad}), InputError);
  }
}

}  // namespace
}  // namespace quoin
