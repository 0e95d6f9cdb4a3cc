// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/sets/overlay.h"

#include <gtest/gtest.h>

#include <random>

#include "quoin/arrangement/linear/linear_polygon_set.h"

namespace quoin {
namespace {

struct Segments {
  std::vector<std::pair<Point2, Point2>> list;
};

Segments random_segments(std::mt19937& random, int count, unsigned size) {
  Segments result;
  while (static_cast<int>(result.list.size()) < count) {
    const auto pick = [&] { return static_cast<double>(random() % size); };
    const Point2 a{pick(), pick()};
    const Point2 b{pick(), pick()};
    if (a != b) result.list.emplace_back(a, b);
  }
  return result;
}

LinearArrangement arrangement_of(const Segments& segments, bool rays) {
  LinearFamily family;
  PieceList<LinearFamily> list;
  for (std::size_t i = 0; i < segments.list.size(); ++i) {
    const auto& [a, b] = segments.list[i];
    if (rays && i % 4 == 0) {
      family.add_ray(list, a, b);
    } else {
      family.add_segment(list, a, b);
    }
  }
  return arrange(std::move(family), list, Context());
}

class Checker : public OverlayVisitor<LinearFamily> {
 public:
  int calls = 0;
  void vertex_on_vertex(dcel::VertexId, dcel::VertexId, dcel::VertexId) override { ++calls; }
  void vertex_on_edge(dcel::VertexId, dcel::VertexId, dcel::EdgeId) override { ++calls; }
  void edge_on_vertex(dcel::VertexId, dcel::EdgeId, dcel::VertexId) override { ++calls; }
  void vertex_in_face(dcel::VertexId, dcel::VertexId, dcel::FaceId) override { ++calls; }
  void face_around_vertex(dcel::VertexId, dcel::FaceId, dcel::VertexId) override { ++calls; }
  void crossing(dcel::VertexId, dcel::EdgeId, dcel::EdgeId) override { ++calls; }
  void overlap(dcel::EdgeId, dcel::EdgeId, dcel::EdgeId) override { ++calls; }
  void edge_in_face(dcel::EdgeId, dcel::EdgeId, dcel::FaceId) override { ++calls; }
  void face_around_edge(dcel::EdgeId, dcel::FaceId, dcel::EdgeId) override { ++calls; }
  void face(dcel::FaceId, dcel::FaceId, dcel::FaceId) override { ++calls; }
};

TEST(Overlay, EqualsDirectConstruction) {
  std::mt19937 random(2);
  for (int round = 0; round < 500; ++round) {
    const unsigned size = 2 + round % 5;
    const Segments red = random_segments(random, 1 + round % 9, size);
    const Segments blue = random_segments(random, 1 + round % 7, size);
    const LinearArrangement a = arrangement_of(red, round % 2 == 0);
    const LinearArrangement b = arrangement_of(blue, round % 2 == 0);
    const std::vector<const LinearArrangement*> sources{&a, &b};
    const auto both = overlay<LinearFamily>(sources, Context());
    dcel::check_links(both.arrangement().cells());
    LinearFamily family;
    PieceList<LinearFamily> list;
    for (const Segments* segments : {&red, &blue}) {
      for (std::size_t i = 0; i < segments->list.size(); ++i) {
        const auto& [p, q] = segments->list[i];
        if (round % 2 == 0 && i % 4 == 0) {
          family.add_ray(list, p, q);
        } else {
          family.add_segment(list, p, q);
        }
      }
    }
    const LinearArrangement direct = arrange(std::move(family), list, Context());
    const dcel::Counts counts = both.arrangement().counts();
    ASSERT_EQ(counts.vertices, direct.counts().vertices) << round;
    ASSERT_EQ(counts.edges, direct.counts().edges) << round;
    ASSERT_EQ(counts.faces, direct.counts().faces) << round;
    for (std::size_t e = 0; e < direct.edge_count(); ++e) {
      const dcel::EdgeId id(e);
      if (!direct.cells().is_real(id)) continue;
      ASSERT_TRUE(std::ranges::equal(direct.curves(id), both.arrangement().curves(id))) << round << ' ' << e;
    }
    Checker checker;
    visit_cells(both, checker);
    ASSERT_EQ(static_cast<std::size_t>(checker.calls), counts.vertices + counts.edges + counts.faces);
  }
}

/// The source face of every face of the overlay is next to the source edges of its boundary.
TEST(Overlay, FacesLieInTheirSourceFaces) {
  std::mt19937 random(4);
  for (int round = 0; round < 300; ++round) {
    std::vector<LinearArrangement> sources;
    for (int i = 0; i < 4; ++i) sources.push_back(arrangement_of(random_segments(random, 6, 6), round % 2 == 0));
    std::vector<const LinearArrangement*> pointers;
    for (const LinearArrangement& source : sources) pointers.push_back(&source);
    const auto all = overlay<LinearFamily>(pointers, Context());
    const dcel::Dcel& cells = all.arrangement().cells();
    for (std::size_t h = 0; h < cells.halfedges.size(); ++h) {
      const dcel::HalfedgeId id(h);
      if (!cells.is_real(id.edge())) continue;
      for (std::size_t i = 0; i < sources.size(); ++i) {
        const SourceCell cell = all.source(id.edge(), i);
        const SourceCell face = all.source(cells.face(id), i);
        if (cell.kind == SourceCell::Kind::edge) {
          const dcel::HalfedgeId same(dcel::EdgeId(std::size_t{cell.id}), !id.is_forward());
          ASSERT_EQ(sources[i].cells().face(same).value, face.id);
        } else {
          ASSERT_EQ(cell, face);
        }
      }
    }
  }
}

}  // namespace
}  // namespace quoin
