// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "quoin/kernel/constructions.h"
#include "quoin/number/test_doubles.h"

/// A table of constructions beside its definition in rationals, and families of explicit points for it.
namespace quoin::testing {

using Vector = std::array<Rational, 3>;

// ---- The definitions, in rationals ----

inline Vector vector_of(const RationalPoint3& p) {
  return {p.x, p.y, p.z};
}
inline RationalPoint3 point_of(const Vector& v) {
  return {v[0], v[1], v[2]};
}
inline RationalPoint3 rational_of(const Point3& p) {
  return {Rational(p.x), Rational(p.y), Rational(p.z)};
}

inline Vector minus(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Rational dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline bool is_zero(const Vector& v) {
  return dot(v, v).sign() == Sign::zero;
}
inline Rational turn_of(const Vector& d, const Vector& e, unsigned axis) {
  const unsigned i = (axis + 1) % 3;
  const unsigned j = (axis + 2) % 3;
  return d[i] * e[j] - d[j] * e[i];
}

struct RationalPlane {
  Vector normal;
  Rational offset;
};

/// A table and the same objects by their definitions. `make_*` does nothing where the construction does not exist.
class Model {
 public:
  explicit Model(const std::vector<Point3>& given) : table(given) {
    for (const Point3& p : given) points.push_back(vector_of(rational_of(p)));
  }
  explicit Model(const std::vector<RationalPoint3>& given) : table(given) {
    for (const RationalPoint3& p : given) points.push_back(vector_of(p));
  }

  void make_plane(PointId a, PointId b, PointId c) {
    const Vector normal = cross(minus(at(b), at(a)), minus(at(c), at(a)));
    if (is_zero(normal)) return;
    const PlaneId id = next_plane({normal, dot(normal, at(a))});
    table.set_plane(id, a, b, c);
  }
  void make_axis_plane(PointId p, PointId q, unsigned axis) {
    const Vector d = minus(at(q), at(p));
    Vector normal;
    normal[(axis + 1) % 3] = -d[(axis + 2) % 3];
    normal[(axis + 2) % 3] = d[(axis + 1) % 3];
    if (is_zero(normal)) return;
    const PlaneId id = next_plane({normal, dot(normal, at(p))});
    table.set_axis_plane(id, p, q, axis);
  }
  void make_line(PointId p, PointId q) {
    const Vector d = minus(at(q), at(p));
    if (!is_zero(d)) table.set_line(next_line(d), p, q);
  }
  void make_line(PlaneId p, PlaneId q) {
    const Vector d = cross(at(p).normal, at(q).normal);
    if (!is_zero(d)) table.set_line(next_line(d), p, q);
  }
  void make_point(PointId p, PointId q, PlaneId m) {
    const Vector d = minus(at(q), at(p));
    const Rational weight = dot(at(m).normal, d);
    if (weight.sign() == Sign::zero) return;
    const Rational t = (at(m).offset - dot(at(m).normal, at(p))) / weight;
    Vector v = at(p);
    for (unsigned i = 0; i < 3; ++i) v[i] += t * d[i];
    table.set_point(next_point(v), p, q, m);
  }
  void make_crossing(PointId p, PointId q, PointId r, PointId s, unsigned axis) {
    const Vector d = minus(at(q), at(p));
    const Vector e = minus(at(s), at(r));
    const Rational weight = turn_of(d, e, axis);
    if (weight.sign() == Sign::zero) return;
    const Rational t = turn_of(minus(at(r), at(p)), e, axis) / weight;
    Vector v = at(p);
    for (unsigned i = 0; i < 3; ++i) v[i] += t * d[i];
    table.set_crossing(next_point(v), p, q, r, s, axis);
  }
  void make_point(PlaneId p, PlaneId q, PlaneId r) {
    const Vector qr = cross(at(q).normal, at(r).normal);
    const Vector rp = cross(at(r).normal, at(p).normal);
    const Vector pq = cross(at(p).normal, at(q).normal);
    const Rational weight = dot(at(p).normal, qr);
    if (weight.sign() == Sign::zero) return;
    Vector v;
    for (unsigned i = 0; i < 3; ++i) {
      v[i] = (at(p).offset * qr[i] + at(q).offset * rp[i] + at(r).offset * pq[i]) / weight;
    }
    table.set_point(next_point(v), p, q, r);
  }
  void make_point(std::array<PointId, 3> corners, std::array<std::uint32_t, 3> weights) {
    Vector v;
    const Rational sum(std::int64_t{weights[0]} + weights[1] + weights[2]);
    for (unsigned i = 0; i < 3; ++i) {
      for (unsigned k = 0; k < 3; ++k) v[i] += at(corners[k])[i] * Rational(std::int64_t{weights[k]}) / sum;
    }
    table.set_point(next_point(v), corners, weights);
  }

  const Vector& at(PointId id) const { return points[id.index()]; }
  const RationalPlane& at(PlaneId id) const { return planes[id.index()]; }
  const Vector& at(LineId id) const { return lines[id.index()]; }

  PointId explicit_point(Random& random) const { return PointId{random() % table.explicit_count()}; }
  PointId point(Random& random) const { return PointId{random() % points.size()}; }
  PlaneId plane(Random& random) const { return PlaneId{random() % planes.size()}; }
  LineId line(Random& random) const { return LineId{random() % lines.size()}; }

  std::string reproduce() const {
    std::ostringstream out;
    out << std::hexfloat << "explicit points:";
    for (std::size_t i = 0; i < table.explicit_count(); ++i) {
      const RationalPoint3 p = point_of(points[i]);
      out << "\n  " << p.x.to_string() << " " << p.y.to_string() << " " << p.z.to_string();
    }
    return out.str();
  }

  Constructions table;
  std::vector<Vector> points;
  std::vector<RationalPlane> planes;
  std::vector<Vector> lines;

 private:
  PlaneId next_plane(RationalPlane plane) {
    planes.push_back(std::move(plane));
    table.resize_planes(planes.size());
    return PlaneId{planes.size() - 1};
  }
  LineId next_line(Vector direction) {
    lines.push_back(std::move(direction));
    table.resize_lines(lines.size());
    return LineId{lines.size() - 1};
  }
  PointId next_point(Vector point) {
    points.push_back(std::move(point));
    table.resize_points(points.size());
    return PointId{points.size() - 1};
  }
};

inline void construct(Model& m, Random& random, int count) {
  for (int i = 0; i < 2 * count; ++i) {
    m.make_plane(m.explicit_point(random), m.explicit_point(random), m.explicit_point(random));
    if (i % 4 == 0) {
      m.make_axis_plane(m.explicit_point(random), m.explicit_point(random), static_cast<unsigned>(random() % 3));
    }
  }
  if (m.planes.empty()) return;
  for (int i = 0; i < count; ++i) {
    m.make_line(m.explicit_point(random), m.explicit_point(random));
    m.make_line(m.plane(random), m.plane(random));
    m.make_point(m.explicit_point(random), m.explicit_point(random), m.plane(random));
    m.make_point(m.plane(random), m.plane(random), m.plane(random));
    m.make_crossing(m.explicit_point(random), m.explicit_point(random), m.explicit_point(random),
                    m.explicit_point(random), static_cast<unsigned>(random() % 3));
    const auto weight = [&] {
      return static_cast<std::uint32_t>(random() % 3 == 0 ? random() % 3 : random() & 0xFFFFF);
    };
    m.make_point({m.explicit_point(random), m.explicit_point(random), m.explicit_point(random)},
                 {weight(), weight() + 1, weight()});
  }
}

// ---- Families of explicit points ----

/// Small integers: most triples are collinear, most quadruples coplanar, most constructions coincide.
inline std::vector<Point3> small_grid(Random& random, std::size_t count, int size) {
  std::vector<Point3> points(count);
  for (Point3& p : points) {
    for (unsigned i = 0; i < 3; ++i) p[i] = static_cast<double>(random() % (2 * size + 1)) - size;
  }
  return points;
}

/// Coordinates with `bits` bits of mantissa at exponents 0 to `spread`, signs mixed.
inline std::vector<Point3> floating(Random& random, std::size_t count, int bits, int spread) {
  std::vector<Point3> points(count);
  for (Point3& p : points) {
    for (unsigned i = 0; i < 3; ++i) {
      const double mantissa = static_cast<double>(random() >> (64 - bits));
      p[i] = std::ldexp(random() % 2 == 0 ? mantissa : -mantissa, static_cast<int>(random() % (spread + 1)));
    }
  }
  return points;
}

/// Combinations of a few points, rounded: nearly coplanar and nearly collinear.
inline std::vector<Point3> nearly_degenerate(Random& random, std::size_t count) {
  std::vector<Point3> points = floating(random, 4, 53, 0);
  std::uniform_real_distribution<double> unit(-1, 2);
  while (points.size() < count) {
    const Point3 a = points[random() % 4], b = points[random() % 4], c = points[random() % 4];
    const double s = unit(random), t = random() % 3 == 0 ? 0 : unit(random);
    Point3 p;
    for (unsigned i = 0; i < 3; ++i) p[i] = a[i] + s * (b[i] - a[i]) + t * (c[i] - a[i]);
    points.push_back(p);
  }
  return points;
}

/// Largest number of at most 53 bits below 2^b: (2^min(b, 53) - 1) scaled.
inline double limit_of(int b) {
  return b <= 53 ? std::ldexp(1, b) - 1 : std::ldexp(std::ldexp(1, 53) - 1, b - 53);
}

/// All coordinates at the limit of b bits, or 1, 0 and others near the ends of the grid.
inline std::vector<Point3> at_limits(Random& random, std::size_t count, int b) {
  std::vector<Point3> points{{limit_of(b), 1, -1}};
  while (points.size() < count) {
    Point3 p;
    for (unsigned i = 0; i < 3; ++i) {
      const std::uint64_t kind = random() % 10;
      p[i] = kind < 7 ? limit_of(b) : kind == 7 ? 1 : kind == 8 ? 0 : std::floor(limit_of(b) / 3);
      if (random() % 2 == 0) p[i] = -p[i];
    }
    points.push_back(p);
  }
  return points;
}

inline void scale(std::vector<Point3>& points, int exponent) {
  for (Point3& p : points) {
    for (unsigned i = 0; i < 3; ++i) p[i] = std::ldexp(p[i], exponent);
  }
}

/// Points whose only use is to widen the grid to b bits.
inline void widen_grid(std::vector<Point3>& points, int b) {
  points.push_back({0, 0, std::ldexp(1, b - 1)});
  points.push_back({1, 0, 0});
}

}  // namespace quoin::testing
