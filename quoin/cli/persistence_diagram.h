// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/cli/options.h"
#include "quoin/topology/filtration.h"
#include "quoin/topology/persistence.h"
#include "quoin/view/persistence_svg.h"

namespace quoin::cli {

/// What the grades of a filtration stand for; asked only for those with which intervals begin and end.
struct GradeValues {
  std::function<double(std::uint32_t)> rounded;     ///< finite
  std::function<std::string(std::uint32_t)> exact;  ///< a decimal or a fraction
  bool tells_exact = false;                         ///< whether exact ones go to reports
};

/// The intervals of classes of homology as commands report and draw them.
class PersistenceDiagram {
 public:
  /// By degree, then by birth and death. `values` are asked now and later; the context is polled all the while.
  PersistenceDiagram(const Filtration& filtration, GradeValues values, std::span<const PersistencePair> pairs,
                     const Context& context);

  /// Adds `pairs` and `essential`, and if `lists_all` `intervals`, with exact values `exact_intervals`.
  void add_to(nlohmann::ordered_json& report, bool lists_all) const;

  /// For people: the longest of each degree, those that stay before all; all of them if asked.
  std::string text(bool all) const;

  /// What is lost where values are told as doubles: empty, or a warning.
  std::string lost_by_rounding() const;

  /// Draws diagrams, or bars, to the outputs.
  void write(const Options& options) const;

 private:
  struct Interval {
    std::uint32_t birth;
    std::uint32_t death;  ///< PersistencePair::never if it stays
    double from;
    double to;  ///< infinite if it stays
  };

  template <class Show>
  nlohmann::ordered_json lists(const Show& show) const;
  std::string shown(std::uint32_t grade, double rounded) const;
  std::vector<PersistenceInterval> drawn() const;

  GradeValues values_;
  const Context& context_;
  std::vector<std::vector<Interval>> degrees_;
};

}  // namespace quoin::cli
