// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace quoin::io {

/// The groups of an ASCII DXF file: a code on one line, a value on the next.
class DxfGroups {
 public:
  /// Both must outlive the groups. @throws InputError  the binary form
  DxfGroups(std::string_view text, const std::string& name);

  /// Goes on to the next group that is no comment (999). @throws InputError  the file ends, or the code is no integer
  void next();
  int code() const { return code_; }
  /// Without space around it.
  std::string_view value() const { return value_; }
  bool is(int code, std::string_view value) const { return code_ == code && value_ == value; }
  /// Of the value. @throws InputError
  double number(std::string_view element) const;
  std::int64_t integer(std::string_view element) const;
  /// Of the value, from 1.
  std::size_t line() const { return line_; }
  /// Nothing but space may follow. @throws InputError
  void expect_end();

  [[noreturn]] void fail(std::string_view element, std::string_view what) const { fail_at(line_, element, what); }
  [[noreturn]] void fail_at(std::size_t line, std::string_view element, std::string_view what) const;

 private:
  std::string_view take_line();

  std::string_view text_;
  const std::string& name_;
  std::size_t position_ = 0;
  std::size_t line_ = 0;
  int code_ = -1;
  std::string_view value_;
};

}  // namespace quoin::io
