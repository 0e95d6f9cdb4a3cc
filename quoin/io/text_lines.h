// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "quoin/base/error.h"

namespace quoin::io {

/// An InputError that names file and line.
class LineError : public InputError {
 public:
  using InputError::InputError;
};

/// Lines of a text, ended by \n, \r\n or \r, split into words; comments start with a given character.
class TextLines {
 public:
  /// Where the text does not begin its file, `lines_before` it are counted.
  TextLines(std::string_view text, std::string name, char comment, std::size_t lines_before = 0)
      : text_(text), name_(std::move(name)), comment_(comment), line_(lines_before) {
    if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
  }

  /// Goes to the next line that has words; false at the end.
  bool next();
  /// The same, but the end is an error that names what was expected.
  void need(std::string_view expected);
  const std::vector<std::string_view>& words() const { return words_; }
  std::size_t line() const { return line_; }
  /// A line that ends in a backslash goes on in the next one.
  void join_continued_lines() { joins_ = true; }

  [[noreturn]] void fail(std::string_view what) const { fail_at(line_, what); }
  [[noreturn]] void fail_at(std::size_t line, std::string_view what) const {
    throw LineError(name_ + ":" + std::to_string(line) + ": " + std::string(what));
  }
  double number(std::string_view word) const;
  /// Perhaps not finite.
  double any_number(std::string_view word) const;
  std::int64_t integer(std::string_view word) const;

 private:
  std::string_view take_line();
  void split(std::string_view line);

  std::string_view text_;
  std::string name_;
  char comment_;
  bool joins_ = false;
  std::size_t position_ = 0;
  std::size_t line_ = 0;
  std::vector<std::string_view> words_;
};

/// A finite double from the whole word, else false. Accepts a leading plus sign.
bool parse_number(std::string_view word, double& value);

/// The same, but also what is not finite: nan, inf, infinity in any case; what is beyond the largest double is
/// infinite.
bool parse_any_number(std::string_view word, double& value);

/// The first word of a text, behind a byte order mark.
std::string_view first_word(std::string_view text);
/// The first one that is not in a comment; empty if there is none.
std::string_view first_word(std::string_view text, char comment);

/// The word in quotes for a message, cut short, control characters as question marks.
std::string quoted(std::string_view word);

/// Whether the word is this one, in letters of any case.
bool is_word(std::string_view word, std::string_view lower_case);

}  // namespace quoin::io
