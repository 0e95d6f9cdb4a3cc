// SPDX-License-Identifier: Apache-2.0
// Plans that plan.test.mjs looks at.
#include <cmath>
#include <fstream>
#include <numbers>

#include "make_pictures.h"
#include "quoin/base/error.h"
#include "quoin/view/plan_page.h"

namespace quoin {
namespace {

PlanPart box(const std::string& name, const Point3& low, const Point3& high) {
  PlanPart part;
  part.name = name;
  for (unsigned i = 0; i < 8; ++i) {
    part.vertices.push_back({i & 1U ? high.x : low.x, i & 2U ? high.y : low.y, i & 4U ? high.z : low.z});
  }
  for (const auto& [a, b, c, d] : {std::array{0U, 4U, 6U, 2U},
                                   {1U, 3U, 7U, 5U},
                                   {0U, 1U, 5U, 4U},
                                   {2U, 6U, 7U, 3U},
                                   {0U, 2U, 3U, 1U},
                                   {4U, 5U, 7U, 6U}}) {
    part.triangles.push_back({a, b, c});
    part.triangles.push_back({a, c, d});
    for (const auto& edge : {std::array{a, b}, {b, c}, {c, d}, {d, a}}) {
      if (edge[0] < edge[1]) part.edges.push_back(edge);
    }
  }
  return part;
}

/// Upper and lower half of the directions and the circle between them; a point at the top.
SpherePicture halves() {
  SpherePicture sphere;
  const Color free{46, 157, 91, 255};
  SphereEdge equator{{}, EdgeStyle::strong, {{}, free}, {"Edge 0", "", {}}};
  for (int i = 0; i <= 180; ++i) {
    const double t = i * std::numbers::pi / 90;
    equator.path.push_back({std::cos(t), std::sin(t), 0});
  }
  sphere.edges = {equator};
  sphere.faces = {{{}, {"Face 0", "", {{"Blocked pairs", "3"}}}}, {{{}, free}, {"Face 1", "", {}}}};
  sphere.points = {{{0, 0, 1}, {{}, free}, {"Vertex 0", "", {{"Direction", "(0, 0, 1)"}}}}};
  fill_face_map(sphere, 256, [](const std::vector<Vector3>& directions) {
    std::vector<std::uint32_t> faces;
    for (const Vector3& d : directions) faces.push_back(d.z > 0 ? 1U : 0U);
    return faces;
  });
  return sphere;
}

/// Three boxes, one on the other: off they come from the top, or the two upper ones together first.
PlanPicture stack() {
  PlanPicture plan;
  plan.title = "Stack <of> boxes";
  plan.facts = {{"Steps", "2"}};
  plan.parts = {box("low", {0, 0, 0}, {2, 2, 1}), box("middle", {0, 0, 1}, {2, 2, 2}),
                box("<top>", {0, 0, 2}, {2, 2, 3})};
  plan.graphs = {
      {{{0, 1}, {0, 2}, {1, 2}}, {{2}, {1, 2}}}, {{{0, 1}}, {{1}}}, {{{1, 2}}, {{2}}}, {{{0, 1}, {1, 0}, {2, 0}}, {}}};
  const Vector3 up{0, 0, 1};
  plan.states = {{{0, 1, 2}, {{{2}, up, "(0, 0, 1)", 0, PlanMove::no_state, 1}, {{1, 2}, up, "(0, 0, 1)", 0, 2}}},
                 {{0, 1}, {{{1}, up, "(0, 0, 1)", 1}}},
                 {{1, 2}, {{{2}, up, "(0, 0, 1)", 2}}}};
  plan.steps = {{0, 0}, {1, 0}};
  plan.sphere = halves();
  plan.face_graphs = {3, 0};
  plan.edge_graphs = {1};
  plan.point_graphs = {0};
  return plan;
}

void write(const std::string& path, const PlanPicture& plan) {
  std::ofstream out(path, std::ios::binary);
  write_plan_page(out, plan);
  out.close();
  if (!out) throw FileError("cannot write '" + path + "'");
}

}  // namespace

void write_plans(const std::string& directory) {
  write(directory + "/plan.html", stack());
  PlanPicture held;
  held.title = "Held";
  held.parts = {box("a", {0, 0, 0}, {1, 1, 1}), box("b", {1, 0, 0}, {2, 1, 1})};
  held.states = {{{0, 1}, {}}};
  held.interlocked = {0};
  write(directory + "/held.html", held);
  write(directory + "/no_plan.html", {});
}

}  // namespace quoin
