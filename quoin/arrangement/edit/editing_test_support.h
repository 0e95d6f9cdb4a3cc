// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "quoin/arrangement/linear/linear_editing.h"

/// Random curves on small grids, and comparison of arrangements, for tests of editing.
namespace quoin::editing_test {

enum class Kind { segment, ray, line, point };

struct GridCurve {
  Kind kind;
  Point2 a;
  Point2 b;
};

inline std::string text(const GridCurve& c) {
  static const char* const names[] = {"segment", "ray", "line", "point"};
  const auto pair = [](const Point2& p) { return "{" + std::to_string(p.x) + ", " + std::to_string(p.y) + "}"; };
  return std::string(names[static_cast<int>(c.kind)]) + " " + pair(c.a) + " " + pair(c.b) + "\n";
}

inline std::string text(const std::vector<GridCurve>& curves) {
  std::string all;
  for (const GridCurve& c : curves) all += text(c);
  return all;
}

struct Mix {
  int size = 4;
  bool unbounded = false;
  bool points = false;
};

inline GridCurve random_curve(std::mt19937& random, const Mix& mix) {
  const auto pick = [&] { return static_cast<double>(random() % static_cast<unsigned>(mix.size)); };
  GridCurve c{Kind::segment, {pick(), pick()}, {pick(), pick()}};
  while (c.a == c.b) c.b = {pick(), pick()};
  if (mix.unbounded && random() % 3 == 0) c.kind = random() % 2 == 0 ? Kind::ray : Kind::line;
  if (mix.points && random() % 6 == 0) c.kind = Kind::point;
  return c;
}

inline void add(LinearFamily& family, PieceList<LinearFamily>& list, const GridCurve& c) {
  switch (c.kind) {
    case Kind::segment:
      family.add_segment(list, c.a, c.b);
      return;
    case Kind::ray:
      family.add_ray(list, c.a, c.b);
      return;
    case Kind::line:
      family.add_line(list, c.a, c.b, "line");
      return;
    case Kind::point:
      family.add_point(list, c.a);
      return;
  }
}

inline LinearArrangement swept(const std::vector<GridCurve>& curves) {
  LinearFamily family;
  PieceList<LinearFamily> list;
  for (const GridCurve& c : curves) add(family, list, c);
  return arrange(std::move(family), list, Context());
}

inline CurveId insert_one(LinearArrangement& arrangement, const GridCurve& c) {
  LinearFamily family;
  PieceList<LinearFamily> list;
  add(family, list, c);
  return insert(arrangement, family, list, Context());
}

/// Compares points of two arrangements in a family that has the supports of both.
template <CurveFamily F>
class PlaceComparison {
 public:
  PlaceComparison(const Arrangement<F>& a, const Arrangement<F>& b) : a_(a), b_(b), family_(a.family()) {
    shift_ = family_.absorb(b.family());
  }
  bool same(dcel::VertexId v) const {
    if (!a_.has_point(v) || !b_.has_point(v)) return a_.has_point(v) == b_.has_point(v);
    return family_.compare_xy(a_.point(v), F::shifted(b_.point(v), shift_)) == Sign::zero;
  }
  bool same(dcel::EdgeId e) const { return family_.same_branch(a_.branch(e), F::shifted(b_.branch(e), shift_)); }

 private:
  const Arrangement<F>& a_;
  const Arrangement<F>& b_;
  F family_;
  typename F::Shift shift_;
};

/// Empty if the two are the same, cell by cell; `curve_of` translates curves of the first to those of the second.
template <CurveFamily F>
std::string difference(const Arrangement<F>& a, const Arrangement<F>& b, const std::vector<std::uint32_t>& curve_of) {
  const PlaceComparison<F> places(a, b);
  const dcel::Dcel& x = a.cells();
  const dcel::Dcel& y = b.cells();
  if (x.vertices.size() != y.vertices.size()) return "numbers of vertices";
  if (x.edges != y.edges) return "edges";
  if (x.base_face != y.base_face) return "base face";
  if (x.faces.size() != y.faces.size()) return "numbers of faces";
  if (x.boundaries.size() != y.boundaries.size()) return "numbers of boundaries";
  for (std::size_t i = 0; i < x.halfedges.size(); ++i) {
    const dcel::Halfedge& h = x.halfedges[i];
    const dcel::Halfedge& k = y.halfedges[i];
    if (h.next != k.next || h.previous != k.previous || h.origin != k.origin || h.boundary != k.boundary) {
      return "halfedge " + std::to_string(i);
    }
  }
  for (std::size_t i = 0; i < x.vertices.size(); ++i) {
    const dcel::Vertex& v = x.vertices[i];
    const dcel::Vertex& w = y.vertices[i];
    if (v.out != w.out || v.face != w.face || v.next_isolated != w.next_isolated || v.state != w.state ||
        !places.same(dcel::VertexId(i))) {
      return "vertex " + std::to_string(i);
    }
  }
  for (std::size_t i = 0; i < x.boundaries.size(); ++i) {
    const dcel::Boundary& c = x.boundaries[i];
    const dcel::Boundary& d = y.boundaries[i];
    if (c.halfedge != d.halfedge || c.face != d.face || c.next != d.next || c.is_outer != d.is_outer) {
      return "boundary " + std::to_string(i);
    }
  }
  for (std::size_t i = 0; i < x.faces.size(); ++i) {
    const dcel::Face& f = x.faces[i];
    const dcel::Face& g = y.faces[i];
    if (f.first_boundary != g.first_boundary || f.first_isolated != g.first_isolated ||
        f.is_unbounded != g.is_unbounded || f.state != g.state) {
      return "face " + std::to_string(i);
    }
  }
  for (std::size_t i = 0; i < x.edges.size(); ++i) {
    if (a.cells().is_real(dcel::EdgeId(i)) && !places.same(dcel::EdgeId(i))) return "branch of " + std::to_string(i);
    std::vector<CurveUse> uses;
    for (const CurveUse use : a.curves(dcel::EdgeId(i))) {
      uses.emplace_back(CurveId(std::size_t{curve_of[use.curve().index()]}), use.is_reversed());
    }
    std::sort(uses.begin(), uses.end());
    const auto expected = b.curves(dcel::EdgeId(i));
    if (!std::equal(uses.begin(), uses.end(), expected.begin(), expected.end()))
      return "curves of " + std::to_string(i);
  }
  return "";
}

/// Boundaries are inner or outer as a fresh construction says, before renumbering too.
template <CurveFamily F>
std::string check_outer(const Arrangement<F>& arrangement) {
  const CellGeometry<F> geometry(arrangement);
  for (std::size_t i = 0; i < arrangement.cells().boundaries.size(); ++i) {
    const dcel::Boundary& boundary = arrangement.cells().boundaries[i];
    if (!boundary.halfedge.is_none() && geometry.is_outer(boundary.halfedge) != boundary.is_outer) {
      return "is_outer of boundary " + std::to_string(i);
    }
  }
  return "";
}

inline std::vector<std::uint32_t> identity(std::size_t count) {
  std::vector<std::uint32_t> ids(count);
  for (std::size_t i = 0; i < count; ++i) ids[i] = static_cast<std::uint32_t>(i);
  return ids;
}

}  // namespace quoin::editing_test
