// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "quoin/number/rational.h"

namespace quoin::io {

/// Nothing nests deeper than this in what is read.
inline constexpr std::size_t max_nesting = 100;

/// A place in a text that is read character by character; errors name file, line and, where given, element.
class TextCursor {
 public:
  /// Both must outlive the cursor. Skips a byte order mark.
  TextCursor(std::string_view text, const std::string& name);

  /// A part of another's text, from one position to another, with the same positions.
  TextCursor(const TextCursor& whole, std::size_t begin, std::size_t end)
      : text_(whole.text_.substr(0, end)), name_(whole.name_), position_(begin) {}

  bool at_end() const { return position_ >= text_.size(); }
  /// The next character, NUL at the end.
  char peek() const { return at_end() ? '\0' : text_[position_]; }
  std::size_t position() const { return position_; }
  void move_to(std::size_t position) { position_ = position; }
  std::string_view text() const { return text_; }
  std::string_view rest() const { return text_.substr(position_); }

  void skip_space();
  /// Skips space, then the character if it follows.
  bool accept(char c);
  /// Skips space, then takes letters.
  std::string_view word();
  /// Skips space, a comma if there is one, and space; whether there was a comma.
  bool skip_comma();
  /// Skips space, then takes a decimal number. @throws InputError  none follows, or it is beyond the largest double
  double number(std::string_view element);

  [[noreturn]] void fail(std::string_view element, std::string_view what) const { fail_at(position_, element, what); }
  [[noreturn]] void fail_at(std::size_t position, std::string_view element, std::string_view what) const;
  /// What follows, for a message: a few characters in quotes, or "the end".
  std::string found() const;

 private:
  std::string_view text_;
  const std::string& name_;
  std::size_t position_ = 0;
};

/// Length of the decimal number at the begin of a text: sign, digits with a point, exponent; 0 if there is none.
std::size_t number_length(std::string_view text);

/// The line, from 1, of a place in a text whose lines end with \n, \r\n or \r.
std::size_t line_of(std::string_view text, std::size_t position);

/// "file:line: element: what" as an InputError.
[[noreturn]] void fail_in_text(const std::string& name, std::size_t line, std::string_view element,
                               std::string_view what);

/// A sum of doubles, exact as long as it is needed, with its nearest double.
class RunningSum {
 public:
  void set(double value);
  /// The result may be beyond the largest double; see value.
  void add(double value);
  /// The nearest double; infinite beyond the largest one.
  double value() const { return value_; }
  /// How far that is from the sum; rounded up.
  double error() const;

 private:
  double value_ = 0;
  double tail_ = 0;                // the sum is value and tail
  std::optional<Rational> exact_;  // where two doubles do not hold it
};

/// Collects remarks: each kind once, with its count, the largest distance and the first element it is about.
class DrawingNotes {
 public:
  /// `remark` is a phrase that a count may follow: "Z coordinates are ignored".
  void count(std::string_view remark, std::string_view element) { add(remark, element, 0, false); }
  /// The same for what moved by at most `distance`.
  void moved(std::string_view remark, std::string_view element, double distance) {
    add(remark, element, distance, true);
  }
  std::vector<std::string> list() const;

 private:
  struct Note {
    std::string remark;
    std::string first;
    std::size_t count = 0;
    double distance = 0;
    bool has_distance = false;
  };
  void add(std::string_view remark, std::string_view element, double distance, bool has_distance);
  std::vector<Note> notes_;
  std::map<std::string, std::size_t, std::less<>> index_;
};

/// The shortest decimals that read back to the same double; zeros without sign.
std::string decimals(double value);
/// Three digits, rounded up.
std::string upper_decimals(double value);

/// Negative zero as zero.
inline double plain(double value) {
  return value + 0.0;
}

}  // namespace quoin::io
