// SPDX-License-Identifier: Apache-2.0
#include <CGAL/Arr_default_overlay_traits.h>
#include <CGAL/Arr_overlay_2.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>

#include "cgal_arrangement.h"

namespace peer {

namespace {

using Traits = CGAL::Arr_segment_traits_2<Kernel>;
using Arrangement = CGAL::Arrangement_2<Traits>;

template <class Curve>
std::vector<Curve> curves(const Input& input) {
  std::vector<Curve> result;
  result.reserve(input.size());
  for (std::size_t i = 0; i < input.size(); ++i) {
    result.emplace_back(point_at(input[i], 0), point_at(input[i], 1));
  }
  return result;
}

}  // namespace

void arrange_segments(const Task& task) {
  const std::vector<Input> inputs = read_all(task, "segments");
  Best best;
  Arrangement arrangement;
  for (int round = 0; round < task.rounds; ++round) {
    arrangement.clear();
    std::vector<Traits::Curve_2> all;
    for (const Input& input : inputs) {
      for (Traits::Curve_2& curve : curves<Traits::Curve_2>(input)) all.push_back(std::move(curve));
    }
    best.start();
    CGAL::insert(arrangement, all.begin(), all.end());
    best.stop();
  }
  report(best, arrangement);
}

void overlay_segments(const Task& task) {
  const std::vector<Input> inputs = read_all(task, "segments");
  Best best;
  Arrangement result;
  for (int round = 0; round < task.rounds; ++round) {
    std::vector<Arrangement> operands(2);
    for (std::size_t k = 0; k < 2; ++k) {
      const std::vector<Traits::X_monotone_curve_2> edges = curves<Traits::X_monotone_curve_2>(inputs[k]);
      CGAL::insert_non_intersecting_curves(operands[k], edges.begin(), edges.end());
    }
    result.clear();
    CGAL::Arr_default_overlay_traits<Arrangement> properties;
    best.start();
    CGAL::overlay(operands[0], operands[1], result, properties);
    best.stop();
  }
  report(best, result);
}

}  // namespace peer
