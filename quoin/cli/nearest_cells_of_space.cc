// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <type_traits>
#include <utility>

#include "quoin/cli/nearest_cell_parts.h"
#include "quoin/cli/point_input.h"
#include "quoin/triangulation/delone.h"
#include "quoin/triangulation/regular3.h"
#include "quoin/triangulation/voronoi.h"

namespace quoin::cli {

namespace {

using Json = nlohmann::ordered_json;
constexpr std::size_t poll_step = 256;

/// For each vertex those of the points there that count.
class InputLists {
 public:
  InputLists() = default;
  InputLists(const Regular3& t, std::span<const double> weights) {
    for (std::uint32_t v = 0; v < t.vertex_count(); ++v) {
      for (const std::uint32_t i : t.inputs(v)) {
        if (weights[i] == t.weight(v)) list_.push_back(i);
      }
      begin_.push_back(list_.size());
    }
  }
  std::span<const std::uint32_t> of(std::uint32_t vertex) const {
    return std::span(list_).subspan(begin_[vertex], begin_[vertex + 1] - begin_[vertex]);
  }

 private:
  std::vector<std::uint32_t> list_;
  std::vector<std::size_t> begin_{0};
};

/// Of space: Delaunay3 or Regular3.
template <class Triangulation>
class SpaceCells : public NearestCells {
 public:
  SpaceCells(Triangulation triangulation, const PointFile& file, bool is_written, const Context& context)
      : triangulation_(std::move(triangulation)),
        labels_(delone_labels(triangulation_, context)),
        counts_(count_faces(triangulation_, labels_, context)),
        sites_(triangulation_.vertex_count(), [this](std::uint32_t v) { return labels_.is_corner(v); }),
        corners_(labels_.cell_count) {
    if constexpr (is_weighted) heaviest_ = InputLists(triangulation_, file.weights);
    if (triangulation_.dimension() < 3) return;
    if constexpr (is_weighted) {
      voronoi_.emplace(triangulation_, labels_);
    } else {
      voronoi_.emplace(triangulation_);
    }
    if (!is_written) return;
    context.progress("corners", 0);
    voronoi_->keep_corners(context);
  }

  /// A face of the Delone complex stands for one of the diagram, of 3 less as many dimensions.
  Json counts() const override {
    return {{"dimension", triangulation_.dimension()},
            {"vertices", counts_.faces[3]},
            {"edges", counts_.faces[2]},
            {"facets", counts_.faces[1]}};
  }
  std::size_t place_count() const override { return triangulation_.vertex_count(); }
  std::size_t site_count() const override { return sites_.count(); }
  std::span<const std::uint32_t> inputs(std::uint32_t site) const override {
    const std::uint32_t vertex = sites_.vertex(site);
    if constexpr (is_weighted) return heaviest_.of(vertex);
    return triangulation_.inputs(vertex);
  }
  bool is_bounded(std::uint32_t site) const override {
    return voronoi_ && !voronoi_->is_unbounded(sites_.vertex(site));
  }
  Rational size(std::uint32_t site) const override { return *voronoi_->volume(sites_.vertex(site)); }
  std::vector<std::array<std::uint32_t, 2>> neighbours(const Context& context) const override {
    const DeloneComplex complex(triangulation_, context);
    std::vector<std::array<std::uint32_t, 2>> pairs;
    pairs.reserve(complex.edges().size());
    for (const auto& [v, w] : complex.edges()) pairs.push_back({sites_.site(v), sites_.site(w)});
    return pairs;
  }

  void add_cell(std::uint32_t site, VtkGrid& grid) override {
    std::vector<std::uint32_t> numbers{0};
    for (const VoronoiFacet& f : facets(site)) {
      ++numbers[0];
      numbers.push_back(static_cast<std::uint32_t>(f.cells.size()));
      for (const std::uint32_t corner : polygon(f, grid.points)) numbers.push_back(corner);
    }
    grid.add_cell(VtkCell::polyhedron, numbers);
  }

  ExactCells bounded_faces(std::span<const std::uint32_t> order, const Context& context) const override {
    FaceList faces(3);
    if (!voronoi_) return faces.take();
    add_corners(faces, context);
    add_edges(faces, context);
    std::vector<std::vector<std::uint32_t>> parts(site_count());  // of the bounded cells
    for (std::uint32_t site = 0; site < site_count(); ++site) {
      context.poll();
      for (const VoronoiFacet& f : facets_of(site)) {
        if (!f.is_bounded || f.neighbour < site) continue;
        std::vector<std::uint32_t> corners;
        for (const std::uint32_t cell : f.cells) corners.push_back(labels_.cell_of[cell]);
        const std::uint32_t face = faces.add(ExactCellKind::polygon, corners, inputs(site)[0], inputs(f.neighbour)[0]);
        if (is_bounded(site)) parts[site].push_back(ExactCells::part_of(face, false));
        if (is_bounded(f.neighbour)) parts[f.neighbour].push_back(ExactCells::part_of(face, true));
      }
    }
    for (const std::uint32_t site : order) {
      if (is_bounded(site)) faces.add(ExactCellKind::polyhedron, parts[site], inputs(site)[0]);
    }
    return faces.take();
  }

  Mesh mesh(const Context& context) override {
    Mesh mesh;
    for (std::uint32_t site = 0; voronoi_ && site < site_count(); ++site) {
      context.poll();
      for (const VoronoiFacet& f : facets(site)) {
        if (f.is_bounded && f.neighbour > site) mesh.add_face(polygon(f, mesh.vertices));
      }
    }
    return mesh;
  }

 private:
  /// One for each Delone cell, in the order of these.
  void add_corners(FaceList& faces, const Context& context) const {
    std::vector<std::uint32_t> simplex_of(labels_.cell_count, no_number);
    for (std::uint32_t c = 0; c < triangulation_.cells().size(); ++c) {
      if (!triangulation_.is_ghost(c)) simplex_of[labels_.cell_of[c]] = c;
    }
    for (const std::uint32_t simplex : simplex_of) {
      if (simplex % poll_step == 0) context.poll();
      faces.add_corner(voronoi_->corner(simplex));
    }
  }

  /// Between Delone cells that share a facet.
  void add_edges(FaceList& faces, const Context& context) const {
    std::vector<std::array<std::uint32_t, 2>> pairs;
    for (std::uint32_t c = 0; c < triangulation_.cells().size(); ++c) {
      if (c % poll_step == 0) context.poll();
      for (const std::uint32_t across : triangulation_.cells()[c].neighbours) {
        const std::uint32_t low = labels_.cell_of[c];
        const std::uint32_t high = labels_.cell_of[across / 4];
        if (low < high && high < labels_.cell_count) pairs.push_back({low, high});
      }
    }
    std::ranges::sort(pairs);
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    for (const auto& pair : pairs) faces.add(ExactCellKind::simplex, pair);
  }

  /// With sites for neighbours.
  std::vector<VoronoiFacet> facets_of(std::uint32_t site) const {
    std::vector<VoronoiFacet> facets = voronoi_->facets(sites_.vertex(site));
    for (VoronoiFacet& f : facets) f.neighbour = sites_.site(f.neighbour);
    return facets;
  }

  /// Those of the site asked for last are kept.
  const std::vector<VoronoiFacet>& facets(std::uint32_t site) const {
    if (facets_of_ != site) {
      facets_ = facets_of(site);
      facets_of_ = site;
    }
    return facets_;
  }

  std::vector<std::uint32_t> polygon(const VoronoiFacet& facet, std::vector<Point3>& points) {
    std::vector<std::uint32_t> numbers;
    for (std::size_t i = 0; i < facet.cells.size(); ++i) {
      numbers.push_back(corners_.place(labels_.cell_of[facet.cells[i]], points, [&] {
        const RationalPoint3& p = facet.corners[i];
        return Point3{p.x.to_double(), p.y.to_double(), p.z.to_double()};
      }));
    }
    return numbers;
  }

  static constexpr bool is_weighted = std::is_same_v<Triangulation, Regular3>;

  Triangulation triangulation_;
  DeloneLabels labels_;
  DeloneCounts counts_;
  Sites sites_;
  InputLists heaviest_;  ///< with weights
  std::optional<Voronoi3> voronoi_;
  Corners corners_;
  mutable std::vector<VoronoiFacet> facets_;
  mutable std::uint32_t facets_of_ = no_number;
};

}  // namespace

std::unique_ptr<NearestCells> nearest_cells_of_space(const PointFile& file, bool is_written, const Context& context) {
  if (!file.weights.empty()) {
    return std::make_unique<SpaceCells<Regular3>>(Regular3(file.points, file.weights, context), file, is_written,
                                                  context);
  }
  return std::make_unique<SpaceCells<Delaunay3>>(Delaunay3(file.points, context), file, is_written, context);
}

}  // namespace quoin::cli
