// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "quoin/cli/nearest_cell_parts.h"
#include "quoin/cli/point_input.h"
#include "quoin/triangulation/delone2.h"
#include "quoin/triangulation/regular2.h"
#include "quoin/triangulation/voronoi2.h"

namespace quoin::cli {

namespace {

using Json = nlohmann::ordered_json;
constexpr std::size_t poll_step = 256;

/// Of the plane: Delaunay2 or Regular2.
template <class Triangulation>
class PlaneCells : public NearestCells {
 public:
  PlaneCells(Triangulation triangulation, std::size_t places, const Context& context)
      : triangulation_(std::move(triangulation)),
        places_(places),
        delone_(triangulation_, context),
        voronoi_(triangulation_, delone_),
        sites_(triangulation_.vertex_count(), [this](std::uint32_t v) { return voronoi_.has_cell(Vertex2(v)); }),
        corners_(delone_.cell_count()) {}

  Json counts() const override {
    return {{"dimension", triangulation_.dimension()},
            {"vertices", voronoi_.vertex_count()},
            {"edges", voronoi_.edges().size()}};
  }
  std::size_t place_count() const override { return places_; }
  std::size_t site_count() const override { return sites_.count(); }
  std::span<const std::uint32_t> inputs(std::uint32_t site) const override { return inputs_of(vertex(site)); }
  bool is_bounded(std::uint32_t site) const override { return voronoi_.cell(vertex(site)).is_bounded; }
  Rational size(std::uint32_t site) const override { return *voronoi_.area(vertex(site)); }

  std::vector<std::array<std::uint32_t, 2>> neighbours(const Context& context) const override {
    context.poll();
    std::vector<std::array<std::uint32_t, 2>> pairs;
    for (const VoronoiEdge2& e : voronoi_.edges())
      pairs.push_back({sites_.site(e.left.value), sites_.site(e.right.value)});
    return pairs;
  }

  void add_cell(std::uint32_t site, VtkGrid& grid) override {
    grid.add_cell(VtkCell::polygon, polygon(site, grid.points));
  }

  ExactCells bounded_faces(std::span<const std::uint32_t> order, const Context& context) const override {
    FaceList faces(2);
    for (std::uint32_t c = 0; c < delone_.cell_count(); ++c) {
      if (c % poll_step == 0) context.poll();
      const RationalPoint2 p = voronoi_.vertex(DeloneCell2(c));
      faces.add_corner({p.x, p.y, Rational()});
    }
    for (const VoronoiEdge2& e : voronoi_.edges()) {
      if (e.from.is_none() || e.to.is_none()) continue;
      faces.add(ExactCellKind::simplex, std::array{e.from.value, e.to.value}, inputs_of(e.left)[0],
                inputs_of(e.right)[0]);
    }
    for (const std::uint32_t site : order) {
      context.poll();
      if (!is_bounded(site)) continue;
      std::vector<std::uint32_t> corners;
      for (const DeloneCell2 corner : voronoi_.cell(vertex(site)).corners) corners.push_back(corner.value);
      faces.add(ExactCellKind::polygon, corners, inputs(site)[0]);
    }
    return faces.take();
  }

  Mesh mesh(const Context& context) override {
    Mesh mesh;
    for (std::uint32_t site = 0; site < site_count(); ++site) {
      context.poll();
      if (is_bounded(site)) mesh.add_face(polygon(site, mesh.vertices));
    }
    return mesh;
  }

 private:
  Vertex2 vertex(std::uint32_t site) const { return Vertex2(sites_.vertex(site)); }
  std::span<const std::uint32_t> inputs_of(Vertex2 vertex) const { return triangulation_.inputs(vertex); }

  std::vector<std::uint32_t> polygon(std::uint32_t site, std::vector<Point3>& points) {
    std::vector<std::uint32_t> numbers;
    for (const DeloneCell2 corner : voronoi_.cell(vertex(site)).corners) {
      numbers.push_back(corners_.place(corner.value, points, [&] {
        const Point2 p = voronoi_.rounded(corner);
        return Point3{p.x, p.y, 0};
      }));
    }
    return numbers;
  }

  Triangulation triangulation_;
  std::size_t places_;
  Delone2 delone_;
  Voronoi2 voronoi_;
  Sites sites_;
  Corners corners_;
};

}  // namespace

std::unique_ptr<NearestCells> nearest_cells_of_plane(const PointFile& file, const Context& context) {
  if (!file.weights.empty()) {
    return std::make_unique<PlaneCells<Regular2>>(Regular2(weighted_plane_points(file), context), distinct_places(file),
                                                  context);
  }
  Delaunay2 delaunay(plane_points(file), {}, context);
  const std::size_t places = delaunay.vertex_count();
  return std::make_unique<PlaneCells<Delaunay2>>(std::move(delaunay), places, context);
}

}  // namespace quoin::cli
