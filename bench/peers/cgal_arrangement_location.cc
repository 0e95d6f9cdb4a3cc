// SPDX-License-Identifier: Apache-2.0
#include <CGAL/Arr_landmarks_point_location.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arr_trapezoid_ric_point_location.h>
#include <CGAL/Arrangement_2.h>

#include <unordered_map>

#include "cgal_arrangement.h"

namespace peer {

namespace {

using Traits = CGAL::Arr_segment_traits_2<Kernel>;
using Arrangement = CGAL::Arrangement_2<Traits>;
using Ric = CGAL::Arr_trapezoid_ric_point_location<Arrangement>;
using Landmarks = CGAL::Arr_landmarks_point_location<Arrangement>;
using Cell = CGAL::Arr_point_location_result<Arrangement>::Type;

// Enough to compare answers without names of cells: how many queries are on vertices, on edges, in the unbounded face,
// and the number of halfedges on the outer boundary of the face, summed over the other queries.
std::string answers(const Arrangement& arrangement, const std::vector<Cell>& cells) {
  std::unordered_map<const void*, std::size_t> sizes;
  for (auto face = arrangement.faces_begin(); face != arrangement.faces_end(); ++face) {
    if (face->is_unbounded()) continue;
    std::size_t size = 0;
    auto at = face->outer_ccb();
    const auto first = at;
    do ++size;
    while (++at != first);
    sizes[&*face] = size;
  }
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t unbounded = 0;
  std::size_t boundary = 0;
  for (const Cell& cell : cells) {
    if (const auto* face = boost::get<Arrangement::Face_const_handle>(&cell)) {
      const auto found = sizes.find(&**face);
      if (found == sizes.end()) {
        ++unbounded;
      } else {
        boundary += found->second;
      }
    } else {
      ++(boost::get<Arrangement::Vertex_const_handle>(&cell) != nullptr ? vertices : edges);
    }
  }
  return member("on_vertices", double(vertices)) + member("on_edges", double(edges)) +
         member("unbounded", double(unbounded)) + member("boundary", double(boundary));
}

template <class Location>
void locate_by(Arrangement& arrangement, const Input& queries, int rounds) {
  Best built;
  Best asked;
  std::vector<Cell> cells;
  for (int round = 0; round < rounds; ++round) {
    std::vector<Kernel::Point_2> points;
    for (std::size_t i = 0; i < queries.size(); ++i) points.push_back(point_at(queries[i], 0));
    cells.clear();
    cells.reserve(points.size());
    Location location;
    built.start();
    location.attach(arrangement);
    built.stop();
    asked.start();
    for (const Kernel::Point_2& p : points) cells.push_back(location.locate(p));
    asked.stop();
  }
  report(asked, arrangement,
         member("build_seconds", built.seconds()) + member("build_cpu_seconds", built.cpu_seconds()) +
             answers(arrangement, cells));
}

}  // namespace

void locate(const Task& task) {
  const Input segments = arrangement_input::read(task.files[0]);
  const Input queries = arrangement_input::read(task.files[1]);
  if (segments.kind != "segments" || queries.kind != "points") throw std::runtime_error("segments and points, please");
  std::vector<Traits::Curve_2> curves;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    curves.emplace_back(point_at(segments[i], 0), point_at(segments[i], 1));
  }
  Arrangement arrangement;
  CGAL::insert(arrangement, curves.begin(), curves.end());
  if (task.strategy == "ric") return locate_by<Ric>(arrangement, queries, task.rounds);
  if (task.strategy == "landmarks") return locate_by<Landmarks>(arrangement, queries, task.rounds);
  throw std::runtime_error("no strategy is called " + task.strategy);
}

}  // namespace peer
