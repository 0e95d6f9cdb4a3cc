// SPDX-License-Identifier: Apache-2.0
#include <CGAL/Arr_circle_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/General_polygon_set_2.h>
#include <CGAL/Gps_circle_segment_traits_2.h>

#include <cmath>

#include "cgal_arrangement.h"

namespace peer {

namespace {

using Traits = CGAL::Arr_circle_segment_traits_2<Kernel>;
using Arrangement = CGAL::Arrangement_2<Traits>;
using DiscTraits = CGAL::Gps_circle_segment_traits_2<Kernel>;
using Disc = DiscTraits::General_polygon_2;
using DiscSet = CGAL::General_polygon_set_2<DiscTraits>;

Traits::Curve_2 circle(std::span<const std::int64_t> numbers) {
  return {point_at(numbers, 0), Kernel::FT(static_cast<double>(numbers[2]))};
}

Disc disc(std::span<const std::int64_t> numbers) {
  const DiscTraits traits;
  std::vector<CGAL::Object> pieces;
  traits.make_x_monotone_2_object()(circle(numbers), std::back_inserter(pieces));
  Disc result;
  for (const CGAL::Object& piece : pieces) {
    DiscTraits::X_monotone_curve_2 arc;
    if (CGAL::assign(arc, piece)) result.push_back(arc);
  }
  return result;
}

// Twice the area to the left of an arc of a circle: Green's formula in doubles.
double twice_area(const DiscTraits::X_monotone_curve_2& arc) {
  const double x1 = CGAL::to_double(arc.source().x());
  const double y1 = CGAL::to_double(arc.source().y());
  const double x2 = CGAL::to_double(arc.target().x());
  const double y2 = CGAL::to_double(arc.target().y());
  const double cx = CGAL::to_double(arc.supporting_circle().center().x());
  const double cy = CGAL::to_double(arc.supporting_circle().center().y());
  const double square = CGAL::to_double(arc.supporting_circle().squared_radius());
  const double turned =
      std::atan2((x1 - cx) * (y2 - cy) - (y1 - cy) * (x2 - cx), (x1 - cx) * (x2 - cx) + (y1 - cy) * (y2 - cy));
  const double full = 2 * std::acos(-1.0);
  const bool is_ccw = arc.orientation() == CGAL::COUNTERCLOCKWISE;
  const double angle = is_ccw ? (turned < 0 ? turned + full : turned) : (turned > 0 ? turned - full : turned);
  return square * angle + cx * (y2 - y1) - cy * (x2 - x1);
}

double twice_area(const Disc& boundary) {
  double sum = 0;
  for (auto arc = boundary.curves_begin(); arc != boundary.curves_end(); ++arc) sum += twice_area(*arc);
  return sum;
}

}  // namespace

void arrange_circles(const Task& task) {
  const std::vector<Input> inputs = read_all(task, "circles");
  Best best;
  Arrangement arrangement;
  for (int round = 0; round < task.rounds; ++round) {
    arrangement.clear();
    std::vector<Traits::Curve_2> curves;
    for (const Input& input : inputs) {
      for (std::size_t i = 0; i < input.size(); ++i) curves.push_back(circle(input[i]));
    }
    best.start();
    CGAL::insert(arrangement, curves.begin(), curves.end());
    best.stop();
  }
  report(best, arrangement);
}

void unite_discs(const Task& task) {
  const Input input = read_all(task, "circles")[0];
  Best best;
  DiscSet result;
  for (int round = 0; round < task.rounds; ++round) {
    result.clear();
    std::vector<Disc> discs;
    for (std::size_t i = 0; i < input.size(); ++i) discs.push_back(disc(input[i]));
    best.start();
    result.join(discs.begin(), discs.end());
    best.stop();
  }
  std::vector<DiscSet::Polygon_with_holes_2> parts;
  result.polygons_with_holes(std::back_inserter(parts));
  std::size_t holes = 0;
  double area = 0;
  for (const auto& part : parts) {
    area += twice_area(part.outer_boundary()) / 2;
    for (auto hole = part.holes_begin(); hole != part.holes_end(); ++hole) area += twice_area(*hole) / 2;
    holes += part.number_of_holes();
  }
  report(best, result.arrangement(),
         member("parts", double(parts.size())) + member("holes", double(holes)) + member("area", area));
}

}  // namespace peer
