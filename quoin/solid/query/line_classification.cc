// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/query/line_classification.h"

#include <algorithm>

#include "quoin/base/error.h"
#include "quoin/solid/query/face_place.h"

namespace quoin {

namespace {

Point3 rounded(const RationalPoint3& p) {
  return {p.x.to_double(), p.y.to_double(), p.z.to_double()};
}

class LineCutter {
 public:
  LineCutter(const SolidLocator& locator, const Line3& line, const Context& context)
      : locator_(locator), b_(locator.boundary()), line_(line), context_(context) {}

  LineClassification run() {
    for (const std::uint32_t face : faces_near()) {
      context_.poll();
      cut_by(face);
    }
    std::sort(parameters_.begin(), parameters_.end());
    parameters_.erase(std::unique(parameters_.begin(), parameters_.end()), parameters_.end());
    return classified();
  }

 private:
  RationalPoint3 at(const Rational& parameter) const { return line_.origin + line_.direction * parameter; }

  std::vector<std::uint32_t> faces_near() const {
    // Scaled so that the direction neither over- nor underflows; its rounding turns it by less than the tree's margin.
    const Rational size = std::max({abs(line_.direction.x), abs(line_.direction.y), abs(line_.direction.z)});
    const Point3 d = rounded(line_.direction * (Rational(1) / size));
    std::vector<std::uint32_t> near;
    locator_.tree().tiles_near_line(rounded(line_.origin), {d.x, d.y, d.z}, near);
    return near;
  }

  void cut_by(std::uint32_t face) {
    const auto& plane = b_.face_planes[face];
    const RationalPoint3 a = b_.points.exact(plane[0]);
    const RationalPoint3 normal = cross(b_.points.exact(plane[1]) - a, b_.points.exact(plane[2]) - a);
    const Rational speed = dot(normal, line_.direction);
    const Rational distance = dot(normal, a - line_.origin);
    if (speed.sign() != Sign::zero) {
      Rational parameter = distance / speed;
      const PlacedPoint point(b_.points, at(parameter));
      const FacePlace place = place_in_face(b_, face, point, projection_axis(b_, face));
      if (place.kind != FacePlace::Kind::outside) parameters_.push_back(std::move(parameter));
    } else if (distance.sign() == Sign::zero) {
      cut_by_edges(face, normal);
    }
  }

  // The line lies in the face's plane: `across` is a normal of the line in it.
  void cut_by_edges(std::uint32_t face, const RationalPoint3& normal) {
    const RationalPoint3 across = cross(normal, line_.direction);
    const auto height = [&](PointId p) { return dot(across, b_.points.exact(p) - line_.origin); };
    for (std::uint32_t l = b_.face_first_loop[face]; l < b_.face_first_loop[face + 1]; ++l) {
      const std::span<const PointId> loop = b_.loop(l);
      Rational before = height(loop.back());
      for (std::size_t i = 0; i < loop.size(); ++i) {
        Rational here = height(loop[i]);
        const RationalPoint3 p = b_.points.exact(loop[i]);
        if (here.sign() == Sign::zero) {
          add(p);
        } else if (here.sign() * before.sign() == Sign::negative) {
          const RationalPoint3 q = b_.points.exact(loop[i == 0 ? loop.size() - 1 : i - 1]);
          add(q + (p - q) * (before / (before - here)));
        }
        before = std::move(here);
      }
    }
  }

  // Of a point on the line.
  void add(const RationalPoint3& point) {
    unsigned axis = 0;
    while (line_.direction[axis].sign() == Sign::zero) ++axis;
    parameters_.push_back((point[axis] - line_.origin[axis]) / line_.direction[axis]);
  }

  LineClassification classified() {
    LineClassification result;
    if (parameters_.empty()) {
      result.pieces.push_back(locator_.locate(line_.origin));
      return result;
    }
    const Rational half(0.5);
    result.pieces.push_back(locator_.locate(at(parameters_.front() - Rational(1))));
    for (std::size_t i = 0; i < parameters_.size(); ++i) {
      context_.poll();
      RationalPoint3 point = at(parameters_[i]);
      const SolidLocation location = locator_.locate(point);
      result.events.push_back({parameters_[i], std::move(point), location});
      const Rational after =
          i + 1 < parameters_.size() ? (parameters_[i] + parameters_[i + 1]) * half : parameters_[i] + Rational(1);
      result.pieces.push_back(locator_.locate(at(after)));
    }
    return result;
  }

  const SolidLocator& locator_;
  const Brep& b_;
  const Line3& line_;
  const Context& context_;
  std::vector<Rational> parameters_;
};

}  // namespace

LineClassification classify_line(const SolidLocator& locator, const Line3& line, const Context& context) {
  if (line.direction == RationalPoint3{0, 0, 0}) throw InputError("the direction of a line is zero");
  return LineCutter(locator, line, context).run();
}

}  // namespace quoin
