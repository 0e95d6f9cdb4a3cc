// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/exact_numbers.h"

#include <algorithm>
#include <span>

namespace quoin {

void ExactNumbers::add(const Rational& value) {
  const double rounded = value.to_double();
  if (std::isfinite(rounded) && Rational(rounded) == value) {
    add(rounded);
  } else {
    add_beside(value);
  }
}

void ExactNumbers::add(const io::ExactNumber& number) {
  if (number.value) {
    add(*number.value);
  } else {
    add_beside(number.exact);
  }
}

void ExactNumbers::add_beside(const Rational& value) {
  const bool is_repeated = !doubles_.empty() && doubles_.back() == not_a_double && others_.back().second == value;
  if (!is_repeated) others_.emplace_back(doubles_.size(), value);
  doubles_.push_back(not_a_double);
}

const Rational& ExactNumbers::beside(std::size_t i) const {
  const auto after = std::ranges::upper_bound(others_, i, {}, &std::pair<std::size_t, Rational>::first);
  return std::prev(after)->second;
}

std::string ExactNumbers::word(std::size_t i) const {
  if (is_none(i)) return "-";
  return is_double(i) ? io::exact_word(doubles_[i]) : beside(i).to_string();
}

Grades<Rational> ExactNumbers::grades() const {
  if (!others_.empty()) {
    std::vector<Rational> all;
    all.reserve(size());
    for (std::size_t i = 0; i < size(); ++i) all.push_back(exact(i));
    return grades_of<Rational>(all);
  }
  Grades<double> grades = grades_of<double>(doubles_);
  return {{grades.values.begin(), grades.values.end()}, std::move(grades.grade)};
}

bool operator==(const ExactNumbers& a, const ExactNumbers& b) {
  return a.doubles_ == b.doubles_ && a.others_ == b.others_;
}

}  // namespace quoin
