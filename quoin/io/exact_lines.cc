// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/exact_lines.h"

namespace quoin::io {

void ExactLines::expect_at_least(std::string_view keyword, std::size_t words) {
  lines_.need("'" + std::string(keyword) + "'");
  if (lines_.words()[0] != keyword) fail("'" + std::string(keyword) + "' should stand here");
  if (lines_.words().size() < words) fail("the line is too short");
}

void ExactLines::expect(std::string_view keyword, std::size_t words) {
  expect_at_least(keyword, words);
  expect_size(words);
}

void ExactLines::expect_size(std::size_t words) const {
  if (lines_.words().size() > words) fail(quoted(lines_.words()[words]) + " does not belong here");
}

void ExactLines::expect_end() {
  expect("end", 1);
  if (lines_.next()) fail("nothing should follow 'end'");
}

bool ExactLines::choice(std::string_view keyword, std::string_view first, std::string_view second) {
  expect(keyword, 2);
  const std::string_view word = lines_.words()[1];
  if (word != first && word != second) {
    fail(quoted(word) + " is neither '" + std::string(first) + "' nor '" + std::string(second) + "'");
  }
  return word == second;
}

std::size_t ExactLines::count(std::size_t word) const {
  const std::int64_t value = lines_.integer(lines_.words().at(word));
  if (value < 0 || static_cast<std::uint64_t>(value) > size_) fail("this count does not fit the file's size");
  return static_cast<std::size_t>(value);
}

std::uint32_t ExactLines::index(std::size_t word, std::size_t bound) const {
  if (word >= lines_.words().size()) fail("the line is too short");
  return index(lines_.words()[word], bound);
}

std::uint32_t ExactLines::index(std::string_view word, std::size_t bound) const {
  const std::int64_t value = lines_.integer(word);
  if (value < 0 || static_cast<std::uint64_t>(value) >= bound) {
    fail("index " + std::to_string(value) + " is out of range");
  }
  return static_cast<std::uint32_t>(value);
}

Rational ExactLines::rational(std::string_view word) const {
  return located([&] { return Rational::parse(word); });
}

}  // namespace quoin::io
