// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/measure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <vector>

#include "quoin/base/parallel.h"
#include "quoin/solid/dyadic_cones.h"
#include "quoin/solid/face_loops.h"
#include "quoin/solid/fixed_point_cones.h"

namespace quoin {

namespace {

void add(RationalPoint3& sum, const RationalPoint3& p) {
  sum.x += p.x;
  sum.y += p.y;
  sum.z += p.z;
}

// Sum in a balanced tree, so that long denominators meet late.
Rational sum(std::vector<Rational> terms) {
  if (terms.empty()) return Rational(0);
  for (std::size_t width = 1; width < terms.size(); width *= 2) {
    for (std::size_t i = 0; i + width < terms.size(); i += 2 * width) terms[i] += terms[i + width];
  }
  return std::move(terms.front());
}

// Six times the signed volume between the origin and the face.
Rational cone_volume(const Brep& boundary, std::uint32_t face) {
  Rational total(0);
  for_each_ring(boundary, face, [&](std::span<const PointId> loop) {
    const RationalPoint3 apex = boundary.points.exact(loop[0]);
    RationalPoint3 previous = boundary.points.exact(loop[1]);
    for (std::size_t i = 2; i < loop.size(); ++i) {
      RationalPoint3 here = boundary.points.exact(loop[i]);
      total += dot(apex, cross(previous, here));
      previous = std::move(here);
    }
  });
  return total;
}

// Terms that add up to six times the signed volume: one for all faces over doubles, and one for each other face.
std::vector<Rational> cone_volumes(const Brep& boundary, const Context& context) {
  constexpr std::size_t grain = 1024;
  struct Part {
    DyadicCones::Sum dyadic;
    std::vector<Rational> others;
  };
  const std::optional<DyadicCones> cones = DyadicCones::of(boundary);
  std::vector<Part> parts(chunk_count(boundary.face_count(), grain));
  for_each_chunk(context, boundary.face_count(), grain, [&](const Chunk& chunk) {
    Part& part = parts[chunk.index];
    for (auto f = static_cast<std::uint32_t>(chunk.begin); f < chunk.end; ++f) {
      if (cones && cones->holds(f)) {
        cones->add(f, part.dyadic);
      } else {
        part.others.push_back(cone_volume(boundary, f));
      }
    }
  });
  DyadicCones::Sum dyadic;
  std::vector<Rational> terms;
  for (Part& part : parts) {
    dyadic = dyadic + part.dyadic;
    std::move(part.others.begin(), part.others.end(), std::back_inserter(terms));
  }
  if (cones) terms.push_back(cones->value(dyadic));
  return terms;
}

// The double nearest to all numbers from low to high, if it is one.
std::optional<double> common_nearest(const Rational& low, const Rational& high) {
  const double below = low.to_double();
  if (below != high.to_double()) return std::nullopt;
  return below + 0.0;  // not the negative zero below one that vanishes
}

// A vertex of the boundary, an explicit one if there is any.
std::optional<PointId> some_vertex(const Brep& boundary) {
  if (boundary.loop_vertices.empty()) return std::nullopt;
  const std::size_t explicit_count = boundary.points.explicit_count();
  const auto found =
      std::ranges::find_if(boundary.loop_vertices, [&](PointId p) { return p.index() < explicit_count; });
  return found != boundary.loop_vertices.end() ? *found : boundary.loop_vertices[0];
}

// By cones to a vertex: however far away the origin is, what is rounded is as fine as the solid asks for. Nothing where
// the volume is too near the middle of two doubles, or all faces are over doubles.
std::optional<double> enclosed_volume(const Brep& boundary, const Context& context) {
  const std::optional<PointId> apex = some_vertex(boundary);
  if (!apex) return std::nullopt;
  std::optional<DyadicCones> dyadic = DyadicCones::of(boundary);
  if (dyadic && apex->index() < boundary.points.explicit_count()) dyadic->measure_from(*apex);
  std::vector<std::uint32_t> others;
  DyadicCones::Sum sum;
  for (std::uint32_t f = 0; f < boundary.face_count(); ++f) {
    if (f % 1024 == 0) context.poll();
    if (!dyadic || !dyadic->holds(f)) {
      others.push_back(f);
    } else {
      dyadic->add(f, sum);
    }
  }
  if (others.empty()) return std::nullopt;
  const std::optional<FixedPointCones> cones =
      FixedPointCones::of(boundary, others, boundary.points.rounded(*apex), context);
  if (!cones) return std::nullopt;
  const Rational exact = dyadic ? dyadic->value(sum) : Rational(0);
  return common_nearest((exact + cones->low()) / Rational(6), (exact + cones->high()) / Rational(6));
}

// floor(value * 2^bits)
Integer fixed_point(const Rational& value, long bits) {
  Integer p = value.numerator();
  Integer q = value.denominator();
  if (bits >= 0) {
    p <<= static_cast<std::size_t>(bits);
  } else {
    q <<= static_cast<std::size_t>(-bits);
  }
  mpz_fdiv_q(p.raw(), p.raw(), q.raw());
  return p;
}

Rational from_fixed_point(const Integer& value, long bits) {
  return bits >= 0 ? Rational(value, Integer(1) << static_cast<std::size_t>(bits))
                   : Rational(value << static_cast<std::size_t>(-bits));
}

// Six times the first moments of the cone between the origin and the face are 1/4 (a + b + c) times its volume.
RationalPoint3 cone_moment(const Brep& boundary, std::uint32_t face) {
  RationalPoint3 total{0, 0, 0};
  for_each_ring(boundary, face, [&](std::span<const PointId> loop) {
    const RationalPoint3 apex = boundary.points.exact(loop[0]);
    RationalPoint3 previous = boundary.points.exact(loop[1]);
    for (std::size_t i = 2; i < loop.size(); ++i) {
      RationalPoint3 here = boundary.points.exact(loop[i]);
      const Rational weight = dot(apex, cross(previous, here));
      add(total, {weight * (apex.x + previous.x + here.x), weight * (apex.y + previous.y + here.y),
                  weight * (apex.z + previous.z + here.z)});
      previous = std::move(here);
    }
  });
  return total;
}

// Of relative error below 3.5 * 2^-53: one part from the components, 1.5 from the sum of squares, one from the root.
// Components are scaled so that no square leaves the range; std::hypot of three is not a number where one is infinite.
double length(const RationalPoint3& v) {
  const std::array<double, 3> p{v.x.to_double(), v.y.to_double(), v.z.to_double()};
  const double largest = std::max({std::fabs(p[0]), std::fabs(p[1]), std::fabs(p[2])});
  if (largest == 0 || std::isinf(largest)) return largest;
  const int exponent = std::ilogb(largest);
  double squares = 0;
  for (const double x : p) {
    const double scaled = std::ldexp(x, -exponent);
    squares += scaled * scaled;
  }
  return std::ldexp(std::sqrt(squares), exponent);
}

}  // namespace

Rational volume(const Brep& boundary, const Context& context) {
  return sum(cone_volumes(boundary, context)) / Rational(6);
}

double rounded_volume(const Brep& boundary, const Context& context) {
  if (const std::optional<double> quick = enclosed_volume(boundary, context)) return *quick;
  const std::vector<Rational> terms = cone_volumes(boundary, context);
  // Each term is below its exact value by less than one unit, so the sum by less than their number.
  long bits = 128;
  for (const Rational& term : terms) {
    const auto size =
        static_cast<long>(term.numerator().bit_length()) - static_cast<long>(term.denominator().bit_length());
    if (term.sign() != Sign::zero) bits = std::max(bits, std::min(128 - size, 4096L));
  }
  for (int attempt = 0; attempt < 6; ++attempt, bits *= 2) {
    Integer low(0);
    for (const Rational& term : terms) low += fixed_point(term, bits);
    const Integer high = low + Integer(static_cast<std::int64_t>(terms.size()));
    const auto nearest =
        common_nearest(from_fixed_point(low, bits) / Rational(6), from_fixed_point(high, bits) / Rational(6));
    if (nearest) return *nearest;
    context.poll();
  }
  return (sum(terms) / Rational(6)).to_double();
}

std::optional<RationalPoint3> centroid(const Brep& boundary, const Context& context) {
  const Rational six_volumes = sum(cone_volumes(boundary, context));
  if (six_volumes.sign() == Sign::zero) return std::nullopt;
  std::vector<Rational> x(boundary.face_count());
  std::vector<Rational> y(boundary.face_count());
  std::vector<Rational> z(boundary.face_count());
  for_each_chunk(context, x.size(), 256, [&](const Chunk& chunk) {
    for (std::size_t f = chunk.begin; f < chunk.end; ++f) {
      RationalPoint3 moment = cone_moment(boundary, static_cast<std::uint32_t>(f));
      x[f] = std::move(moment.x);
      y[f] = std::move(moment.y);
      z[f] = std::move(moment.z);
    }
  });
  const Rational scale = Rational(4) * six_volumes;
  return RationalPoint3{sum(std::move(x)) / scale, sum(std::move(y)) / scale, sum(std::move(z)) / scale};
}

RationalPoint3 area_vector(const Brep& boundary, std::uint32_t face) {
  RationalPoint3 twice{0, 0, 0};
  for_each_ring(boundary, face, [&](std::span<const PointId> loop) {
    const RationalPoint3 apex = boundary.points.exact(loop[0]);
    for (std::size_t i = 2; i < loop.size(); ++i) {
      add(twice, cross(boundary.points.exact(loop[i - 1]) - apex, boundary.points.exact(loop[i]) - apex));
    }
  });
  const Rational half(0.5);
  return {twice.x * half, twice.y * half, twice.z * half};
}

double surface_area(const Brep& boundary, const Context& context) {
  std::vector<double> areas(boundary.face_count());
  for_each_chunk(context, areas.size(), 256, [&](const Chunk& chunk) {
    for (std::size_t f = chunk.begin; f < chunk.end; ++f) {
      areas[f] = length(area_vector(boundary, static_cast<std::uint32_t>(f)));
    }
  });
  double total = 0;
  for (const double area : areas) total += area;
  return total;
}

std::optional<Bounds> bounds(const Brep& boundary) {
  if (boundary.loop_vertices.empty()) return std::nullopt;
  Bounds box{boundary.points.rounded(boundary.loop_vertices[0]), boundary.points.rounded(boundary.loop_vertices[0])};
  for (const PointId id : boundary.loop_vertices) {
    const Point3& p = boundary.points.rounded(id);
    for (std::size_t k = 0; k < 3; ++k) {
      box.lo[k] = std::min(box.lo[k], p[k]);
      box.hi[k] = std::max(box.hi[k], p[k]);
    }
  }
  return box;
}

bool ExactBox::contains(const RationalPoint3& p) const {
  return lo.x <= p.x && p.x <= hi.x && lo.y <= p.y && p.y <= hi.y && lo.z <= p.z && p.z <= hi.z;
}

void ExactBox::extend(const RationalPoint3& p) {
  lo = {std::min(lo.x, p.x), std::min(lo.y, p.y), std::min(lo.z, p.z)};
  hi = {std::max(hi.x, p.x), std::max(hi.y, p.y), std::max(hi.z, p.z)};
}

ExactBox exact_bounds(const Brep& boundary) {
  const RationalPoint3 first = boundary.points.exact(boundary.loop_vertices[0]);
  ExactBox box{first, first};
  for (const PointId v : boundary.loop_vertices) box.extend(boundary.points.exact(v));
  return box;
}

}  // namespace quoin
