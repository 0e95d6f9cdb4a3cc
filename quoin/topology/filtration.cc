// SPDX-License-Identifier: Apache-2.0
#include "quoin/topology/filtration.h"

#include <string>

#include "quoin/base/error.h"
#include "quoin/base/large_vector.h"
#include "quoin/base/parallel_sort.h"
#include "quoin/base/polled_resize.h"
#include "quoin/topology/complex_builder.h"

namespace quoin {

namespace {

constexpr std::size_t poll_interval = 4096;
constexpr std::uint32_t not_listed = ComplexBuilder::not_listed;

std::string name_of(const std::vector<std::uint32_t>& vertices) {
  std::string text = "simplex (";
  for (const std::uint32_t label : vertices) text += (text.back() == '(' ? "" : " ") + std::to_string(label);
  return text + ")";
}

std::string name_of(const SimplicialComplex& complex, SimplexId s) {
  return name_of(complex.labels(s));
}

void require_faces_first(const Filtration& filtration, const Context& context) {
  const SimplicialComplex& complex = filtration.complex;
  for (int k = 1; k <= complex.dimension(); ++k) {
    for (std::uint32_t i = 0; i < complex.count(k); ++i) {
      if (i % poll_interval == 0) context.poll();
      for (const std::uint32_t facet : complex.facets({k, i})) {
        if (filtration.grade[k - 1][facet] > filtration.grade[k][i])
          throw InputError(name_of(complex, {k, i}) + " enters before its face " + name_of(complex, {k - 1, facet}));
      }
    }
  }
}

// Counts where there are not many more grades than simplices.
std::vector<std::uint32_t> order_by_grade(const std::vector<std::uint32_t>& grade, const Context& context) {
  std::vector<std::uint32_t> order;
  resize_and_poll(order, grade.size(), context);
  const std::size_t grades = grade.empty() ? 0 : std::size_t{*std::max_element(grade.begin(), grade.end())} + 1;
  if (grades / 8 <= grade.size()) {
    LargeVector<std::uint32_t> next;
    resize_and_poll(next, grades + 1, context);
    const auto for_each = [&](std::size_t end, const auto& visit) {
      for (std::size_t i = 0; i < end; ++i) {
        if (i % poll_interval == 0) context.poll();
        visit(i);
      }
    };
    for_each(grade.size(), [&](std::size_t i) { ++next[grade[i] + 1]; });
    for_each(grades, [&](std::size_t g) { next[g + 1] += next[g]; });
    for_each(grade.size(), [&](std::size_t i) { order[next[grade[i]]++] = static_cast<std::uint32_t>(i); });
    return order;
  }
  std::vector<std::uint64_t> keys(grade.size());
  for (std::size_t i = 0; i < grade.size(); ++i) keys[i] = static_cast<std::uint64_t>(grade[i]) << 32 | i;
  sort_parallel(context, keys);
  std::transform(keys.begin(), keys.end(), order.begin(),
                 [](std::uint64_t key) { return static_cast<std::uint32_t>(key); });
  return order;
}

}  // namespace

Filtration filtration_of(const SimplexList& simplices, std::span<const std::uint32_t> grades, const Context& context) {
  if (simplices.size() != grades.size() || grades.size() >= not_listed)
    throw InputError("a filtration needs a grade for each simplex, of fewer than 2^32");
  Filtration result;
  ComplexBuilder builder(simplices, context);
  result.complex = builder.build();
  if (!builder.duplicates().empty()) {
    const auto twice = simplices[builder.duplicates()[0][0]];
    throw InputError(name_of({twice.begin(), twice.end()}) + " is listed twice");
  }
  result.grade = std::move(builder.listing());
  for (int k = result.complex.dimension(); k >= 0; --k) {
    std::vector<std::uint32_t> least(result.complex.count(k), not_listed);  // of the cofacets
    for (std::uint32_t i = 0; i < result.complex.count(k + 1); ++i)
      for (const std::uint32_t facet : result.complex.facets({k + 1, i}))
        least[facet] = std::min(least[facet], result.grade[k + 1][i]);
    for (std::uint32_t i = 0; i < result.complex.count(k); ++i) {
      std::uint32_t& grade = result.grade[k][i];
      if (grade == not_listed) ++result.added_faces;
      grade = grade == not_listed ? least[i] : grades[grade];
    }
  }
  require_faces_first(result, context);
  return result;
}

Filtration lower_star_filtration(SimplicialComplex complex, std::span<const std::uint32_t> vertex_grades) {
  if (vertex_grades.size() != complex.count(0)) throw InputError("a lower star filtration needs a grade per vertex");
  Filtration result{std::move(complex), {}};
  for (int k = 0; k <= result.complex.dimension(); ++k) {
    result.grade.emplace_back();
    for (std::uint32_t i = 0; i < result.complex.count(k); ++i) {
      std::uint32_t grade = 0;
      for (const std::uint32_t v : result.complex.vertices({k, i})) grade = std::max(grade, vertex_grades[v]);
      result.grade[k].push_back(grade);
    }
  }
  return result;
}

Filtration filtration_by_order(SimplicialComplex complex, std::span<const SimplexId> order) {
  Filtration result{std::move(complex), {}};
  for (int k = 0; k <= result.complex.dimension(); ++k) result.grade.emplace_back(result.complex.count(k), not_listed);
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    const SimplexId s = order[i];
    if (s.dimension < 0 || s.index >= result.complex.count(s.dimension))
      throw InputError("there is no simplex " + std::to_string(s.index) + " of dimension " +
                       std::to_string(s.dimension));
    std::uint32_t& grade = result.grade[s.dimension][s.index];
    if (grade != not_listed) throw InputError(name_of(result.complex, s) + " enters twice");
    grade = i;
  }
  if (order.size() != result.complex.size()) throw InputError("not all simplices enter");
  require_faces_first(result, Context());
  return result;
}

std::vector<std::vector<std::uint32_t>> filtration_order(const Filtration& filtration, const Context& context) {
  std::vector<std::vector<std::uint32_t>> order;
  for (const std::vector<std::uint32_t>& grade : filtration.grade) {
    context.poll();
    order.push_back(order_by_grade(grade, context));
  }
  return order;
}

}  // namespace quoin
