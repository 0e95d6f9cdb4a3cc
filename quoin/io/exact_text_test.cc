// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/exact_text.h"

#include <gtest/gtest.h>

#include <array>
#include <sstream>
#include <string>

#include "quoin/base/error.h"
#include "quoin/solid/leaf.h"
#include "quoin/solid/shapes.h"
#include "quoin/solid/solid.h"

namespace quoin {
namespace {

const Context context({.threads = 1});

Solid solid(const Mesh& mesh) {
  return Solid::from_leaf(make_leaf(mesh, {}, context).leaf, context);
}

std::string text_of(const Solid& s) {
  std::ostringstream out;
  write_exact_text(out, s.boundary());
  return out.str();
}

// The text with one occurrence of `from` replaced.
std::string changed(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

void expect_refused(const std::string& text, const std::string& place) {
  SCOPED_TRACE(place);
  try {
    read_exact_text(text, "a.qsolid");
    FAIL() << "read without complaint";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).substr(0, place.size()), place);
  }
}

TEST(ExactText, WordsThatAreNoChoiceAreRefused) {
  const std::string text = text_of(solid(shapes::cube()));
  EXPECT_NO_THROW(read_exact_text(text, "a.qsolid"));
  expect_refused(changed(text, "unbounded no", "unbounded maybe"), "a.qsolid:2: 'maybe'");
  expect_refused(changed(text, "shell outer", "shell foo"), "a.qsolid:7: 'foo'");
  expect_refused(changed(text, "colors no", "colors maybe"), "a.qsolid:17: 'maybe'");
}

TEST(ExactText, WhatDoesNotBelongThereIsRefused) {
  const std::string text = text_of(solid(shapes::cube()));
  expect_refused(text + "more\n", "a.qsolid:32: nothing should follow 'end'");
  expect_refused(text + text, "a.qsolid:32: nothing should follow 'end'");
  EXPECT_NO_THROW(read_exact_text(text + "\n# a remark\n", "a.qsolid"));
  expect_refused(changed(text, "end\n", "end it\n"), "a.qsolid:31: 'it' does not belong here");
  expect_refused(changed(text, "quoin-solid 1\n", "quoin-solid 1 2\n"), "a.qsolid:1: '2' does not belong here");
  expect_refused(changed(text, "faces 6\n", "faces 6 7\n"), "a.qsolid:18: '7' does not belong here");
  expect_refused(changed(text, "\nloop", " 1 2 3 4\nloop"), "a.qsolid:19: '1' does not belong here");
}

TEST(ExactText, ComponentsMustBeThoseOfTheShells) {
  const Solid cube = solid(shapes::box({0, 0, 0}, {3, 3, 3}));
  const Solid hollow = subtract(cube, std::array{solid(shapes::box({1, 1, 1}, {2, 2, 2}))}, context);
  const Solid both = unite(std::array{hollow, solid(shapes::box({5, 0, 0}, {6, 1, 1}))}, context);
  for (const Solid& s : {Solid(), cube, hollow, both}) {
    for (const Solid& t : {s, complement(s, context)}) {
      const std::string text = text_of(t);
      const Brep read = read_exact_text(text, "a.qsolid");
      EXPECT_EQ(read.component_count, t.boundary().component_count);
      const std::string line = "components " + std::to_string(read.component_count);
      const std::size_t names = t.boundary().leaf_names.size();
      for (const std::uint32_t wrong : {read.component_count + 1, 0U}) {
        if (wrong == read.component_count) continue;
        expect_refused(changed(text, line, "components " + std::to_string(wrong)),
                       "a.qsolid:" + std::to_string(4 + names) + ": " + std::to_string(wrong) + " components");
      }
    }
  }
}

}  // namespace
}  // namespace quoin
