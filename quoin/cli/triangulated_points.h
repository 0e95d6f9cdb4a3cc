// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/cli/cell_outputs.h"
#include "quoin/io/point_file.h"
#include "quoin/io/vtk_grid.h"

namespace quoin::cli {

/// A triangulation of points of the plane or of space, whichever made it.
struct TriangulatedPoints {
  int dimension = 0;                     ///< of the affine hull
  std::size_t distinct = 0;              ///< places with points
  std::size_t vertices = 0;              ///< fewer where weights hide points
  std::size_t cells = 0;                 ///< simplices of that dimension
  std::size_t delone = 0;                ///< Delone cells
  std::size_t hull_vertices = 0;         ///< on the boundary of the hull
  std::size_t hull_simplices = 0;        ///< that make this boundary
  std::size_t largest_multiplicity = 1;  ///< most points at one vertex
  std::size_t hidden = 0;                ///< given points that are no vertices
  std::size_t heights_lost = 0;          ///< points at a vertex of the plane with another z than its first

  // Of those that are to be written.
  std::vector<std::uint32_t> first_input;               ///< by vertex
  std::vector<std::uint32_t> multiplicity;              ///< by vertex
  std::vector<std::array<std::uint32_t, 4>> simplices;  ///< dimension + 1 vertices
  std::vector<std::uint32_t> delone_of;                 ///< by simplex
  ExactCells delone_faces;                              ///< see delone_faces.h; if asked for
  std::vector<std::array<std::uint32_t, 3>> hull;       ///< of dimension 3, counterclockwise from outside
};

struct TriangulateOptions {
  bool of_plane = false;
  bool check = false;       ///< prove it, if there are no weights
  bool is_written = false;  ///< with what outputs hold
  bool delone = false;      ///< which are Delone cells, not simplices; without weights
};

/// By Delaunay2, Delaunay3, Regular2 or Regular3.
/// @throws InternalError  the check found something; and what those throw
TriangulatedPoints triangulate(const PointFile& file, const TriangulateOptions& options, const Context& context);

/// About the most memory that it takes at a time, with what outputs take, in bytes.
std::uint64_t memory_to_triangulate(std::size_t points, const TriangulateOptions& options, bool weighted);

/// All cells, simplices or Delone cells, with numbers of inputs, multiplicities and Delone cells, and normals and
/// colours of the points.
VtkGrid grid_of(const TriangulatedPoints& triangulated, const PointFile& file);

/// The triangles of the hull, or its Delone facets, with its vertices, or all cells of dimension 2 with all vertices.
/// Nothing of lower dimension.
CellMesh mesh_of(const TriangulatedPoints& triangulated, const PointFile& file);

}  // namespace quoin::cli
