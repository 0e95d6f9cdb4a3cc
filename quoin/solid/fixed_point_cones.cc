// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/fixed_point_cones.h"

#include <algorithm>
#include <cmath>

#include "quoin/base/parallel.h"
#include "quoin/kernel/exact_arithmetic.h"
#include "quoin/kernel/rational_point.h"
#include "quoin/solid/face_loops.h"

namespace quoin {

namespace {

constexpr std::uint32_t none = 0xFFFFFFFFU;
constexpr int grid_bits = 122;
constexpr std::size_t error_bits = 249;

/// floor(x 2^bits), which two limbs hold.
FixedInt<2> in_units(const Rational& x, long bits) {
  Integer p = x.numerator();
  Integer q = x.denominator();
  if (bits >= 0) {
    p <<= static_cast<std::size_t>(bits);
  } else {
    q <<= static_cast<std::size_t>(-bits);
  }
  const Integer units = floor_quotient(p, q);
  std::array<std::uint64_t, 2> limbs{};
  mpz_export(limbs.data(), nullptr, -1, sizeof(std::uint64_t), 0, 0, units.raw());
  FixedInt<2> magnitude;
  for (std::size_t i = 0; i < limbs.size(); ++i) magnitude.set_limb(i, limbs[i]);
  return units.sign() == Sign::negative ? -magnitude : magnitude;
}

/// sum 2^-bits
Rational from_units(const Integer& sum, long bits) {
  return bits >= 0 ? Rational(sum, Integer(1) << static_cast<std::size_t>(bits))
                   : Rational(sum << static_cast<std::size_t>(-bits));
}

}  // namespace

std::optional<FixedPointCones> FixedPointCones::of(const Brep& boundary, std::span<const std::uint32_t> faces,
                                                   const Point3& from, const Context& context) {
  std::vector<std::uint32_t> place(boundary.points.point_count(), none);
  std::vector<PointId> points;
  double farthest = 0;  // of coordinates, from the point
  double largest = 0;
  std::size_t polled = 0;
  for (const std::uint32_t face : faces) {
    if (polled++ % 1024 == 0) context.poll();
    for_each_ring(boundary, face, [&](std::span<const PointId> loop) {
      for (const PointId p : loop) {
        if (place[p.index()] != none) continue;
        place[p.index()] = static_cast<std::uint32_t>(points.size());
        points.push_back(p);
        const Point3& rounded = boundary.points.rounded(p);
        for (std::size_t k = 0; k < 3; ++k) {
          farthest = std::max(farthest, std::fabs(rounded[k] - from[k]));
          largest = std::max(largest, std::fabs(rounded[k]));
        }
      }
    });
  }
  // The exact distance is off by the rounding of the vertex, within half a unit of it, and that of the difference.
  // Twice the power of two above the sum is above both.
  farthest += 0x1p-52 * largest;
  if (!std::isfinite(farthest)) return std::nullopt;
  const long exponent = farthest == 0 ? -1074L : std::ilogb(farthest) + 2L;
  FixedPointCones cones(boundary, from, grid_bits - exponent);
  cones.place_ = std::move(place);
  cones.evaluate(points, context);
  cones.enclose(faces, context);
  return cones;
}

void FixedPointCones::evaluate(const std::vector<PointId>& points, const Context& context) {
  coordinates_.resize(points.size());
  const RationalPoint3 from = exact_point(from_);
  for_each_chunk(context, points.size(), 256, [&](const Chunk& chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const RationalPoint3 exact = boundary_->points.exact(points[i]) - from;
      for (unsigned axis = 0; axis < 3; ++axis) coordinates_[i][axis] = in_units(exact[axis], bits_);
    }
  });
}

void FixedPointCones::add(std::span<const PointId> loop, Sum& sum, std::size_t& triangles) const {
  const auto at = [&](std::size_t i) -> const Coordinates& { return coordinates_[place_[loop[i].index()]]; };
  for (std::size_t i = 2; i < loop.size(); ++i) {
    sum = sum + detail::dot<Sum>(at(0), detail::cross<FixedInt<4>>(at(i - 1), at(i)));
  }
  triangles += loop.size() - 2;
}

void FixedPointCones::enclose(std::span<const std::uint32_t> faces, const Context& context) {
  constexpr std::size_t grain = 1024;
  struct Part {
    Sum sum;
    std::size_t triangles = 0;
  };
  std::vector<Part> parts(chunk_count(faces.size(), grain));
  for_each_chunk(context, faces.size(), grain, [&](const Chunk& chunk) {
    Part part;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      for_each_ring(*boundary_, faces[i], [&](std::span<const PointId> loop) { add(loop, part.sum, part.triangles); });
    }
    parts[chunk.index] = part;
  });
  Part all;
  for (const Part& part : parts) {
    all.sum = all.sum + part.sum;
    all.triangles += part.triangles;
  }
  const Integer sum = to_integer(all.sum);
  const Integer error = Integer(static_cast<std::int64_t>(all.triangles)) << error_bits;
  low_ = from_units(sum - error, 3 * bits_);
  high_ = from_units(sum + error, 3 * bits_);
}

}  // namespace quoin
