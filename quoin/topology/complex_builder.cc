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
void sort_narrow(std::uint32_t* begin, std::uint32_t* end) {
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
  std::vector<std::vector<std::uint32_t>> rows;
  for (const std::uint32_t* row = begin; row != end; row += width) rows.emplace_back(row, row + width);
  std::sort(rows.begin(), rows.end());
  for (const std::vector<std::uint32_t>& row : rows) begin = std::copy(row.begin(), row.end(), begin);
}

void sort_bucket(std::uint32_t* begin, std::uint32_t* end, std::size_t width) {
  switch (width) {
    case 2:
      return sort_narrow<2>(begin, end);
    case 3:
      return sort_narrow<3>(begin, end);
    case 4:
      return sort_narrow<4>(begin, end);
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
  std::array<std::uint32_t, SimplicialComplex::most_vertices> row;
  for (std::size_t i = 0; i < simplices_.size(); ++i) {
    if (i % poll_interval == 0) context_.poll();
    const auto simplex = simplices_[i];
    std::transform(simplex.begin(), simplex.end(), row.begin(), [&](std::uint32_t label) {
      if (is_numbered) return label;
      return static_cast<std::uint32_t>(std::lower_bound(labels.begin(), labels.end(), label) - labels.begin());
    });
    const auto end = row.begin() + static_cast<std::ptrdiff_t>(simplex.size());
    std::sort(row.begin(), end);
    if (given_.size() < simplex.size()) given_.resize(simplex.size());
    Rows& rows = given_[simplex.size() - 1];
    rows.insert(rows.end(), row.begin(), end);
  }
}

void ComplexBuilder::sort_rows(int k, Rows& rows) {
  const std::size_t width = static_cast<std::size_t>(k) + 1;
  SimplicialComplex::Layer& layer = result_.layers_[k];
  if (rows.size() / width >= most_rows) throw InputError("more than 2^32 simplices of dimension " + std::to_string(k));
  std::vector<std::size_t> begin(result_.labels_.size() + 1, 0);
  for (std::size_t i = 0; i < rows.size(); i += width) ++begin[rows[i] + 1];
  for (std::size_t v = 1; v < begin.size(); ++v) begin[v] += begin[v - 1];
  Rows sorted(rows.size());
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for (std::size_t i = 0; i < rows.size(); i += width)
    std::copy_n(rows.begin() + static_cast<std::ptrdiff_t>(i), width,
                sorted.begin() + static_cast<std::ptrdiff_t>(width * next[rows[i]]++));
  rows = Rows();
  layer.first.assign(begin.size(), 0);
  std::size_t kept = 0;  // rows that are not equal to the one before
  for (std::size_t v = 0; v + 1 < begin.size(); ++v) {
    if (v % 256 == 0) context_.poll();
    sort_bucket(sorted.data() + begin[v] * width, sorted.data() + begin[v + 1] * width, width);
    layer.first[v] = static_cast<std::uint32_t>(kept);
    for (std::size_t i = begin[v]; i < begin[v + 1]; ++i) {
      const auto row = sorted.begin() + static_cast<std::ptrdiff_t>(i * width);
      const auto last = sorted.begin() + static_cast<std::ptrdiff_t>(kept * width);
      if (kept > layer.first[v] &&
          std::equal(row, row + static_cast<std::ptrdiff_t>(width), last - static_cast<std::ptrdiff_t>(width)))
        continue;
      std::copy_n(row, width, last);
      ++kept;
    }
  }
  layer.first.back() = static_cast<std::uint32_t>(kept);
  sorted.resize(kept * width);
  sorted.shrink_to_fit();
  layer.vertices = std::move(sorted);
  layer.size = kept;
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
    std::copy_n(row + 1, width - 1, facet.begin());
    for (std::size_t j = 0; j < width; ++j) {
      const auto found = result_.find({facet.data(), width - 1});
      layer.facets[i * width + j] = found ? found->index : 0;
      if (!found) missing.insert(missing.end(), facet.begin(), facet.begin() + static_cast<std::ptrdiff_t>(width - 1));
      if (j + 1 < width) facet[j] = row[j];
    }
  }
  return missing;
}

void ComplexBuilder::finish_layer(int k, Rows rows) {
  sort_rows(k, rows);
  if (k + 1 > result_.dimension()) return;
  const Rows missing = join_facets(k + 1);
  if (missing.empty()) return;
  rows = std::move(result_.layers_[k].vertices);
  rows.insert(rows.end(), missing.begin(), missing.end());
  sort_rows(k, rows);
  join_facets(k + 1);
}

SimplicialComplex ComplexBuilder::build() {
  context_.progress("complex", 0);
  require_valid();
  number_vertices();
  spread_rows();
  result_.layers_.resize(given_.size());
  if (given_.empty()) return std::move(result_);
  given_[0].resize(result_.labels_.size());  // every vertex of a simplex is one of the complex
  for (std::size_t v = 0; v < given_[0].size(); ++v) given_[0][v] = static_cast<std::uint32_t>(v);
  for (int k = result_.dimension(); k >= 0; --k) finish_layer(k, std::move(given_[k]));
  return std::move(result_);
}

}  // namespace quoin
