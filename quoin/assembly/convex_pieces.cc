// SPDX-License-Identifier: Apache-2.0
#include "quoin/assembly/convex_pieces.h"

#include <unordered_map>

#include "quoin/base/error.h"
#include "quoin/polytope/convex_boundary.h"

namespace quoin {

namespace {

std::string text_of(const RationalPoint3& p) {
  return "(" + p.x.to_string() + ", " + p.y.to_string() + ", " + p.z.to_string() + ")";
}

/// One shell over points of its own.
class ShellCopy {
 public:
  ShellCopy(const Brep& all, std::uint32_t shell, const std::string& name) : all_(all), name_(name) {
    for (std::uint32_t f = 0; f < all.face_count(); ++f) {
      if (all.face_shells[f] == shell) add_face(f);
    }
    copy_.points = Constructions(points_);
  }

  const Brep& boundary() const { return copy_; }
  /// Vertices, and points that span planes but are no vertices.
  const std::vector<Point3>& points() const { return points_; }

 private:
  void add_face(std::uint32_t f) {
    for (std::uint32_t l = all_.face_first_loop[f]; l < all_.face_first_loop[f + 1]; ++l) {
      for (const PointId corner : all_.loop(l)) copy_.loop_vertices.push_back(number_of(corner));
      copy_.loop_begin.push_back(static_cast<std::uint32_t>(copy_.loop_vertices.size()));
    }
    const auto& [a, b, c] = all_.face_planes[f];
    copy_.face_planes.push_back({number_of(a), number_of(b), number_of(c)});
    copy_.face_first_loop.push_back(static_cast<std::uint32_t>(copy_.loop_count()));
  }
  PointId number_of(PointId point) {
    const auto [at, is_new] = number_.try_emplace(point, PointId(points_.size()));
    if (is_new) points_.push_back(as_doubles(point));
    return at->second;
  }
  Point3 as_doubles(PointId point) const {
    const RationalPoint3 exact = all_.points.exact(point);
    const Point3 rounded{exact.x.to_double(), exact.y.to_double(), exact.z.to_double()};
    if (exact_point(rounded) == exact) return rounded;
    throw InputError(name_ + ": the vertex " + text_of(exact) + " is no point of doubles");
  }

  const Brep& all_;
  const std::string& name_;
  Brep copy_;
  std::vector<Point3> points_;
  std::unordered_map<PointId, PointId> number_;
};

std::vector<Point3> corners_of(const ShellCopy& shell) {
  std::vector<Point3> corners;
  for (const PointId corner : shell.boundary().loop_vertices) corners.push_back(shell.points()[corner.index()]);
  return corners;
}

}  // namespace

std::vector<Polytope> convex_pieces(const Brep& boundary, const std::string& name, const Context& context) {
  if (boundary.is_unbounded) throw InputError(name + ": an unbounded solid is no part");
  if (boundary.face_count() == 0) throw InputError(name + ": the part is empty");
  std::vector<Polytope> pieces;
  for (std::uint32_t s = 0; s < boundary.shells.size(); ++s) {
    context.poll();
    if (boundary.shells[s].is_void) throw InputError(name + ": not convex: it has a cavity");
    const ShellCopy shell(boundary, s, name);
    if (const auto edge = find_reflex_edge(shell.boundary())) {
      const Constructions& points = shell.boundary().points;
      throw InputError(name + ": not convex at the edge from " + text_of(points.exact((*edge)[0])) + " to " +
                       text_of(points.exact((*edge)[1])) + "; give its convex pieces as groups ('g') of an OBJ object");
    }
    pieces.push_back(Polytope::hull_of(corners_of(shell), context));
  }
  return pieces;
}

}  // namespace quoin
