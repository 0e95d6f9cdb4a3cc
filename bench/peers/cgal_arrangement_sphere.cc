// SPDX-License-Identifier: Apache-2.0
#include <CGAL/Arr_geodesic_arc_on_sphere_traits_2.h>
#include <CGAL/Arr_spherical_topology_traits_2.h>
#include <CGAL/Arrangement_on_surface_2.h>

#include "cgal_arrangement.h"

namespace peer {

namespace {

using Traits = CGAL::Arr_geodesic_arc_on_sphere_traits_2<Kernel>;
using Topology = CGAL::Arr_spherical_topology_traits_2<Traits>;
using Arrangement = CGAL::Arrangement_on_surface_2<Traits, Topology>;

Traits::Point_2 direction(const Traits& traits, std::span<const std::int64_t> numbers) {
  return traits.construct_point_2_object()(static_cast<double>(numbers[0]), static_cast<double>(numbers[1]),
                                           static_cast<double>(numbers[2]));
}

// Inserts what `make` makes of every element.
template <class Curve, class Make>
void arrange(const Task& task, const char* kind, const Make& make) {
  const std::vector<Input> inputs = read_all(task, kind);
  const Traits traits;
  Best best;
  Arrangement arrangement(&traits);
  for (int round = 0; round < task.rounds; ++round) {
    arrangement.clear();
    std::vector<Curve> curves;
    for (const Input& input : inputs) {
      for (std::size_t i = 0; i < input.size(); ++i) curves.push_back(make(traits, input[i]));
    }
    best.start();
    CGAL::insert(arrangement, curves.begin(), curves.end());
    best.stop();
  }
  report(best, arrangement);
}

}  // namespace

void arrange_geodesics(const Task& task) {
  arrange<Traits::Curve_2>(task, "geodesics", [](const Traits& traits, std::span<const std::int64_t> numbers) {
    const Traits::Point_2 from = direction(traits, numbers.subspan(0, 3));
    const Traits::Point_2 to = direction(traits, numbers.subspan(3, 3));
    return traits.construct_curve_2_object()(from, to);
  });
}

// They come out as two edges at least: cut where they meet the meridian of +-pi, and opposite to that.
void arrange_great_circles(const Task& task) {
  arrange<Traits::Curve_2>(task, "great_circles", [](const Traits& traits, std::span<const std::int64_t> numbers) {
    const Kernel::Direction_3 normal(static_cast<double>(numbers[0]), static_cast<double>(numbers[1]),
                                     static_cast<double>(numbers[2]));
    return traits.construct_curve_2_object()(normal);
  });
}

}  // namespace peer
