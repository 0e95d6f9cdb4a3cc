// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/edit/arrangement_editor.h"

#include <algorithm>

#include "quoin/arrangement/edit/editing_test_support.h"
#include "quoin/arrangement/location/naive_locator.h"
#include "quoin/base/error.h"

namespace quoin {
namespace {

using namespace editing_test;
using Editor = ArrangementEditor<LinearFamily>;

const Mix mixes[] = {{3, false, true}, {4, true, false}, {5, true, true}, {9, false, false}};

dcel::VertexId vertex_at(const LinearArrangement& arrangement, const LinearPoint& p) {
  if (p.is_end()) return {};
  const Location cell = NaiveLocator<LinearFamily>(arrangement).locate(p);
  return cell.vertex();
}

/// A face that holds a point or the part of the edge near an end at infinity.
dcel::FaceId face_at(const LinearArrangement& arrangement, const CellGeometry<LinearFamily>& geometry,
                     const LinearPoint& p) {
  if (!p.is_end()) return NaiveLocator<LinearFamily>(arrangement).locate(p).face();
  if (!geometry.first_corner().is_none()) return arrangement.cells().face(geometry.frame_place(p).edge);
  return arrangement.cells().base_face;
}

void insert_edge(Editor& editor, const LinearArrangement& from, dcel::EdgeId e, bool with_hints) {
  const LinearPoint& l = from.left_point(e);
  const LinearPoint& r = from.right_point(e);
  const NewEdge edge{from.branch(e), from.curves(e)};
  const LinearArrangement& to = editor.arrangement();
  const dcel::VertexId left = vertex_at(to, l);
  const dcel::VertexId right = vertex_at(to, r);
  dcel::HalfedgeId left_hint;
  dcel::HalfedgeId right_hint;
  if (with_hints && !left.is_none()) left_hint = editor.geometry().place_right(left, edge.branch).place.arriving;
  if (with_hints && !right.is_none()) right_hint = editor.geometry().place_left(right, edge.branch).place.arriving;
  if (left.is_none() && right.is_none()) {
    editor.insert_in_face(edge, l, r, face_at(to, editor.geometry(), l));
  } else if (left.is_none()) {
    editor.insert_from_right(edge, l, right, right_hint);
  } else if (right.is_none()) {
    editor.insert_from_left(edge, left, r, left_hint);
  } else {
    editor.insert_between(edge, left, right, left_hint, right_hint);
  }
}

/// Squares within squares, with points between: closing one moves what lies inside it.
std::vector<GridCurve> nested_squares() {
  std::vector<GridCurve> curves;
  const double squares[][3] = {{0, 0, 16}, {1, 1, 6}, {2, 2, 2}, {9, 1, 5},
                               {10, 2, 1}, {1, 9, 6}, {8, 8, 7}, {9, 9, 4}};
  for (const auto& [x, y, size] : squares) {
    const Point2 corners[] = {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
    for (std::size_t i = 0; i < 4; ++i) curves.push_back({Kind::segment, corners[i], corners[(i + 1) % 4]});
    curves.push_back({Kind::point, {x + 0.5, y + 0.25}, {}});
  }
  curves.push_back({Kind::point, {20, 3}, {}});
  return curves;
}

/// The edges of an arrangement, inserted one by one where they belong, in any order, make the same arrangement; removed
/// one by one, they leave nothing.
TEST(ArrangementEditor, EdgeByEdgeInAnyOrder) {
  std::mt19937 random(41);
  for (int round = 0; round < 800; ++round) {
    std::vector<GridCurve> curves;
    for (int i = 0; i < 1 + round % 8; ++i) curves.push_back(random_curve(random, mixes[round % 4]));
    if (round % 20 == 7) curves = nested_squares();
    const LinearArrangement from = swept(curves);
    std::vector<dcel::EdgeId> edges;
    for (std::size_t i = 0; i < from.edge_count(); ++i) {
      if (from.cells().is_real(dcel::EdgeId(i))) edges.push_back(dcel::EdgeId(i));
    }
    std::shuffle(edges.begin(), edges.end(), random);
    LinearArrangement to;
    Editor editor(to);
    editor.family().absorb(from.family());
    editor.add_curves(from.curve_count());
    for (std::size_t i = 0; i < from.vertex_count(); ++i) {
      const dcel::VertexId v(i);
      if (!from.cells().is_real(v) || !from.cells().is_isolated(v)) continue;
      editor.insert_vertex(from.point(v), face_at(to, editor.geometry(), from.point(v)));
    }
    SCOPED_TRACE(text(curves));
    for (const dcel::EdgeId e : edges) {
      insert_edge(editor, from, e, round % 2 == 0);
      ASSERT_NO_THROW(dcel::check_links(to.cells()));
      ASSERT_EQ(check_outer(to), "");
    }
    LinearArrangement copy = to;
    renumber(copy, Context());
    ASSERT_EQ(difference(copy, from, identity(curves.size())), "");
    for (std::size_t i = 0; i < to.edge_count(); ++i) {
      if (!to.cells().is_real(dcel::EdgeId(i))) continue;
      editor.remove_edge(dcel::EdgeId(i), {random() % 2 == 0, random() % 2 == 0});
      ASSERT_NO_THROW(dcel::check_links(to.cells()));
      ASSERT_EQ(check_outer(to), "");
    }
    for (std::size_t i = 0; i < to.vertex_count(); ++i) {
      if (to.cells().is_real(dcel::VertexId(i))) editor.remove_vertex(dcel::VertexId(i));
    }
    dcel::check_links(to.cells());
    const dcel::Counts counts = to.counts();
    ASSERT_EQ(counts.faces, 1U);
    ASSERT_EQ(counts.unbounded_faces, 1U);
    ASSERT_EQ(counts.vertices + counts.edges + counts.components, 0U);
  }
}

TEST(ArrangementEditor, SplitAndMergeUndoEachOther) {
  std::mt19937 random(43);
  for (int round = 0; round < 300; ++round) {
    std::vector<GridCurve> curves;
    for (int i = 0; i < 1 + round % 6; ++i) curves.push_back(random_curve(random, mixes[round % 4]));
    LinearArrangement arrangement = swept(curves);
    Editor editor(arrangement);
    std::vector<dcel::VertexId> added;
    for (std::size_t i = 0; i < arrangement.edge_count(); ++i) {
      const dcel::EdgeId e(i);
      if (!arrangement.cells().is_real(e) || arrangement.left_point(e).is_end() || arrangement.right_point(e).is_end())
        continue;
      const RationalPoint2 p = arrangement.family().exact(arrangement.left_point(e));
      const RationalPoint2 q = arrangement.family().exact(arrangement.right_point(e));
      const Rational third = Rational(1) / Rational(3);
      added.push_back(editor.split_edge(
          e, editor.family().point(RationalPoint2{p.x + (q.x - p.x) * third, p.y + (q.y - p.y) * third})));
      ASSERT_NO_THROW(dcel::check_links(arrangement.cells()));
      if (arrangement.edge_count() > 60) break;
    }
    std::shuffle(added.begin(), added.end(), random);
    for (const dcel::VertexId v : added) {
      ASSERT_TRUE(editor.can_merge(v));
      editor.merge_edges(v);
      ASSERT_NO_THROW(dcel::check_links(arrangement.cells()));
    }
    renumber(arrangement, Context());
    ASSERT_EQ(difference(arrangement, swept(curves), identity(curves.size())), "") << text(curves);
  }
}

TEST(ArrangementEditor, RefusalsChangeNothing) {
  const std::vector<GridCurve> curves{{Kind::segment, {0, 0}, {4, 0}}, {Kind::segment, {0, 0}, {2, 3}},
                                      {Kind::segment, {2, 3}, {4, 0}}, {Kind::segment, {2, 3}, {2, 5}},
                                      {Kind::point, {9, 9}, {}},       {Kind::line, {0, -7}, {1, -7}}};
  LinearArrangement arrangement = swept(curves);
  Editor editor(arrangement);
  const BranchId up = editor.family().add_line(Point2{2, 1}, Point2{2, 5});
  const BranchId flat = editor.family().add_line(Point2{0, 0}, Point2{1, 0});
  const auto at = [](double x, double y) { return LinearFamily::point(Point2{x, y}); };
  const dcel::VertexId top = vertex_at(arrangement, at(2, 3));
  const dcel::VertexId left = vertex_at(arrangement, at(0, 0));
  const dcel::VertexId right = vertex_at(arrangement, at(4, 0));
  const dcel::VertexId lone = vertex_at(arrangement, at(9, 9));
  const dcel::FaceId inside = NaiveLocator<LinearFamily>(arrangement).locate(at(2, 1)).face();
  const CurveUse use(CurveId(std::size_t{0}), false);
  const NewEdge along{flat, {&use, 1}};
  const NewEdge vertical{up, {&use, 1}};
  EXPECT_THROW(editor.insert_between(along, left, right), InputError);       // runs along an edge
  EXPECT_THROW(editor.insert_between(vertical, right, left), InputError);    // wrong way
  EXPECT_THROW(editor.insert_from_left(along, left, at(9, 0)), InputError);  // runs along an edge
  EXPECT_THROW(editor.insert_in_face(vertical, at(2, 1), at(2, 1), inside), InputError);
  EXPECT_THROW(editor.insert_in_face(vertical, at(2, 1), editor.family().last_end(up), inside), InputError);
  EXPECT_THROW(editor.insert_between(vertical, top, lone, {}, arrangement.cells()[left].out), InputError);
  EXPECT_THROW(editor.insert_vertex(at(2, 1), dcel::FaceId(99)), InputError);
  EXPECT_THROW(editor.remove_vertex(top), InputError);
  EXPECT_THROW(editor.remove_vertex(dcel::VertexId(1000)), InputError);
  EXPECT_THROW(editor.remove_edge(dcel::EdgeId(1000)), InputError);
  EXPECT_THROW(editor.merge_edges(top), InputError);
  EXPECT_THROW(editor.merge_edges(left), InputError);
  EXPECT_THROW(editor.split_edge(dcel::EdgeId(0), at(50, 50)), InputError);
  EXPECT_THROW(remove_curve(arrangement, CurveId(std::size_t{77})), InputError);
  EXPECT_EQ(difference(arrangement, swept(curves), identity(curves.size())), "");
}

}  // namespace
}  // namespace quoin
