// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/solid/brep.h"
#include "quoin/solid/overlay/kept_sheets.h"
#include "quoin/solid/overlay/sheets.h"

namespace quoin::overlay {

/// A point of the sheets of a composed face that none of its loops names: it lies inside the face.
struct InnerVertex {
  std::uint32_t face;  ///< of the composed ones
  PointId point;
};

/// The faces of a result before they are put together. A kept tile outside `is_in_composed` is a face of its own; the
/// others were merged to composed faces, or cut.
struct FaceParts {
  const Sheets* sheets;
  const CellComplex* complex;
  const KeptSheets* kept;
  /// Planes, loops and origins of the composed faces, in ascending order of their smallest sheet; points are those of
  /// the scene's table.
  Brep composed;
  std::vector<InnerVertex> inner_vertices;     ///< ascending by face
  std::vector<std::uint32_t> composed_sheets;  ///< the smallest sheet of each
  std::vector<std::uint8_t> is_in_composed;    ///< per sheet
  std::vector<std::uint32_t> shell_of_patch;   ///< or none
  std::uint32_t shell_count = 0;
};

/// Per point of the table, 1: a corner of a tile that is a face of its own.
std::vector<std::uint8_t> corners_of_tile_faces(const FaceParts& parts, const Context& context);

/// The boundary with its faces in the order of their smallest sheets, over the points that they name. Parts are written
/// in chunks of sheets to places counted before, so the bytes do not depend on threads. O(sheets).
/// `used` are the corners of tile faces.
Brep emit_boundary(const FaceParts& parts, std::vector<std::uint8_t> used, const Context& context);

}  // namespace quoin::overlay
