// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "quoin/io/point_file.h"

namespace quoin::io {

/// What a column of a point file may be. A triple is three columns without names, colours or normals by what they hold;
/// the second triple may be the other. A packed colour is an integer, red above green above blue, perhaps below alpha.
enum class PointField {
  x,
  y,
  z,
  nx,
  ny,
  nz,
  red,
  green,
  blue,
  alpha,
  packed,
  intensity,
  weight,
  triple,
  triple2,
  other
};

/// By the names that are usual, in any case and perhaps with a unit behind: x, nx or normal_x, red or r, intensity ...
PointField point_field_named(std::string_view name);

/// What columns without names are by their number, more than one: x y; x y z; and behind these an intensity, normals,
/// colours, normals and colours in either order, or an intensity and colours. If asked for, the last one is a weight.
std::vector<PointField> usual_fields(std::size_t columns, bool weights);

/// How colours are written.
enum class ColorScale { unknown, bytes };

/// Collects points column by column, and makes a file of them.
class PointColumns {
 public:
  PointColumns(std::vector<PointField> fields, ColorScale scale);

  int dimension() const { return has(PointField::z) ? 3 : 2; }
  std::size_t size() const { return points_.size(); }
  bool has(PointField field) const;
  std::span<const PointField> fields() const { return fields_; }
  /// Whether a number must be finite for its point to be one.
  static bool is_needed(PointField field) { return field <= PointField::z || field == PointField::weight; }
  /// Whether the column is read at all.
  static bool is_read(PointField field) { return field != PointField::other; }

  /// A value for each column. Those that are needed are finite; of the others, what is not finite is taken for zero.
  void add(std::span<const double> row);

  /// Moves everything to the file, with warnings about what is not kept.
  void finish(PointFile& file);

 private:
  using Triple = std::array<double, 3>;
  void finish_triples(std::vector<Triple>& triples, const char* where, PointFile& file);
  void finish_colors(const std::vector<Triple>& triples, PointFile& file);
  void finish_normals(const std::vector<Triple>& triples, PointFile& file);

  std::vector<PointField> fields_;
  ColorScale scale_;
  std::vector<Point3> points_;
  std::vector<Triple> normals_;
  std::vector<Triple> colors_;
  std::vector<double> alphas_;
  std::array<std::vector<Triple>, 2> triples_;
  std::vector<double> intensities_;
  std::vector<double> weights_;
  std::size_t not_finite_ = 0;
};

}  // namespace quoin::io
