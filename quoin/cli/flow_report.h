// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "quoin/flow/flat_flow.h"
#include "quoin/flow/flow_regions.h"
#include "quoin/flow/flow_survey.h"
#include "quoin/number/rational.h"

namespace quoin::cli {

/// Of `--ratio`.
inline constexpr double default_ratio = 0.5;

/// What is told of manifolds of the flow. In lists, for JSON, there are also the frequencies of distributions, the
/// filters of each question, and the numbers of flagged manifolds.
nlohmann::ordered_json report_of(const StableSurvey& survey, bool has_lists);
nlohmann::ordered_json report_of(const UnstableSurvey& survey, bool has_lists);
nlohmann::ordered_json report_of(const SheetSurvey& survey, bool has_lists);
nlohmann::ordered_json report_of(const FlowRegions& regions, const RegionSurvey& survey, bool has_lists);
nlohmann::ordered_json report_of(const FlatSurvey& survey, bool has_lists);
/// Of critical edges, which are the stable manifolds of their midpoints whatever the other points are: none has a flag.
nlohmann::ordered_json report_of_edges(std::size_t edges, bool has_lists);

/// Signs that the tables took: how many, and how many doubles did not decide.
nlohmann::ordered_json report_of(const CellSignCounts& counts);

/// A number under a name: its nearest double, or null beyond the largest; and under `exact_` and the name itself, where
/// it is no double.
void add_number(nlohmann::ordered_json& report, const std::string& name, const Rational& number);

/// The alternating sum of counts by index.
long alternating_sum(const std::array<std::size_t, 4>& counts);

/// A distribution with what to call it.
struct FlowHistogram {
  std::string name;
  Histogram histogram;
};
std::vector<FlowHistogram> histograms_of(const StableSurvey& survey);
std::vector<FlowHistogram> histograms_of(const UnstableSurvey& survey);
std::vector<FlowHistogram> histograms_of(const SheetSurvey& survey);
std::vector<FlowHistogram> histograms_of(const RegionSurvey& survey);
std::vector<FlowHistogram> histograms_of(const FlatSurvey& survey);

}  // namespace quoin::cli
