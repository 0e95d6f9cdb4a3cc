// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <utility>

#include "quoin/cli/page_values.h"
#include "quoin/cli/point_scenes.h"
#include "quoin/topology/persistence.h"

namespace quoin::cli {

namespace {

constexpr std::size_t poll_step = 4096;
constexpr std::size_t most_edges_at_first = 200'000;
constexpr std::size_t most_points_at_first = 100'000;  // where triangles would be hidden under them
constexpr Color boundary_color{125, 158, 198, 255};
constexpr Color singular_color{219, 197, 128, 255};
constexpr Color edge_color{105, 116, 132, 255};

std::vector<GradedPair> pairs_of(const AlphaComplex& alpha, const Context& context) {
  const Filtration& filtration = alpha.filtration();
  std::vector<GradedPair> pairs;
  for (const PersistencePair& pair : persistence(filtration, {}, context)) {
    const bool dies = pair.death != PersistencePair::never;
    pairs.push_back({.degree = static_cast<std::uint32_t>(pair.degree),
                     .birth = filtration.grade_of({pair.degree, pair.birth}),
                     .death = dies ? filtration.grade_of({pair.degree + 1, pair.death}) : never_in_scene});
  }
  return pairs;
}

class AlphaScene {
 public:
  AlphaScene(const AlphaPoints& points, const AlphaIntervals& intervals, std::optional<std::uint32_t> shown,
             const PointFile& file, const Context& context)
      : alpha_(points.alpha),
        intervals_(intervals),
        context_(context),
        is_weighted_(!file.weights.empty()),
        scene_(scene_of_points(file, points.first_input)),
        pairs_(pairs_of(alpha_, context)),
        stops_({alpha_.grade_count(), [this](std::uint32_t grade) { return alpha_.value(grade); }, !is_weighted_},
               pairs_, shown, context) {}

  LayeredScene make() {
    scene_.value_name = "Value";
    if (!is_weighted_) scene_.root_name = "Radius";
    add_simplex_counts();
    add_betti_numbers();
    stops_.add_pairs(pairs_, scene_);
    add_layers();
    stops_.move_to(scene_);
    return std::move(scene_);
  }

 private:
  void add_simplex_counts() {
    static constexpr std::array names{"Points", "Edges", "Triangles", "Tetrahedra"};
    SceneCounts counts{.name = "Simplices"};
    for (int k = 0; k <= alpha_.dimension(); ++k) {
      PageTally tally(stops_);
      for (const std::uint32_t grade : alpha_.filtration().grade[static_cast<std::size_t>(k)]) tally.come(grade);
      counts.rows.push_back(tally.take(names[static_cast<std::size_t>(k)]));
    }
    scene_.counts.push_back(std::move(counts));
  }

  void add_betti_numbers() {
    static constexpr std::array of_space{"Components", "Tunnels", "Voids"};
    static constexpr std::array of_plane{"Components", "Holes"};
    // The whole is a ball: it has no class of full degree.
    std::vector<PageTally> tallies(static_cast<std::size_t>(std::max(1, alpha_.dimension())), PageTally(stops_));
    for (const GradedPair& pair : pairs_) {
      tallies[pair.degree].come(pair.birth);
      tallies[pair.degree].go(pair.death);
    }
    SceneCounts counts{.name = "Betti numbers"};
    for (std::size_t k = 0; k < tallies.size(); ++k)
      counts.rows.push_back(tallies[k].take(alpha_.dimension() == 3 ? of_space[k] : of_plane[k]));
    scene_.counts.push_back(std::move(counts));
  }

  /// A layer of simplices, with the grades with which one is drawn and no more drawn.
  struct Plan {
    std::string name;
    SceneLayer::Kind kind;
    Color color;
    std::pair<std::uint32_t, std::uint32_t> (*life)(const AlphaInterval&);
  };

  std::vector<Plan> plans() const {
    using Kind = SceneLayer::Kind;
    const auto as_it_enters = [](const AlphaInterval& i) { return std::pair{i.singular, never_in_scene}; };
    std::vector<Plan> all;
    if (alpha_.dimension() == 3) {
      all.push_back({"Boundary", Kind::triangles, boundary_color, [](const AlphaInterval& i) {
                       return std::pair{i.regular, i.interior};
                     }});
      all.push_back({"Singular triangles", Kind::triangles, singular_color, [](const AlphaInterval& i) {
                       return std::pair{i.singular, i.regular};
                     }});
      all.push_back({"Edges that are not inside", Kind::segments, edge_color, [](const AlphaInterval& i) {
                       return std::pair{i.singular, i.interior};
                     }});
    }
    if (alpha_.dimension() == 2) all.push_back({"Triangles", Kind::triangles, boundary_color, as_it_enters});
    if (alpha_.dimension() == 2 || alpha_.dimension() == 1)
      all.push_back({"Edges", Kind::segments, edge_color, as_it_enters});
    return all;
  }

  void add_layers() {
    for (const Plan& plan : plans()) add(plan);
    add_points();
  }

  /// Simplices that are there at some stop, with the stops of their life.
  template <class Visit>
  void for_each(const Plan& plan, const Visit& visit) const {
    const int k = static_cast<int>(plan.kind);
    for (std::uint32_t i = 0; i < alpha_.complex().count(k); ++i) {
      if (i % poll_step == 0) context_.poll();
      const auto [from, to] = plan.life(intervals_.of({k, i}));
      if (from != never_in_scene && stops_.stop_of(from) < stops_.stop_of(to))
        visit(i, stops_.stop_of(from), stops_.stop_of(to));
    }
  }

  void add_points() {
    SceneLayer& layer = scene_.layers[0];
    for (std::uint32_t v = 0; v < alpha_.complex().count(0); ++v)
      layer.begin.push_back(stops_.stop_of(alpha_.grade_of({0, v})));
    if (layer.vertices.size() > most_points_at_first && layer.colors.empty() && alpha_.dimension() >= 2) {
      SceneLayer bare = layer;
      bare.name = "Points without triangles";
      bare.end = first_triangles();
      scene_.layers.insert(scene_.layers.begin() + 1, std::move(bare));
      scene_.layers[0].is_shown = false;
    }
    std::vector<std::uint32_t>& begin = scene_.layers[0].begin;
    if (std::ranges::all_of(begin, [](std::uint32_t stop) { return stop == 0; })) begin.clear();
  }

  /// The first stop at which each vertex is one of a triangle that is drawn.
  std::vector<std::uint32_t> first_triangles() const {
    std::vector<std::uint32_t> first(alpha_.complex().count(0), never_in_scene);
    for (std::uint32_t i = 0; i < alpha_.complex().count(2); ++i) {
      if (i % poll_step == 0) context_.poll();
      const std::uint32_t stop = std::max(triangles_from_, stops_.stop_of(alpha_.grade_of({2, i})));
      for (const std::uint32_t v : alpha_.complex().vertices({2, i})) first[v] = std::min(first[v], stop);
    }
    return first;
  }

  void add(const Plan& plan) {
    SceneLayer layer{.name = plan.name, .kind = plan.kind, .color = plan.color};
    const int k = static_cast<int>(plan.kind);
    const std::uint32_t first = first_drawn(plan);
    const bool is_left_out = first == stops_.stop_count();
    if (k == 2) triangles_from_ = std::max(triangles_from_, is_left_out ? never_in_scene : first);
    if (is_left_out) return;
    bool has_ends = false;
    for_each(plan, [&](std::uint32_t i, std::uint32_t begin, std::uint32_t end) {
      if (end <= first) return;
      const auto vertices = alpha_.complex().vertices({k, i});
      layer.vertices.insert(layer.vertices.end(), vertices.begin(), vertices.end());
      layer.begin.push_back(std::max(begin, first));
      layer.end.push_back(end);
      has_ends = has_ends || end != never_in_scene;
    });
    if (!has_ends) layer.end.clear();
    if (k == 1) layer.is_shown = layer.begin.size() <= most_edges_at_first;
    if (!layer.vertices.empty()) scene_.layers.push_back(std::move(layer));
  }

  /// The stop from which on a layer is drawn: the first such that no more simplices are there then or later than may
  /// be.
  std::uint32_t first_drawn(const Plan& plan) {
    std::vector<std::size_t> ending(stops_.stop_count() + 1, 0);  // the last: those that never end
    for_each(plan,
             [&](std::uint32_t, std::uint32_t, std::uint32_t end) { ++ending[std::min(end, stops_.stop_count())]; });
    const std::size_t most_drawn = plan.kind == SceneLayer::Kind::triangles ? most_triangles_drawn : most_edges_drawn;
    std::uint32_t first = stops_.stop_count();
    std::size_t sum = ending[first];
    if (sum <= most_drawn) {
      while (first > 0 && sum + ending[first - 1] <= most_drawn) sum += ending[--first];
      first = first > 0 ? first - 1 : 0;  // those that end at `first` are no more there
    }
    if (first == stops_.stop_count()) {
      scene_.facts.emplace_back("Not in this page", plan.name + ": too many");
    } else if (first > 0) {
      scene_.facts.emplace_back(plan.name, "from value " + short_text(stops_.value(first)) + " on");
    }
    return first;
  }

  const AlphaComplex& alpha_;
  const AlphaIntervals& intervals_;
  const Context& context_;
  bool is_weighted_;
  LayeredScene scene_;
  std::vector<GradedPair> pairs_;
  PageValues stops_;
  std::uint32_t triangles_from_ = 0;  // the first stop at which triangles are drawn
};

}  // namespace

LayeredScene scene_of_alpha(const AlphaPoints& points, const AlphaIntervals& intervals,
                            std::optional<std::uint32_t> shown, const PointFile& file, const Context& context) {
  return AlphaScene(points, intervals, shown, file, context).make();
}

}  // namespace quoin::cli
