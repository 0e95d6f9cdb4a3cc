// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/overlay/shell_orientation.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "quoin/base/parallel.h"

namespace quoin::overlay {

namespace {

// A sum of cone volumes with a bound on its error.
struct Sum {
  double value = 0;
  double size = 0;   // of the absolute values of all products
  double reach = 0;  // the largest coordinate
  std::size_t triangles = 0;

  void add(const Sum& other) {
    value += other.value;
    size += other.size;
    reach = std::max(reach, other.reach);
    triangles += other.triangles;
  }
};

// Of neighbouring faces of one shell.
struct PartialSum {
  std::uint32_t shell;
  Sum sum;
};

Point3 minus(const Point3& a, const Point3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

void add_cone(Sum& sum, const Point3& a, const Point3& b, const Point3& c) {
  const double terms[] = {a.x * b.y * c.z,  a.y * b.z * c.x,  a.z * b.x * c.y,
                          -a.x * b.z * c.y, -a.y * b.x * c.z, -a.z * b.y * c.x};
  for (const double t : terms) {
    sum.value += t;
    sum.size += std::fabs(t);
  }
}

class ShellOrienter {
 public:
  ShellOrienter(Brep& brep, const Context& context) : brep_(brep), context_(context), sums_(brep.shells.size()) {}

  void run() {
    if (brep_.shells.empty()) {
      brep_.component_count = brep_.is_unbounded ? 1 : 0;
      return;
    }
    choose_origins();
    sum_cones();
    brep_.component_count = brep_.is_unbounded ? 1 : 0;
    for (std::uint32_t s = 0; s < brep_.shells.size(); ++s) {
      brep_.shells[s].is_void = sign(s) == Sign::negative;
      if (!brep_.shells[s].is_void) ++brep_.component_count;
    }
  }

 private:
  template <class Visit>
  void for_each_triangle(std::uint32_t face, const Visit& visit) const {
    for (std::uint32_t l = brep_.face_first_loop[face]; l < brep_.face_first_loop[face + 1]; ++l) {
      const auto loop = brep_.loop(l);
      for (std::size_t i = 2; i < loop.size(); ++i) visit(loop[0], loop[i - 1], loop[i]);
    }
  }

  // Cones have their apex at a vertex of the shell, so that far-away shells do not lose digits.
  void choose_origins() {
    origins_.resize(brep_.shells.size());
    std::vector<bool> chosen(brep_.shells.size(), false);
    for (std::uint32_t f = 0; f < brep_.face_count(); ++f) {
      const std::uint32_t s = brep_.face_shells[f];
      if (chosen[s]) continue;
      chosen[s] = true;
      origins_[s] = brep_.loop(brep_.face_first_loop[f])[0];
    }
  }

  // Chunks do not depend on threads, nor does the order in which their sums are added.
  void sum_cones() {
    constexpr std::size_t grain = 8192;
    std::vector<std::vector<PartialSum>> parts(chunk_count(brep_.face_count(), grain));
    for_each_chunk(context_, brep_.face_count(), grain, [&](const Chunk& chunk) {
      std::vector<PartialSum>& part = parts[chunk.index];
      for (std::size_t f = chunk.begin; f < chunk.end; ++f) {
        const std::uint32_t shell = brep_.face_shells[f];
        if (part.empty() || part.back().shell != shell) part.push_back({shell, {}});
        add_face(static_cast<std::uint32_t>(f), part.back().sum);
      }
    });
    for (const auto& part : parts) {
      for (const PartialSum& partial : part) sums_[partial.shell].add(partial.sum);
    }
  }

  void add_face(std::uint32_t face, Sum& sum) const {
    const Point3& origin = brep_.points.rounded(origins_[brep_.face_shells[face]]);
    for_each_triangle(face, [&](PointId a, PointId b, PointId c) {
      const Point3& p = brep_.points.rounded(a);
      const Point3& q = brep_.points.rounded(b);
      const Point3& r = brep_.points.rounded(c);
      add_cone(sum, minus(p, origin), minus(q, origin), minus(r, origin));
      for (const Point3* v : {&p, &q, &r}) {
        sum.reach = std::max({sum.reach, std::fabs(v->x), std::fabs(v->y), std::fabs(v->z)});
      }
      ++sum.triangles;
    });
  }

  // Coordinates are off by 2^-53 of the reach M, differences by 2^-51 M, and no difference exceeds 2 M; a product of
  // three is then off by 3 * 2^-51 M * 4 M^2 < 2^-47 M^3 and the sum of 6 n of them, with its own roundings, by less
  // than n 2^-44 M^3 + n 2^-49 size.
  Sign sign(std::uint32_t s) const {
    const Point3& o = brep_.points.rounded(origins_[s]);
    const double reach = std::max({sums_[s].reach, std::fabs(o.x), std::fabs(o.y), std::fabs(o.z)});
    const double n = static_cast<double>(sums_[s].triangles);
    const double bound = n * (0x1p-44 * reach * reach * reach + 0x1p-49 * sums_[s].size);
    const bool in_range = reach > 1e-90 && reach < 1e90;
    if (in_range && std::fabs(sums_[s].value) > bound) return sign_of(sums_[s].value);
    return exact_sign(s);
  }

  Sign exact_sign(std::uint32_t s) const {
    std::vector<Rational> terms;
    const RationalPoint3 o = brep_.points.exact(origins_[s]);
    for (std::uint32_t f = 0; f < brep_.face_count(); ++f) {
      if (brep_.face_shells[f] != s) continue;
      for_each_triangle(f, [&](PointId a, PointId b, PointId c) {
        const RationalPoint3 p = brep_.points.exact(a);
        const RationalPoint3 q = brep_.points.exact(b);
        const RationalPoint3 r = brep_.points.exact(c);
        terms.push_back((p.x - o.x) * ((q.y - o.y) * (r.z - o.z) - (q.z - o.z) * (r.y - o.y)) +
                        (p.y - o.y) * ((q.z - o.z) * (r.x - o.x) - (q.x - o.x) * (r.z - o.z)) +
                        (p.z - o.z) * ((q.x - o.x) * (r.y - o.y) - (q.y - o.y) * (r.x - o.x)));
      });
    }
    for (std::size_t width = 1; width < terms.size(); width *= 2) {
      for (std::size_t i = 0; i + width < terms.size(); i += 2 * width) terms[i] += terms[i + width];
    }
    return terms.empty() ? Sign::zero : terms[0].sign();
  }

  Brep& brep_;
  const Context& context_;
  std::vector<PointId> origins_;
  std::vector<Sum> sums_;
};

}  // namespace

void orient_shells(Brep& brep, const Context& context) {
  ShellOrienter(brep, context).run();
}

}  // namespace quoin::overlay
