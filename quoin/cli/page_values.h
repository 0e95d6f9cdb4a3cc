// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/view/layered_scene.h"
#include "quoin/view/value_stops.h"

namespace quoin::cli {

/// Values in ascending order by their number, the grade, as a complex of simplices or the flow has them.
struct PageGrades {
  std::uint32_t count = 0;
  std::function<double(std::uint32_t)> value;  ///< never descending
  bool is_square = false;                      ///< people read the square root
};

/// A class of homology, by grades.
struct GradedPair {
  std::uint32_t degree = 0;
  std::uint32_t birth = 0;
  std::uint32_t death = never_in_scene;
  std::uint32_t birth_point = never_in_scene;  ///< a point of the scene
  std::uint32_t death_point = never_in_scene;
};

/// The values at which a page of very many stops, so that what it shows at each is exact: some at even distances among
/// the grades and among the values, and the births and deaths of the longest classes.
class PageValues {
 public:
  /// The pairs are put in order, the longest ones first, where not all grades are stops. `shown` is the number of
  /// grades up to the one that is shown first. The function must live as long. @throws Cancelled
  PageValues(PageGrades grades, std::vector<GradedPair>& pairs, std::optional<std::uint32_t> shown,
             const Context& context);

  std::uint32_t stop_count() const { return stops_.count(); }
  double value(std::uint32_t stop) const { return values_[stop]; }
  /// The first stop at which a grade has begun; never_in_scene of what never does.
  std::uint32_t stop_of(std::uint32_t grade) const {
    return grade == never_in_scene ? never_in_scene : stops_.of(grade);
  }

  /// The values, which is shown first, and how many are left out. Once, after everything else.
  void move_to(LayeredScene& scene);
  /// The persistence diagram; of very many classes the longest ones. Those without length at the stops are counted as
  /// left out.
  void add_pairs(std::vector<GradedPair>& pairs, LayeredScene& scene) const;

 private:
  double place(double value) const;
  std::vector<double> values_at(const ValueStops& stops) const;
  void put_longest_first(std::vector<GradedPair>& pairs, std::size_t count, const ValueStops& stops,
                         const std::vector<double>& values) const;
  std::vector<std::uint32_t> wanted(const std::vector<GradedPair>& pairs) const;
  std::uint32_t last_up_to(double value) const;

  PageGrades grades_;
  const Context& context_;
  ValueStops stops_{0, 0};
  std::vector<double> values_;
  std::optional<std::uint32_t> shown_;
};

/// How much there is at each stop of what comes and goes.
class PageTally {
 public:
  explicit PageTally(const PageValues& values) : values_(values), at_(values.stop_count(), 0) {}

  void come(std::uint32_t grade) { ++at_[values_.stop_of(grade)]; }
  /// Not before it came; nothing goes at never_in_scene.
  void go(std::uint32_t grade) {
    if (grade != never_in_scene) --at_[values_.stop_of(grade)];  // modulo 2^32 in between
  }
  SceneCount take(const std::string& name);

 private:
  const PageValues& values_;
  std::vector<std::uint32_t> at_;
};

/// With four digits.
std::string short_text(double value);

}  // namespace quoin::cli
