// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/persistence_diagram.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "quoin/cli/reporting.h"
#include "quoin/cli/target_writing.h"
#include "quoin/cli/targets.h"

namespace quoin::cli {

using Json = nlohmann::ordered_json;

namespace {

constexpr std::size_t poll_step = 1024;

}  // namespace

PersistenceDiagram::PersistenceDiagram(const Filtration& filtration, GradeValues values,
                                       std::span<const PersistencePair> pairs, const Context& context)
    : values_(std::move(values)),
      context_(context),
      degrees_(static_cast<std::size_t>(filtration.complex.dimension() + 1)) {
  std::size_t seen = 0;
  for (const PersistencePair& pair : pairs) {
    if (++seen % poll_step == 0) context.poll();
    const auto k = static_cast<std::size_t>(pair.degree);
    Interval interval{filtration.grade[k][pair.birth], PersistencePair::never, 0,
                      std::numeric_limits<double>::infinity()};
    interval.from = values_.rounded(interval.birth);
    if (pair.death != PersistencePair::never) {
      interval.death = filtration.grade[k + 1][pair.death];
      interval.to = values_.rounded(interval.death);
    }
    degrees_[k].push_back(interval);
  }
  for (std::vector<Interval>& list : degrees_) {
    std::sort(list.begin(), list.end(), [&](const Interval& a, const Interval& b) {
      if (++seen % poll_step == 0) context.poll();
      return std::tie(a.birth, a.death) < std::tie(b.birth, b.death);
    });
  }
}

void PersistenceDiagram::add_to(Json& report, bool lists_all) const {
  Json pairs = Json::array();
  Json essential = Json::array();
  for (const std::vector<Interval>& list : degrees_) {
    pairs.push_back(list.size());
    essential.push_back(
        std::count_if(list.begin(), list.end(), [](const Interval& i) { return i.death == PersistencePair::never; }));
  }
  report["pairs"] = std::move(pairs);
  report["essential"] = std::move(essential);
  if (!lists_all) return;
  report["intervals"] = lists([](std::uint32_t, double rounded) { return Json(rounded); });
  if (!values_.tells_exact) return;
  report["exact_intervals"] = lists([&](std::uint32_t grade, double) { return Json(values_.exact(grade)); });
}

template <class Show>
Json PersistenceDiagram::lists(const Show& show) const {
  Json json = Json::array();
  for (const std::vector<Interval>& list : degrees_) {
    Json of_degree = Json::array();
    for (const Interval& i : list) {
      if (of_degree.size() % poll_step == 0) context_.poll();
      of_degree.push_back({show(i.birth, i.from), i.death == PersistencePair::never ? Json() : show(i.death, i.to)});
    }
    json.push_back(std::move(of_degree));
  }
  return json;
}

std::string PersistenceDiagram::shown(std::uint32_t grade, double rounded) const {
  if (grade == PersistencePair::never) return "infinity";
  return values_.tells_exact ? values_.exact(grade) : Json(rounded).dump();
}

std::string PersistenceDiagram::text(bool all) const {
  constexpr std::size_t shown_intervals = 10;
  const auto half_length = [](const Interval& i) { return i.to / 2 - i.from / 2; };
  std::string result;
  for (std::size_t k = 0; k < degrees_.size(); ++k) {
    std::vector<Interval> list = degrees_[k];
    if (!all) {
      // The longest first, of equal ones those that come first: intervals are in the order of births and deaths.
      const auto end = list.begin() + static_cast<std::ptrdiff_t>(std::min(list.size(), shown_intervals));
      std::size_t seen = 0;
      std::partial_sort(list.begin(), end, list.end(), [&](const Interval& a, const Interval& b) {
        if (++seen % poll_step == 0) context_.poll();
        const double first = half_length(a);
        const double second = half_length(b);
        return first != second ? first > second : std::tie(a.birth, a.death) < std::tie(b.birth, b.death);
      });
      list.erase(end, list.end());
    }
    result += "degree " + std::to_string(k) + ": " + std::to_string(degrees_[k].size()) + " intervals" +
              (list.size() < degrees_[k].size() ? ", the longest:\n" : "\n");
    for (const Interval& i : list) {
      context_.poll();
      result += "  " + shown(i.birth, i.from) + " to " + shown(i.death, i.to) + "\n";
    }
  }
  return result;
}

std::string PersistenceDiagram::lost_by_rounding() const {
  if (values_.tells_exact) return {};
  constexpr double largest = std::numeric_limits<double>::max();
  std::size_t beyond = 0;
  std::size_t empty = 0;
  for (const std::vector<Interval>& list : degrees_) {
    for (const Interval& i : list) {
      const bool ends = i.death != PersistencePair::never;
      if (std::abs(i.from) == largest || (ends && std::abs(i.to) == largest)) {
        ++beyond;
      } else if (ends && i.from == i.to) {
        ++empty;
      }
    }
  }
  std::string lost;
  if (beyond > 0) lost = std::to_string(beyond) + " intervals have ends beyond the largest double, told as that";
  if (empty > 0) {
    lost += (lost.empty() ? "" : "; ") + std::to_string(empty) +
            " intervals begin and end at different values with one nearest double";
  }
  return lost.empty() ? lost : lost + ": '--exact' tells values as fractions";
}

std::vector<PersistenceInterval> PersistenceDiagram::drawn() const {
  std::vector<PersistenceInterval> result;
  for (std::size_t k = 0; k < degrees_.size(); ++k) {
    for (const Interval& i : degrees_[k]) result.push_back({static_cast<int>(k), i.from, i.to});
  }
  return result;
}

void PersistenceDiagram::write(const Options& options) const {
  const std::string title = title_of(options.inputs[0]);
  for (const Target& target : targets_of(options)) {
    write_target(target, [&](std::ostream& out) {
      options.barcode ? write_barcode(out, drawn(), title) : write_persistence_diagram(out, drawn(), title);
    });
  }
}

}  // namespace quoin::cli
