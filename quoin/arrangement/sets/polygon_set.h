// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "quoin/arrangement/arrangement.h"
#include "quoin/arrangement/sets/fill_rule.h"

namespace quoin {

enum class SetOperation : std::uint8_t {
  unite,
  intersect,
  subtract,              ///< all others from the first
  symmetric_difference,  ///< in an odd number of them
  first                  ///< the first as it is
};

/// Whether sets keep edges and vertices without area.
enum class Regularity : std::uint8_t {
  regularized,  ///< closure of the interior: edges and vertices belong to a set if a face next to them does
  plain         ///< every vertex, edge and face is a member or not by itself
};

/// A set of points of a surface whose boundary consists of curves of one family: an arrangement and for each cell
/// whether it is a member. It may be unbounded, or everything.
///
/// Kept in the one simplest form: no edge with the same membership on it and on both sides, no vertex of degree two
/// inside an edge of one branch with the same membership, no isolated vertex like its face. Two sets are equal if their
/// arrangements and memberships are.
template <CurveFamily F>
class PolygonSet {
 public:
  /// The empty set.
  PolygonSet();
  /// Members by real cell; the rest is ignored. Simplified.
  PolygonSet(const Arrangement<F>& arrangement, std::vector<bool> vertices, std::vector<bool> edges,
             std::vector<bool> faces);

  const Arrangement<F>& arrangement() const { return arrangement_; }
  bool contains(dcel::VertexId v) const { return vertices_[v.index()]; }
  bool contains(dcel::EdgeId e) const { return edges_[e.index()]; }
  bool contains(dcel::FaceId f) const { return faces_[f.index()]; }
  const std::vector<bool>& vertex_members() const { return vertices_; }
  const std::vector<bool>& edge_members() const { return edges_; }
  const std::vector<bool>& face_members() const { return faces_; }

  bool is_empty() const;
  bool is_everything() const;
  /// Some member face is unbounded (in the plane).
  bool is_unbounded() const;
  /// No member edge or vertex but on the boundary of a member face, and all of these.
  bool is_regular() const;

  // Topological operators; O(size).
  PolygonSet complement() const;
  PolygonSet interior() const;
  PolygonSet closure() const;
  PolygonSet boundary() const;
  /// Closure of the interior.
  PolygonSet regularized() const;

 private:
  Arrangement<F> arrangement_;
  std::vector<bool> vertices_;
  std::vector<bool> edges_;
  std::vector<bool> faces_;
};

/// Combines any number of sets by one sweep.
///
/// Exact; touching, overlapping and equal sets are ordinary. Without operands the result is empty. O((n + k) log n).
/// @throws Cancelled
template <CurveFamily F>
PolygonSet<F> combine(std::span<const PolygonSet<F>* const> sets, SetOperation operation, Regularity regularity,
                      const Context& context);

/// Combines operands given as directed closed chains, straight from the list: curve k of the list is a piece of the
/// boundary of operand `operand_of_curve[k]`, its interior on the left. Chains may overlap and cross; `rule` says what
/// each operand is. The result is regularized. One sweep, whatever the number of operands.
/// @throws Cancelled
template <CurveFamily F>
PolygonSet<F> combine_rings(F family, const PieceList<F>& rings, std::span<const std::uint32_t> operand_of_curve,
                            std::uint32_t operand_count, FillRule rule, SetOperation operation, const Context& context);

/// How directed closed curves make up operands.
struct RegionGroups {
  std::vector<std::uint32_t> element_of_curve;
  std::vector<FillRule> rule_of_element;  ///< what the curves of an element enclose together
  std::vector<std::uint32_t> operand_of_element;
  std::uint32_t operand_count = 0;
};

/// The same from curves that are arranged already, in two levels: an operand is the union of its elements. O(size).
template <CurveFamily F>
PolygonSet<F> combine_regions(const Arrangement<F>& drawn, const RegionGroups& groups, SetOperation operation);

/// What is wrong with the rings of a polygon.
struct RingProblem {
  enum class Kind : std::uint8_t {
    overlap,         ///< two rings of an element, or a ring twice, run along the same edge
    crosses_itself,  ///< a ring encloses something more than once, or in both directions
    hole_outside,    ///< part of a hole lies outside the outer ring
    holes_overlap
  };
  Kind kind = Kind::overlap;
  std::uint32_t first_curve = 0;
  std::uint32_t second_curve = 0;  ///< of kinds with two rings
  dcel::EdgeId edge;               ///< where: an edge next to the place
};

/// Stands for the element of curves that `find_ring_problem` leaves alone.
constexpr std::uint32_t no_element = 0xFFFFFFFFU;

/// Whether the curves bound polygons: every element one outer ring and holes inside it, each simple; rings may touch in
/// points. Elements may overlap one another. Orientation does not matter. Returns the first problem in the order of
/// faces. O(size).
template <CurveFamily F>
std::optional<RingProblem> find_ring_problem(const Arrangement<F>& drawn,
                                             std::span<const std::uint32_t> element_of_curve,
                                             const std::vector<bool>& is_hole);

/// A boundary cycle of a set: simple, but may touch others; the set lies on its left.
struct PolygonRing {
  std::vector<dcel::HalfedgeId> halfedges;
  bool is_hole = false;
};
/// A connected part of the interior of a bounded set.
struct PolygonWithHoles {
  PolygonRing outer;
  std::vector<PolygonRing> holes;
};

/// The member faces of a set in the plane as polygons with holes, by their smallest vertices; where a boundary touches
/// itself it is cut into simple rings. @throws InputError if the set is unbounded
template <CurveFamily F>
std::vector<PolygonWithHoles> polygons_of(const PolygonSet<F>& set);

}  // namespace quoin
