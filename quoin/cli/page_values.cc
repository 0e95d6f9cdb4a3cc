// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/page_values.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace quoin::cli {

namespace {

constexpr std::size_t poll_step = 4096;
constexpr std::uint32_t most_stops = 1U << 14;
constexpr int spread_values = 512;
constexpr std::size_t most_pairs = std::size_t{1} << 17;
constexpr std::size_t named_pairs = std::size_t{1} << 11;  // the longest ones, at whose values the page stops

}  // namespace

PageValues::PageValues(PageGrades grades, std::vector<GradedPair>& pairs, std::optional<std::uint32_t> shown,
                       const Context& context)
    : grades_(std::move(grades)), context_(context) {
  std::vector<std::uint32_t> also;
  if (grades_.count > most_stops) {
    const ValueStops even(grades_.count, most_stops);
    put_longest_first(pairs, named_pairs, even, values_at(even));
    also = wanted(pairs);
  }
  if (shown && *shown > 0) also.push_back(*shown - 1);
  stops_ = ValueStops(grades_.count, most_stops, also);
  values_ = values_at(stops_);
  if (shown && *shown > 0) shown_ = stops_.of(*shown - 1);
}

/// As far along the axis as it is drawn.
double PageValues::place(double value) const {
  return grades_.is_square ? std::sqrt(value) : value;
}

std::vector<double> PageValues::values_at(const ValueStops& stops) const {
  std::vector<double> values;
  for (std::uint32_t s = 0; s < stops.count(); ++s) {
    if (s % poll_step == 0) context_.poll();
    values.push_back(grades_.value(stops.grade(s)));
  }
  return values;
}

/// The longest pairs come first, as far as values at the stops tell.
void PageValues::put_longest_first(std::vector<GradedPair>& pairs, std::size_t count, const ValueStops& stops,
                                   const std::vector<double>& values) const {
  const auto length = [&](const GradedPair& pair) {
    if (pair.death == never_in_scene) return std::numeric_limits<double>::infinity();
    const std::uint32_t birth = stops.of(pair.birth);
    const std::uint32_t death = stops.of(pair.death);
    return birth == death ? -1 : place(values[death]) - place(values[birth]);  // no number: both are infinite
  };
  std::vector<std::pair<double, std::uint32_t>> order;
  for (std::uint32_t i = 0; i < pairs.size(); ++i) {
    const double of_pair = length(pairs[i]);
    order.emplace_back(of_pair >= 0 ? -of_pair : 1, i);
  }
  const auto middle = order.begin() + static_cast<std::ptrdiff_t>(std::min(count, order.size()));
  std::partial_sort(order.begin(), middle, order.end());
  std::vector<GradedPair> sorted;
  sorted.reserve(pairs.size());
  for (const auto& [minus_length, i] : order) sorted.push_back(pairs[i]);
  pairs = std::move(sorted);
}

/// The last grade whose value is not above; the first if all are.
std::uint32_t PageValues::last_up_to(double value) const {
  std::uint32_t from = 0;
  std::uint32_t to = grades_.count;
  while (from < to) {
    const std::uint32_t middle = from + (to - from) / 2;
    if (grades_.value(middle) <= value) {
      from = middle + 1;
    } else {
      to = middle;
    }
  }
  return std::max(1U, from) - 1;
}

/// Grades at which a page of few stops stops too: of the longest pairs, and far apart as values go.
std::vector<std::uint32_t> PageValues::wanted(const std::vector<GradedPair>& pairs) const {
  std::vector<std::uint32_t> grades;
  for (std::size_t i = 0; i < std::min(named_pairs, pairs.size()); ++i)
    grades.insert(grades.end(), {pairs[i].birth, pairs[i].death});
  const double low = grades_.value(grades_.count / 100);
  const double high = std::min(grades_.value(grades_.count - 1), std::numeric_limits<double>::max());
  if (!(low > 0) || !(high > low)) return grades;
  for (int i = 0; i <= spread_values; ++i) {
    const double value = low * std::pow(high / low, i / double{spread_values});
    if (std::isfinite(value)) grades.push_back(last_up_to(value));
  }
  return grades;
}

void PageValues::move_to(LayeredScene& scene) {
  scene.values = std::move(values_);
  scene.value = shown_;
  scene.has_all_values = stops_.count() == grades_.count;
  if (scene.has_all_values) return;
  scene.facts.emplace_back("Values", std::to_string(grades_.count));
  scene.facts.emplace_back("Values of this page", std::to_string(stops_.count()));
}

void PageValues::add_pairs(std::vector<GradedPair>& pairs, LayeredScene& scene) const {
  if (pairs.size() > most_pairs) put_longest_first(pairs, most_pairs, stops_, values_);
  for (const GradedPair& pair : pairs) {
    if (scene.pairs.size() == most_pairs) break;
    const std::uint32_t birth = stop_of(pair.birth);
    const std::uint32_t death = stop_of(pair.death);
    if (birth != death) scene.pairs.push_back({pair.degree, birth, death, pair.birth_point, pair.death_point});
  }
  scene.pairs_left_out = pairs.size() - scene.pairs.size();
}

SceneCount PageTally::take(const std::string& name) {
  std::partial_sum(at_.begin(), at_.end(), at_.begin());
  return {name, std::move(at_)};
}

std::string short_text(double value) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 4).ptr;
  return {text.data(), end};
}

}  // namespace quoin::cli
