// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/proximity_path.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <sstream>
#include <utility>

#include "quoin/base/error.h"
#include "quoin/cli/coordinates.h"
#include "quoin/cli/inputs.h"
#include "quoin/cli/planar.h"
#include "quoin/cli/point_queries.h"
#include "quoin/cli/proximity_report.h"
#include "quoin/cli/reporting.h"
#include "quoin/cli/target_writing.h"
#include "quoin/cli/targets.h"
#include "quoin/cli/trail_drawing.h"
#include "quoin/polytope/piecewise_proximity.h"

namespace quoin::cli {

namespace {

using Json = nlohmann::ordered_json;

using PiecePairs = std::set<std::pair<std::size_t, std::size_t>>;

/// The report grows place by place, with the trail.
struct Report {
  Json steps = Json::array();
  Json events = Json::array();
  std::string text;
  Trail trail;
  std::optional<std::pair<Rational, std::size_t>> least;  // distance, and its step
  PiecePairs met_at_end;                                  // of the last leg: what a contact may continue
};

Point2 seen_from_above(const RationalPoint3& p) {
  return {p.x.to_double(), p.y.to_double()};
}

std::string text_of(const RationalPoint3& p) {
  return as_json(p).dump();
}

void add_step(Report& report, const RationalPoint3& at, Proximity relation, const Rational& squared_distance,
              const std::array<RationalPoint3, 2>& witness, Json details) {
  const std::size_t index = report.steps.size();
  Json step{{"at", as_json(at)}};
  step.update(describe_distance(relation, squared_distance, witness));
  std::ostringstream line;
  line << index << ": at " << text_of(at) << " " << name_of(relation);
  if (relation == Proximity::apart) line << ", distance " << std::sqrt(squared_distance.to_double());
  if (details.contains("contact")) {
    line << ", " << details["contact"][0].get<std::string>() << " on " << details["contact"][1].get<std::string>()
         << (details["grazing"].get<bool>() ? ", grazing" : "");
  }
  report.text += line.str() + "\n";
  step.update(details);
  report.steps.push_back(std::move(step));
  report.trail.steps.push_back({seen_from_above(at), relation});
  if (relation != Proximity::apart || (report.least && report.least->first <= squared_distance)) return;
  report.least.emplace(squared_distance, index);
  report.trail.nearest = {seen_from_above(witness[0]), seen_from_above(witness[1])};
}

/// A contact that goes on from the last leg and ends where this one begins was told there.
void add_event(Report& report, std::size_t leg, const PiecewisePassage& event, const RationalPoint3& from,
               const RationalPoint3& to) {
  const TranslationPassage& passage = event.passage;
  const bool is_continued =
      passage.enter.sign() == Sign::zero && report.met_at_end.contains({event.first, event.second});
  if (is_continued && passage.leave.sign() == Sign::zero) return;
  const RationalPoint3 enter = from + (to - from) * passage.enter;
  const RationalPoint3 leave = from + (to - from) * passage.leave;
  report.events.push_back({{"leg", leg},
                           {"pieces", {event.first, event.second}},
                           {"relation", name_of(passage.relation)},
                           {"continues", is_continued},
                           {"enter", passage.enter.to_double()},
                           {"exact_enter", passage.enter.to_string()},
                           {"leave", passage.leave.to_double()},
                           {"exact_leave", passage.leave.to_string()},
                           {"from", as_json(enter)},
                           {"to", as_json(leave)}});
  report.trail.contacts.push_back({seen_from_above(enter), seen_from_above(leave), passage.relation});
  report.text += std::string(is_continued ? "   still " : "   then ") + name_of(passage.relation) + " piece " +
                 std::to_string(event.second) + " from " + text_of(enter) + " to " + text_of(leave) + "\n";
}

/// All places are of doubles, and all pieces convex.
void follow(Report& report, const ProximityOperand& moving, const ProximityOperand& fixed,
            const std::vector<RationalPoint3>& path, const Context& context) {
  PiecewiseProximity proximity(*moving.pieces, *fixed.pieces);
  for (std::size_t i = 0; i < path.size(); ++i) {
    context.poll();
    const Vector3 at = *as_doubles(path[i]);
    const PiecewiseDistance found = proximity.distance(at, context);
    Json details{{"pieces", {found.first, found.second}}};
    const TranslationDistance& d = found.distance;
    if (d.relation == Proximity::touching) {
      details.update(describe_contact(proximity.queries(found.first, found.second, context), d.feature));
    }
    add_step(report, path[i], d.relation, d.squared_distance, d.witness, std::move(details));
    if (i + 1 == path.size()) return;
    PiecePairs met_at_end;
    for (const PiecewisePassage& event : proximity.passages(at, *as_doubles(path[i + 1]), context)) {
      add_event(report, i, event, path[i], path[i + 1]);
      if (event.passage.leave == Rational(1)) met_at_end.emplace(event.first, event.second);
    }
    report.met_at_end = std::move(met_at_end);
  }
}

void follow_any(Report& report, const ProximityOperand& moving, const ProximityOperand& fixed,
                const std::vector<RationalPoint3>& path, const Context& context) {
  const SolidProximity proximity(solid_of(moving, context), solid_of(fixed, context), context);
  for (const RationalPoint3& at : path) {
    context.progress("path", static_cast<double>(report.steps.size()) / static_cast<double>(path.size()));
    const SolidDistance d = proximity.distance(at, context);
    add_step(report, at, proximity_of(d.relation), d.squared_distance, d.witness, Json::object());
  }
}

void draw(const Trail& trail, const Options& options) {
  for (const Target& target : targets_of(options)) {
    write_target(target, [&](std::ostream& out) { draw_trail(out, trail); });
  }
}

}  // namespace

std::vector<RationalPoint3> read_path(const Options& options) {
  std::vector<RationalPoint3> path;
  for (const Query& query : points_of_file(options.path, 3)) {
    path.push_back({query.numbers[0], query.numbers[1], query.numbers[2]});
  }
  if (path.empty()) throw InputError(shown(options.path) + ": there are no places on the path");
  return path;
}

int run_path(const ProximityOperand& moving, const ProximityOperand& fixed, const std::vector<RationalPoint3>& path,
             const std::vector<std::string>& warnings, const Options& options, const Context& context) {
  Report report;
  const bool is_convex = moving.pieces && fixed.pieces &&
                         std::ranges::all_of(path, [](const RationalPoint3& p) { return as_doubles(p).has_value(); });
  if (is_convex) {
    follow(report, moving, fixed, path, context);
  } else {
    follow_any(report, moving, fixed, path, context);
  }
  if (!options.outputs.empty()) {
    report.trail.moving = shadow_of(moving, context);
    report.trail.fixed = shadow_of(fixed, context);
    report.trail.title = title_of(moving.name) + " past " + title_of(fixed.name);
    draw(report.trail, options);
  }
  Json json{{"steps", std::move(report.steps)}, {"between", is_convex}};
  if (is_convex) json["events"] = std::move(report.events);
  json["nearest_step"] = report.least ? Json(report.least->second) : Json(nullptr);
  json["outputs"] = options.outputs;
  print_report(std::move(json), report.text, warnings, options);
  return 0;
}

}  // namespace quoin::cli
