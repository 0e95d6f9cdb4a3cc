// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/kernel/point.h"
#include "quoin/solid/mesh.h"

namespace quoin {

/// XYZ: columns separated by blanks; PTS: the same behind a line with their number; CSV: columns separated by commas,
/// semicolons or tabs, with names or without; PLY, OBJ, OFF: vertices of meshes; PCD: clouds of the Point Cloud
/// Library.
enum class PointFormat { xyz, pts, csv, ply, obj, off, pcd };

/// The format of that name, in any case, if there is one.
std::optional<PointFormat> point_format_named(std::string_view name);
std::string_view name_of(PointFormat format);

struct PointReadOptions {
  std::optional<PointFormat> format;  ///< else told by content, and where that says nothing by the ending
  bool weights =
      false;  ///< the last column, or the field `weight` or `w`, is a weight: two coordinates are of the plane
};

struct PointReport {
  PointFormat format = PointFormat::xyz;
  std::size_t points_in_file = 0;
  std::size_t missing = 0;            ///< of PCD: points that are not there, left out
  std::vector<std::string> warnings;  ///< what the file holds and this does not
};

/// Points with what files say of them.
struct PointFile {
  std::vector<Point3> points;       ///< finite, unit and order of the file; z is 0 in the plane
  int dimension = 3;                ///< how many coordinates the file has: 2 or 3
  std::vector<Vector3> normals;     ///< empty, or one per point, of the length they have in the file
  std::vector<Color> colors;        ///< empty, or one per point
  std::vector<double> intensities;  ///< empty, or one per point
  std::vector<double> weights;      ///< one per point if asked for
  PointReport report;
};

/// Reads points of the plane or of space: XYZ, PTS, CSV, PLY, OBJ, OFF, PCD (text, binary, compressed).
///
/// Coordinates are the nearest doubles of the file's decimals, or just its binary numbers. Further columns are kept
/// where they are normals, colours or intensities, by their names or by what they hold (docs/formats.md); what is not
/// kept is a warning, and so is what is 0 there because it is not finite in the file. Duplicates stay. O(file size); no
/// allocation is larger than a multiple of the file.
/// @throws FileError   the file cannot be opened or read, or is a directory
/// @throws InputError  the content is refused: no points, lines of different numbers of columns, coordinates or weights
///                     that are not finite, words that are no numbers, counts that do not fit, an early end; names the
///                     file and the line (text) or byte (binary)
/// @throws Cancelled
PointFile read_points(const std::filesystem::path& path, const PointReadOptions& options, const Context& context);

/// The same from bytes in memory; `name` stands for the file in messages, its ending is a hint.
PointFile read_points(std::string_view bytes, const std::string& name, const PointReadOptions& options,
                      const Context& context);

}  // namespace quoin
