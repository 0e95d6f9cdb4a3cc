// SPDX-License-Identifier: Apache-2.0
#include "quoin/flow/critical_separation.h"

#include <algorithm>

#include "quoin/base/disjoint_sets.h"
#include "quoin/flow/face_formulas.h"
#include "quoin/flow/poles.h"

namespace quoin {

namespace {

using flow::between;
using flow::Vector;

/// Twice the squared cosine of an angle less 1, times what is positive.
template <class N>
N slant(const Vector<N>& a, const Vector<N>& b) {
  const N along = dot(a, b);
  return N(2) * along * along - dot(a, a) * dot(b, b);
}

/// A multiple of the vector from the first of a simplex's points to its circumcentre, and the factor.
template <class N>
struct Centre {
  Vector<N> vector;
  N factor;

  explicit Centre(const std::vector<Point3>& p) {
    if (p.size() == 2) {
      vector = between<N>(p[0], p[1]);
      factor = N(2);
    } else if (p.size() == 3) {
      const flow::Circle<N> circle({p[0], p[1], p[2]});
      vector = circle.centre;
      factor = N(2) * circle.square_normal;
    } else {
      const Vector<N> a = between<N>(p[0], p[1]);
      const Vector<N> b = between<N>(p[0], p[2]);
      const Vector<N> c = between<N>(p[0], p[3]);
      vector = cross(b, c) * dot(a, a) + cross(c, a) * dot(b, b) + cross(a, b) * dot(c, c);
      factor = N(2) * dot(a, cross(b, c));
    }
  }
};

class Separator {
 public:
  Separator(const FlowCells& flow, const Context& context) : points_(flow.triangulation()), poles_(flow, context) {}

  enum class Place { surface, medial, disputed_surface, disputed_medial };

  /// Of the circumcentre of a simplex, which has these nearest points.
  Place place(const std::vector<std::uint32_t>& simplex, const std::vector<std::uint32_t>& nearest) {
    corners_.clear();
    for (const std::uint32_t v : simplex) corners_.push_back(points_.point(v));
    std::size_t medial = 0;
    for (const std::uint32_t v : nearest) medial += is_medial(v) ? 1 : 0;
    const bool is_most = 2 * medial > nearest.size();
    if (medial == 0 || medial == nearest.size()) return is_most ? Place::medial : Place::surface;
    return is_most ? Place::disputed_medial : Place::disputed_surface;
  }

 private:
  bool is_medial(std::uint32_t vertex) const {
    const std::optional<Sign> sign = slant_at<Interval>(vertex).sign();
    return (sign ? *sign : slant_at<Rational>(vertex).sign()) == Sign::positive;
  }
  template <class N>
  N slant_at(std::uint32_t vertex) const {
    const Centre<N> centre(corners_);
    const Vector<N> way = centre.vector + between<N>(points_.point(vertex), corners_[0]) * centre.factor;
    return slant(way, poles_.direction<N>(vertex));
  }

  const Delaunay3& points_;
  Poles poles_;
  std::vector<Point3> corners_;
};

class SeparationMaker {
 public:
  SeparationMaker(const FlowGraph& graph, const Context& context)
      : graph_(graph), flow_(graph.cells()), context_(context), separator_(flow_, context) {}

  CriticalSeparation make() {
    flow_.for_each_critical_edge(context_, [this](std::uint32_t cell, unsigned edge) {
      const std::vector<std::uint32_t> ends{corner(cell, edge_slots[edge][0]), corner(cell, edge_slots[edge][1])};
      add(ends, ends, found_.edges, 1);
    });
    for (const FlowGraph::Saddle& saddle : graph_.saddles()) {
      simplex_.clear();
      for (const unsigned slot : facet_slots[saddle.facet.slot]) simplex_.push_back(corner(saddle.facet.cell, slot));
      add(simplex_, flow_.vertices_of_polygon(saddle.facet), found_.saddles, 2);
    }
    for (const FlowGraph::Maximum& maximum : graph_.maxima()) {
      const std::array<std::uint32_t, 4>& corners = flow_.cells()[maximum.cell].vertices;
      simplex_.assign(corners.begin(), corners.end());
      add(simplex_, flow_.vertices_of(maximum.cell), found_.maxima, 3);
    }
    return std::move(found_);
  }

 private:
  std::uint32_t corner(std::uint32_t cell, unsigned slot) const { return flow_.cells()[cell].vertices[slot]; }

  void add(const std::vector<std::uint32_t>& simplex, const std::vector<std::uint32_t>& nearest,
           std::vector<bool>& list, std::size_t index) {
    if (list.size() % 64 == 0) context_.poll();
    using Place = Separator::Place;
    const Place place = separator_.place(simplex, nearest);
    list.push_back(place == Place::medial || place == Place::disputed_medial);
    found_.medial[index] += list.back() ? 1 : 0;
    found_.disputed[index] += place == Place::disputed_medial || place == Place::disputed_surface ? 1 : 0;
  }

  const FlowGraph& graph_;
  const FlowCells& flow_;
  const Context& context_;
  Separator separator_;
  CriticalSeparation found_;
  std::vector<std::uint32_t> simplex_;
};

/// Whether a saddle is lower than another, or equal and has a smaller number. Exact.
bool is_lower(const FlowGraph& graph, std::uint32_t a, std::uint32_t b) {
  const std::optional<Sign> sign = compare(graph.saddles()[a].square, graph.saddles()[b].square);
  if (sign) return *sign == Sign::negative || (*sign == Sign::zero && a < b);
  const Rational square_a = graph.exact_square_of_saddle(a);
  const Rational square_b = graph.exact_square_of_saddle(b);
  return square_a < square_b || (square_a == square_b && a < b);
}

/// Parts of space, as sets of maxima and infinity.
DisjointSets parts_of(const FlowGraph& graph, const CriticalSeparation& separation, const Context& context) {
  constexpr std::uint32_t none = 0xFFFFFFFF;
  DisjointSets parts(graph.maxima().size() + 1);
  std::vector<std::uint32_t> highest(graph.maxima().size(), none);
  for (std::uint32_t i = 0; i < graph.saddles().size(); ++i) {
    if (i % 1024 == 0) context.poll();
    const std::array<std::uint32_t, 2>& ends = graph.saddles()[i].ends;
    if (separation.saddles[i]) parts.unite(ends[0], ends[1]);
    for (const std::uint32_t end : ends) {
      if (end == graph.infinity() || separation.maxima[end] || ends[0] == ends[1]) continue;
      if (highest[end] == none || is_lower(graph, highest[end], i)) highest[end] = i;
    }
  }
  for (const std::uint32_t i : highest) {
    if (i != none) parts.unite(graph.saddles()[i].ends[0], graph.saddles()[i].ends[1]);
  }
  return parts;
}

}  // namespace

CriticalSeparation separate(const FlowGraph& graph, const Context& context) {
  return SeparationMaker(graph, context).make();
}

SeparatedSolid separated_solid(const FlowGraph& graph, const CriticalSeparation& separation, const Context& context) {
  DisjointSets parts = parts_of(graph, separation, context);
  const std::size_t count = parts.size();
  std::vector<std::vector<std::uint32_t>> behind(count);
  for (const FlowGraph::Saddle& saddle : graph.saddles()) {
    const std::uint32_t a = parts.find(saddle.ends[0]);
    const std::uint32_t b = parts.find(saddle.ends[1]);
    if (a == b) continue;
    behind[a].push_back(b);
    behind[b].push_back(a);
  }
  // Surfaces between each part and infinity.
  constexpr std::uint32_t unknown = 0xFFFFFFFF;
  std::vector<std::uint32_t> surfaces(count, unknown);
  std::vector<std::uint32_t> reached{parts.find(graph.infinity())};
  surfaces[reached[0]] = 0;
  for (std::size_t at = 0; at < reached.size(); ++at) {
    if (at % 1024 == 0) context.poll();
    for (const std::uint32_t next : behind[reached[at]]) {
      if (surfaces[next] != unknown) continue;
      surfaces[next] = surfaces[reached[at]] + 1;
      reached.push_back(next);
    }
  }
  SeparatedSolid found;
  found.parts = reached.size();
  const auto is_inside = [&](std::uint32_t end) { return surfaces[parts.find(end)] % 2 == 1; };
  for (std::uint32_t i = 0; i < graph.maxima().size(); ++i) found.solid.is_inside.push_back(is_inside(i));
  for (const FlowGraph::Saddle& saddle : graph.saddles()) {
    const bool is_between = parts.find(saddle.ends[0]) != parts.find(saddle.ends[1]);
    if (is_between && is_inside(saddle.ends[0]) == is_inside(saddle.ends[1])) ++found.unclear;
  }
  found.solid.wall = wall_of(graph, found.solid.is_inside);
  return found;
}

}  // namespace quoin
