// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/expression_parser.h"

#include <cctype>
#include <unordered_map>
#include <vector>

#include "quoin/cli/failure.h"

namespace quoin::cli {

namespace {

using Kind = Expression::Kind;

// Operator precedence with two stacks. The parser alternates between places where an operand begins and places where
// one has ended.
class Parser {
 public:
  Parser(std::string_view text, std::span<const std::string> names, const Context& context)
      : text_(text), context_(context) {
    for (std::uint32_t i = 0; i < names.size(); ++i) leaf_of_.emplace(names[i], i);
  }

  Expression run() {
    do {
      read_operand();
      while (peek() == ')') close_parenthesis();
    } while (read_operator());
    if (peek() != '\0') fail("an operator should stand here");
    apply_down_to(0);
    if (!operators_.empty()) fail("')' should stand here");
    node_of(operands_.back());
    return builder_.take();
  }

 private:
  // A group that may take further children: `kind` over them; Kind::leaf for a node that stands for itself.
  struct Operand {
    Kind kind;
    std::vector<std::uint32_t> nodes;
  };

  [[noreturn]] void fail(const std::string& what) const {
    throw UsageError("expression, column " + std::to_string(position_ + 1) + ": " + what);
  }

  char peek() {
    while (position_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[position_])) != 0) ++position_;
    return position_ < text_.size() ? text_[position_] : '\0';
  }

  // 0 for what is no binary operator.
  static int strength(char op) {
    switch (op) {
      case '|':
      case '+':
      case '-':
      case '^':
        return 1;
      case '&':
      case '*':
        return 2;
      default:
        return 0;
    }
  }
  static constexpr int strength_of_complement = 3;

  // The signs before a name, and the name.
  void read_operand() {
    for (char c = peek(); c == '!' || c == '~' || c == '('; c = peek()) {
      operators_.push_back(c == '(' ? '(' : '!');
      ++position_;
      poll();
    }
    operands_.push_back({Kind::leaf, {builder_.leaf(read_name())}});
    poll();
  }

  std::uint32_t read_name() {
    const auto is_name = [](char c) {
      return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.';
    };
    const std::size_t begin = position_;
    while (position_ < text_.size() && is_name(text_[position_])) ++position_;
    if (position_ == begin) fail("a name, '(' or '!' should stand here");
    const std::string_view word = text_.substr(begin, position_ - begin);
    const auto found = leaf_of_.find(word);
    if (found == leaf_of_.end()) {
      position_ = begin;
      fail("'" + std::string(word) + "' is not given as " + std::string(word) + "=FILE");
    }
    return found->second;
  }

  bool read_operator() {
    const char op = peek();
    if (strength(op) == 0) return false;
    apply_down_to(strength(op));
    operators_.push_back(op);
    ++position_;
    return true;
  }

  void close_parenthesis() {
    apply_down_to(0);
    if (operators_.empty()) fail("this ')' closes nothing");
    operators_.pop_back();
    ++position_;
    poll();
  }

  // Applies what stands before and binds as strongly at least, back to an open parenthesis.
  void apply_down_to(int least) {
    while (!operators_.empty() && operators_.back() != '(') {
      const char op = operators_.back();
      if ((op == '!' ? strength_of_complement : strength(op)) < least) return;
      operators_.pop_back();
      if (op == '!') {
        operands_.back() = complement_of(operands_.back());
      } else {
        apply(op);
      }
    }
  }

  void apply(char op) {
    Operand right = std::move(operands_.back());
    operands_.pop_back();
    if (op == '-') right = complement_of(right);
    const Kind kind = op == '|' || op == '+' ? Kind::any : op == '^' ? Kind::odd : Kind::every;
    Operand& left = operands_.back();
    if (left.kind != kind) left = {kind, {node_of(left)}};
    left.nodes.push_back(node_of(right));
  }

  std::uint32_t node_of(const Operand& operand) {
    return operand.kind == Kind::leaf ? operand.nodes[0] : builder_.combine(operand.kind, operand.nodes);
  }

  Operand complement_of(const Operand& operand) {
    const std::uint32_t node[] = {node_of(operand)};
    return {Kind::leaf, {builder_.combine(Kind::complement, node)}};
  }

  void poll() {
    if (++steps_ % 1024 == 0) context_.poll();
  }

  std::string_view text_;
  const Context& context_;
  std::unordered_map<std::string_view, std::uint32_t> leaf_of_;
  ExpressionBuilder builder_;
  std::vector<char> operators_;
  std::vector<Operand> operands_;
  std::size_t position_ = 0;
  std::size_t steps_ = 0;
};

}  // namespace

Expression parse_expression(std::string_view text, std::span<const std::string> names, const Context& context) {
  return Parser(text, names, context).run();
}

}  // namespace quoin::cli
