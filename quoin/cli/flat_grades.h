// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/cli/square_grades.h"
#include "quoin/flow/critical_spheres.h"
#include "quoin/flow/flat_flow.h"

namespace quoin::cli {

/// The squared distances at critical points of a plane or line as grades, in exact order. Grade 0 is that of the points
/// themselves.
class FlatGrades {
 public:
  /// The complex must outlive it. O(n log n) comparisons. @throws Cancelled
  FlatGrades(const FlowComplex& flow, const Context& context);
  FlatGrades(const FlatGrades&) = delete;
  FlatGrades& operator=(const FlatGrades&) = delete;

  /// Critical edges and polygons, ascending: what has a number here is at that place.
  std::span<const std::uint32_t> edges() const { return edges_; }
  std::span<const std::uint32_t> polygons() const { return polygons_; }
  /// Numbers by ascending distance; ties by number.
  std::span<const std::uint32_t> edges_in_order() const { return edges_in_order_; }
  std::span<const std::uint32_t> polygons_in_order() const { return polygons_in_order_; }

  std::uint32_t count() const { return grades_.count(); }
  /// As SquareGrades has it.
  double square(std::uint32_t grade) const { return grades_.square(grade); }
  std::uint32_t of_edge(std::uint32_t i) const { return grades_.of(i); }
  std::uint32_t of_polygon(std::uint32_t i) const { return grades_.of(edge_count() + i); }
  /// How many grades are at most this. Exact. O(log n)
  std::uint32_t up_to(const Rational& square) const { return grades_.up_to(square); }

 private:
  std::uint32_t edge_count() const { return static_cast<std::uint32_t>(edges_.size()); }
  DeloneFace face(std::uint32_t i) const;
  CriticalFace critical(std::uint32_t i) const;
  SquareList squares() const;

  const FlowComplex& flow_;
  CriticalSpheres spheres_;
  std::vector<std::uint32_t> edges_;
  std::vector<std::uint32_t> polygons_;
  SquareGrades grades_;  // of edges, then polygons
  std::vector<std::uint32_t> edges_in_order_;
  std::vector<std::uint32_t> polygons_in_order_;
};

/// A hole of the union of balls, by numbers: it begins at an edge that cuts it off, and ends at a polygon.
struct FlatHole {
  std::uint32_t edge = 0;
  std::uint32_t polygon = 0;
};

/// Of edges that join two parts, ascending; all other critical edges begin a hole. @throws Cancelled
std::vector<std::uint32_t> joining_edges(const FlowComplex& flow, const FlatGrades& grades, const Context& context);

/// The holes, in descending order of their edges: what an edge cuts off from a higher maximum, or from outside. Exact.
/// @throws Cancelled
std::vector<FlatHole> holes_of(FlatFlow& flow, const FlatGrades& grades, const Context& context);

}  // namespace quoin::cli
