// SPDX-License-Identifier: Apache-2.0
#include "quoin/topology/cell_complex.h"

#include <algorithm>
#include <numeric>
#include <string>

#include "quoin/base/error.h"
#include "quoin/base/large_vector.h"
#include "quoin/base/polled_resize.h"

namespace quoin {

namespace {

constexpr std::size_t poll_interval = 4096;
constexpr std::size_t most_rows = 0xFFFFFFF0U;

/// A facet without its least vertex, and where it is a facet: place of the simplex times its width and the slot.
struct Facet {
  std::uint64_t rest;
  std::uint64_t at;
};

void require_few(std::size_t rows, std::size_t width) {
  if (rows >= most_rows) throw InputError("2^32 simplices of dimension " + std::to_string(width - 1) + " or more");
}

}  // namespace

CellComplexBuilder::CellComplexBuilder(std::span<const std::uint32_t> vertices, std::size_t width,
                                       const Context& context)
    : given_(vertices), width_(width), context_(context) {
  if (width < 1 || width > 4) throw InputError("cells of " + std::to_string(width) + " vertices");
  if (vertices.size() % width != 0) {
    throw InputError(std::to_string(vertices.size()) + " vertices of cells of " + std::to_string(width));
  }
  require_few(vertices.size() / width, width);
}

void CellComplexBuilder::number_vertices() {
  std::vector<std::uint32_t>& labels = result_.labels_;
  std::vector<bool> is_used(std::size_t{*std::max_element(given_.begin(), given_.end())} + 1);
  for (std::size_t i = 0; i < given_.size(); ++i) {
    if (i % poll_interval == 0) context_.poll();
    is_used[given_[i]] = true;
  }
  for (std::size_t label = 0; label < is_used.size(); ++label) {
    if (label % poll_interval == 0) context_.poll();
    if (is_used[label]) labels.push_back(static_cast<std::uint32_t>(label));
  }
}

/// In buckets by the least vertex, then within these.
template <std::size_t W>
void CellComplexBuilder::sort_cells() {
  using Row = std::array<std::uint32_t, W>;
  const std::vector<std::uint32_t>& labels = result_.labels_;
  std::vector<std::uint32_t> number(std::size_t{labels.back()} + 1);
  for (std::uint32_t v = 0; v < labels.size(); ++v) {
    if (v % poll_interval == 0) context_.poll();
    number[labels[v]] = v;
  }
  const std::size_t count = given_.size() / W;
  std::vector<std::size_t> begin(labels.size() + 1, 0);
  for (std::size_t i = 0; i < count; ++i) {
    if (i % poll_interval == 0) context_.poll();
    ++begin[number[*std::min_element(given_.begin() + static_cast<std::ptrdiff_t>(i * W),
                                     given_.begin() + static_cast<std::ptrdiff_t>((i + 1) * W))] +
            1];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  LargeVector<Row> rows;
  resize_and_poll(rows, count, context_);
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for (std::size_t i = 0; i < count; ++i) {
    if (i % poll_interval == 0) context_.poll();
    Row row;
    for (std::size_t j = 0; j < W; ++j) row[j] = number[given_[i * W + j]];
    std::sort(row.begin(), row.end());
    const auto twice = std::adjacent_find(row.begin(), row.end());
    if (twice != row.end()) {
      throw InputError("simplex " + std::to_string(i) + " has vertex " + std::to_string(labels[*twice]) + " twice");
    }
    rows[next[row[0]]++] = row;
  }
  SimplicialComplex::Layer& layer = result_.layers_[W - 1];
  layer.first.assign(labels.size() + 1, 0);
  layer.vertices.reserve(count * W);
  for (std::size_t v = 0; v < labels.size(); ++v) {
    if (v % poll_interval == 0) context_.poll();
    const auto from = rows.begin() + static_cast<std::ptrdiff_t>(begin[v]);
    auto to = rows.begin() + static_cast<std::ptrdiff_t>(begin[v + 1]);
    std::sort(from, to);
    to = std::unique(from, to);
    layer.first[v] = static_cast<std::uint32_t>(layer.size);
    layer.size += static_cast<std::size_t>(to - from);
    for (auto row = from; row != to; ++row) layer.vertices.insert(layer.vertices.end(), row->begin(), row->end());
  }
  layer.first.back() = static_cast<std::uint32_t>(layer.size);
}

/// Of simplices of W vertices, which are in order: three or four.
template <std::size_t W>
void CellComplexBuilder::derive_facets() {
  SimplicialComplex::Layer& layer = result_.layers_[W - 1];
  SimplicialComplex::Layer& lower = result_.layers_[W - 2];
  const std::size_t vertex_count = result_.labels_.size();
  const LargeVector<std::uint32_t>& v = layer.vertices;
  resize_and_poll(layer.facets, v.size(), context_);

  // By the second vertex.
  std::vector<std::size_t> begin(vertex_count + 1, 0);
  for (std::size_t i = 0; i < layer.size; ++i) {
    if (i % poll_interval == 0) context_.poll();
    ++begin[v[i * W + 1] + 1];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  LargeVector<std::uint32_t> of_second;
  resize_and_poll(of_second, layer.size, context_);
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for (std::uint32_t i = 0; i < layer.size; ++i) {
    if (i % poll_interval == 0) context_.poll();
    of_second[next[v[i * W + 1]]++] = i;
  }

  const auto pack = [](std::uint64_t b, std::uint64_t c) { return W == 4 ? b << 32 | c : c; };
  lower.first.assign(vertex_count + 1, 0);
  lower.vertices.reserve((2 * layer.size + layer.size / 8 + vertex_count) * (W - 1));
  std::vector<Facet> facets;
  for (std::uint32_t a = 0; a < vertex_count; ++a) {
    if (a % 256 == 0) context_.poll();
    facets.clear();
    for (std::size_t i = layer.first[a]; i < layer.first[a + 1]; ++i) {
      const std::uint32_t* const row = v.data() + i * W;
      if constexpr (W == 4) {
        facets.push_back({pack(row[2], row[3]), i * W + 1});
        facets.push_back({pack(row[1], row[3]), i * W + 2});
        facets.push_back({pack(row[1], row[2]), i * W + 3});
      } else {
        facets.push_back({row[2], i * W + 1});
        facets.push_back({row[1], i * W + 2});
      }
    }
    for (std::size_t i = begin[a]; i < begin[a + 1]; ++i) {
      const std::size_t at = of_second[i] * W;
      facets.push_back({pack(v[at + 2], v[at + W - 1]), at});
    }
    std::sort(facets.begin(), facets.end(), [](const Facet& x, const Facet& y) { return x.rest < y.rest; });
    lower.first[a] = static_cast<std::uint32_t>(lower.size);
    for (std::size_t i = 0; i < facets.size(); ++i) {
      if (i == 0 || facets[i].rest != facets[i - 1].rest) {
        ++lower.size;
        lower.vertices.push_back(a);
        if constexpr (W == 4) lower.vertices.push_back(static_cast<std::uint32_t>(facets[i].rest >> 32));
        lower.vertices.push_back(static_cast<std::uint32_t>(facets[i].rest));
      }
      layer.facets[facets[i].at] = static_cast<std::uint32_t>(lower.size - 1);
    }
    require_few(lower.size, W - 1);
  }
  lower.first.back() = static_cast<std::uint32_t>(lower.size);
}

void CellComplexBuilder::finish_edges() {
  SimplicialComplex::Layer& edges = result_.layers_[1];
  resize_and_poll(edges.facets, edges.vertices.size(), context_);
  for (std::size_t i = 0; i < edges.vertices.size(); i += 2) {
    if (i % poll_interval == 0) context_.poll();
    edges.facets[i] = edges.vertices[i + 1];
    edges.facets[i + 1] = edges.vertices[i];
  }
  SimplicialComplex::Layer& vertices = result_.layers_[0];
  vertices.size = result_.labels_.size();
  vertices.vertices.resize(vertices.size);
  std::iota(vertices.vertices.begin(), vertices.vertices.end(), 0U);
  vertices.first.resize(vertices.size + 1);
  std::iota(vertices.first.begin(), vertices.first.end(), 0U);
}

SimplicialComplex CellComplexBuilder::build() {
  context_.progress("complex", 0);
  if (given_.empty()) return {};
  number_vertices();
  result_.layers_.resize(width_);
  if (width_ == 4) {
    sort_cells<4>();
    derive_facets<4>();
  } else if (width_ == 3) {
    sort_cells<3>();
  } else if (width_ == 2) {
    sort_cells<2>();
  } else {
    sort_cells<1>();
  }
  if (width_ > 2) derive_facets<3>();
  if (width_ > 1) finish_edges();
  return std::move(result_);
}

SimplicialComplex SimplicialComplex::closure_of_cells(std::span<const std::uint32_t> vertices, std::size_t width,
                                                      const Context& context) {
  CellComplexBuilder builder(vertices, width, context);
  if (!vertices.empty() && *std::max_element(vertices.begin(), vertices.end()) / 64 > vertices.size()) {
    SimplexList list;
    for (std::size_t i = 0; i < vertices.size(); i += width) list.add(vertices.subspan(i, width));
    return closure_of(list, context);
  }
  return builder.build();
}

}  // namespace quoin
