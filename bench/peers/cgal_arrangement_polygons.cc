// SPDX-License-Identifier: Apache-2.0
#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_set_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/minkowski_sum_2.h>

#include "cgal_arrangement.h"

namespace peer {

namespace {

using Polygon = CGAL::Polygon_2<Kernel>;
using Part = CGAL::Polygon_with_holes_2<Kernel>;
using PolygonSet = CGAL::Polygon_set_2<Kernel>;

Polygon polygon(std::span<const std::int64_t> numbers) {
  Polygon result;
  for (std::size_t i = 0; 2 * i < numbers.size(); ++i) result.push_back(point_at(numbers, i));
  return result;
}

// Of the rounded vertices; outer boundaries count positive, holes negative.
double area(const Part& part) {
  double twice = 0;
  const auto add = [&twice](const Polygon& boundary) {
    for (auto edge = boundary.edges_begin(); edge != boundary.edges_end(); ++edge) {
      const Kernel::Segment_2 segment = *edge;
      twice += CGAL::to_double(segment.source().x()) * CGAL::to_double(segment.target().y()) -
               CGAL::to_double(segment.source().y()) * CGAL::to_double(segment.target().x());
    }
  };
  add(part.outer_boundary());
  for (auto hole = part.holes_begin(); hole != part.holes_end(); ++hole) add(*hole);
  return twice / 2;
}

}  // namespace

void unite_polygons(const Task& task) {
  const Input input = read_all(task, "polygons")[0];
  Best best;
  PolygonSet result;
  for (int round = 0; round < task.rounds; ++round) {
    result.clear();
    std::vector<Polygon> polygons;
    for (std::size_t i = 0; i < input.size(); ++i) polygons.push_back(polygon(input[i]));
    best.start();
    result.join(polygons.begin(), polygons.end());
    best.stop();
  }
  std::vector<Part> parts;
  result.polygons_with_holes(std::back_inserter(parts));
  std::size_t holes = 0;
  double sum = 0;
  for (const Part& part : parts) {
    holes += part.number_of_holes();
    sum += area(part);
  }
  report(best, result.arrangement(),
         member("parts", double(parts.size())) + member("holes", double(holes)) + member("area", sum));
}

// The counts are those of the boundary of the sum: every boundary is a cycle, and bounds one more face.
void add_polygons(const Task& task) {
  const std::vector<Input> inputs = read_all(task, "polygons");
  Best best;
  Part sum;
  for (int round = 0; round < task.rounds; ++round) {
    const Polygon a = polygon(inputs[0][0]);
    const Polygon b = polygon(inputs[1][0]);
    best.start();
    sum = CGAL::minkowski_sum_by_reduced_convolution_2(a, b);
    best.stop();
  }
  std::size_t vertices = sum.outer_boundary().size();
  for (auto hole = sum.holes_begin(); hole != sum.holes_end(); ++hole) vertices += hole->size();
  struct Counts {
    std::size_t vertices;
    std::size_t faces;
    std::size_t number_of_vertices() const { return vertices; }
    std::size_t number_of_edges() const { return vertices; }
    std::size_t number_of_faces() const { return faces; }
  };
  report(best, Counts{vertices, 2 + sum.number_of_holes()},
         member("holes", double(sum.number_of_holes())) + member("area", area(sum)));
}

}  // namespace peer
