// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/delone.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include "quoin/kernel/predicates3.h"
#include "quoin/triangulation/affine_basis.h"
#include "quoin/triangulation/circulators.h"

namespace quoin {

namespace {

constexpr std::uint32_t no_label = 0xFFFFFFFF;

/// Numbers the connected parts of what `is_joined(simplex, slot)` joins across facets, among simplices that are
/// `chosen`.
template <class Chosen, class Joined>
std::uint32_t label_parts(std::span<const TriangulationCell> cells, unsigned dimension, std::uint32_t next,
                          std::vector<std::uint32_t>& label, const Context& context, const Chosen& chosen,
                          const Joined& is_joined) {
  std::vector<std::uint32_t> open;
  for (std::uint32_t first = 0; first < cells.size(); ++first) {
    if (first % 1024 == 0) context.poll();
    if (label[first] != no_label || !chosen(first)) continue;
    label[first] = next;
    open.push_back(first);
    for (std::size_t steps = 1; !open.empty(); ++steps) {
      if (steps % 1024 == 0) context.poll();
      const std::uint32_t c = open.back();
      open.pop_back();
      for (unsigned i = 0; i <= dimension; ++i) {
        const std::uint32_t mate = cells[c].neighbours[i] >> 2;
        if (label[mate] != no_label || !chosen(mate) || !is_joined(c, i)) continue;
        label[mate] = next;
        open.push_back(mate);
      }
    }
    ++next;
  }
  return next;
}

int sphere_side(const Delaunay3& t, const DelaunaySigns& signs, std::size_t cell, std::uint32_t vertex) {
  return t.in_sphere(signs, cell, vertex);
}
int sphere_side(const Regular3& t, const RegularSigns& signs, std::size_t cell, std::uint32_t vertex) {
  return t.power_side(signs, cell, vertex);
}

template <class Triangulation>
DeloneLabels labels_of(const Triangulation& triangulation, const Context& context) {
  const std::span<const TriangulationCell> cells = triangulation.cells();
  const auto d = static_cast<unsigned>(triangulation.dimension());
  const auto signs = triangulation.signs();
  DeloneLabels labels;
  labels.cell_of.assign(cells.size(), no_label);
  const auto is_ghost = [&](std::uint32_t c) { return triangulation.is_ghost(c); };
  const auto is_finite = [&](std::uint32_t c) { return !triangulation.is_ghost(c); };
  labels.cell_count = label_parts(cells, d, 0, labels.cell_of, context, is_finite, [&](std::uint32_t c, unsigned slot) {
    const std::uint32_t mate = cells[c].neighbours[slot];
    return sphere_side(triangulation, signs, c, cells[mate >> 2].vertices[mate & 3]) == 0;
  });
  const auto finite_label = [&](std::uint32_t ghost) { return labels.cell_of[cells[ghost].neighbours[d] >> 2]; };
  label_parts(cells, d, labels.cell_count, labels.cell_of, context, is_ghost, [&](std::uint32_t c, unsigned slot) {
    const std::uint32_t mate = cells[c].neighbours[slot];
    if (d < 2 || slot == d || finite_label(c) != finite_label(mate >> 2)) return false;
    const auto& v = cells[c].vertices;
    const std::uint32_t beyond = cells[mate >> 2].vertices[mate & 3];
    if (d == 3) return signs.orientation(v[0], v[1], v[2], beyond) == 0;
    return normal_axis(triangulation.point(v[0]), triangulation.point(v[1]), triangulation.point(beyond)) == 3;
  });
  return labels;
}

/// Which vertices of a regular triangulation are corners of their Delone cells.
class CornerSearch {
 public:
  CornerSearch(const Regular3& triangulation, const DeloneLabels& labels)
      : triangulation_(triangulation), labels_(labels), size_(static_cast<unsigned>(triangulation.dimension()) + 1) {}

  std::vector<bool> run(const Context& context) const {
    std::vector<bool> corners = corners_of_simplices();
    const VertexStars stars(triangulation_);
    for (std::uint32_t v = 0; v < corners.size(); ++v) {
      if (v % 1024 == 0) context.poll();
      if (!corners[v] && stars.cell(v) != VertexStars::no_cell) corners[v] = is_corner(v, stars.star(v));
    }
    return corners;
  }

 private:
  /// Those of some cell that is one simplex: of most.
  std::vector<bool> corners_of_simplices() const {
    std::vector<std::uint32_t> parts(labels_.cell_count, 0);
    const std::span<const TriangulationCell> cells = triangulation_.cells();
    for (std::size_t c = 0; c < cells.size(); ++c) {
      if (!triangulation_.is_ghost(c)) ++parts[labels_.cell_of[c]];
    }
    std::vector<bool> corners(triangulation_.vertex_count(), false);
    for (std::size_t c = 0; c < cells.size(); ++c) {
      if (triangulation_.is_ghost(c) || parts[labels_.cell_of[c]] > 1) continue;
      for (unsigned i = 0; i < size_; ++i) corners[cells[c].vertices[i]] = true;
    }
    return corners;
  }

  /// A point of a convex cell is a corner if the cell's sides there have nothing else in common. It is then a corner of
  /// all cells that it is in, so one of them decides.
  bool is_corner(std::uint32_t vertex, const std::vector<std::uint32_t>& star) const {
    std::uint32_t label = no_label;
    for (const std::uint32_t c : star) label = std::min(label, labels_.cell_of[c]);
    std::vector<std::array<std::uint32_t, 2>> sides;  // the other vertices of each, as many as there are
    for (const std::uint32_t c : star) {
      if (labels_.cell_of[c] != label) continue;
      const TriangulationCell& cell = triangulation_.cells()[c];
      for (unsigned i = 0; i < size_; ++i) {
        if (cell.vertices[i] == vertex || labels_.cell_of[cell.neighbours[i] >> 2] == label) continue;
        std::array<std::uint32_t, 2> side{};
        unsigned count = 0;
        for (unsigned k = 0; k < size_; ++k) {
          if (k != i && cell.vertices[k] != vertex) side[count++] = cell.vertices[k];
        }
        sides.push_back(side);
      }
    }
    if (size_ < 3) return !sides.empty() || size_ == 1;
    return size_ == 3 ? is_corner_between(vertex, sides) : is_corner_of_planes(vertex, sides);
  }

  bool is_corner_between(std::uint32_t vertex, const std::vector<std::array<std::uint32_t, 2>>& edges) const {
    const auto point = [this](std::uint32_t v) { return triangulation_.point(v); };
    return edges.size() == 2 && normal_axis(point(edges[0][0]), point(vertex), point(edges[1][0])) < 3;
  }

  /// Sides of a wedge are in two planes, those of a half-space in one.
  bool is_corner_of_planes(std::uint32_t vertex, const std::vector<std::array<std::uint32_t, 2>>& triangles) const {
    const auto point = [this](std::uint32_t v) { return triangulation_.point(v); };
    std::vector<std::array<std::uint32_t, 2>> planes;  // by some triangle of each
    for (const auto& [a, b] : triangles) {
      const bool is_new = std::ranges::none_of(planes, [&, a = a, b = b](const std::array<std::uint32_t, 2>& plane) {
        const auto is_in = [&](std::uint32_t v) {
          return orientation(point(vertex), point(plane[0]), point(plane[1]), point(v)) == Sign::zero;
        };
        return is_in(a) && is_in(b);
      });
      if (is_new) planes.push_back({a, b});
      if (planes.size() > 2) return true;
    }
    return false;
  }

  const Regular3& triangulation_;
  const DeloneLabels& labels_;
  unsigned size_;
};

/// A triangle, edge or vertex between two numbers, as seen from the smaller one.
struct Piece {
  std::uint32_t low;
  std::uint32_t high;
  std::array<std::uint32_t, 3> vertices;
};

/// Facets of simplices between cells of different numbers, by these.
std::vector<Piece> pieces_between(const TriangulationView3& triangulation, const DeloneLabels& labels) {
  const std::span<const TriangulationCell> cells = triangulation.cells();
  const auto d = static_cast<unsigned>(triangulation.dimension());
  std::vector<Piece> pieces;
  for (std::uint32_t c = 0; c < cells.size(); ++c) {
    if (triangulation.is_ghost(c)) continue;
    for (unsigned i = 0; i <= d; ++i) {
      const std::uint32_t low = labels.cell_of[c];
      const std::uint32_t high = labels.cell_of[cells[c].neighbours[i] >> 2];
      if (low >= high) continue;
      Piece piece{low, high, {}};
      unsigned count = 0;
      if (d == 3) {
        // Counterclockwise from inside, so the other way round.
        const std::array<unsigned, 3>& slots = facet_slots[i];
        piece.vertices = {cells[c].vertices[slots[1]], cells[c].vertices[slots[0]], cells[c].vertices[slots[2]]};
      } else {
        for (unsigned j = 0; j <= d; ++j) {
          if (j != i) piece.vertices[count++] = cells[c].vertices[j];
        }
      }
      pieces.push_back(piece);
    }
  }
  std::sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) {
    return std::tie(a.low, a.high, a.vertices) < std::tie(b.low, b.high, b.vertices);
  });
  return pieces;
}

/// From the boundary edges of triangles that make one polygon.
std::vector<std::uint32_t> polygon_of(std::span<const Piece> triangles) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> sides;
  for (const Piece& t : triangles) {
    for (unsigned i = 0; i < 3; ++i) sides.emplace_back(t.vertices[i], t.vertices[(i + 1) % 3]);
  }
  std::sort(sides.begin(), sides.end());
  std::vector<std::pair<std::uint32_t, std::uint32_t>> outer;
  for (const auto& [from, to] : sides) {
    if (!std::binary_search(sides.begin(), sides.end(), std::pair(to, from))) outer.emplace_back(from, to);
  }
  std::vector<std::uint32_t> polygon{outer.front().first};
  for (std::uint32_t at = outer.front().second; at != polygon.front();) {
    polygon.push_back(at);
    at = std::lower_bound(outer.begin(), outer.end(), std::pair(at, std::uint32_t{0}))->second;
  }
  return polygon;
}

std::vector<std::uint32_t> vertices_of(std::span<const Piece> pieces, std::size_t size) {
  std::vector<std::uint32_t> vertices;
  for (const Piece& p : pieces) {
    vertices.insert(vertices.end(), p.vertices.begin(), p.vertices.begin() + static_cast<std::ptrdiff_t>(size));
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

}  // namespace

DeloneLabels delone_labels(const Delaunay3& triangulation, const Context& context) {
  return labels_of(triangulation, context);
}

DeloneLabels delone_labels(const Regular3& triangulation, const Context& context) {
  DeloneLabels labels = labels_of(triangulation, context);
  labels.corners = CornerSearch(triangulation, labels).run(context);
  return labels;
}

namespace {

/// Pairs of numbers of cells, or of a cell and a facet of the hull, that share a facet.
std::size_t count_facets(const TriangulationView3& triangulation, const DeloneLabels& labels, const Context& context) {
  const std::span<const TriangulationCell> cells = triangulation.cells();
  std::vector<std::uint32_t> begin(std::size_t{labels.cell_count} + 1, 0);
  for (std::uint32_t c = 0; c < cells.size(); ++c) {
    if (!triangulation.is_ghost(c)) ++begin[labels.cell_of[c] + 1];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<std::uint32_t> simplices(begin.back());
  std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
  for (std::uint32_t c = 0; c < cells.size(); ++c) {
    if (!triangulation.is_ghost(c)) simplices[next[labels.cell_of[c]]++] = c;
  }
  std::size_t count = 0;
  std::vector<std::uint32_t> mates;
  for (std::uint32_t label = 0; label < labels.cell_count; ++label) {
    if (label % 1024 == 0) context.poll();
    mates.clear();
    for (std::uint32_t i = begin[label]; i < begin[label + 1]; ++i) {
      for (const std::uint32_t mate : cells[simplices[i]].neighbours) {
        if (labels.cell_of[mate >> 2] > label) mates.push_back(labels.cell_of[mate >> 2]);
      }
    }
    std::sort(mates.begin(), mates.end());
    count += static_cast<std::size_t>(std::unique(mates.begin(), mates.end()) - mates.begin());
  }
  return count;
}

}  // namespace

DeloneCounts count_faces(const TriangulationView3& triangulation, const DeloneLabels& labels, const Context& context) {
  DeloneCounts counts;
  const std::size_t vertices = labels.corner_count(triangulation.vertex_count());
  const std::size_t cells = labels.cell_count;
  counts.faces[0] = vertices;
  counts.faces[static_cast<std::size_t>(triangulation.dimension())] = cells;
  if (triangulation.dimension() == 2) counts.faces[1] = vertices + cells - 1;
  if (triangulation.dimension() == 3) {
    counts.faces[2] = count_facets(triangulation, labels, context);
    counts.faces[1] = vertices + counts.faces[2] - cells - 1;
  }
  return counts;
}

DeloneComplex::DeloneComplex(const Delaunay3& triangulation, const Context& context)
    : DeloneComplex(triangulation, delone_labels(triangulation, context), context) {}

DeloneComplex::DeloneComplex(const Regular3& triangulation, const Context& context)
    : DeloneComplex(triangulation, delone_labels(triangulation, context), context) {}

DeloneComplex::DeloneComplex(const TriangulationView3& triangulation, DeloneLabels labels, const Context& context)
    : dimension_(triangulation.dimension()), vertex_count_(triangulation.vertex_count()) {
  collect_cells(triangulation, labels);
  collect_facets(triangulation, labels, context);
  collect_edges();
}

void DeloneComplex::collect_cells(const TriangulationView3& triangulation, DeloneLabels& labels) {
  const std::span<const TriangulationCell> cells = triangulation.cells();
  const auto size = static_cast<std::size_t>(dimension_) + 1;
  std::vector<std::vector<std::uint32_t>> vertices(labels.cell_count);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (triangulation.is_ghost(c)) continue;
    std::vector<std::uint32_t>& list = vertices[labels.cell_of[c]];
    for (std::size_t i = 0; i < size; ++i) {
      if (labels.is_corner(cells[c].vertices[i])) list.push_back(cells[c].vertices[i]);
    }
  }
  for (std::vector<std::uint32_t>& list : vertices) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  std::vector<std::uint32_t> order(vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return vertices[a] < vertices[b]; });
  std::vector<std::uint32_t> number(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    number[order[i]] = i;
    cell_vertices_.insert(cell_vertices_.end(), vertices[order[i]].begin(), vertices[order[i]].end());
    cell_begin_.push_back(cell_vertices_.size());
  }
  for (std::uint32_t& label : labels.cell_of) {
    if (label < labels.cell_count) label = number[label];
  }
}

void DeloneComplex::collect_facets(const TriangulationView3& triangulation, const DeloneLabels& labels,
                                   const Context& context) {
  if (dimension_ == 0) return;
  const auto d = static_cast<unsigned>(dimension_);
  const std::vector<Piece> pieces = pieces_between(triangulation, labels);
  struct Facet {
    std::array<std::uint32_t, 2> cells;
    std::vector<std::uint32_t> vertices;
  };
  std::vector<Facet> facets;
  for (std::size_t begin = 0; begin < pieces.size();) {
    if (facets.size() % 1024 == 0) context.poll();
    const Piece& first = pieces[begin];
    std::size_t end = begin + 1;
    while (end < pieces.size() && pieces[end].low == first.low && pieces[end].high == first.high) ++end;
    Facet facet{{first.low, first.high < labels.cell_count ? first.high : outside}, {}};
    const std::span<const Piece> parts(pieces.data() + begin, end - begin);
    facet.vertices = d == 3 ? polygon_of(parts) : vertices_of(parts, d);
    std::erase_if(facet.vertices, [&](std::uint32_t v) { return !labels.is_corner(v); });
    std::rotate(facet.vertices.begin(), std::ranges::min_element(facet.vertices), facet.vertices.end());
    facets.push_back(std::move(facet));
    begin = end;
  }
  std::sort(facets.begin(), facets.end(), [](const Facet& a, const Facet& b) {
    return std::tie(a.cells, a.vertices) < std::tie(b.cells, b.vertices);
  });
  for (const Facet& facet : facets) {
    facet_cells_.push_back(facet.cells);
    facet_vertices_.insert(facet_vertices_.end(), facet.vertices.begin(), facet.vertices.end());
    facet_begin_.push_back(facet_vertices_.size());
  }
}

void DeloneComplex::collect_edges() {
  const auto add = [this](std::uint32_t a, std::uint32_t b) { edges_.push_back({std::min(a, b), std::max(a, b)}); };
  if (dimension_ == 1) {
    for (std::size_t c = 0; c < cell_count(); ++c) add(cell(c)[0], cell(c)[1]);
  } else if (dimension_ > 1) {
    for (std::size_t f = 0; f < facet_count(); ++f) {
      const std::span<const std::uint32_t> polygon = facet(f);
      for (std::size_t i = 0; i < polygon.size(); ++i) add(polygon[i], polygon[(i + 1) % polygon.size()]);
    }
  }
  std::sort(edges_.begin(), edges_.end());
  edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
}

}  // namespace quoin
