// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "quoin/polytope/translation_body.h"

namespace quoin {

/// The signs of a translation body in doubles: of each the true one, or zero where doubles do not decide.
///
/// Everything is measured from a double near the centre. Lengths of vectors are sums of their absolute components.
/// u = 2^-53; bounds are multiplied by `spare` to pay for their own roundings and for products of small errors, and
/// 2^-1000 pays for what falls below the range of doubles, where all numbers are below 2^200, and beyond that nothing
/// is decided.
class TranslationFilters {
 public:
  /// O(size of the body), in intervals. @throws Cancelled
  TranslationFilters(const TranslationBody& body, const Context& context);

  /// A translation, from the double near the centre: each component within u of itself.
  struct Query {
    Vector3 at;
    double size = 0;   ///< its length
    double reach = 0;  ///< the length, and what the centre is off by, over u
  };
  Query query(const Point3& t) const {
    const Vector3 d{t.x - centre_.x, t.y - centre_.y, t.z - centre_.z};
    const double size = length(d);
    // Not below: a NaN, too.
    if (!(size < 0x1p200) || !is_in_range_) return {d, infinite, infinite};
    return {d, size, size + centre_error_ * 0x1p53};
  }

  /// A translation that lies about in that direction from the centre.
  Vector3 towards(const Vector3& d) const {
    return {centre_.x + d.x * extent_, centre_.y + d.y * extent_, centre_.z + d.z * extent_};
  }

  /// As those of the body.
  int height(std::uint32_t f, const Query& t) const {
    const Plane& p = planes_[f];
    return sign(dot(p.normal, t.at) - p.height, p.relative * t.size + p.absolute + tiny);
  }
  /// With normals within m + r of m, of which `relative` is at least the largest component of r + 5 u |m|: the error is
  /// at most that times the length, and |m| + r times what the centre is off by, which 3 / (5 u) times that covers.
  int seen(std::uint32_t rim, const Query& t) const {
    const Side& s = sides_[rim];
    return sign(dot(s.normal, t.at), s.relative * t.reach + tiny);
  }
  int along(std::uint32_t tail, std::uint32_t head, const Query& t) const;
  int across(std::uint32_t facet, std::uint32_t tail, std::uint32_t head, const Query& t) const;
  int seen_along(std::uint32_t tail, std::uint32_t head, const Query& t, const Vector3& direction) const;

 private:
  struct Plane {
    Vector3 normal;
    double height;
    double relative;
    double absolute;
  };
  struct Side {
    Vector3 normal;
    double relative;
  };
  /// A vector and what it is off by, in length.
  struct Off {
    Vector3 vector;
    double error;
  };
  static constexpr double u = 0x1p-53;
  static constexpr double spare = 1 + 0x1p-30;
  static constexpr double tiny = 0x1p-1000;
  static constexpr double infinite = std::numeric_limits<double>::infinity();

  static double length(const Vector3& v) { return std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z); }
  static double dot(const Vector3& a, const Vector3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
  static int sign(double value, double bound) {
    return static_cast<int>(value > bound) - static_cast<int>(value < -bound);
  }
  static Off cross(const Off& a, const Off& b);
  static int sign_of_dot(const Off& a, const Off& b);
  Off from_vertex(std::uint32_t v, const Query& t) const;
  Off edge(std::uint32_t tail, std::uint32_t head) const;

  Point3 centre_;
  double extent_ = 1;        ///< about the size of the body
  double centre_error_ = 0;  ///< per component
  double vertex_error_ = 0;  ///< per component of any vertex
  bool is_in_range_ = true;
  std::vector<Vector3> vertices_;
  std::vector<Plane> planes_;
  std::vector<Side> sides_;
};

/// Each of six products errs by |a| eb + ea |b| + ea eb at most together, and is rounded once, and once more in a
/// difference.
inline TranslationFilters::Off TranslationFilters::cross(const Off& a, const Off& b) {
  const Vector3& p = a.vector;
  const Vector3& q = b.vector;
  const double la = length(p);
  const double lb = length(q);
  return {{p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x},
          spare * (la * b.error + a.error * (lb + b.error) + 3 * u * la * lb) + tiny};
}

/// Three products in sums of three roundings.
inline int TranslationFilters::sign_of_dot(const Off& a, const Off& b) {
  const double la = length(a.vector);
  const double lb = length(b.vector);
  const double bound = spare * (la * b.error + a.error * (lb + b.error) + 4 * u * la * lb) + tiny;
  return sign(dot(a.vector, b.vector), bound);
}

inline TranslationFilters::Off TranslationFilters::from_vertex(std::uint32_t v, const Query& t) const {
  const Vector3& p = vertices_[v];
  const Vector3 d{t.at.x - p.x, t.at.y - p.y, t.at.z - p.z};
  return {d, spare * (u * (t.size + length(d)) + 3 * vertex_error_)};
}

inline TranslationFilters::Off TranslationFilters::edge(std::uint32_t tail, std::uint32_t head) const {
  const Vector3& p = vertices_[tail];
  const Vector3& q = vertices_[head];
  const Vector3 d{q.x - p.x, q.y - p.y, q.z - p.z};
  return {d, spare * (u * length(d) + 6 * vertex_error_)};
}

inline int TranslationFilters::along(std::uint32_t tail, std::uint32_t head, const Query& t) const {
  return sign_of_dot(from_vertex(tail, t), edge(tail, head));
}

inline int TranslationFilters::across(std::uint32_t facet, std::uint32_t tail, std::uint32_t head,
                                      const Query& t) const {
  const Off normal{planes_[facet].normal, 3 * planes_[facet].relative};
  return sign_of_dot(cross(normal, edge(tail, head)), from_vertex(tail, t));
}

inline int TranslationFilters::seen_along(std::uint32_t tail, std::uint32_t head, const Query& t,
                                          const Vector3& direction) const {
  if (!(length(direction) < 0x1p200)) return 0;
  return sign_of_dot({direction, 0}, cross(from_vertex(tail, t), from_vertex(head, t)));
}

}  // namespace quoin
