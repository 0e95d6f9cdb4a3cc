// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/number_options.h"

#include <charconv>

#include "quoin/base/error.h"
#include "quoin/cli/numbers.h"
#include "quoin/io/text_lines.h"

namespace quoin::cli {

const NumberRange any_number{[](const Rational&) { return true; }, ""};
const NumberRange from_zero{[](const Rational& n) { return n.sign() != Sign::negative; }, "below zero"};
const NumberRange above_zero{[](const Rational& n) { return n.sign() == Sign::positive; }, "not above zero"};
const NumberRange zero_to_one{[](const Rational& n) { return n.sign() != Sign::negative && n <= Rational(1); },
                              "not from 0 to 1"};

namespace {

/// An option whose word is read when it is checked, so that it is refused as those of the parser's own are.
template <class Read>
CLI::Option* add_read(CLI::App& command, const std::string& names, const std::string& type, const std::string& text,
                      const Read& read, const std::function<void(decltype(read(std::string())))>& set) {
  CLI::Option* option = command.add_option_function<std::string>(
      names, [read, set](const std::string& word) { set(read(word)); }, text);
  option->type_name(type);
  return option->check([read](const std::string& word) -> std::string {
    try {
      read(word);
      return {};
    } catch (const InputError& error) {
      return error.what();
    }
  });
}

void require_in(const NumberRange& range, const Rational& number, const std::string& word) {
  if (!range.holds(number)) throw InputError(io::quoted(word) + " is " + range.what);
}

std::uint64_t whole_number(const std::string& word, std::uint64_t least, std::uint64_t most) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  const bool is_whole = !word.empty() && end == word.data() + word.size();
  if (!is_whole) throw InputError(io::quoted(word) + " is not a whole number");
  if (error != std::errc() || number < least || number > most) {
    throw InputError(io::quoted(word) + " is not from " + std::to_string(least) + " to " + std::to_string(most));
  }
  return number;
}

}  // namespace

CLI::Option* add_exact_number(CLI::App& command, const std::string& names, std::optional<Rational>& value,
                              const NumberRange& range, const std::string& text) {
  const auto read = [range](const std::string& word) {
    Rational number = parse_exact_number(word);
    require_in(range, number, word);
    return number;
  };
  return add_read(command, names, "NUMBER", text, read, [&value](const Rational& number) { value = number; });
}

CLI::Option* add_number(CLI::App& command, const std::string& names, std::optional<double>& value,
                        const NumberRange& range, const std::string& text) {
  const auto read = [range](const std::string& word) {
    const double number = parse_double(word);
    require_in(range, Rational(number), word);
    return number;
  };
  return add_read(command, names, "NUMBER", text, read, [&value](double number) { value = number; });
}

CLI::Option* add_whole_number(CLI::App& command, const std::string& names,
                              const std::function<void(std::uint64_t)>& set, std::uint64_t least, std::uint64_t most,
                              const std::string& text) {
  const auto read = [least, most](const std::string& word) { return whole_number(word, least, most); };
  return add_read(command, names, "WHOLE", text, read, set);
}

}  // namespace quoin::cli
