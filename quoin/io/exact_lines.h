// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "quoin/io/exact_words.h"
#include "quoin/io/text_lines.h"

namespace quoin::io {

/// Lines of an exact text form: each begins with a keyword and has just the words it should have. All that is not as
/// expected is an InputError with file and line.
class ExactLines {
 public:
  ExactLines(std::string_view text, const std::string& name) : size_(text.size()), lines_(text, name, '#') {}

  bool next() { return lines_.next(); }
  void need(std::string_view expected) { lines_.need(expected); }
  const std::vector<std::string_view>& words() const { return lines_.words(); }
  std::size_t line() const { return lines_.line(); }
  [[noreturn]] void fail(std::string_view what) const { lines_.fail(what); }
  [[noreturn]] void fail_at(std::size_t line, std::string_view what) const { lines_.fail_at(line, what); }

  /// The next line has this keyword and at least, or just, so many words with it.
  void expect_at_least(std::string_view keyword, std::size_t words);
  void expect(std::string_view keyword, std::size_t words);
  /// The present line has not more words.
  void expect_size(std::size_t words) const;
  void expect_end();

  /// A line of the keyword and one of two words; whether it is the second.
  bool choice(std::string_view keyword, std::string_view first, std::string_view second);
  /// A word of the present line as a count of lines that follow, which cannot be more than the file has bytes.
  std::size_t count(std::size_t word) const;
  /// A word of the present line as an integer from 0 to bound - 1.
  std::uint32_t index(std::size_t word, std::size_t bound) const;
  std::uint32_t index(std::string_view word, std::size_t bound) const;
  Rational rational(std::string_view word) const;

  /// What f returns; an InputError of it that names no line gets the present one.
  template <class Call>
  auto located(const Call& f) const {
    try {
      return f();
    } catch (const LineError&) {
      throw;
    } catch (const InputError& error) {
      lines_.fail(error.what());
    }
  }

 private:
  std::size_t size_;
  TextLines lines_;
};

}  // namespace quoin::io
