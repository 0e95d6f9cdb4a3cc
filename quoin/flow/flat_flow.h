// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/flow/flow_complex.h"
#include "quoin/flow/flow_survey.h"
#include "quoin/flow/stable_surface.h"
#include "quoin/number/interval.h"

namespace quoin {

/// Where a way from a saddle of index 1 ends, of points of a plane or line.
struct FlatWay {
  static constexpr std::uint32_t infinity = 0xFFFFFFFF;
  std::uint32_t end = infinity;    ///< the polygon whose centre it ends in
  std::uint32_t first = infinity;  ///< the polygon whose centre it reaches first
  std::uint32_t segments = 1;
  bool has_passed_regular = false;
};

/// The flow of points of one plane, in the plane, or of one line: there, what flows from critical points of index 1 are
/// two ways each, along Voronoi edges of the plane, and those of index 2 are maxima. The flow of space is the same
/// times the direction across the plane: sheets are these ways times a line, and from saddles of index 2 both ways go
/// straight to infinity. Ways of points of a line go straight to infinity.
///
/// Exact: all that flows between centres of polygons, so that nothing is constructed. O(n) memory.
class FlatFlow {
 public:
  /// The complex must be of dimension 2 at most, and outlive it. @throws InputError
  explicit FlatFlow(const FlowComplex& flow);

  /// The two ways of a critical edge. Each polygon is advanced once. @throws Cancelled
  std::array<FlatWay, 2> ways(std::uint32_t edge, const Context& context);
  /// The edge across which the flow leaves the centre of a polygon; nothing where it stops. Behind a stationary point
  /// that is not critical it goes on; `passes` is set there.
  std::optional<std::uint32_t> exit(std::uint32_t polygon, bool& passes) const;
  /// The polygon whose centre comes next; infinity, or the polygon itself where the flow stops.
  std::uint32_t next(std::uint32_t polygon, bool& passes) const;

  const FlowComplex& complex() const { return flow_; }

 private:
  std::uint32_t beyond(std::uint32_t edge, std::uint32_t polygon) const;
  void trace(std::uint32_t polygon, const Context& context);

  const FlowComplex& flow_;
  std::vector<FlatWay> known_;  ///< of each polygon's centre; of no segments until it is known
};

/// What StableSurvey has: the triangles of the plane that flow to critical points of index 2. Each surface costs its
/// own size. @throws Cancelled
StableSurvey survey_flat_stable(const FlowComplex& flow, const Context& context);

/// Ways of all critical edges, in the plane.
struct FlatSurvey {
  Histogram segments;
  std::size_t to_infinity = 0;
  ManifoldList passed_regular;  ///< critical edges by their numbers among them; twice where both ways did
};

/// @throws Cancelled
FlatSurvey survey_flat_unstable(FlatFlow& flow, const Context& context);

/// Critical points up to a squared distance, and the Betti numbers of the union of balls of this squared radius. Exact.
struct FlatShape {
  std::array<std::vector<std::uint32_t>, 3> faces;  ///< critical vertices, edges and polygons up to it
  std::array<std::size_t, 3> betti_numbers{};
};

/// O(n) comparisons, by bounds, exact where they do not tell. @throws Cancelled
FlatShape flat_shape(const FlowComplex& flow, const Rational& square, const Context& context);

/// Bounds of the squared distance at the centre of a vertex, edge or polygon.
Interval square_radius_bounds(const FlowComplex& flow, DeloneFace face);

/// Critical faces of a dimension, ascending.
std::vector<std::uint32_t> critical_faces(const FlowComplex& flow, unsigned dimension);

}  // namespace quoin
