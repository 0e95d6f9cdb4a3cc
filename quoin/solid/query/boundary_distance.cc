// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/query/boundary_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/number/interval.h"
#include "quoin/solid/box_tree.h"
#include "quoin/solid/exit_triangulation.h"
#include "quoin/solid/query/triangle_distance.h"

namespace quoin {

namespace {

using closest::PointPair;
using closest::SquaredBounds;
using closest::Triangle;
using closest::TrianglePair;
using closest::Vector;

}  // namespace

/// A boundary as triangles that cover its faces exactly, in a tree.
class BoundaryProximity::Covered {
 public:
  Covered(const Brep& boundary, const Context& context) : boundary_(boundary) {
    const std::size_t count = boundary.points.point_count();
    std::vector<std::uint8_t> is_rounded(count, 0);
    for (std::size_t v = 0; v < count; ++v) {
      if (v % 4096 == 0) context.poll();
      const PointId p{static_cast<std::uint32_t>(v)};
      rounded_.push_back(boundary.points.rounded(p));
      is_rounded[v] = boundary.points.is_exact(p) ? 0 : 1;
      are_exact_ = are_exact_ && is_rounded[v] == 0;
    }
    // A face that is a triangle is one wherever its corners are.
    const std::vector<std::uint8_t> none_moved(count, 0);
    triangles_ = triangulate_faces(boundary, rounded_, none_moved, context);
    std::vector<std::uint32_t> anew = triangles_.failed_faces;
    for (std::uint32_t f = 0; f < boundary.face_count(); ++f) {
      if (f % 4096 == 0) context.poll();
      if (!is_triangle(f) && has_any(f, is_rounded)) anew.push_back(f);
    }
    std::sort(anew.begin(), anew.end());
    anew.erase(std::unique(anew.begin(), anew.end()), anew.end());
    if (!anew.empty() &&
        !triangulate_exactly(boundary, anew, triangles_.triangles, triangles_.triangle_face, context)) {
      throw InputError("a face of a boundary bounds no polygon");
    }
    tree_ = BoxTree(rounded_, triangles_.triangles, context);
  }

  const BoxTree& tree() const { return tree_; }
  bool are_exact() const { return are_exact_; }
  std::uint32_t face_of(std::uint32_t t) const { return triangles_.triangle_face[t]; }
  Triangle<double> rounded(std::uint32_t t) const {
    Triangle<double> result;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point3& p = rounded_[triangles_.triangles[t][i]];
      result[i] = {p.x, p.y, p.z};
    }
    return result;
  }
  Triangle<Rational> exact(std::uint32_t t) const {
    Triangle<Rational> result;
    for (std::size_t i = 0; i < 3; ++i) {
      const RationalPoint3 p = boundary_.points.exact(PointId{triangles_.triangles[t][i]});
      result[i] = {p.x, p.y, p.z};
    }
    return result;
  }

 private:
  bool is_triangle(std::uint32_t f) const {
    const std::uint32_t l = boundary_.face_first_loop[f];
    return boundary_.face_first_loop[f + 1] - l == 1 && boundary_.loop(l).size() == 3;
  }
  bool has_any(std::uint32_t f, const std::vector<std::uint8_t>& marks) const {
    for (std::uint32_t l = boundary_.face_first_loop[f]; l < boundary_.face_first_loop[f + 1]; ++l) {
      for (const PointId p : boundary_.loop(l)) {
        if (marks[p.index()] != 0) return true;
      }
    }
    return false;
  }

  const Brep& boundary_;
  std::vector<Point3> rounded_;
  FaceTriangles triangles_;
  BoxTree tree_;
  bool are_exact_ = true;
};

class BoundaryProximity::Search {
 public:
  Search(const Covered& a, const Covered& b, const RationalPoint3& by, const Context& context)
      : a_(a), b_(b), by_{by.x, by.y, by.z}, context_(context) {
    const Vector3 rounded{by.x.to_double(), by.y.to_double(), by.z.to_double()};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      rounded_by_[axis] = rounded[axis];
      enclosed_by_[axis] = Interval::around(by_[axis]);
      is_moved_ = is_moved_ || by_[axis].sign() != Sign::zero;
      length_ = std::max(length_, std::fabs(rounded[axis]));
    }
  }

  BoundaryDistance run() {
    BoxTree::nearest_pairs(
        a_.tree(), b_.tree(), {rounded_by_[0], rounded_by_[1], rounded_by_[2]},
        [&](const TilePair& pair) { return visit(pair); }, context_);
    std::sort(left_.begin(), left_.end());
    for (const auto& [lower, pair] : left_) {
      if (best_ && Rational(lower) >= best_->squared_length) break;
      compare_exactly(pair);
    }
    const auto point = [&](std::size_t k) -> RationalPoint3 {
      const Vector<Rational>& p = best_->points[k];
      return {p[0], p[1], p[2]};
    };
    return {best_->squared_length, {point(0), point(1)}, is_crossing_};
  }

 private:
  /// Pairs that are surely apart wait until the bound is as low as it gets; others are decided at once.
  double visit(const TilePair& pair) {
    Triangle<double> p = a_.rounded(pair.a);
    const Triangle<double> q = b_.rounded(pair.b);
    double error = a_.are_exact() && b_.are_exact() ? 0 : std::max(largest(p), largest(q));
    if (is_moved_) {
      // The vector, the corner and their sum are each off by 2^-53 of themselves.
      for (Vector<double>& corner : p) {
        for (std::size_t axis = 0; axis < 3; ++axis) corner[axis] += rounded_by_[axis];
      }
      error += length_ + largest(p);
    }
    const SquaredBounds bounds = closest::squared_bounds(p, q, 0x1p-52 * error);
    if (bounds.lower > bound_) return bound_;
    if (bounds.lower > 0) {
      left_.emplace_back(bounds.lower, pair);
      bound_ = std::min(bound_, bounds.upper);
      return bound_;
    }
    compare_exactly(pair);
    if (best_->squared_length.sign() == Sign::zero) {
      // A few more that meet may tell that they cross.
      constexpr std::size_t enough = 50;
      left_.clear();
      bound_ = is_crossing_ || ++meeting_ == enough ? -1 : 0;
    } else {
      bound_ = std::min(bound_, best_->squared_length.to_double() * (1 + 0x1p-52) + 0x1p-1070);
    }
    return bound_;
  }

  void compare_exactly(const TilePair& pair) {
    if (++compared_ % 16 == 0) context_.poll();
    Triangle<Interval> enclosed_p = enclosed(a_, pair.a);
    move(enclosed_p, enclosed_by_);
    const bool is_met_or_first = !best_ || best_->squared_length.sign() == Sign::zero;
    if (!is_met_or_first && is_no_nearer(enclosed_p, enclosed(b_, pair.b), enclosed_between_)) return;
    Triangle<Rational> p = a_.exact(pair.a);
    move(p, by_);
    const Triangle<Rational> q = b_.exact(pair.b);
    if (!is_met_or_first && is_no_nearer(p, q, between_)) return;
    TrianglePair<Rational> triangles(p, q);
    if (const auto common = triangles.common_point()) {
      is_crossing_ = common->is_crossing;
      best_ = PointPair<Rational>{{common->point, common->point}, Rational(0), {}};
      return;
    }
    PointPair<Rational> nearest = triangles.nearest();
    if (best_ && nearest.squared_length >= best_->squared_length) return;
    best_ = std::move(nearest);
    between_ = closest::difference(best_->points[0], best_->points[1]);
    for (std::size_t axis = 0; axis < 3; ++axis) enclosed_between_[axis] = Interval::around(between_[axis]);
  }

  template <class Number>
  static void move(Triangle<Number>& t, const Vector<Number>& by) {
    for (Vector<Number>& corner : t) {
      for (std::size_t axis = 0; axis < 3; ++axis) corner[axis] = corner[axis] + by[axis];
    }
  }
  static double largest(const Triangle<double>& t) {
    double size = 0;
    for (const Vector<double>& corner : t) {
      for (const double x : corner) size = std::max(size, std::fabs(x));
    }
    return size;
  }

  /// Whether a pair is surely as far apart as the best one already along the line through the points of that one: of
  /// many pairs that are equally near, as between parallel faces and their borders, nearly all.
  template <class Number>
  static bool is_no_nearer(const Triangle<Number>& p, const Triangle<Number>& q, const Vector<Number>& between) {
    const Number square = closest::dot(between, between);
    for (const Vector<Number>& y : q) {
      const Number reached = closest::dot(between, y) + square;
      for (const Vector<Number>& x : p) {
        if (!is_at_least(closest::dot(between, x), reached)) return false;
      }
    }
    return true;
  }
  static bool is_at_least(const Rational& x, const Rational& y) { return x >= y; }
  static bool is_at_least(const Interval& x, const Interval& y) { return x.lower() >= y.upper(); }

  static Triangle<Interval> enclosed(const Covered& boundary, std::uint32_t t) {
    const Triangle<double> rounded = boundary.rounded(t);
    Triangle<Interval> result;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double x = rounded[i][axis];
        result[i][axis] = boundary.are_exact() ? Interval(x) : Interval(previous(x), next(x));
      }
    }
    return result;
  }
  static double next(double x) { return std::nextafter(x, std::numeric_limits<double>::infinity()); }
  static double previous(double x) { return -next(-x); }

  const Covered& a_;
  const Covered& b_;
  const Vector<Rational> by_;
  Vector<double> rounded_by_{};
  Vector<Interval> enclosed_by_;
  bool is_moved_ = false;
  double length_ = 0;
  const Context& context_;
  double bound_ = std::numeric_limits<double>::infinity();
  std::vector<std::pair<double, TilePair>> left_;  // with lower bounds
  std::optional<PointPair<Rational>> best_;
  Vector<Rational> between_;  // of its points
  Vector<Interval> enclosed_between_;
  std::size_t compared_ = 0;
  std::size_t meeting_ = 0;  // pairs compared since the first that meets
  bool is_crossing_ = false;
};

BoundaryProximity::BoundaryProximity(const Brep& a, const Brep& b, const Context& context) {
  if (a.face_count() == 0 || b.face_count() == 0) throw InputError("a boundary without faces has no distance");
  a_ = std::make_unique<const Covered>(a, context);
  b_ = std::make_unique<const Covered>(b, context);
}

BoundaryProximity::~BoundaryProximity() = default;

BoundaryDistance BoundaryProximity::distance(const RationalPoint3& translation, const Context& context) const {
  return Search(*a_, *b_, translation, context).run();
}

}  // namespace quoin
