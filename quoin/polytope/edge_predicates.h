// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include <cstddef>

#include "quoin/base/sign.h"
#include "quoin/kernel/point.h"
#include "quoin/kernel/rational_point.h"

namespace quoin {

/// A vector between two points, and exact by these; or by `exact`, where they are no doubles.
struct EdgeVector {
  Point3 from;
  Point3 to;
  const RationalPoint3* exact = nullptr;  ///< if there is one, `from` is zero and `to` the vector, rounded
};

/// Of a vector that lives as long as what is returned.
EdgeVector edge_vector(const RationalPoint3& exact);

RationalPoint3 exact_vector(const EdgeVector& v);

/// Each component within u = 2^-53 of itself; or none is a number, where a rational is beyond what doubles can do so:
/// every filter leaves such to the exact tier.
inline Vector3 rounded(const EdgeVector& v) {
  return {v.to.x - v.from.x, v.to.y - v.from.y, v.to.z - v.from.z};
}

/// The normal u x w of a facet, by two of its rounded edges. `size` is the sum of all products in its components, which
/// err by less than 4.1 u times it together.
struct RoundedNormal {
  Vector3 vector;
  double size = 0;
};
inline RoundedNormal rounded_normal(const Vector3& u, const Vector3& w) {
  const double yz = u.y * w.z;
  const double zy = u.z * w.y;
  const double zx = u.z * w.x;
  const double xz = u.x * w.z;
  const double xy = u.x * w.y;
  const double yx = u.y * w.x;
  return {{yz - zy, zx - xz, xy - yx},
          std::fabs(yz) + std::fabs(zy) + std::fabs(zx) + std::fabs(xz) + std::fabs(xy) + std::fabs(yx)};
}

/// Sign of det(a, b, c) for rounded vectors; of what they do not decide, `exact()`.
///
/// Each of six terms is a product of three rounded differences, rounded twice, in sums rounded three times: below 8.1 u
/// times the permanent; what falls below the range of doubles is paid for beside.
template <class Exact>
Sign determinant(const Vector3& a, const Vector3& b, const Vector3& c, const Exact& exact) {
  const double yz = b.y * c.z;
  const double zy = b.z * c.y;
  const double zx = b.z * c.x;
  const double xz = b.x * c.z;
  const double xy = b.x * c.y;
  const double yx = b.y * c.x;
  const double value = a.x * (yz - zy) + a.y * (zx - xz) + a.z * (xy - yx);
  const double size = std::fabs(a.x) * (std::fabs(yz) + std::fabs(zy)) +
                      std::fabs(a.y) * (std::fabs(zx) + std::fabs(xz)) +
                      std::fabs(a.z) * (std::fabs(xy) + std::fabs(yx));
  const double bound = 9 * 0x1p-53 * size + 0x1p-1000 * (std::fabs(a.x) + std::fabs(a.y) + std::fabs(a.z)) + 0x1p-1000;
  if (value > bound) return Sign::positive;
  if (value < -bound) return Sign::negative;
  return exact();
}

/// Sign of n.d, likewise. The normal errs by 4.1 u size, the vector by u, products and sums by 3 u more.
template <class Exact>
Sign side(const RoundedNormal& n, const Vector3& d, const Exact& exact) {
  const double value = n.vector.x * d.x + n.vector.y * d.y + n.vector.z * d.z;
  const double length = std::fabs(d.x) + std::fabs(d.y) + std::fabs(d.z);
  const double bound = (9 * 0x1p-53 * n.size + 0x1p-1000) * length + 0x1p-1000;
  if (value > bound) return Sign::positive;
  if (value < -bound) return Sign::negative;
  return exact();
}

/// Sign of det(a, b, c).
Sign exact_determinant(const EdgeVector& a, const EdgeVector& b, const EdgeVector& c);

/// Sign of the first component of (a x b) x c that is not zero; zero if all are. Exact.
Sign first_sign_of_double_cross(const EdgeVector& a, const EdgeVector& b, const EdgeVector& c);

/// Exact.
bool are_parallel(const EdgeVector& a, const EdgeVector& b);
/// And of one direction.
bool point_one_way(const EdgeVector& a, const EdgeVector& b);

/// Sign of the component. Exact.
Sign component_sign(const EdgeVector& v, unsigned axis);
/// Sign of the component of a x b. Exact.
Sign cross_sign(const EdgeVector& a, const EdgeVector& b, unsigned axis);

}  // namespace quoin
