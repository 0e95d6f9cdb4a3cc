// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/overlay/shell_orientation.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace quoin::overlay {

namespace {

// A sum of cone volumes with a bound on its error.
struct Sum {
  double value = 0;
  double size = 0;  // of the absolute values of all products
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
  explicit ShellOrienter(Brep& brep) : brep_(brep), sums_(brep.shells.size()), reach_(brep.shells.size(), 0) {}

  void run() {
    if (brep_.shells.empty()) {
      brep_.component_count = brep_.is_unbounded ? 1 : 0;
      return;
    }
    choose_origins();
    for (std::uint32_t f = 0; f < brep_.face_count(); ++f) add_face(f);
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

  void add_face(std::uint32_t face) {
    const std::uint32_t s = brep_.face_shells[face];
    const Point3& origin = brep_.points.rounded(origins_[s]);
    for_each_triangle(face, [&](PointId a, PointId b, PointId c) {
      const Point3& p = brep_.points.rounded(a);
      const Point3& q = brep_.points.rounded(b);
      const Point3& r = brep_.points.rounded(c);
      add_cone(sums_[s], minus(p, origin), minus(q, origin), minus(r, origin));
      for (const Point3* v : {&p, &q, &r, &origin}) {
        reach_[s] = std::max({reach_[s], std::fabs(v->x), std::fabs(v->y), std::fabs(v->z)});
      }
      ++triangles_;
    });
  }

  // Coordinates are off by 2^-53 of the reach M, differences by 2^-51 M, and no difference exceeds 2 M; a product of
  // three is then off by 3 * 2^-51 M * 4 M^2 < 2^-47 M^3 and the sum of 6 n of them, with its own roundings, by less
  // than n 2^-44 M^3 + n 2^-49 size.
  Sign sign(std::uint32_t s) const {
    const double reach = reach_[s];
    const double n = static_cast<double>(triangles_);
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
  std::vector<PointId> origins_;
  std::vector<Sum> sums_;
  std::vector<double> reach_;
  std::size_t triangles_ = 0;
};

}  // namespace

void orient_shells(Brep& brep) {
  ShellOrienter(brep).run();
}

}  // namespace quoin::overlay
