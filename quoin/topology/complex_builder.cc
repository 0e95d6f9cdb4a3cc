// SPDX-License-Identifier: Apache-2.0
#include "quoin/topology/complex_builder.h"

#include <algorithm>
#include <array>
#include <string>

#include "quoin/base/error.h"

namespace quoin {

namespace {

constexpr std::size_t poll_interval = 4096;
constexpr std::size_t most_rows = 0xFFFFFFF0U;

std::string name_of(const SimplexList& list, std::size_t i) {
  std::string text = "simplex " + std::to_string(i) + " (";
  for (std::size_t j = 0; j < list[i].size() && j < 30; ++j) text += (j == 0 ? "" : " ") + std::to_string(list[i][j]);
  return text + ")";
}

// Rows of W numbers that follow one another, as values that can be sorted.
template <std::size_t W>
void sort_narrow(std::uint32_t* begin, const std::uint32_t* end) {
  using Row = std::array<std::uint32_t, W>;
  static_assert(sizeof(Row) == W * sizeof(std::uint32_t));
  const std::size_t count = static_cast<std::size_t>(end - begin) / W;
  if (count < 2) return;
  std::array<Row, 256> few;
  std::vector<Row> many;
  Row* rows = few.data();
  if (count > few.size()) {
    many.resize(count);
    rows = many.data();
  }
  for (std::size_t i = 0; i < count; ++i) std::copy_n(begin + i * W, W, rows[i].begin());
  std::sort(rows, rows + count);
  for (std::size_t i = 0; i < count; ++i) std::copy_n(rows[i].begin(), W, begin + i * W);
}

void sort_wide(std::uint32_t* begin, std::uint32_t* end, std::size_t width) {
  const std::vector<std::uint32_t> copy(begin, end);
  std::vector<const std::uint32_t*> rows;
  for (std::size_t i = 0; i < copy.size(); i += width) rows.push_back(copy.data() + i);
  std::sort(rows.begin(), rows.end(), [width](const std::uint32_t* a, const std::uint32_t* b) {
    return std::lexicographical_compare(a, a + width, b, b + width);
  });
  for (const std::uint32_t* row : rows) begin = std::copy_n(row, width, begin);
}

bool is_sorted(const std::uint32_t* begin, const std::uint32_t* end, std::size_t width) {
  for (const std::uint32_t* row = begin; row != end && row + width != end; row += width)
    if (std::lexicographical_compare(row + width, row + 2 * width, row, row + width)) return false;
  return true;
}

void sort_bucket(std::uint32_t* begin, std::uint32_t* end, std::size_t width) {
  if (is_sorted(begin, end, width)) return;
  switch (width) {
    case 2:
      return sort_narrow<2>(begin, end);
    case 3:
      return sort_narrow<3>(begin, end);
    case 4:
      return sort_narrow<4>(begin, end);
    case 5:
      return sort_narrow<5>(begin, end);
    default:
      return sort_wide(begin, end, width);
  }
}

}  // namespace

ComplexBuilder::ComplexBuilder(const SimplexList& simplices, const Context& context)
    : simplices_(simplices), context_(context) {}

void ComplexBuilder::require_valid() const {
  for (std::size_t i = 0; i < simplices_.size(); ++i) {
    if (i % poll_interval == 0) context_.poll();
    const auto simplex = simplices_[i];
    if (simplex.empty()) throw InputError("simplex " + std::to_string(i) + " has no vertex");
    if (simplex.size() > SimplicialComplex::most_vertices) {
      throw InputError(name_of(simplices_, i) + " has " + std::to_string(simplex.size()) + " vertices; more than " +
                       std::to_string(SimplicialComplex::most_vertices) + " have too many faces");
    }
    for (std::size_t j = 1; j < simplex.size(); ++j) {
      if (std::find(simplex.begin(), simplex.begin() + static_cast<std::ptrdiff_t>(j), simplex[j]) !=
          simplex.begin() + static_cast<std::ptrdiff_t>(j))
        throw InputError(name_of(simplices_, i) + " has vertex " + std::to_string(simplex[j]) + " twice");
    }
  }
}

void ComplexBuilder::number_vertices() {
  std::vector<std::uint32_t>& labels = result_.labels_;
  std::size_t mentions = 0;
  std::uint32_t largest = 0;
  for (std::size_t i = 0; i < simplices_.size(); ++i) {
    mentions += simplices_[i].size();
    for (const std::uint32_t label : simplices_[i]) largest = std::max(largest, label);
  }
  context_.poll();
  if (largest / 64 <= mentions) {
    std::vector<bool> is_used(mentions == 0 ? 0 : std::size_t{largest} + 1);
    for (std::size_t i = 0; i < simplices_.size(); ++i)
      for (const std::uint32_t label : simplices_[i]) is_used[label] = true;
    for (std::size_t label = 0; label < is_used.size(); ++label)
      if (is_used[label]) labels.push_back(static_cast<std::uint32_t>(label));
    return;
  }
  labels.reserve(mentions);
  for (std::size_t i = 0; i < simplices_.size(); ++i)
    labels.insert(labels.end(), simplices_[i].begin(), simplices_[i].end());
  std::sort(labels.begin(), labels.end());
  labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
  labels.shrink_to_fit();
}

void ComplexBuilder::spread_rows() {
  const std::vector<std::uint32_t>& labels = result_.labels_;
  const bool is_numbered = labels.empty() || labels.back() + std::size_t{1} == labels.size();
  std::array<std::uint32_t, SimplicialComplex::most_vertices + 1> row;
  for (std::size_t i = 0; i < simplices_.size(); ++i) {
    if (i % poll_interval == 0) context_.poll();
    const auto simplex = simplices_[i];
    std::transform(simplex.begin(), simplex.end(), row.begin(), [&](std::uint32_t label) {
      if (is_numbered) return label;
      return static_cast<std::uint32_t>(std::lower_bound(labels.begin(), labels.end(), label) - labels.begin());
    });
    const auto end = row.begin() + static_cast<std::ptrdiff_t>(simplex.size());
    std::sort(row.begin(), end);
    *end = static_cast<std::uint32_t>(i);
    if (given_.size() < simplex.size()) given_.resize(simplex.size());
    Rows& rows = given_[simplex.size() - 1];
    rows.insert(rows.end(), row.begin(), end + 1);
  }
  // Every vertex of a simplex is one of the complex.
  for (std::uint32_t v = 0; v < labels.size(); ++v) given_[0].insert(given_[0].end(), {v, not_listed});
}

// By the first vertex, each bucket in the order of the rows.
ComplexBuilder::Rows ComplexBuilder::sort_by_first(const Rows& rows, std::size_t width,
                                                   std::vector<std::size_t>& begin) const {
  begin.assign(result_.labels_.size() + 1, 0);
  for (std::size_t i = 0; i < rows.size(); i += width) ++begin[rows[i] + 1];
  for (std::size_t v = 1; v < begin.size(); ++v) begin[v] += begin[v - 1];
  Rows sorted(rows.size());
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for (std::size_t i = 0; i < rows.size(); i += width) {
    std::uint32_t* const to = sorted.data() + width * next[rows[i]]++;
    for (std::size_t j = 0; j < width; ++j) to[j] = rows[i + j];
  }
  return sorted;
}

void ComplexBuilder::sort_rows(int k, Rows rows) {
  const std::size_t vertices = static_cast<std::size_t>(k) + 1;
  const std::size_t width = vertices + 1;
  SimplicialComplex::Layer& layer = result_.layers_[k];
  if (rows.size() / width >= most_rows)
    throw InputError("2^32 simplices of dimension " + std::to_string(k) + " or more");
  std::vector<std::size_t> begin;
  Rows sorted = sort_by_first(rows, width, begin);
  rows = Rows();
  layer.first.assign(begin.size(), 0);
  layer.vertices.clear();
  listing_[k].clear();
  for (std::size_t v = 0; v + 1 < begin.size(); ++v) {
    if (v % 256 == 0) context_.poll();
    sort_bucket(sorted.data() + begin[v] * width, sorted.data() + begin[v + 1] * width, width);
    layer.first[v] = static_cast<std::uint32_t>(listing_[k].size());
    for (std::size_t i = begin[v]; i < begin[v + 1]; ++i) {
      const std::uint32_t* const row = sorted.data() + i * width;
      if (i > begin[v] && std::equal(row, row + vertices, row - width)) {
        if (row[vertices] != not_listed) duplicates_.push_back({listing_[k].back(), row[vertices]});
        continue;
      }
      layer.vertices.insert(layer.vertices.end(), row, row + vertices);
      listing_[k].push_back(row[vertices]);
    }
  }
  layer.size = listing_[k].size();
  layer.first.back() = static_cast<std::uint32_t>(layer.size);
  layer.vertices.shrink_to_fit();
}

ComplexBuilder::Rows ComplexBuilder::join_facets(int k) {
  SimplicialComplex::Layer& layer = result_.layers_[k];
  const std::size_t width = static_cast<std::size_t>(k) + 1;
  layer.facets.resize(layer.vertices.size());
  Rows missing;
  std::array<std::uint32_t, SimplicialComplex::most_vertices> facet;
  for (std::size_t i = 0; i < layer.size; ++i) {
    if (i % poll_interval == 0) context_.poll();
    const std::uint32_t* row = layer.vertices.data() + i * width;
    for (std::size_t j = 1; j < width; ++j) facet[j - 1] = row[j];
    // Rows that follow one another often have all but the last vertex in common.
    const bool is_alike = i > 0 && std::equal(row, row + width - 1, row - width);
    for (std::size_t j = 0; j < width; ++j) {
      const bool is_known = is_alike && j + 1 == width;
      const std::uint32_t found = is_known ? layer.facets[i * width - 1] : result_.place_of({facet.data(), width - 1});
      layer.facets[i * width + j] = found;
      if (found == SimplicialComplex::nowhere) {
        missing.insert(missing.end(), facet.begin(), facet.begin() + static_cast<std::ptrdiff_t>(width - 1));
        missing.push_back(not_listed);
      }
      facet[j] = row[j];
    }
  }
  return missing;
}

void ComplexBuilder::finish_layer(int k) {
  sort_rows(k, std::move(given_[k]));
  if (k + 1 > result_.dimension()) return;
  Rows rows = join_facets(k + 1);
  if (rows.empty()) return;
  const LargeVector<std::uint32_t> vertices = std::move(result_.layers_[k].vertices);
  const std::size_t width = static_cast<std::size_t>(k) + 1;
  for (std::size_t i = 0; i < listing_[k].size(); ++i) {
    const auto row = vertices.begin() + static_cast<std::ptrdiff_t>(i * width);
    rows.insert(rows.end(), row, row + static_cast<std::ptrdiff_t>(width));
    rows.push_back(listing_[k][i]);
  }
  sort_rows(k, std::move(rows));
  join_facets(k + 1);
}

SimplicialComplex ComplexBuilder::build() {
  context_.progress("complex", 0);
  if (simplices_.size() >= not_listed) throw InputError("2^32 simplices or more");
  require_valid();
  number_vertices();
  if (simplices_.size() == 0) return std::move(result_);
  spread_rows();
  result_.layers_.resize(given_.size());
  listing_.resize(given_.size());
  for (int k = result_.dimension(); k >= 0; --k) finish_layer(k);
  return std::move(result_);
}

}  // namespace quoin
