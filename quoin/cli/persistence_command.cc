// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/cli/commands.h"
#include "quoin/cli/failure.h"
#include "quoin/cli/inputs.h"
#include "quoin/cli/planar.h"
#include "quoin/cli/primes.h"
#include "quoin/cli/reporting.h"
#include "quoin/cli/streams.h"
#include "quoin/cli/target_writing.h"
#include "quoin/cli/targets.h"
#include "quoin/io/simplex_text.h"
#include "quoin/topology/persistence.h"
#include "quoin/view/persistence_svg.h"

namespace quoin::cli {

namespace {

using Json = nlohmann::ordered_json;

// A pair with the places of its values.
struct Interval {
  std::uint32_t birth;
  std::uint32_t death;  // PersistencePair::never if it stays
};

class Diagram {
 public:
  Diagram(const Filtration& filtration, std::vector<Rational> values, const std::vector<PersistencePair>& pairs)
      : values_(std::move(values)), degrees_(filtration.complex.dimension() + 1) {
    for (const Rational& value : values_) {
      rounded_.push_back(
          std::clamp(value.to_double(), std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max()));
      is_rounded_ = is_rounded_ || Rational(rounded_.back()) != value;
    }
    for (const PersistencePair& pair : pairs) {
      const bool dies = pair.death != PersistencePair::never;
      degrees_[pair.degree].push_back({filtration.grade[pair.degree][pair.birth],
                                       dies ? filtration.grade[pair.degree + 1][pair.death] : PersistencePair::never});
    }
    for (std::vector<Interval>& list : degrees_)
      std::sort(list.begin(), list.end(), [](const Interval& a, const Interval& b) {
        return a.birth != b.birth ? a.birth < b.birth : a.death < b.death;
      });
  }

  Json counts() const {
    Json json = Json::array();
    for (const std::vector<Interval>& list : degrees_) json.push_back(list.size());
    return json;
  }

  Json essential() const {
    Json json = Json::array();
    for (const std::vector<Interval>& list : degrees_)
      json.push_back(std::count_if(list.begin(), list.end(), [](const Interval& i) { return !dies(i); }));
    return json;
  }

  void add_intervals(Json& report) const {
    report["intervals"] = lists([&](std::uint32_t grade) { return Json(rounded_[grade]); });
    if (is_rounded_) report["exact_intervals"] = lists([&](std::uint32_t grade) { return Json(exact(grade)); });
  }

  // The longest of each degree, those that stay before all; all of them if asked.
  std::string text(bool all) const {
    constexpr std::size_t shown_intervals = 10;
    std::string result;
    for (std::size_t k = 0; k < degrees_.size(); ++k) {
      std::vector<Interval> list = degrees_[k];
      if (!all) {
        std::stable_sort(list.begin(), list.end(),
                         [&](const Interval& a, const Interval& b) { return length(a) > length(b); });
        list.resize(std::min(list.size(), shown_intervals));
      }
      result += "degree " + std::to_string(k) + ": " + std::to_string(degrees_[k].size()) + " intervals" +
                (list.size() < degrees_[k].size() ? ", the longest:\n" : "\n");
      for (const Interval& i : list)
        result += "  " + exact(i.birth) + " to " + (dies(i) ? exact(i.death) : "infinity") + "\n";
    }
    return result;
  }

  std::vector<PersistenceInterval> drawn() const {
    std::vector<PersistenceInterval> result;
    for (std::size_t k = 0; k < degrees_.size(); ++k) {
      for (const Interval& i : degrees_[k]) {
        result.push_back({static_cast<int>(k), rounded_[i.birth]});
        if (dies(i)) result.back().death = rounded_[i.death];
      }
    }
    return result;
  }

 private:
  static bool dies(const Interval& i) { return i.death != PersistencePair::never; }

  double length(const Interval& i) const {
    return dies(i) ? rounded_[i.death] / 2 - rounded_[i.birth] / 2 : std::numeric_limits<double>::infinity();
  }

  std::string exact(std::uint32_t grade) const {
    return Rational(rounded_[grade]) == values_[grade] ? Json(rounded_[grade]).dump() : values_[grade].to_string();
  }

  template <class Show>
  Json lists(const Show& show) const {
    Json json = Json::array();
    for (const std::vector<Interval>& list : degrees_) {
      Json of_degree = Json::array();
      for (const Interval& i : list) of_degree.push_back({show(i.birth), dies(i) ? show(i.death) : Json(nullptr)});
      json.push_back(std::move(of_degree));
    }
    return json;
  }

  std::vector<Rational> values_;
  std::vector<double> rounded_;
  bool is_rounded_ = false;
  std::vector<std::vector<Interval>> degrees_;
};

void draw(std::ostream& out, const Diagram& diagram, const Options& options) {
  const std::string title = title_of(options.inputs[0]);
  if (options.barcode) {
    write_barcode(out, diagram.drawn(), title);
  } else {
    write_persistence_diagram(out, diagram.drawn(), title);
  }
}

void write_drawings_of(const Diagram& diagram, const Options& options) {
  for (const Target& target : targets_of(options)) {
    write_target(target, [&](std::ostream& out) { draw(out, diagram, options); });
  }
}

Filtration filtration_of_text(const FiltrationText& text, const std::string& name, const Context& context) {
  try {
    return filtration_of(text.simplices, text.grades, context);
  } catch (const InputError& error) {
    throw InputError(shown(name) + ": " + error.what());
  }
}

}  // namespace

int run_persistence(const Options& options, const Context& context) {
  const std::vector<std::uint32_t> primes = primes_of(options);
  if (primes.size() > 1) throw UsageError("--prime is given twice; persistence is over one field");
  const std::string& name = options.inputs[0];
  std::vector<std::string> warnings;
  FiltrationText text = read_filtration(read_all(name), shown(name), context);
  const Filtration filtration = filtration_of_text(text, name, context);
  if (filtration.added_faces > 0) {
    warnings.push_back(shown(name) + ": " + std::to_string(filtration.added_faces) +
                       " faces are not listed: each enters with the first simplex that has it");
  }
  const PersistenceOptions how{.prime = primes.empty() ? 2 : primes[0]};
  const Diagram diagram(filtration, std::move(text.values), persistence(filtration, how, context));
  write_drawings_of(diagram, options);
  Json counts = Json::array();
  for (int k = 0; k <= filtration.complex.dimension(); ++k) counts.push_back(filtration.complex.count(k));
  Json report{{"simplices", std::move(counts)},
              {"prime", how.prime},
              {"pairs", diagram.counts()},
              {"essential", diagram.essential()}};
  if (options.json) diagram.add_intervals(report);
  print_report(std::move(report), options.json || options.quiet ? "" : diagram.text(options.verbose), warnings,
               options);
  return 0;
}

}  // namespace quoin::cli
