// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/topology/simplicial_complex.h"

namespace quoin {

/// Whether a complex of dimension d is a manifold, perhaps with boundary, and a witness if it is not.
///
/// Up to dimension 3 the answer is about topological manifolds. Above, about homology manifolds: links have the integer
/// homology of a sphere or of a point; whether such a link is a sphere is not decidable in general.
struct ManifoldReport {
  std::optional<SimplexId> impure;     ///< a maximal simplex of dimension below d
  std::optional<SimplexId> branching;  ///< of dimension d - 1, in more than two simplices of dimension d
  std::optional<SimplexId> pinched;  ///< its link is neither a sphere nor a ball; looked for where the others are empty
  std::size_t boundary_facets = 0;   ///< simplices of dimension d - 1 in just one of dimension d

  bool is_manifold() const { return !impure && !branching && !pinched; }
  bool is_closed() const { return is_manifold() && boundary_facets == 0; }
};

/// O(size) up to dimension 3 for links of bounded size; above, O(size^2) and the homology of every link. The empty
/// complex is a closed manifold. @throws Cancelled
ManifoldReport check_manifold(const SimplicialComplex& complex, const Context& context);

/// The simplices opposite to a simplex in those that contain it, as a complex with the labels of the whole.
/// O(size); use `check_manifold` for all links.
SimplicialComplex link(const SimplicialComplex& complex, SimplexId s, const Context& context);

/// Orientations of the simplices of the highest dimension d that agree across every facet of just two of them.
struct OrientationReport {
  std::vector<bool> is_reversed;  ///< against the ascending order of vertices; in each component, not for the first one
  /// Empty if there are such orientations; else simplices of dimension d, each sharing such a facet with the next, and
  /// the last with the first, around which orientation is reversed.
  std::vector<std::uint32_t> reversing_loop;

  bool is_orientable() const { return reversing_loop.empty(); }
};

/// O(size) @throws Cancelled
OrientationReport orient(const SimplicialComplex& complex, const Context& context);

/// A connected surface, up to homeomorphism.
struct SurfaceClass {
  bool is_orientable = true;
  std::int64_t euler_characteristic = 0;
  std::size_t boundary_loops = 0;
  std::size_t genus = 0;  ///< handles, or projective planes where it cannot be oriented
  friend bool operator==(const SurfaceClass&, const SurfaceClass&) = default;
};

/// The class of each component, in the order of connected_components. O(size)
/// @throws InputError  the complex is not a surface: not a manifold of dimension 2, perhaps with boundary
std::vector<SurfaceClass> classify_surface(const SimplicialComplex& complex, const Context& context);
/// The same where it is known what `check_manifold` says of the complex.
std::vector<SurfaceClass> classify_surface(const SimplicialComplex& complex, const ManifoldReport& report,
                                           const Context& context);

}  // namespace quoin
