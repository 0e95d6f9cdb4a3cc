// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/delone.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

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

/// A triangle, edge or vertex between two numbers, as seen from the smaller one.
struct Piece {
  std::uint32_t low;
  std::uint32_t high;
  std::array<std::uint32_t, 3> vertices;
};

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

}  // namespace

DeloneLabels delone_labels(const Delaunay3& triangulation, const Context& context) {
  const std::span<const TriangulationCell> cells = triangulation.cells();
  const auto d = static_cast<unsigned>(triangulation.dimension());
  const DelaunaySigns signs = triangulation.signs();
  DeloneLabels labels;
  labels.cell_of.assign(cells.size(), no_label);
  const auto is_ghost = [&](std::uint32_t c) { return triangulation.is_ghost(c); };
  const auto is_finite = [&](std::uint32_t c) { return !triangulation.is_ghost(c); };
  labels.cell_count = label_parts(cells, d, 0, labels.cell_of, context, is_finite, [&](std::uint32_t c, unsigned slot) {
    const std::uint32_t mate = cells[c].neighbours[slot];
    return triangulation.in_sphere(signs, c, cells[mate >> 2].vertices[mate & 3]) == 0;
  });
  const auto finite_label = [&](std::uint32_t ghost) { return labels.cell_of[cells[ghost].neighbours[d] >> 2]; };
  label_parts(cells, d, labels.cell_count, labels.cell_of, context, is_ghost, [&](std::uint32_t c, unsigned slot) {
    const std::uint32_t mate = cells[c].neighbours[slot];
    if (d < 3 || slot == d || finite_label(c) != finite_label(mate >> 2)) return false;
    const auto& v = cells[c].vertices;
    return signs.orientation(v[0], v[1], v[2], cells[mate >> 2].vertices[mate & 3]) == 0;
  });
  return labels;
}

namespace {

/// Pairs of numbers of cells, or of a cell and a facet of the hull, that share a facet.
std::size_t count_facets(const Delaunay3& triangulation, const DeloneLabels& labels, const Context& context) {
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

DeloneCounts count_faces(const Delaunay3& triangulation, const DeloneLabels& labels, const Context& context) {
  DeloneCounts counts;
  const std::size_t vertices = triangulation.vertex_count();
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
    : dimension_(triangulation.dimension()), vertex_count_(triangulation.vertex_count()) {
  DeloneLabels labels = delone_labels(triangulation, context);
  collect_cells(triangulation, labels);
  collect_facets(triangulation, labels, context);
  collect_edges();
}

void DeloneComplex::collect_cells(const Delaunay3& triangulation, DeloneLabels& labels) {
  const std::span<const TriangulationCell> cells = triangulation.cells();
  const auto size = static_cast<std::size_t>(dimension_) + 1;
  std::vector<std::vector<std::uint32_t>> vertices(labels.cell_count);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (triangulation.is_ghost(c)) continue;
    std::vector<std::uint32_t>& list = vertices[labels.cell_of[c]];
    list.insert(list.end(), cells[c].vertices.begin(), cells[c].vertices.begin() + static_cast<std::ptrdiff_t>(size));
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

void DeloneComplex::collect_facets(const Delaunay3& triangulation, const DeloneLabels& labels, const Context& context) {
  if (dimension_ == 0) return;
  const std::span<const TriangulationCell> cells = triangulation.cells();
  const auto d = static_cast<unsigned>(dimension_);
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
        if (d == 2 && piece.vertices[0] > piece.vertices[1]) std::swap(piece.vertices[0], piece.vertices[1]);
      }
      pieces.push_back(piece);
    }
  }
  std::sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) {
    return std::tie(a.low, a.high, a.vertices) < std::tie(b.low, b.high, b.vertices);
  });
  struct Facet {
    std::array<std::uint32_t, 2> cells;
    std::vector<std::uint32_t> vertices;
  };
  std::vector<Facet> facets;
  for (std::size_t begin = 0; begin < pieces.size();) {
    if (facets.size() % 1024 == 0) context.poll();
    const Piece& first = pieces[begin];
    std::size_t end = begin + 1;
    while (d == 3 && end < pieces.size() && pieces[end].low == first.low && pieces[end].high == first.high) ++end;
    Facet facet{{first.low, first.high < labels.cell_count ? first.high : outside}, {}};
    if (d == 3) {
      facet.vertices = polygon_of({pieces.data() + begin, end - begin});
    } else {
      facet.vertices.assign(first.vertices.begin(), first.vertices.begin() + d);
    }
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
