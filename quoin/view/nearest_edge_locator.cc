// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include "quoin/view/sphere_arrangement_picture.h"

namespace quoin {

namespace {

using dcel::Dcel;
using dcel::EdgeId;
using dcel::FaceId;
using dcel::HalfedgeId;

Vector3 difference(const Vector3& a, const Vector3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

double dot(const Vector3& a, const Vector3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

double determinant(const Vector3& a, const Vector3& b, const Vector3& c) {
  return a.x * (b.y * c.z - b.z * c.y) - a.y * (b.x * c.z - b.z * c.x) + a.z * (b.x * c.y - b.y * c.x);
}

/// A chord of an edge; a direction is nearest to its inside, or to one of its ends.
struct Nearest {
  double square = std::numeric_limits<double>::infinity();
  EdgeId edge;
  std::size_t chord = 0;
  double part = 0;  ///< along the chord, 0 to 1
};

class NearestEdge {
 public:
  NearestEdge(const Dcel& cells, const SpherePlaces& places) : cells_(cells), places_(places) {
    for (std::size_t f = 0; f < cells.faces.size() && any_face_.is_none(); ++f) {
      if (cells.is_real(FaceId(f))) any_face_ = FaceId(f);
    }
  }

  FaceId face(const Vector3& d) const {
    const Nearest nearest = nearest_to(d);
    if (nearest.edge.is_none()) return any_face_;
    const std::vector<Vector3>& path = places_.edges[nearest.edge.index()];
    const bool is_first = nearest.chord == 0 && nearest.part == 0;
    const bool is_last = nearest.chord + 2 == path.size() && nearest.part == 1;
    if (is_first || is_last) return face_around(HalfedgeId(nearest.edge, is_last), d);
    const bool is_left = determinant(path[nearest.chord], path[nearest.chord + 1], d) > 0;
    return cells_.face(HalfedgeId(nearest.edge, !is_left));
  }

 private:
  Nearest nearest_to(const Vector3& d) const {
    Nearest nearest;
    for (std::size_t e = 0; e < places_.edges.size(); ++e) {
      const std::vector<Vector3>& path = places_.edges[e];
      for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const Vector3 along = difference(path[i + 1], path[i]);
        const Vector3 from = difference(d, path[i]);
        const double length = dot(along, along);
        const double part = length > 0 ? std::clamp(dot(from, along) / length, 0.0, 1.0) : 0.0;
        const Vector3 rest{from.x - part * along.x, from.y - part * along.y, from.z - part * along.z};
        const double square = dot(rest, rest);
        if (square < nearest.square) nearest = {square, EdgeId(e), i, part};
      }
    }
    return nearest;
  }

  /// Around the origin of a halfedge: the face between the edges that enclose the direction.
  FaceId face_around(HalfedgeId first, const Vector3& d) const {
    const Vector3 center = start_of(first);
    const Vector3 reference = second_of(first);
    const auto angle = [&](const Vector3& v) {
      const Vector3 a = tangent(center, reference);
      const Vector3 b = tangent(center, v);
      const double turned = std::atan2(determinant(center, a, b), dot(a, b));
      return turned < 0 ? turned + 2 * 3.141592653589793 : turned;
    };
    const double sought = angle(d);
    HalfedgeId best = first;
    double largest = 0;
    for (HalfedgeId h = cells_.counterclockwise(first); h != first; h = cells_.counterclockwise(h)) {
      const double at = angle(second_of(h));
      if (at <= sought && at >= largest) {
        largest = at;
        best = h;
      }
    }
    return cells_.face(best);
  }

  static Vector3 tangent(const Vector3& center, const Vector3& v) {
    const double height = dot(center, v);
    return {v.x - height * center.x, v.y - height * center.y, v.z - height * center.z};
  }
  const Vector3& start_of(HalfedgeId h) const {
    const std::vector<Vector3>& path = places_.edges[h.edge().index()];
    return h.is_forward() ? path.front() : path.back();
  }
  const Vector3& second_of(HalfedgeId h) const {
    const std::vector<Vector3>& path = places_.edges[h.edge().index()];
    return h.is_forward() ? path[1] : path[path.size() - 2];
  }

  const Dcel& cells_;
  const SpherePlaces& places_;
  FaceId any_face_;
};

}  // namespace

LocateOnSphere nearest_edge_locator(const Dcel& cells, const SpherePlaces& places) {
  return [locator = NearestEdge(cells, places)](const std::vector<Vector3>& directions) {
    std::vector<FaceId> faces;
    faces.reserve(directions.size());
    for (const Vector3& d : directions) faces.push_back(locator.face(d));
    return faces;
  };
}

}  // namespace quoin
