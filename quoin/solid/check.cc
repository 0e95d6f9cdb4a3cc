// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/check.h"

#include "quoin/solid/boundary_crossings.h"
#include "quoin/solid/measure.h"
#include "quoin/solid/topology_counts.h"

namespace quoin {

namespace {

class BoundaryChecker {
 public:
  BoundaryChecker(const Brep& boundary, std::size_t max_listed, const Context& context)
      : b_(boundary), max_listed_(max_listed), context_(context) {}

  std::vector<std::string> run() {
    if (!indices_are_valid()) return std::move(violations_);
    for (std::uint32_t f = 0; f < b_.face_count(); ++f) {
      if (f % 64 == 0) context_.poll();
      check_face(f);
    }
    const TopologyCounts counts = count_topology(b_);
    if (counts.unbalanced_edges != 0) say(std::to_string(counts.unbalanced_edges) + " edges are not balanced");
    check_euler(counts);
    if (!violations_.empty()) return std::move(violations_);
    for (std::string& violation : find_boundary_crossings(b_, max_listed_, context_)) say(std::move(violation));
    return std::move(violations_);
  }

 private:
  void say(std::string violation) {
    if (violations_.size() < max_listed_) violations_.push_back(std::move(violation));
  }

  bool indices_are_valid() {
    for (const PointId p : b_.loop_vertices) {
      if (p.index() >= b_.points.point_count()) say("a loop names a vertex that is not there");
    }
    for (const auto& plane : b_.face_planes) {
      for (const PointId p : plane) {
        if (p.index() >= b_.points.explicit_count()) say("a plane names a point that is not explicit");
      }
    }
    if (b_.face_first_loop.size() != b_.face_count() + 1 || b_.face_shells.size() != b_.face_count())
      say("array lengths disagree");
    for (const std::uint32_t shell : b_.face_shells) {
      if (shell >= b_.shells.size()) say("a face names a shell that is not there");
    }
    return violations_.empty();
  }

  void check_face(std::uint32_t f) {
    const auto& plane = b_.face_planes[f];
    const RationalPoint3 origin = b_.points.exact(plane[0]);
    const RationalPoint3 normal = cross(b_.points.exact(plane[1]) - origin, b_.points.exact(plane[2]) - origin);
    for (std::uint32_t l = b_.face_first_loop[f]; l < b_.face_first_loop[f + 1]; ++l) {
      const auto loop = b_.loop(l);
      if (loop.empty()) say("face " + std::to_string(f) + " has an empty loop");
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const RationalPoint3 p = b_.points.exact(loop[i]);
        if (dot(normal, p - origin).sign() != Sign::zero)
          say("face " + std::to_string(f) + ": vertex " + std::to_string(loop[i].value) + " is off its plane");
        if (loop.size() > 1 && loop[i] == loop[i + 1 == loop.size() ? 0 : i + 1])
          say("face " + std::to_string(f) + " has an edge of length zero");
      }
    }
    const RationalPoint3 area = area_vector(b_, f);
    if (dot(normal, area).sign() != Sign::positive)
      say("face " + std::to_string(f) + " does not turn counterclockwise about its normal");
  }

  // V - E + F - (L - F) = 2 (S - G) for manifold boundaries, with a genus G >= 0.
  void check_euler(const TopologyCounts& counts) {
    if (!counts.is_manifold() || counts.faces == 0) return;
    const auto left = static_cast<long long>(counts.vertices) - static_cast<long long>(counts.edges) +
                      2 * static_cast<long long>(counts.faces) - static_cast<long long>(counts.loops);
    if (left % 2 != 0 || left > 2 * static_cast<long long>(b_.shells.size())) {
      say("Euler-Poincare: V - E + F - (L - F) = " + std::to_string(left) + " for " + std::to_string(b_.shells.size()) +
          " shells");
    }
  }

  const Brep& b_;
  std::size_t max_listed_;
  const Context& context_;
  std::vector<std::string> violations_;
};

}  // namespace

std::vector<std::string> check_boundary(const Brep& boundary, std::size_t max_listed, const Context& context) {
  return BoundaryChecker(boundary, max_listed, context).run();
}

}  // namespace quoin
