// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/polytope/polytope_shape.h"

namespace quoin {

/// The two signs that decide how the Gaussian maps of P and Q lie on one another, with Q turned by an infinitesimal
/// rotation so that none is ever zero: by the vector (1, h, h^2) e for h, and e beyond all powers of h, infinitesimal.
/// Every answer belongs to that one rotated pair, so together they are consistent. Exact.
class MapPredicates {
 public:
  MapPredicates(const PolytopeShape& p, const PolytopeShape& q) : p_(p), q_(q) {}

  /// n.d for the normal of a facet of P and a halfedge of Q. To first order the rotation adds w.(d x n).
  Sign side_of_normal(std::uint32_t facet, std::uint32_t halfedge) {
    const Sign sign =
        side(p_.normal(facet), q_.halfedges()[halfedge].vector, [&] { return exact_side(facet, halfedge); });
    if (sign != Sign::zero) return sign;
    has_ties_ = true;
    const std::uint32_t h = p_.first_halfedge(facet);
    return -first_sign_of_double_cross(p_.edge(h), p_.edge(p_.halfedges()[h].next), q_.edge(halfedge));
  }
  /// det(e, a, b) for a halfedge of P and two of Q that leave one vertex. The rotation adds w.((a x b) x e).
  Sign order_along_arc(std::uint32_t arc, std::uint32_t a, std::uint32_t b) {
    const Sign sign = determinant(p_.halfedges()[arc].vector, q_.halfedges()[a].vector, q_.halfedges()[b].vector,
                                  [&] { return exact_determinant(p_.edge(arc), q_.edge(a), q_.edge(b)); });
    if (sign != Sign::zero) return sign;
    has_ties_ = true;
    return first_sign_of_double_cross(q_.edge(a), q_.edge(b), p_.edge(arc));
  }
  /// Whether any sign was zero before the rotation.
  bool has_ties() const { return has_ties_; }

 private:
  Sign exact_side(std::uint32_t facet, std::uint32_t halfedge) const {
    const std::uint32_t h = p_.first_halfedge(facet);
    return exact_determinant(p_.edge(h), p_.edge(p_.halfedges()[h].next), q_.edge(halfedge));
  }

  const PolytopeShape& p_;
  const PolytopeShape& q_;
  bool has_ties_ = false;
};

}  // namespace quoin
