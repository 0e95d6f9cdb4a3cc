// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/flow_report.h"

#include <cmath>

namespace quoin::cli {

namespace {

using Json = nlohmann::ordered_json;

Json of_histogram(const Histogram& histogram, bool has_lists) {
  Json json{{"count", histogram.count()}, {"mean", histogram.mean()},     {"deviation", histogram.deviation()},
            {"mode", histogram.mode()},   {"median", histogram.median()}, {"most", histogram.most()}};
  if (has_lists) json["frequencies"] = histogram.counts();
  return json;
}

Json of_filter(const FilterCount& count) {
  return {{"calls", count.calls}, {"undecided", count.undecided}};
}

void add_crossings(Json& report, const CrossingStatistics& crossings, bool has_lists) {
  report["comparisons"] = crossings.filters.comparisons.calls;
  report["undecided_by_doubles"] = crossings.undecided;
  report["longest_chain"] = crossings.depth;
  report["exact_points"] = crossings.exact_points;
  report["most_bits"] = crossings.most_bits;
  if (!has_lists) return;
  report["exact_bytes"] = of_histogram(crossings.bytes, true);
  report["filters"] = {{"starts", of_filter(crossings.filters.starts)},
                       {"comparisons", of_filter(crossings.filters.comparisons)},
                       {"exits", of_filter(crossings.filters.exits)},
                       {"landings", of_filter(crossings.filters.landings)}};
}

/// With sizes of exact places, if there were any.
std::vector<FlowHistogram> with_sizes(std::vector<FlowHistogram> histograms, const CrossingStatistics& crossings) {
  if (crossings.bytes.count() > 0) histograms.push_back({"Bytes of exact places", crossings.bytes});
  return histograms;
}

/// How many manifolds have a flag; which ones goes to `flagged`.
void add_flag(Json& report, Json& flagged, const char* name, const ManifoldList& list) {
  report[name] = list.size();
  if (!list.empty()) flagged[name] = list;
}

void add_flagged(Json& report, Json flagged, bool has_lists) {
  if (has_lists) report["flagged"] = std::move(flagged);
}

}  // namespace

void add_number(Json& report, const std::string& name, const Rational& number) {
  const double nearest = number.to_double();
  const bool is_finite = std::isfinite(nearest);
  report[name] = is_finite ? Json(nearest) : Json();
  if (!is_finite || Rational(nearest) != number) report["exact_" + name] = number.to_string();
}

long alternating_sum(const std::array<std::size_t, 4>& counts) {
  return static_cast<long>(counts[0] + counts[2]) - static_cast<long>(counts[1] + counts[3]);
}

Json report_of(const CellSignCounts& counts) {
  return {{"centres", of_filter({counts.centre_calls, counts.centres})},
          {"spheres", of_filter({counts.sphere_calls, counts.spheres})}};
}

Json report_of_edges(std::size_t edges, bool has_lists) {
  Json json{{"edges", edges}};
  add_flagged(json, Json::object(), has_lists);
  return json;
}

Json report_of(const StableSurvey& survey, bool has_lists) {
  Json json{{"triangles", survey.triangles}, {"depth", of_histogram(survey.depths, has_lists)}};
  Json flagged = Json::object();
  add_flag(json, flagged, "with_voronoi_vertex", survey.with_voronoi_vertex);
  add_flag(json, flagged, "with_solid_part", survey.with_solid_part);
  add_flag(json, flagged, "with_regular_point", survey.with_regular_point);
  add_flagged(json, std::move(flagged), has_lists);
  add_crossings(json, survey.crossings, has_lists);
  return json;
}

Json report_of(const UnstableSurvey& survey, bool has_lists) {
  Json json{{"segments", of_histogram(survey.segments, has_lists)},
            {"cascades", of_histogram(survey.cascades, has_lists)},
            {"to_infinity", survey.to_infinity}};
  Json flagged = Json::object();
  add_flag(json, flagged, "passed_regular_point", survey.passed_regular);
  add_flag(json, flagged, "end_in_saddle", survey.in_saddles);
  add_flagged(json, std::move(flagged), has_lists);
  add_crossings(json, survey.crossings, has_lists);
  return json;
}

Json report_of(const SheetSurvey& survey, bool has_lists) {
  Json json{{"sheets", survey.parts.count()},
            {"pieces", survey.pieces},
            {"parts", of_histogram(survey.parts, has_lists)},
            {"saddles", of_histogram(survey.saddles, has_lists)},
            {"voronoi_vertices", of_histogram(survey.vertices, has_lists)},
            {"to_infinity", survey.to_infinity}};
  Json flagged = Json::object();
  add_flag(json, flagged, "with_regular_point", survey.with_regular_point);
  add_flag(json, flagged, "with_stationary_end", survey.with_stationary_end);
  add_flagged(json, std::move(flagged), has_lists);
  add_crossings(json, survey.crossings, has_lists);
  return json;
}

Json report_of(const FlowRegions& regions, const RegionSurvey& survey, bool has_lists) {
  Json json{{"regions", regions.regions.size()},
            {"voronoi_vertices", of_histogram(survey.vertices, has_lists)},
            {"voronoi_vertices_to_infinity", regions.vertices_to_infinity},
            {"voronoi_vertices_to_saddles", regions.vertices_to_saddles},
            {"wall_saddles", of_histogram(survey.walls, has_lists)},
            {"inner_saddles", survey.inner_saddles},
            {"beside_infinity", survey.beside_infinity},
            {"triangles", survey.triangles}};
  Json flagged = Json::object();
  add_flag(json, flagged, "with_wall_not_ordinary", survey.not_ordinary);
  add_flagged(json, std::move(flagged), has_lists);
  return json;
}

Json report_of(const FlatSurvey& survey, bool has_lists) {
  Json json{{"segments", of_histogram(survey.segments, has_lists)}, {"to_infinity", survey.to_infinity}};
  Json flagged = Json::object();
  add_flag(json, flagged, "passed_regular_point", survey.passed_regular);
  add_flagged(json, std::move(flagged), has_lists);
  add_crossings(json, {}, has_lists);  // none: ways turn at centres of polygons alone
  return json;
}

std::vector<FlowHistogram> histograms_of(const StableSurvey& survey) {
  return with_sizes({{"Flow segments from a critical edge to the saddle (nS2)", survey.depths}}, survey.crossings);
}

std::vector<FlowHistogram> histograms_of(const UnstableSurvey& survey) {
  return with_sizes({{"Flow segments of a way from a saddle (nU2)", survey.segments},
                     {"Points constructed in a row (nWCC)", survey.cascades}},
                    survey.crossings);
}

std::vector<FlowHistogram> histograms_of(const SheetSurvey& survey) {
  return with_sizes({{"Parts of Voronoi edges of a sheet", survey.parts},
                     {"Saddles of index 2 on a sheet", survey.saddles},
                     {"Voronoi vertices of a sheet", survey.vertices}},
                    survey.crossings);
}

std::vector<FlowHistogram> histograms_of(const RegionSurvey& survey) {
  return {{"Voronoi vertices of a region", survey.vertices}, {"Saddles on the boundary of a region", survey.walls}};
}

std::vector<FlowHistogram> histograms_of(const FlatSurvey& survey) {
  return {{"Flow segments of a way from a saddle", survey.segments}};
}

}  // namespace quoin::cli
