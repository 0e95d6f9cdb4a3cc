// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/expression_parser.h"

#include <algorithm>
#include <cctype>

#include "quoin/base/error.h"

namespace quoin::cli {

namespace {

class Parser {
 public:
  Parser(std::string_view text, const std::vector<std::string>& names) : text_(text), names_(names) {}

  Expression run() {
    Expression result = sum();
    if (peek() != '\0') fail("an operator should stand here");
    return result;
  }

 private:
  static constexpr int deepest = 500;

  [[noreturn]] void fail(const std::string& what) const {
    throw InputError("expression, column " + std::to_string(position_ + 1) + ": " + what);
  }

  char peek() {
    while (position_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[position_])) != 0) ++position_;
    return position_ < text_.size() ? text_[position_] : '\0';
  }

  Expression sum() {
    Expression left = product();
    while (true) {
      const char op = peek();
      if (op != '|' && op != '+' && op != '-' && op != '^') return left;
      ++position_;
      const Expression right = product();
      const Expression both[] = {left, right};
      left = op == '-'   ? Expression::subtract(left, {&right, 1})
             : op == '^' ? Expression::exclusive(both)
                         : Expression::unite(both);
    }
  }

  Expression product() {
    Expression left = factor();
    while (peek() == '&' || peek() == '*') {
      ++position_;
      const Expression both[] = {left, factor()};
      left = Expression::intersect(both);
    }
    return left;
  }

  Expression factor() {
    if (++depth_ > deepest) fail("the expression is nested too deeply");
    Expression result;
    const char c = peek();
    if (c == '!' || c == '~') {
      ++position_;
      result = Expression::complement(factor());
    } else if (c == '(') {
      ++position_;
      result = sum();
      if (peek() != ')') fail("')' should stand here");
      ++position_;
    } else {
      result = name();
    }
    --depth_;
    return result;
  }

  Expression name() {
    const auto is_name = [](char c) {
      return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.';
    };
    const std::size_t begin = position_;
    while (position_ < text_.size() && is_name(text_[position_])) ++position_;
    if (position_ == begin) fail("a name, '(' or '!' should stand here");
    const std::string_view word = text_.substr(begin, position_ - begin);
    const auto found = std::find(names_.begin(), names_.end(), word);
    if (found == names_.end()) {
      position_ = begin;
      fail("'" + std::string(word) + "' is not given as " + std::string(word) + "=FILE");
    }
    return Expression::leaf(static_cast<std::uint32_t>(found - names_.begin()));
  }

  std::string_view text_;
  const std::vector<std::string>& names_;
  std::size_t position_ = 0;
  int depth_ = 0;
};

}  // namespace

Expression parse_expression(std::string_view text, const std::vector<std::string>& names) {
  return Parser(text, names).run();
}

}  // namespace quoin::cli
