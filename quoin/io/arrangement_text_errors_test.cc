// SPDX-License-Identifier: Apache-2.0
// The form of an exact text of an arrangement, and what is wrong with one.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>

#include "quoin/base/error.h"
#include "quoin/io/arrangement_text.h"

namespace quoin {
namespace {

const Context context({.threads = 1});

std::string text_of(const LinearArrangement& what, std::span<const std::string> names = {}) {
  std::ostringstream out;
  write_arrangement_text(out, what, names);
  return out.str();
}

AnyArrangementText read(const std::string& text) {
  return read_arrangement_text(text, "a.qarr", context);
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
  EXPECT_EQ(text_of(a, names),
            "quoin-arrangement 1 linear\n"
            "curves 4\nnames yes\nname a%20b\nname 50%25%23\nname \nname \xC3\xA4\n"
            "supports 3\nline 0 0 3 1\nline 0 1 3 0.5\nline 1 5 1 6\n"
            "vertices 8\npoint -1 0.1\npoint 0 0\npoint 0 1\npoint 1 5\nlast 2\ncrossing 0 1\npoint 3 0.5\npoint 3 1\n"
            "edges 5\nedge 0 1 5 +0\nedge 1 2 5 +1\nedge 2 3 4 +2\nedge 1 5 6 +1\nedge 0 5 7 +0\n"
            "faces 1\nmembers none\nend\n");
  const AnyArrangementText back = read(text_of(a, names));
  EXPECT_EQ(std::get<ArrangementText<LinearFamily>>(back).names, names);
  EXPECT_FALSE(std::get<ArrangementText<LinearFamily>>(back).set().has_value());
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

TEST(ArrangementText, PolesAndMembersAreChecked) {
  const std::string head = "quoin-arrangement 1 geodesic\ncurves 0\nnames no\n";
  const std::string rest = "faces 1\nmembers none\nend\n";
  EXPECT_NO_THROW(read(head + "supports 0\nvertices 1\ndirection 0 0 1\nedges 0\n" + rest));
  expect_refused(head + "supports 0\nvertices 1\ndirection 0 0 0\nedges 0\n" + rest, "a.qarr:6: ");
  expect_refused(head + "supports 2\ncircle 1 0 0\ncircle -2 0 0\n", "a.qarr:6: this circle was given before");
  expect_refused(head + "supports 2\ncircle 1 0 0\ncircle 0 1 0\nvertices 1\ncrossing 0 1 +\n",
                 "a.qarr:8: both circles pass through the poles");
  expect_refused(head +
                     "supports 1\ncircle 1 0 0\nvertices 3\ndirection 0 0 -1\ndirection 0 0 1\ndirection 0 0 1\n"
                     "edges 1\nedge 0:second 0 1\n" +
                     rest,
                 "a.qarr:");
  expect_refused(head +
                     "supports 1\ncircle 1 0 0\nvertices 2\ndirection 0 0 -1\ndirection 0 -1 0\nedges 1\n"
                     "edge 0:second 0 1\n" +
                     rest,
                 "a.qarr:10: its right end does not lie on it");
  const std::string plain = head + "supports 0\nvertices 1\ndirection 1 0 1\nedges 0\nfaces 1\n";
  EXPECT_NO_THROW(read(plain + "members 2\nface 0 in\nvertex 0 out\nend\n"));
  expect_refused(plain + "members 2\nface 0 in\nvertex 0 in\nend\n", "a.qarr:11: a member is named that follows");
  expect_refused(plain + "members 2\nvertex 0 in\nface 0 in\nend\n", "a.qarr:11: members are not in order");
  expect_refused(plain + "members 2\nface 0 in\nface 0 in\nend\n", "a.qarr:11: members are not in order");
  expect_refused(plain + "members 1\nface 0 out\nend\n", "a.qarr:10: 'out' is not 'in'");
  expect_refused(plain + "members 1\nedge 0 in\nend\n", "a.qarr:10: index 0 is out of range");
}

}  // namespace
}  // namespace quoin
