// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "quoin/arrangement/circular/circular_polygon_set.h"
#include "quoin/arrangement/linear/linear_polygon_set.h"
#include "quoin/base/context.h"
#include "quoin/cli/planar.h"
#include "quoin/io/drawing_curves.h"

namespace quoin::cli {

/// What the inputs enclose, arranged; each input is an operand, the union of its elements.
template <class F>
struct Regions {
  Arrangement<F> drawn;
  RegionCurves curves;
  RegionGroups groups;
};

/// Arranges the rings of all inputs, each element read by `rule`; without one by the rule of its file where that has
/// rings in any order, else as an outline with holes, which must be valid. Elements that enclose nothing go to
/// `warnings`.
/// @throws InputError naming an element that is refused; without a rule also rings that cross, with a place
template <class F>
Regions<F> read_regions(std::span<const PlanarInput> inputs, const std::optional<FillRule>& rule,
                        std::vector<std::string>& warnings, const Context& context);
extern template Regions<LinearFamily> read_regions(std::span<const PlanarInput>, const std::optional<FillRule>&,
                                                   std::vector<std::string>&, const Context&);
extern template Regions<CircularFamily> read_regions(std::span<const PlanarInput>, const std::optional<FillRule>&,
                                                     std::vector<std::string>&, const Context&);

/// One of the operands.
template <class F>
PolygonSet<F> set_of_operand(const Regions<F>& regions, std::uint32_t operand) {
  // The others' elements become an operand that is no part of a union of one.
  RegionGroups groups = regions.groups;
  for (std::uint32_t& of : groups.operand_of_element) of = of == operand ? 0 : 1;
  groups.operand_count = 2;
  return combine_regions(regions.drawn, groups, SetOperation::first);
}

}  // namespace quoin::cli
