// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace quoin::io {

/// What stands between the columns of a table; `blank` is any number of blanks and tabs.
enum class Separator : char { blank = ' ', comma = ',', semicolon = ';', tab = '\t' };

/// The separator of a line: a semicolon if there is one, else a comma; else a tab if nothing between tabs has blanks
/// inside; else blanks. What is in quotes does not count.
Separator separator_of(std::string_view line);

/// Lines of a table, ended by \n, \r\n or \r; empty ones and comments, which begin with # or //, are passed over.
class TableLines {
 public:
  TableLines(std::string_view text, std::string name);

  /// Goes to the next line; false at the end.
  bool next();
  std::string_view text() const { return line_; }
  std::size_t number() const { return number_; }
  /// The last comment that was passed over, without its mark.
  std::string_view comment() const { return comment_; }

  /// The line's fields, without blanks and quotes around them. A separator at the end makes no field.
  /// @throws InputError  a quote is not closed, or the field goes on behind it
  void split(Separator separator, std::vector<std::string_view>& fields) const;

  [[noreturn]] void fail(std::string_view what) const;

 private:
  std::string_view take_field(std::size_t& at, Separator separator) const;

  std::string_view rest_;
  std::string name_;
  std::string_view line_;
  std::string_view comment_;
  std::size_t number_ = 0;
};

}  // namespace quoin::io
