// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/topology/simplicial_complex.h"

namespace quoin {

/// A complex whose simplices enter one after another, or several at once: by grades, which stand for values of any kind
/// in their order. No simplex has a lower grade than its faces.
struct Filtration {
  SimplicialComplex complex;
  std::vector<std::vector<std::uint32_t>> grade;  ///< by dimension and simplex
  std::size_t added_faces = 0;  ///< faces that were not listed; each has the least grade of its cofaces

  std::uint32_t grade_of(SimplexId s) const { return grade[s.dimension][s.index]; }
};

/// The filtration of listed simplices with a grade each, and of their faces.
/// @throws InputError  as SimplicialComplex; a simplex is listed twice, and named, or enters before one of its faces,
///                     and both are named
Filtration filtration_of(const SimplexList& simplices, std::span<const std::uint32_t> grades, const Context& context);

/// Each simplex enters with the last of its vertices.
Filtration lower_star_filtration(SimplicialComplex complex, std::span<const std::uint32_t> vertex_grades);

/// Each simplex of the complex enters by itself, in this order.
/// @throws InputError  one is missing, there twice, or before one of its faces
Filtration filtration_by_order(SimplicialComplex complex, std::span<const SimplexId> order);

/// The simplices of each dimension by grade, those of equal grade by their place in the complex.
std::vector<std::vector<std::uint32_t>> filtration_order(const Filtration& filtration, const Context& context);

/// Values as grades: the distinct ones in ascending order, and the place of each value among them.
template <class Value>
struct Grades {
  std::vector<Value> values;
  std::vector<std::uint32_t> grade;
};
template <class Value>
Grades<Value> grades_of(std::span<const Value> values) {
  std::vector<std::uint32_t> order(values.size());
  std::iota(order.begin(), order.end(), 0U);
  if (!std::is_sorted(values.begin(), values.end()))
    std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) { return values[i] < values[j]; });
  Grades<Value> result;
  result.grade.resize(values.size());
  for (const std::uint32_t i : order) {
    if (result.values.empty() || result.values.back() < values[i]) result.values.push_back(values[i]);
    result.grade[i] = static_cast<std::uint32_t>(result.values.size() - 1);
  }
  return result;
}

}  // namespace quoin
