// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/solid/mesh.h"

namespace quoin {

enum class MeshFormat { off, obj, stl_text, stl_binary, ply_text, ply_binary_little, ply_binary_big, threemf };

/// The format that a file name's ending stands for (.off, .obj, .stl, .ply, .3mf, in any case; binary where there is a
/// choice), or nothing.
std::optional<MeshFormat> format_from_path(const std::filesystem::path& path);

/// Whether a format is written; 3MF is only read.
constexpr bool is_written(MeshFormat format) {
  return format != MeshFormat::threemf;
}

/// Whether a format holds single-precision coordinates only.
constexpr bool is_single_precision(MeshFormat format) {
  return format == MeshFormat::stl_binary;
}

/// Whether a format holds triangles only.
constexpr bool is_triangles_only(MeshFormat format) {
  return format == MeshFormat::stl_binary || format == MeshFormat::stl_text;
}

struct ReadOptions {
  bool weld = true;                      ///< one vertex for all of exactly equal coordinates
  std::optional<double> weld_tolerance;  ///< also for those within this distance (chains of such are one vertex)
};

struct ReadReport {
  MeshFormat format = MeshFormat::off;
  std::size_t vertices_in_file = 0;
  std::size_t welded = 0;             ///< vertices that became one with an earlier one
  double weld_displacement = 0;       ///< largest move of a coordinate by a tolerance
  std::vector<std::string> warnings;  ///< what the file holds and the mesh does not
};

/// Faces of a mesh that a file holds as one: from `first_face` to the next group's.
struct MeshGroup {
  std::string object;  ///< may be empty
  std::string group;   ///< may be empty
  std::size_t first_face = 0;
};

struct MeshFile {
  Mesh mesh;
  ReadReport report;
  /// Of OBJ: what its lines `o` and `g` tell; of 3MF: an object for each item of the build, a group for each mesh in
  /// it, unless there is just one mesh and it has no name. None where a file has none of them.
  std::vector<MeshGroup> groups;
};

/// Reads a mesh: OFF, OBJ, STL (text, binary), PLY (text, binary of both byte orders) or 3MF, told by content.
///
/// Polygons stay as they are. Coordinates are the nearest doubles of the decimals in the file; where a 3MF file moves
/// what it holds, the nearest doubles of the exact images, and a warning says how far they are. O(file size), for 3MF
/// of the size of what its build holds.
/// @throws FileError   the file cannot be opened or read, or is a directory
/// @throws InputError  the content is refused; the message names the file and line (text) or byte offset (binary)
MeshFile read_mesh(const std::filesystem::path& path, const ReadOptions& options, const Context& context);

/// The same from bytes in memory; `name` stands for the file in messages, its ending is a hint.
MeshFile read_mesh(std::string_view bytes, const std::string& name, const ReadOptions& options, const Context& context);

/// What is known of the vertices of a mesh over given points: each list is empty, or has one per vertex.
struct VertexData {
  std::vector<Vector3> normals;
  std::vector<Color> colors;
  std::vector<double> intensities;
  std::vector<double> weights;
};

struct WriteReport {
  std::size_t rounded_coordinates = 0;  ///< that the format could not hold
  double largest_rounding = 0;
  bool dropped_colors = false;                   ///< the mesh has colours of faces and the format has none
  std::vector<std::string> dropped_vertex_data;  ///< what is known of vertices and the format does not hold
};

/// Writes a mesh; text formats hold the shortest decimals that read back to the same doubles. PLY holds all data of
/// vertices, OBJ normals and colours.
/// @throws FileError   the file cannot be written
/// @throws InputError  the format cannot hold the mesh (polygons in STL, coordinates beyond single precision in
///                     binary STL), or is only read (3MF)
WriteReport write_mesh(const std::filesystem::path& path, MeshFormat format, const Mesh& mesh, const Context& context);
WriteReport write_mesh(std::ostream& out, MeshFormat format, const Mesh& mesh, const Context& context,
                       const VertexData& data = {});

/// The whole content of a file. @throws FileError
std::string read_file(const std::filesystem::path& path);

}  // namespace quoin
