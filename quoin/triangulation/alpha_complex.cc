// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/alpha_complex.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "quoin/base/error.h"
#include "quoin/base/parallel.h"
#include "quoin/base/polled_resize.h"
#include "quoin/triangulation/delaunay2.h"
#include "quoin/triangulation/delaunay3.h"
#include "quoin/triangulation/exact_ranks.h"
#include "quoin/triangulation/regular2.h"
#include "quoin/triangulation/regular3.h"

namespace quoin {

namespace {

constexpr std::size_t poll_interval = 1024;
constexpr std::size_t grain = 256;
constexpr std::uint32_t none = 0xFFFFFFFF;

/// The simplices of full dimension of a triangulation of space.
template <class Triangulation>
std::vector<std::uint32_t> cells_of_space(const Triangulation& triangulation, const Context& context) {
  std::vector<std::uint32_t> list;
  const auto size = triangulation.dimension() + 1;
  list.reserve(triangulation.cells().size() * static_cast<std::size_t>(size));
  for (std::size_t c = 0; c < triangulation.cells().size(); ++c) {
    if (c % poll_interval == 0) context.poll();
    if (triangulation.is_ghost(c)) continue;
    const auto& v = triangulation.cells()[c].vertices;
    list.insert(list.end(), v.begin(), v.begin() + size);
  }
  return list;
}

template <class Triangulation>
std::vector<std::uint32_t> cells_of_plane(const Triangulation& triangulation, const Context& context) {
  std::vector<std::uint32_t> list;
  const std::span<const Vertex2> line = triangulation.line();
  if (line.size() == 1) list.push_back(line[0].value);
  for (std::size_t i = 1; i < line.size(); ++i) list.insert(list.end(), {line[i - 1].value, line[i].value});
  const Triangulation2& links = triangulation.links();
  for (std::uint32_t t = 0; t < links.triangle_count(); ++t) {
    if (t % poll_interval == 0) context.poll();
    const auto& v = links.links()[t].corner;
    if (!links.is_infinite(Triangle2(t))) list.insert(list.end(), v.begin(), v.end());
  }
  return list;
}

Point3 in_space(const Point2& p) {
  return {p.x, p.y, 0};
}

}  // namespace

AlphaComplex::AlphaComplex(const Delaunay3& triangulation, const Context& context) {
  build(
      cells_of_space(triangulation, context), triangulation.dimension(), false,
      [&](std::uint32_t v) { return triangulation.point(v); }, [](std::uint32_t) { return 0.0; }, context);
}

AlphaComplex::AlphaComplex(const Regular3& triangulation, const Context& context) {
  build(
      cells_of_space(triangulation, context), triangulation.dimension(), true,
      [&](std::uint32_t v) { return triangulation.point(v); }, [&](std::uint32_t v) { return triangulation.weight(v); },
      context);
}

AlphaComplex::AlphaComplex(const Delaunay2& triangulation, const Context& context) {
  build(
      cells_of_plane(triangulation, context), triangulation.dimension(), false,
      [&](std::uint32_t v) { return in_space(triangulation.point(Vertex2(v))); }, [](std::uint32_t) { return 0.0; },
      context);
}

AlphaComplex::AlphaComplex(const Regular2& triangulation, const Context& context) {
  build(
      cells_of_plane(triangulation, context), triangulation.dimension(), true,
      [&](std::uint32_t v) { return in_space(triangulation.point(Vertex2(v)).point); },
      [&](std::uint32_t v) { return triangulation.point(Vertex2(v)).weight; }, context);
}

template <class PointOf, class WeightOf>
void AlphaComplex::build(const std::vector<std::uint32_t>& cells, int dimension, bool is_weighted, const PointOf& point,
                         const WeightOf& weight, const Context& context) {
  SimplicialComplex& complex = filtration_.complex;
  if (dimension >= 0) {
    complex = SimplicialComplex::closure_of_cells(cells, static_cast<std::size_t>(dimension) + 1, context);
  }
  std::vector<Point3> points(complex.count(0));
  std::vector<double> weights(is_weighted ? points.size() : 0);
  for (std::uint32_t v = 0; v < points.size(); ++v) {
    if (v % poll_interval == 0) context.poll();
    points[v] = point(complex.label(v));
    if (is_weighted) weights[v] = weight(complex.label(v));
  }
  spheres_ = SmallestSpheres(std::move(points), std::move(weights));
  find_grades(find_places(context), context);
}

/// Where the vertices of all simplices of dimension k are in the smallest spheres of the facets opposite:
/// `look(vertices, place in the list)` tells, two bits for each vertex. Of each facet the innermost counts.
template <class Look>
void AlphaComplex::look_at_facets(int k, const Look& look, const Context& context) {
  const SimplicialComplex& complex = filtration_.complex;
  std::vector<std::uint8_t> places;
  resize_and_poll(places, complex.count(k), context);
  for_each_chunk(context, places.size(), grain, [&](const Chunk& chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      places[i] = look(complex.vertices({k, static_cast<std::uint32_t>(i)}), i);
    }
  });
  for (std::uint32_t i = 0; i < places.size(); ++i) {
    if (i % poll_interval == 0) context.poll();
    unsigned bits = places[i];
    for (const std::uint32_t facet : complex.facets({k, i})) {
      place_[k - 1][facet] = std::max(place_[k - 1][facet], static_cast<Place>(bits & 3));
      bits >>= 2;
    }
  }
}

/// And the powers of tetrahedra, as these are known by then; there is room for others.
LargeVector<Interval> AlphaComplex::find_places(const Context& context) {
  const SimplicialComplex& complex = filtration_.complex;
  for (int k = 0; k <= dimension(); ++k)
    resize_and_poll(place_.emplace_back(), complex.count(k), context, Place::empty);
  const auto bits = [](Sign side, std::size_t j) { return static_cast<unsigned>(place_of(side)) << 2 * j; };
  LargeVector<Interval> powers;
  powers.reserve(complex.size());
  resize_and_poll(powers, complex.count(3), context);
  const auto look_in_cell = [&](SmallestSpheres::Simplex v, std::size_t i) {
    const SmallestSpheres::Cell cell = spheres_.cell({v[0], v[1], v[2], v[3]});
    powers[i] = cell.power;
    unsigned places = 0;
    for (std::size_t j = 0; j < 4; ++j) places |= bits(cell.side[j], j);
    return static_cast<std::uint8_t>(places);
  };
  const auto look_in_triangle = [&](SmallestSpheres::Simplex v, std::size_t) {
    return static_cast<std::uint8_t>(bits(spheres_.side(std::array{v[1], v[2]}, v[0]), 0) |
                                     bits(spheres_.side(std::array{v[0], v[2]}, v[1]), 1) |
                                     bits(spheres_.side(std::array{v[0], v[1]}, v[2]), 2));
  };
  const auto look_in_edge = [&](SmallestSpheres::Simplex v, std::size_t) {
    return static_cast<std::uint8_t>(bits(spheres_.side(v.last(1), v[0]), 0) |
                                     bits(spheres_.side(v.first(1), v[1]), 1));
  };
  if (dimension() > 2) look_at_facets(3, look_in_cell, context);
  if (dimension() > 1) look_at_facets(2, look_in_triangle, context);
  if (dimension() > 0 && spheres_.is_weighted()) look_at_facets(1, look_in_edge, context);
  return powers;
}

/// Values of Gabriel simplices are their own; others have the grade of a coface. Without weights those of vertices are
/// zero, and all others above.
void AlphaComplex::find_grades(LargeVector<Interval> bounds, const Context& context) {
  const SimplicialComplex& complex = filtration_.complex;
  const int lowest = spheres_.is_weighted() ? 0 : 1;
  // Items: Gabriel simplices, those of the highest dimension first.
  LargeVector<std::uint32_t> owner;
  std::array<std::uint32_t, 5> begin{};  // of dimension k those from begin[k + 1] to begin[k]
  if (complex.size() >= none) throw InputError("an alpha complex of 2^32 simplices or more");
  owner.reserve(complex.size());
  for (int k = 3; k >= lowest; --k) {
    for (std::uint32_t i = 0; i < complex.count(k); ++i) {
      if (i % poll_interval == 0) context.poll();
      if (!is_gabriel({k, i})) continue;
      owner.push_back(i);
    }
    begin[k] = static_cast<std::uint32_t>(owner.size());
  }
  const auto simplex_of = [&](std::uint32_t item) {
    int k = 3;
    while (item >= begin[k]) --k;
    return SimplexId{k, owner[item]};
  };
  const std::size_t known = bounds.size();
  resize_and_poll(bounds, owner.size(), context);
  for_each_chunk(context, owner.size() - known, grain, [&](const Chunk& chunk) {
    for (std::size_t i = known + chunk.begin; i < known + chunk.end; ++i) {
      bounds[i] = spheres_.power(complex.vertices(simplex_of(static_cast<std::uint32_t>(i))));
    }
  });
  const NumberSource source{
      [&](std::uint32_t item) { return spheres_.close_power(complex.vertices(simplex_of(item))); },
      [&](std::uint32_t item) { return spheres_.exact_power(complex.vertices(simplex_of(item))); }};
  const ExactRanks ranks = exact_ranks(bounds, source, context);

  const std::uint32_t zeros = lowest == 1 && complex.count(0) > 0 ? 1 : 0;
  simplex_of_grade_.reserve(ranks.first.size() + zeros);
  if (zeros > 0) simplex_of_grade_.push_back({0, 0});
  for (std::size_t i = 0; i < ranks.first.size(); ++i) {
    if (i % poll_interval == 0) context.poll();
    simplex_of_grade_.push_back(simplex_of(ranks.first[i]));
  }

  std::vector<std::vector<std::uint32_t>>& grade = filtration_.grade;
  for (int k = 0; k <= dimension(); ++k)
    resize_and_poll(grade.emplace_back(), complex.count(k), context, k < lowest ? 0 : none);
  for (int k = lowest; k <= dimension(); ++k) {
    for (std::uint32_t item = begin[k + 1]; item < begin[k]; ++item) {
      if (item % poll_interval == 0) context.poll();
      grade[k][owner[item]] = ranks.rank[item] + zeros;
    }
  }
  for (int k = dimension(); k > lowest; --k) {
    for (std::uint32_t i = 0; i < complex.count(k); ++i) {
      if (i % poll_interval == 0) context.poll();
      for (const std::uint32_t facet : complex.facets({k, i})) {
        grade[k - 1][facet] = std::min(grade[k - 1][facet], grade[k][i]);
      }
    }
  }
}

Rational AlphaComplex::exact_value(std::uint32_t grade) const {
  return spheres_.exact_power(complex().vertices(simplex_of_grade_[grade])).rational();
}

std::uint32_t AlphaComplex::grades_up_to(const Rational& value) const {
  std::uint32_t low = 0;
  std::uint32_t high = grade_count();
  while (low < high) {
    const std::uint32_t middle = low + (high - low) / 2;
    if (exact_value(middle) <= value) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

std::uint32_t AlphaComplex::grades_up_to(double value) const {
  if (std::isnan(value)) throw InputError("the value of an alpha complex is no number");
  if (std::isinf(value)) return value > 0 ? grade_count() : 0;
  return grades_up_to(Rational(value));
}

/// Those of each dimension after those below.
template <class Visit>
void AlphaComplex::for_each_simplex(const Context& context, const Visit& visit) const {
  for (int k = 0; k <= dimension(); ++k) {
    for (std::uint32_t i = 0; i < complex().count(k); ++i) {
      if (i % poll_interval == 0) context.poll();
      visit(SimplexId{k, i});
    }
  }
}

std::vector<SimplexId> AlphaComplex::order(const Context& context) const {
  std::vector<std::size_t> next;
  resize_and_poll(next, std::size_t{grade_count()} + 1, context);
  for_each_simplex(context, [&](SimplexId s) { ++next[grade_of(s) + 1]; });
  for (std::size_t g = 1; g < next.size(); ++g) {
    if (g % poll_interval == 0) context.poll();
    next[g] += next[g - 1];
  }
  std::vector<SimplexId> order;
  resize_and_poll(order, complex().size(), context);
  for_each_simplex(context, [&](SimplexId s) { order[next[grade_of(s)]++] = s; });
  return order;
}

}  // namespace quoin
