// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace bench {

/// The words behind a command's name; options are taken from among them wherever they stand.
class CommandWords {
 public:
  CommandWords(int argc, char** argv) : words_(argv + 1, argv + argc) {}

  /// Whether this word is there.
  bool take_flag(std::string_view name) {
    const auto at = std::find(words_.begin(), words_.end(), name);
    if (at == words_.end()) return false;
    words_.erase(at);
    return true;
  }

  /// The whole number behind this word, or another one where it is not there. @throws std::invalid_argument
  template <class Number>
  Number take_number(std::string_view name, Number otherwise) {
    const auto at = std::find(words_.begin(), words_.end(), name);
    if (at == words_.end()) return otherwise;
    if (at + 1 == words_.end()) throw std::invalid_argument(std::string(name) + " needs a number");
    const auto number = static_cast<Number>(std::stoll(at[1]));
    words_.erase(at, at + 2);
    return number;
  }

  /// What is left, which has to be so many words. @throws std::invalid_argument that says how the command is called
  const std::vector<std::string>& rest(std::size_t count, const char* usage) const {
    if (words_.size() != count) throw std::invalid_argument(usage);
    return words_;
  }
  const std::vector<std::string>& rest() const { return words_; }

 private:
  std::vector<std::string> words_;
};

/// Exit code of a command that does this; what it throws goes to standard error.
template <class Run>
int exit_code_of(const Run& run) {
  try {
    run();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}

}  // namespace bench
