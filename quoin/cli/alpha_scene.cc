// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "quoin/cli/point_scenes.h"
#include "quoin/topology/persistence.h"
#include "quoin/view/value_stops.h"

namespace quoin::cli {

namespace {

constexpr std::size_t poll_step = 4096;
constexpr std::uint32_t most_stops = 1U << 14;
constexpr int spread_values = 512;
constexpr std::size_t most_pairs = std::size_t{1} << 17;
constexpr std::size_t named_pairs = std::size_t{1} << 11;  // the longest ones, at whose values the page stops
constexpr std::size_t most_edges_at_first = 200'000;
constexpr std::size_t most_points_at_first = 100'000;  // where triangles would be hidden under them
constexpr Color boundary_color{125, 158, 198, 255};
constexpr Color singular_color{219, 197, 128, 255};
constexpr Color edge_color{105, 116, 132, 255};

struct Grades {
  std::uint32_t degree;
  std::uint32_t birth;
  std::uint32_t death;  // never_in_scene of those that stay
};

std::vector<Grades> pairs_of(const AlphaComplex& alpha, const Context& context) {
  const Filtration& filtration = alpha.filtration();
  std::vector<Grades> pairs;
  for (const PersistencePair& pair : persistence(filtration, {}, context)) {
    const bool dies = pair.death != PersistencePair::never;
    pairs.push_back({static_cast<std::uint32_t>(pair.degree), filtration.grade_of({pair.degree, pair.birth}),
                     dies ? filtration.grade_of({pair.degree + 1, pair.death}) : never_in_scene});
  }
  return pairs;
}

/// With four digits.
std::string short_text(double value) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 4).ptr;
  return {text.data(), end};
}

class AlphaScene {
 public:
  AlphaScene(const AlphaPoints& points, const AlphaIntervals& intervals, const PointFile& file, const Context& context)
      : alpha_(points.alpha),
        intervals_(intervals),
        context_(context),
        is_weighted_(!file.weights.empty()),
        scene_(scene_of_points(file, points.first_input)),
        stops_(0, 0) {}

  LayeredScene make(std::optional<std::uint32_t> shown) {
    std::vector<Grades> pairs = pairs_of(alpha_, context_);
    choose_stops(pairs, shown);
    scene_.value_name = "Value";
    if (!is_weighted_) scene_.root_name = "Radius";
    add_simplex_counts();
    add_betti_numbers(pairs);
    add_pairs(pairs);
    add_layers();
    return std::move(scene_);
  }

 private:
  /// As far along the axis as it is drawn.
  double place(double value) const { return is_weighted_ ? value : std::sqrt(value); }

  std::vector<double> values_at(const ValueStops& stops) const {
    std::vector<double> values;
    for (std::uint32_t s = 0; s < stops.count(); ++s) {
      if (s % poll_step == 0) context_.poll();
      values.push_back(alpha_.value(stops.grade(s)));
    }
    return values;
  }

  /// The longest pairs come first, as far as values at the stops tell.
  void put_longest_first(std::vector<Grades>& pairs, std::size_t count, const ValueStops& stops,
                         const std::vector<double>& values) const {
    const auto length = [&](const Grades& pair) {
      if (pair.death == never_in_scene) return std::numeric_limits<double>::infinity();
      const std::uint32_t birth = stops.of(pair.birth);
      const std::uint32_t death = stops.of(pair.death);
      return birth == death ? -1 : place(values[death]) - place(values[birth]);  // no number: both are infinite
    };
    std::vector<std::pair<double, std::uint32_t>> order;
    for (std::uint32_t i = 0; i < pairs.size(); ++i) {
      const double of_pair = length(pairs[i]);
      order.emplace_back(of_pair >= 0 ? -of_pair : 1, i);
    }
    const auto middle = order.begin() + static_cast<std::ptrdiff_t>(std::min(count, order.size()));
    std::partial_sort(order.begin(), middle, order.end());
    std::vector<Grades> sorted;
    for (const auto& [minus_length, i] : order) sorted.push_back(pairs[i]);
    pairs = std::move(sorted);
  }

  /// Grades at which a page of few stops stops too: of the longest pairs, and far apart as values go.
  std::vector<std::uint32_t> wanted(const std::vector<Grades>& pairs) const {
    std::vector<std::uint32_t> grades;
    for (std::size_t i = 0; i < std::min(named_pairs, pairs.size()); ++i)
      grades.insert(grades.end(), {pairs[i].birth, pairs[i].death});
    const double low = alpha_.value(alpha_.grade_count() / 100);
    const double high = std::min(alpha_.value(alpha_.grade_count() - 1), std::numeric_limits<double>::max());
    if (!(low > 0) || !(high > low)) return grades;
    for (int i = 0; i <= spread_values; ++i) {
      const double value = low * std::pow(high / low, i / double{spread_values});
      if (std::isfinite(value)) grades.push_back(std::max(1U, alpha_.grades_up_to(value)) - 1);
    }
    return grades;
  }

  void choose_stops(std::vector<Grades>& pairs, std::optional<std::uint32_t> shown) {
    const std::uint32_t grades = alpha_.grade_count();
    std::vector<std::uint32_t> also;
    if (grades > most_stops) {
      const ValueStops even(grades, most_stops);
      put_longest_first(pairs, named_pairs, even, values_at(even));
      also = wanted(pairs);
    }
    if (shown && *shown > 0) also.push_back(*shown - 1);
    stops_ = ValueStops(grades, most_stops, also);
    scene_.values = values_at(stops_);
    if (shown && *shown > 0) scene_.value = stops_.of(*shown - 1);
    if (stops_.count() < grades) {
      scene_.facts.emplace_back("Values", std::to_string(grades));
      scene_.facts.emplace_back("Values of this page", std::to_string(stops_.count()));
    }
  }

  std::uint32_t stop_of(std::uint32_t grade) const {
    return grade == never_in_scene ? never_in_scene : stops_.of(grade);
  }

  void add_simplex_counts() {
    static constexpr std::array names{"Points", "Edges", "Triangles", "Tetrahedra"};
    SceneCounts counts{.name = "Simplices"};
    for (int k = 0; k <= alpha_.dimension(); ++k) {
      std::vector<std::uint32_t> at(stops_.count(), 0);
      for (const std::uint32_t grade : alpha_.filtration().grade[static_cast<std::size_t>(k)]) ++at[stops_.of(grade)];
      std::partial_sum(at.begin(), at.end(), at.begin());
      counts.rows.push_back({names[static_cast<std::size_t>(k)], std::move(at)});
    }
    scene_.counts.push_back(std::move(counts));
  }

  void add_betti_numbers(const std::vector<Grades>& pairs) {
    static constexpr std::array of_space{"Components", "Tunnels", "Voids"};
    static constexpr std::array of_plane{"Components", "Holes"};
    SceneCounts counts{.name = "Betti numbers"};
    // The whole is a ball: it has no class of full degree.
    for (std::size_t k = 0; k < static_cast<std::size_t>(std::max(1, alpha_.dimension())); ++k)
      counts.rows.push_back(
          {alpha_.dimension() == 3 ? of_space[k] : of_plane[k], std::vector<std::uint32_t>(stops_.count(), 0)});
    for (const Grades& pair : pairs) {  // modulo 2^32 in between
      std::vector<std::uint32_t>& at = counts.rows[pair.degree].at;
      ++at[stops_.of(pair.birth)];
      if (pair.death != never_in_scene) --at[stops_.of(pair.death)];
    }
    for (SceneCount& row : counts.rows) std::partial_sum(row.at.begin(), row.at.end(), row.at.begin());
    scene_.counts.push_back(std::move(counts));
  }

  void add_pairs(std::vector<Grades>& pairs) {
    if (pairs.size() > most_pairs) put_longest_first(pairs, most_pairs, stops_, scene_.values);
    for (const Grades& pair : pairs) {
      if (scene_.pairs.size() == most_pairs) break;
      if (stop_of(pair.birth) != stop_of(pair.death))
        scene_.pairs.push_back({pair.degree, stop_of(pair.birth), stop_of(pair.death)});
    }
    scene_.pairs_left_out = pairs.size() - scene_.pairs.size();
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
      if (from != never_in_scene && stop_of(from) < stop_of(to)) visit(i, stop_of(from), stop_of(to));
    }
  }

  void add_points() {
    SceneLayer& layer = scene_.layers[0];
    for (std::uint32_t v = 0; v < alpha_.complex().count(0); ++v)
      layer.begin.push_back(stops_.of(alpha_.grade_of({0, v})));
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
      const std::uint32_t stop = std::max(triangles_from_, stops_.of(alpha_.grade_of({2, i})));
      for (const std::uint32_t v : alpha_.complex().vertices({2, i})) first[v] = std::min(first[v], stop);
    }
    return first;
  }

  void add(const Plan& plan) {
    SceneLayer layer{.name = plan.name, .kind = plan.kind, .color = plan.color};
    const int k = static_cast<int>(plan.kind);
    const std::uint32_t first = first_drawn(plan);
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
    if (k == 2) triangles_from_ = std::max(triangles_from_, first);
    if (!layer.vertices.empty()) scene_.layers.push_back(std::move(layer));
  }

  /// The stop from which on a layer is drawn: the first such that no more simplices are there then or later than may
  /// be.
  std::uint32_t first_drawn(const Plan& plan) {
    std::vector<std::size_t> ending(stops_.count() + 1, 0);  // the last: those that never end
    for_each(plan, [&](std::uint32_t, std::uint32_t, std::uint32_t end) { ++ending[std::min(end, stops_.count())]; });
    const std::size_t most_drawn = plan.kind == SceneLayer::Kind::triangles ? most_triangles_drawn : most_edges_drawn;
    std::uint32_t first = stops_.count();
    std::size_t sum = ending[first];
    if (sum <= most_drawn) {
      while (first > 0 && sum + ending[first - 1] <= most_drawn) sum += ending[--first];
      first = first > 0 ? first - 1 : 0;  // those that end at `first` are no more there
    }
    if (first == stops_.count()) {
      scene_.facts.emplace_back("Not in this page", plan.name + ": too many");
    } else if (first > 0) {
      scene_.facts.emplace_back(plan.name, "from value " + short_text(scene_.values[first]) + " on");
    }
    return first;
  }

  const AlphaComplex& alpha_;
  const AlphaIntervals& intervals_;
  const Context& context_;
  bool is_weighted_;
  LayeredScene scene_;
  ValueStops stops_;
  std::uint32_t triangles_from_ = 0;  // the first stop at which triangles are drawn
};

}  // namespace

LayeredScene scene_of_alpha(const AlphaPoints& points, const AlphaIntervals& intervals,
                            std::optional<std::uint32_t> shown, const PointFile& file, const Context& context) {
  return AlphaScene(points, intervals, file, context).make(shown);
}

}  // namespace quoin::cli
