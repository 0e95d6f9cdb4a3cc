// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/base/large_vector.h"
#include "quoin/kernel/point.h"
#include "quoin/number/rational.h"
#include "quoin/topology/filtration.h"
#include "quoin/triangulation/smallest_spheres.h"

namespace quoin {

class Delaunay2;
class Delaunay3;
class Regular2;
class Regular3;

/// The alpha complexes of points of the plane or of space, weighted or not, of any affine dimension: a filtration of
/// all simplices of their triangulation.
///
/// The value of a simplex is the least power of a sphere that is orthogonal to its vertices and to no vertex less:
/// without weights, the squared radius of the smallest empty sphere through it. At a value a the complex is that of the
/// balls of squared radii a + weight, each cut to the power cell of its point: it has the homotopy type of their union.
/// Values are exact: grades are the ranks of the distinct values, equal if and only if the values are. Where more
/// points than it takes lie on a sphere the triangulation chooses diagonals; values, and the homology at each of them,
/// do not depend on that.
///
/// Vertices are those of the triangulation that are not hidden, in its order: `complex().label(v)` is the number there.
/// Hence the order in which points are given changes nothing, nor does the number of threads. Immutable; does not need
/// the triangulation any more. Source: Edelsbrunner and Mücke 1994; Edelsbrunner 1995 for weights.
class AlphaComplex {
 public:
  /// O(n log n) for n simplices, less where values are spread; of which there are O(p^2) for p points.
  /// @throws InputError of 2^32 simplices or more; Cancelled
  AlphaComplex(const Delaunay3& triangulation, const Context& context);
  AlphaComplex(const Regular3& triangulation, const Context& context);
  AlphaComplex(const Delaunay2& triangulation, const Context& context);
  AlphaComplex(const Regular2& triangulation, const Context& context);

  /// Of the affine hull of the points; -1 of none.
  int dimension() const { return filtration_.complex.dimension(); }
  const SimplicialComplex& complex() const { return filtration_.complex; }
  /// What `persistence` takes.
  const Filtration& filtration() const { return filtration_; }
  std::uint32_t grade_of(SimplexId s) const { return filtration_.grade_of(s); }
  /// Points and weights by the vertices of the complex; points of the plane have z = 0.
  const SmallestSpheres& spheres() const { return spheres_; }

  std::uint32_t grade_count() const { return static_cast<std::uint32_t>(simplex_of_grade_.size()); }
  /// The nearest double, ties to even; infinite beyond the largest. Computed each time, as a rule in less than a
  /// microsecond.
  double value(std::uint32_t grade) const {
    return spheres_.nearest_power(complex().vertices(simplex_of_grade_[grade])) + 0.0;  // not the negative zero
  }
  Rational exact_value(std::uint32_t grade) const;
  /// A simplex the smallest sphere of which has the value: of the highest dimension the first by vertices.
  SimplexId simplex_of_grade(std::uint32_t grade) const { return simplex_of_grade_[grade]; }

  /// Whether no vertex is inside the smallest sphere of the simplex, so that its value is the power of that; else the
  /// value is that of the least coface, and the simplex is attached to that. Vertices on the sphere are not inside.
  bool is_gabriel(SimplexId s) const { return place_[s.dimension][s.index] != Place::attached; }
  /// Whether an edge has no vertex inside its smallest sphere, nor on it but for its ends. Without weights such edges
  /// are in all Delaunay triangulations.
  bool has_empty_ball(std::uint32_t edge) const { return place_[1][edge] == Place::empty; }

  /// How many grades have values up to this one: the complex there is that of all simplices of smaller grades. O(log n)
  std::uint32_t grades_up_to(const Rational& value) const;
  /// Infinity has all of them. @throws InputError if it is no number
  std::uint32_t grades_up_to(double value) const;

  /// All simplices by value, those of equal value by dimension, then by vertices. @throws Cancelled
  std::vector<SimplexId> order(const Context& context) const;

 private:
  /// Of the smallest sphere of a simplex: without other vertices, with some on it, with some inside.
  enum class Place : std::uint8_t { empty, touched, attached };

  template <class PointOf, class WeightOf>
  void build(const std::vector<std::uint32_t>& cells, int dimension, bool is_weighted, const PointOf& point,
             const WeightOf& weight, const Context& context);
  static Place place_of(Sign side) {
    return side == Sign::positive ? Place::empty : side == Sign::zero ? Place::touched : Place::attached;
  }
  template <class Look>
  void look_at_facets(int k, const Look& look, const Context& context);
  template <class Visit>
  void for_each_simplex(const Context& context, const Visit& visit) const;
  LargeVector<Interval> find_places(const Context& context);
  void find_grades(LargeVector<Interval> bounds, const Context& context);

  Filtration filtration_;
  SmallestSpheres spheres_{{}};
  std::vector<std::vector<Place>> place_;  ///< by dimension and simplex
  std::vector<SimplexId> simplex_of_grade_;
};

}  // namespace quoin
