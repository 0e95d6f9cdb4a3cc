// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/scene_check.h"

#include <cmath>

#include "quoin/base/error.h"

namespace quoin {
namespace {

[[noreturn]] void refuse(const ViewPart& part, const std::string& what) {
  throw InputError("view: part '" + part.name + "': " + what);
}

void check_index(const ViewPart& part, const char* holder, std::size_t at, std::size_t index, std::size_t count,
                 const char* kind) {
  if (index < count) return;
  refuse(part, std::string(holder) + ' ' + std::to_string(at) + " names " + kind + ' ' + std::to_string(index) +
                   " of " + std::to_string(count));
}

void check_points(const ViewPart& part, const std::vector<Point3>& points, const char* kind) {
  for (std::size_t v = 0; v < points.size(); ++v) {
    const Point3& p = points[v];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
      refuse(part, std::string(kind) + ' ' + std::to_string(v) + " is not finite");
    }
  }
}

void check_triangles(const ViewPart& part) {
  if (part.triangle_face.size() != part.triangles.size()) {
    refuse(part, std::to_string(part.triangles.size()) + " triangles, but faces given for " +
                     std::to_string(part.triangle_face.size()));
  }
  for (std::size_t t = 0; t < part.triangles.size(); ++t) {
    for (const std::uint32_t v : part.triangles[t]) {
      check_index(part, "triangle", t, v, part.vertices.size(), "vertex");
    }
    check_index(part, "triangle", t, part.triangle_face[t], part.faces.size(), "face");
  }
}

void check_face_spans(const ViewPart& part) {
  if (!part.face_spans.empty() && part.face_spans.size() != part.faces.size()) {
    refuse(part, std::to_string(part.faces.size()) + " faces, but " + std::to_string(part.face_spans.size()) +
                     " spans of planes");
  }
  check_points(part, part.plane_points, "plane point");
  const std::size_t points = part.vertices.size() + part.plane_points.size();
  for (std::size_t f = 0; f < part.face_spans.size(); ++f) {
    for (const std::uint32_t p : part.face_spans[f]) check_index(part, "the span of face", f, p, points, "point");
  }
}

void check_faces(const ViewPart& part) {
  for (std::size_t f = 0; f < part.faces.size(); ++f) {
    for (const double coefficient : part.faces[f].plane) {
      if (!std::isfinite(coefficient)) refuse(part, "the plane of face " + std::to_string(f) + " is not finite");
    }
  }
  if (!part.plane_texts.empty() && part.plane_texts.size() != part.faces.size()) {
    refuse(part, std::to_string(part.faces.size()) + " faces, but " + std::to_string(part.plane_texts.size()) +
                     " texts of planes");
  }
  check_face_spans(part);
  for (std::size_t i = 0; i < part.more_origins.size(); ++i) {
    check_index(part, "further origin", i, part.more_origins[i].face, part.faces.size(), "face");
  }
}

void check_edges(const ViewPart& part) {
  for (std::size_t e = 0; e < part.edges.size(); ++e) {
    for (const std::uint32_t v : part.edges[e]) check_index(part, "edge", e, v, part.vertices.size(), "vertex");
  }
}

}  // namespace

void check_scene(const ViewScene& scene) {
  for (const ViewPart& part : scene.parts) {
    check_points(part, part.vertices, "vertex");
    check_faces(part);
    check_triangles(part);
    check_edges(part);
  }
}

}  // namespace quoin
