// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "quoin/io/point_file.h"
#include "quoin/io/usual_columns.h"

namespace quoin::io {

/// What a column of a point file may be. What columns without names are is told by what they hold (usual_columns.h). A
/// packed colour is an integer, red above green above blue, perhaps below alpha.
enum class PointField { x, y, z, nx, ny, nz, red, green, blue, alpha, packed, intensity, weight, unnamed, other };

/// By the names that are usual, in any case and perhaps with a unit behind: x, nx or normal_x, red or r, intensity ...
PointField point_field_named(std::string_view name);

/// What columns without names are by their number, more than one: x y; x y z; and behind these what is usual. If asked
/// for, the last one is a weight.
std::vector<PointField> usual_fields(std::size_t columns, bool weights);

/// How colours are written.
enum class ColorScale { unknown, bytes };

/// Where a point stands in its file: line 7, or point 3 of a binary one.
struct PointPlace {
  const char* unit;
  std::uint64_t number;
};

/// Numbers that are kept as 0 because they are not finite, or too large for what they are.
class NotFinite {
 public:
  void note(const PointPlace& place) {
    if (count_++ == 0) first_ = place;
  }
  void add(const NotFinite& other);
  /// Says how many `what` holds and where the first is, if there are any.
  void warn(const std::string& what, PointReport& report) const;

 private:
  std::size_t count_ = 0;
  PointPlace first_{};
};

/// Collects points column by column, and makes a file of them.
class PointColumns {
 public:
  /// Weights are read only if asked for.
  PointColumns(std::vector<PointField> fields, ColorScale scale, bool weights);

  int dimension() const { return has(PointField::z) ? 3 : 2; }
  std::size_t size() const { return points_.size(); }
  bool has(PointField field) const;
  std::span<const PointField> fields() const { return fields_; }
  /// Whether a number must be finite for its point to be one.
  static bool is_needed(PointField field) { return field <= PointField::z || field == PointField::weight; }

  /// A value for each column. Those that are needed are finite; of the others, what is not finite is taken for zero.
  void add(std::span<const double> row, const PointPlace& place);

  /// Moves everything to the file, with warnings about what is not kept.
  void finish(PointFile& file);

 private:
  using Triple = std::array<double, 3>;
  void drop(std::initializer_list<PointField> list);
  void tell_unnamed(PointReport& report);
  void take_part(const ColumnPart& part, std::size_t before, std::size_t columns);
  void finish_colors(PointFile& file);
  void warn_not_finite(PointReport& report) const;

  std::vector<PointField> fields_;
  ColorScale scale_;
  std::vector<Point3> points_;
  std::vector<Vector3> normals_;
  std::vector<Triple> colors_;
  std::vector<double> alphas_;
  std::vector<double> unnamed_;  ///< row by row, not finite where the file's are
  std::vector<double> intensities_;
  std::vector<double> weights_;
  std::vector<NotFinite> not_finite_;  ///< by column
};

}  // namespace quoin::io
