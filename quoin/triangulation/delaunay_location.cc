// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/delaunay_location.h"

#include <cmath>

#include "quoin/base/error.h"

namespace quoin {

DelaunayLocation DelaunayLocator::locate(const Point3& p, std::uint32_t start) const {
  require_finite(p);
  const Delaunay3& t = triangulation_;
  if (t.dimension() < 3) throw InputError("points are located in triangulations of dimension 3 only");
  return walk_to(p, t.cells(), start < t.cells().size() ? start : 0, [&t](std::uint32_t v) { return t.point(v); });
}

std::uint32_t DelaunayLocator::nearest(const Point3& p) const {
  require_finite(p);
  const Delaunay3& t = triangulation_;
  const auto count = static_cast<std::uint32_t>(t.vertex_count());
  // As many samples as steps are saved by them.
  const auto samples = static_cast<std::uint32_t>(std::cbrt(static_cast<double>(count))) + 1;
  std::uint32_t best = 0;
  for (std::uint32_t i = 1; i < samples; ++i) {
    const auto v = static_cast<std::uint32_t>(std::uint64_t{i} * count / samples);
    if (compare_distances(p, t.point(v), t.point(best)) < 0) best = v;
  }
  return walk_to_nearest(
      p, best, [&t](std::uint32_t v) { return t.point(v); }, [this](std::uint32_t v) { return stars_.neighbours(v); });
}

}  // namespace quoin
