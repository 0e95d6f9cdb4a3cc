// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/location/location_scenes.h"

#include <gtest/gtest.h>

#include <random>
#include <utility>

namespace quoin {
namespace {

using List = PieceList<LinearFamily>;

/// The same arrangement over a family that knows more points.
LinearArrangement with_family(const LinearArrangement& a, LinearFamily family) {
  std::vector<LinearPoint> points;
  for (std::size_t i = 0; i < a.vertex_count() && a.has_point(dcel::VertexId(i)); ++i) {
    points.push_back(a.point(dcel::VertexId(i)));
  }
  std::vector<BranchId> branches;
  for (std::size_t i = 0; i < a.edge_count(); ++i) branches.push_back(a.branch(dcel::EdgeId(i)));
  return {std::move(family), a.cells(), std::move(points), std::move(branches), a.history(), a.curve_count()};
}

/// Some point inside an edge, exactly.
RationalPoint2 point_inside(const LinearArrangement& a, dcel::EdgeId e) {
  const LinearFamily& family = a.family();
  const RationalPoint2 first = family.first_support_point(a.branch(e));
  const RationalPoint2 second = family.second_support_point(a.branch(e));
  const bool is_left_end = a.left_point(e).is_end();
  const bool is_right_end = a.right_point(e).is_end();
  if (is_left_end && is_right_end) return first;
  if (!is_left_end && !is_right_end) {
    const RationalPoint2 p = family.exact(a.left_point(e));
    const RationalPoint2 q = family.exact(a.right_point(e));
    return {(p.x + q.x) / Rational(2), (p.y + q.y) / Rational(2)};
  }
  const Rational sign(is_right_end ? 1 : -1);
  const RationalPoint2 p = family.exact(is_right_end ? a.left_point(e) : a.right_point(e));
  return {p.x + sign * (second.x - first.x), p.y + sign * (second.y - first.y)};
}

void add_beside(const RationalPoint2& p, LinearFamily& family, std::vector<LinearPoint>& queries) {
  const Rational step(0x1p-40);
  for (int dx = -1; dx <= 1; ++dx) {
    for (int dy = -1; dy <= 1; ++dy) {
      queries.push_back(family.point(RationalPoint2{p.x + Rational(dx) * step, p.y + Rational(dy) * step}));
    }
  }
}

Scene scene(std::string name, LinearFamily family, const List& list, double size, unsigned seed) {
  const LinearArrangement a = arrange(family, list, Context());
  std::vector<LinearPoint> queries;
  for (std::size_t i = 0; i < a.vertex_count(); ++i) {
    const dcel::VertexId v(i);
    if (!a.cells().is_real(v)) continue;
    queries.push_back(a.point(v));
    add_beside(a.family().exact(a.point(v)), family, queries);
  }
  for (std::size_t i = 0; i < a.edge_count(); ++i) {
    if (a.cells().is_real(dcel::EdgeId(i))) add_beside(point_inside(a, dcel::EdgeId(i)), family, queries);
  }
  for (double x = -1; x <= size + 1; x += 0.5) {
    for (double y = -1; y <= size + 1; y += 0.5) queries.push_back(LinearFamily::point(Point2{x, y}));
  }
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-size, 2 * size);
  for (int i = 0; i < 50; ++i) queries.push_back(LinearFamily::point(Point2{any(random), any(random)}));
  queries.push_back(LinearFamily::point(Point2{1e30, -1e300}));
  queries.push_back(LinearFamily::point(Point2{-1e300, 1e30}));
  return {std::move(name), with_family(a, std::move(family)), std::move(queries)};
}

/// Kinds of curves that a random scene draws from.
enum Drawn : unsigned { segments = 1, rays = 2, lines = 4, points = 8, uprights = 16 };

Scene random_scene(unsigned seed, unsigned kinds, int size, int count) {
  std::mt19937 random(seed);
  LinearFamily family;
  List list;
  const auto pick = [&] { return static_cast<double>(random() % static_cast<unsigned>(size + 1)); };
  for (int i = 0; i < count;) {
    const unsigned kind = 1U << (random() % 5);
    if ((kind & kinds) == 0) continue;
    ++i;
    const Point2 a{pick(), pick()};
    const Point2 b{kind == uprights ? a.x : pick(), pick()};
    if (kind == points || a == b) {
      family.add_point(list, a);
    } else if (kind == rays) {
      family.add_ray(list, a, b);
    } else if (kind == lines) {
      family.add_line(list, a, b, "line");
    } else {
      family.add_segment(list, a, b);
    }
  }
  return scene("random " + std::to_string(seed) + " kinds " + std::to_string(kinds), std::move(family), list, size,
               seed);
}

Scene pencil(int count, bool with_transversals) {
  LinearFamily family;
  List list;
  for (int i = 0; i < count; ++i) family.add_line(list, {2, 2}, {4, static_cast<double>(i)}, "line");
  family.add_line(list, {2, 2}, {2, 3}, "line");
  if (with_transversals) {
    for (int i = 0; i < 4; ++i) family.add_line(list, {static_cast<double>(i), 0}, {static_cast<double>(i), 1}, "line");
  }
  return scene("pencil", std::move(family), list, 4, 1);
}

Scene comb(int teeth) {
  LinearFamily family;
  List list;
  family.add_segment(list, Point2{0, 0}, Point2{static_cast<double>(teeth), 0});
  for (int i = 0; i <= teeth; ++i) {
    const auto x = static_cast<double>(i);
    family.add_segment(list, Point2{x, 0}, Point2{x, 1 + x / 8});
    family.add_point(list, {x + 0.5, 1});
  }
  return scene("comb", std::move(family), list, teeth, 2);
}

Scene star(int tips) {
  LinearFamily family;
  List list;
  for (int i = 0; i < tips; ++i) {
    family.add_segment(list, Point2{2, 2},
                       Point2{static_cast<double>(i * 5 % tips) / 2, static_cast<double>(i * 3 % tips) / 2 + 3});
    family.add_segment(list, Point2{2, 2}, Point2{static_cast<double>(i), -1});
  }
  return scene("star", std::move(family), list, 4, 3);
}

Scene only_verticals(bool with_rays) {
  LinearFamily family;
  List list;
  for (int i = 0; i < 4; ++i) {
    const auto x = static_cast<double>(i);
    if (with_rays) {
      family.add_ray(list, {x, x}, {x, i % 2 == 0 ? -5.0 : 9.0});
    } else {
      family.add_line(list, {x, 0}, {x, 1}, "line");
    }
  }
  return scene(with_rays ? "vertical rays" : "vertical lines", std::move(family), list, 4, 4);
}

std::vector<Scene> make_scenes() {
  std::vector<Scene> scenes;
  scenes.push_back(scene("empty", LinearFamily(), List(), 2, 0));
  for (unsigned seed = 0; seed < 10; ++seed) {
    scenes.push_back(random_scene(seed, segments | uprights | points, 4, 3 + static_cast<int>(seed)));
    scenes.push_back(
        random_scene(seed, segments | rays | lines | uprights | points, 3, 2 + static_cast<int>(seed) / 2));
    scenes.push_back(random_scene(seed, rays | uprights, 3, 2 + static_cast<int>(seed) / 2));
    scenes.push_back(random_scene(seed, lines, 5, 1 + static_cast<int>(seed) / 2));
    scenes.push_back(random_scene(seed, points, 3, 1 + static_cast<int>(seed)));
  }
  scenes.push_back(pencil(5, false));
  scenes.push_back(pencil(3, true));
  scenes.push_back(comb(5));
  scenes.push_back(star(6));
  scenes.push_back(only_verticals(false));
  scenes.push_back(only_verticals(true));
  return scenes;
}

}  // namespace

const std::vector<Scene>& location_scenes() {
  static const std::vector<Scene> scenes = make_scenes();
  return scenes;
}

LinearArrangement random_segments(std::size_t count, double length, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  LinearFamily family;
  List list;
  for (std::size_t i = 0; i < count; ++i) {
    const Point2 p{unit(random), unit(random)};
    family.add_segment(list, p, {p.x + length * (unit(random) - 0.5), p.y + length * (unit(random) - 0.5)});
  }
  return arrange(std::move(family), list, Context());
}

}  // namespace quoin
