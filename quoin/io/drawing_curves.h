// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "quoin/arrangement/circular/circular_family.h"
#include "quoin/arrangement/linear/linear_family.h"
#include "quoin/io/drawing.h"

namespace quoin {

/// Whether some element is a circle or has an arc: then CircularFamily is needed, else LinearFamily serves.
bool has_arcs(const Drawing& drawing);

/// Adds every element as curves of an arrangement, exactly: a point, a path and a circle as one curve each, a polygon
/// as one curve for each ring. Appends the names of the curves. Arcs in a linear family are refused.
/// @throws InputError naming an element without extent (see check_drawing)
void add_curves(LinearFamily& family, PieceList<LinearFamily>& list, const Drawing& drawing,
                std::vector<std::string>& names);
void add_curves(CircularFamily& family, PieceList<CircularFamily>& list, const Drawing& drawing,
                std::vector<std::string>& names);

/// The rings of the polygons of a drawing, its circles and closed paths, as directed curves.
struct RegionCurves {
  std::vector<std::string> names;       ///< by curve
  std::vector<std::uint32_t> elements;  ///< by curve: which element it belongs to
  std::vector<bool> is_hole;            ///< by curve: a ring that is not the first of its polygon
  std::vector<FillRule> rules;          ///< by element: what its rings enclose
  std::vector<std::string> ignored;     ///< names of elements that enclose nothing: points and open paths
};
void add_regions(LinearFamily& family, PieceList<LinearFamily>& list, const Drawing& drawing, RegionCurves& curves);
void add_regions(CircularFamily& family, PieceList<CircularFamily>& list, const Drawing& drawing, RegionCurves& curves);

}  // namespace quoin
