// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/edit/observer.h"

#include <map>
#include <set>

#include "quoin/arrangement/edit/cell_data.h"
#include "quoin/arrangement/edit/editing_test_support.h"
#include "quoin/arrangement/location/naive_locator.h"

namespace quoin {
namespace {

using namespace editing_test;

/// Keeps books of the real cells from what it is told; every before has its after, and links are right in each call.
class Bookkeeper : public ArrangementObserver {
 public:
  explicit Bookkeeper(LinearArrangement& arrangement) : arrangement_(arrangement) {}

  std::set<dcel::VertexId> vertices;
  std::set<dcel::EdgeId> edges;
  std::set<dcel::FaceId> faces;
  std::map<dcel::BoundaryId, dcel::FaceId> moved;
  int open = 0;
  int global_changes = 0;

  std::string compare() const {
    const dcel::Dcel& cells = arrangement_.cells();
    if (open != 0) return "pairs of calls";
    for (std::size_t i = 0; i < cells.vertices.size(); ++i) {
      if (cells.is_real(dcel::VertexId(i)) != (vertices.count(dcel::VertexId(i)) != 0)) return "vertices";
    }
    for (std::size_t i = 0; i < cells.edges.size(); ++i) {
      if (cells.is_real(dcel::EdgeId(i)) != (edges.count(dcel::EdgeId(i)) != 0)) return "edges";
    }
    for (std::size_t i = 0; i < cells.faces.size(); ++i) {
      if (cells.is_real(dcel::FaceId(i)) != (faces.count(dcel::FaceId(i)) != 0)) return "faces";
    }
    return "";
  }

  void before_create_vertex() override { before(); }
  void after_create_vertex(dcel::VertexId v) override {
    after();
    if (real(v)) vertices.insert(v);
  }
  void before_remove_vertex(dcel::VertexId v) override {
    before();
    vertices.erase(v);
  }
  void after_remove_vertex(dcel::VertexId) override { after(); }
  void before_create_edge(dcel::VertexId, dcel::VertexId) override { before(); }
  void after_create_edge(dcel::EdgeId e) override {
    after();
    EXPECT_TRUE(edges.insert(e).second);
  }
  void before_remove_edge(dcel::EdgeId e) override {
    before();
    EXPECT_EQ(edges.erase(e), 1U);
  }
  void after_remove_edge(dcel::EdgeId) override { after(); }
  void before_split_edge(dcel::EdgeId) override { before(); }
  void after_split_edge(dcel::EdgeId left, dcel::VertexId v, dcel::EdgeId right) override {
    after();
    if (!real(v)) return;
    vertices.insert(v);
    EXPECT_EQ(edges.count(left), 1U);
    edges.insert(right);
  }
  void before_merge_edges(dcel::EdgeId, dcel::VertexId v, dcel::EdgeId right) override {
    before();
    vertices.erase(v);
    edges.erase(right);
  }
  void after_merge_edges(dcel::EdgeId, dcel::VertexId, dcel::EdgeId) override { after(); }
  void before_change_curves(dcel::EdgeId) override { before(); }
  void after_change_curves(dcel::EdgeId) override { after(); }
  void before_split_face(dcel::FaceId) override { before(); }
  void after_split_face(dcel::FaceId old, dcel::FaceId created) override {
    after();
    EXPECT_EQ(faces.count(old), 1U);
    EXPECT_TRUE(faces.insert(created).second);
  }
  void before_merge_faces(dcel::FaceId, dcel::FaceId gone) override {
    before();
    EXPECT_EQ(faces.erase(gone), 1U);
  }
  void after_merge_faces(dcel::FaceId, dcel::FaceId) override { after(); }
  void before_move_boundary(dcel::BoundaryId b, dcel::FaceId from, dcel::FaceId) override {
    before();
    EXPECT_EQ(arrangement_.cells()[b].face, from);
  }
  void after_move_boundary(dcel::BoundaryId b, dcel::FaceId, dcel::FaceId to) override {
    after();
    EXPECT_EQ(arrangement_.cells()[b].face, to);
  }
  void before_move_isolated(dcel::VertexId v, dcel::FaceId from, dcel::FaceId) override {
    before();
    EXPECT_EQ(arrangement_.cells()[v].face, from);
  }
  void after_move_isolated(dcel::VertexId v, dcel::FaceId, dcel::FaceId to) override {
    after();
    EXPECT_EQ(arrangement_.cells()[v].face, to);
  }
  void before_change_frame() override { before(); }
  void after_change_frame() override { after(); }
  void before_global_change() override { before(); }
  void after_global_change(const CellMap&) override {
    after();
    ++global_changes;
    after_attach(arrangement_.cells());
  }
  void after_attach(const dcel::Dcel& cells) override {
    vertices.clear();
    edges.clear();
    faces.clear();
    for (std::size_t i = 0; i < cells.vertices.size(); ++i) {
      if (cells.is_real(dcel::VertexId(i))) vertices.insert(dcel::VertexId(i));
    }
    for (std::size_t i = 0; i < cells.edges.size(); ++i) {
      if (cells.is_real(dcel::EdgeId(i))) edges.insert(dcel::EdgeId(i));
    }
    for (std::size_t i = 0; i < cells.faces.size(); ++i) {
      if (cells.is_real(dcel::FaceId(i))) faces.insert(dcel::FaceId(i));
    }
  }

 private:
  bool real(dcel::VertexId v) const { return arrangement_.cells().is_real(v); }
  void before() {
    ++open;
    EXPECT_NO_THROW(dcel::check_links(arrangement_.cells()));
  }
  void after() {
    --open;
    EXPECT_NO_THROW(dcel::check_links(arrangement_.cells()));
  }

  LinearArrangement& arrangement_;
};

TEST(Observer, BooksAgreeWithCells) {
  std::mt19937 random(53);
  for (int round = 0; round < 12; ++round) {
    const Mix mix{3 + round % 4, round % 2 == 1, round % 3 == 1};
    LinearArrangement arrangement = swept({{Kind::segment, {0, 0}, {2, 2}}});
    Bookkeeper books(arrangement);
    arrangement.attach(books);
    std::vector<CurveId> ids{CurveId(std::size_t{0})};
    for (int step = 0; step < 120; ++step) {
      if (ids.size() < 3 || (ids.size() < 10 && random() % 2 == 0)) {
        ids.push_back(insert_one(arrangement, random_curve(random, mix)));
      } else {
        const std::size_t gone = random() % ids.size();
        remove_curve(arrangement, ids[gone]);
        ids.erase(ids.begin() + static_cast<std::ptrdiff_t>(gone));
      }
      ASSERT_EQ(books.compare(), "") << round << ' ' << step;
      if (step % 50 == 49) renumber(arrangement, Context());
    }
    EXPECT_EQ(books.global_changes, 2);
  }
}

TEST(Observer, FollowsMovesButNotCopies) {
  LinearArrangement arrangement;
  Bookkeeper books(arrangement);
  arrangement.attach(books);
  LinearArrangement copy = arrangement;
  insert_one(copy, {Kind::segment, {0, 0}, {1, 1}});
  EXPECT_TRUE(books.edges.empty());
  const LinearArrangement moved = std::move(arrangement);
  EXPECT_TRUE(books.is_attached());
  copy.attach(books);
  EXPECT_EQ(books.edges.size(), 1U);
  {
    LinearArrangement brief;
    brief.attach(books);
  }
  EXPECT_FALSE(books.is_attached());
}

/// Colours follow through splits, merges and sweeps.
TEST(CellData, ColoursOfFacesFollow) {
  std::mt19937 random(59);
  for (int round = 0; round < 200; ++round) {
    // Two halves of the plane, coloured; whatever comes later lies in one of them or is cut by the line.
    LinearArrangement arrangement = swept({{Kind::line, {0, 2}, {1, 2}}});
    CellData<dcel::FaceId, int> colour;
    CellRules<int> rules;
    rules.initial = -1;
    rules.on_split = [](const int& value) { return value; };
    CellData<dcel::EdgeId, int> is_of_line(rules);
    arrangement.attach(colour);
    arrangement.attach(is_of_line);
    const auto face_of = [&](double x, double y) {
      return NaiveLocator<LinearFamily>(arrangement).locate(LinearFamily::point(Point2{x, y}));
    };
    colour[face_of(0, 5).face()] = 1;
    colour[face_of(0, -5).face()] = 2;
    is_of_line[dcel::EdgeId(0)] = 7;
    std::vector<CurveId> ids;
    for (int step = 0; step < 12; ++step) {
      if (!ids.empty() && random() % 3 == 0) {
        remove_curve(arrangement, ids.back());
        ids.pop_back();
      } else {
        ids.push_back(insert_one(arrangement, random_curve(random, {5, round % 2 == 0, false})));
      }
      if (random() % 5 == 0) renumber(arrangement, Context());
      for (std::size_t i = 0; i < arrangement.edge_count(); ++i) {
        const dcel::EdgeId e(i);
        if (!arrangement.cells().is_real(e)) continue;
        bool of_line = false;
        for (const CurveUse use : arrangement.curves(e)) of_line = of_line || use.curve().value == 0;
        if (of_line) {
          ASSERT_EQ(is_of_line[e], 7);
          ASSERT_EQ(colour[arrangement.cells().face(dcel::HalfedgeId(e, false))], 1);
          ASSERT_EQ(colour[arrangement.cells().face(dcel::HalfedgeId(e, true))], 2);
        } else {
          ASSERT_EQ(is_of_line[e], -1);
        }
      }
      for (const double y : {0.25, 1.125, 2.375, 3.625}) {
        for (const double x : {-3.0625, 0.3125, 1.4375, 2.71875}) {
          const Location cell = face_of(x, y);
          if (cell.is_face()) {
            ASSERT_EQ(colour[cell.face()], y > 2 ? 1 : 2);
          }
        }
      }
    }
  }
}

TEST(CellData, RulesOfSplitAndMerge) {
  LinearArrangement arrangement = swept({{Kind::segment, {0, 0}, {4, 0}}});
  CellRules<double> rules;
  rules.on_split = [](const double& value) { return value / 2; };
  rules.on_merge = [](const double& kept, const double& gone) { return kept + gone; };
  CellData<dcel::HalfedgeId, double> data(rules);
  CellData<dcel::VertexId, std::string> names;
  arrangement.attach(data);
  arrangement.attach(names);
  data[dcel::HalfedgeId(0)] = 8;
  data[dcel::HalfedgeId(1)] = 6;
  names[dcel::VertexId(0)] = "start";
  const CurveId cut = insert_one(arrangement, {Kind::segment, {2, -1}, {2, 1}});
  const dcel::HalfedgeId right = arrangement.cells().next(dcel::HalfedgeId(0));
  EXPECT_EQ(names[dcel::VertexId(0)], "start");
  double sum = 0;
  for (std::size_t e = 0; e < arrangement.edge_count(); ++e) sum += data[dcel::HalfedgeId(dcel::EdgeId(e), false)];
  EXPECT_EQ(sum, 12) << right.value;
  remove_curve(arrangement, cut);
  EXPECT_EQ(data[dcel::HalfedgeId(0)], 12);
  EXPECT_EQ(data[dcel::HalfedgeId(1)], 9);
  EXPECT_EQ(arrangement.counts().edges, 1U);
}

}  // namespace
}  // namespace quoin
