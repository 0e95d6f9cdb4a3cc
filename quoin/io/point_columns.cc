// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/point_columns.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace quoin::io {

namespace {

std::string plain_name(std::string_view name) {
  std::string plain;
  for (const char c : name.substr(0, 40)) plain += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return plain.substr(0, plain.find_first_of(" [("));  // a unit
}

using Triple = std::array<double, 3>;

bool is_byte(double value) {
  return value >= 0 && value <= 255 && value == std::floor(value);
}

bool are_bytes(std::span<const Triple> triples) {
  return std::ranges::all_of(triples, [](const Triple& t) { return std::ranges::all_of(t, is_byte); });
}

bool are_fractions(std::span<const Triple> triples) {
  return std::ranges::all_of(
      triples, [](const Triple& t) { return std::ranges::all_of(t, [](double v) { return v >= 0 && v <= 1; }); });
}

Triple unpacked(double value) {
  const auto bits = static_cast<std::uint32_t>(value);
  return {static_cast<double>(bits >> 16 & 255), static_cast<double>(bits >> 8 & 255), static_cast<double>(bits & 255)};
}

std::uint8_t byte_of(double value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
}

}  // namespace

PointField point_field_named(std::string_view name) {
  struct Name {
    std::string_view text;
    PointField field;
  };
  using enum PointField;
  static constexpr Name names[] = {{"x", x},
                                   {"y", y},
                                   {"z", z},
                                   {"points:0", x},
                                   {"points:1", y},
                                   {"points:2", z},
                                   {"points_0", x},
                                   {"points_1", y},
                                   {"points_2", z},
                                   {"nx", nx},
                                   {"ny", ny},
                                   {"nz", nz},
                                   {"normal_x", nx},
                                   {"normal_y", ny},
                                   {"normal_z", nz},
                                   {"normalx", nx},
                                   {"normaly", ny},
                                   {"normalz", nz},
                                   {"normals:0", nx},
                                   {"normals:1", ny},
                                   {"normals:2", nz},
                                   {"normals_0", nx},
                                   {"normals_1", ny},
                                   {"normals_2", nz},
                                   {"r", red},
                                   {"g", green},
                                   {"b", blue},
                                   {"a", alpha},
                                   {"red", red},
                                   {"green", green},
                                   {"blue", blue},
                                   {"alpha", alpha},
                                   {"diffuse_red", red},
                                   {"diffuse_green", green},
                                   {"diffuse_blue", blue},
                                   {"i", intensity},
                                   {"intensity", intensity},
                                   {"scalar_intensity", intensity},
                                   {"w", weight},
                                   {"weight", weight}};
  const std::string plain = plain_name(name);
  const auto found = std::find_if(std::begin(names), std::end(names), [&](const Name& n) { return n.text == plain; });
  return found == std::end(names) ? other : found->field;
}

std::vector<PointField> usual_fields(std::size_t columns, bool weights) {
  using enum PointField;
  std::vector<PointField> fields{x, y, z};
  const std::size_t others = columns - (weights ? 1 : 0);
  fields.resize(others, others > 3 && are_usual(others - 3) ? unnamed : other);
  if (weights) fields.push_back(weight);
  return fields;
}

void NotFinite::add(const NotFinite& other) {
  if (count_ == 0 || (other.count_ > 0 && other.first_.number < first_.number)) first_ = other.first_;
  count_ += other.count_;
}

void NotFinite::warn(const std::string& what, PointReport& report) const {
  if (count_ == 0) return;
  report.warnings.push_back(std::to_string(count_) + " numbers of " + what +
                            " are not finite or too large, the first at " + first_.unit + " " +
                            std::to_string(first_.number) + ": taken for 0");
}

PointColumns::PointColumns(std::vector<PointField> fields, ColorScale scale, bool weights)
    : fields_(std::move(fields)), scale_(scale), not_finite_(fields_.size()) {
  // Parts of triples say nothing; of columns of one name the first counts.
  using enum PointField;
  if (!weights) drop({weight});
  if (!has(nx) || !has(ny) || !has(nz)) drop({nx, ny, nz});
  if (!has(red) || !has(green) || !has(blue)) drop({red, green, blue, alpha});
  if (has(red)) drop({packed});
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    if (fields_[i] == unnamed) continue;
    if (std::find(fields_.begin(), fields_.begin() + static_cast<std::ptrdiff_t>(i), fields_[i]) !=
        fields_.begin() + static_cast<std::ptrdiff_t>(i))
      fields_[i] = other;
  }
}

void PointColumns::drop(std::initializer_list<PointField> list) {
  for (PointField& f : fields_) {
    if (std::ranges::find(list, f) != list.end()) f = PointField::other;
  }
}

bool PointColumns::has(PointField field) const {
  return std::ranges::find(fields_, field) != fields_.end();
}

void PointColumns::add(std::span<const double> row, const PointPlace& place) {
  using enum PointField;
  Point3 point;
  Triple normal{};
  Triple color{};
  double opacity = 255;
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    const PointField field = fields_[i];
    if (field == other) continue;
    const bool fits = field == packed ? row[i] >= 0 && row[i] <= 0xFFFFFFFFU : std::isfinite(row[i]);
    if (!fits) not_finite_[i].note(place);
    const double value = fits ? row[i] : 0;
    if (field <= z) {
      point[static_cast<std::size_t>(field)] = value;
    } else if (field <= nz) {
      normal[static_cast<std::size_t>(field) - static_cast<std::size_t>(nx)] = value;
    } else if (field <= blue) {
      color[static_cast<std::size_t>(field) - static_cast<std::size_t>(red)] = value;
    } else if (field == alpha) {
      opacity = value;
    } else if (field == packed) {
      color = unpacked(value);
    } else if (field == intensity) {
      intensities_.push_back(value);
    } else if (field == weight) {
      weights_.push_back(value);
    } else {
      unnamed_.push_back(row[i]);
    }
  }
  points_.push_back(point);
  if (has(nx)) normals_.push_back({normal[0], normal[1], normal[2]});
  if (has(red) || has(packed)) colors_.push_back(color);
  if (has(alpha)) alphas_.push_back(opacity);
}

void PointColumns::tell_unnamed(PointReport& report) {
  const auto columns = static_cast<std::size_t>(std::ranges::count(fields_, PointField::unnamed));
  if (columns == 0) return;
  const auto before = static_cast<std::size_t>(std::ranges::find(fields_, PointField::unnamed) - fields_.begin());
  const UsualColumns told = usual_columns(unnamed_, columns);
  if (!told.instead.empty() && !(report.format == PointFormat::pts && told.parts[0].size() == 1)) {
    report.warnings.push_back("columns without names are taken for " + described(told.parts, before) +
                              ", but could be " + described(told.instead, before) + "; names in the first line tell");
  }
  for (const ColumnPart& part : told.parts) {
    take_part(part, before, columns);
    if (part.kind == ColumnPart::Kind::unknown) {
      report.warnings.push_back("columns " + std::to_string(before + part.first + 1) + " to " +
                                std::to_string(before + part.first + 3) +
                                " are no colours from 0 to 255 and no normals of length 1, or a second time: not kept");
    }
  }
  unnamed_ = {};
}

/// Of the columns without names, `before` which others stand.
void PointColumns::take_part(const ColumnPart& part, std::size_t before, std::size_t columns) {
  using enum PointField;
  static constexpr PointField fields[][3] = {{intensity}, {red, green, blue}, {nx, ny, nz}, {other, other, other}};
  std::copy_n(fields[static_cast<std::size_t>(part.kind)], part.size(),
              fields_.begin() + static_cast<std::ptrdiff_t>(before + part.first));
  for (std::size_t row = part.first; row < unnamed_.size(); row += columns) {
    const auto value = [&](std::size_t k) { return std::isfinite(unnamed_[row + k]) ? unnamed_[row + k] : 0; };
    if (part.kind == ColumnPart::Kind::intensity) {
      intensities_.push_back(value(0));
    } else if (part.kind == ColumnPart::Kind::colors) {
      colors_.push_back({value(0), value(1), value(2)});
    } else if (part.kind == ColumnPart::Kind::normals) {
      normals_.push_back({value(0), value(1), value(2)});
    }
  }
}

void PointColumns::finish_colors(PointFile& file) {
  const bool bytes = are_bytes(colors_);
  const bool fractions = !(bytes && scale_ == ColorScale::bytes) && are_fractions(colors_);
  if (!bytes && !fractions) {
    file.report.warnings.emplace_back("colours beyond 0 to 255 are not kept");
    using enum PointField;
    drop({red, green, blue, alpha, packed});
    return;
  }
  const double scale = fractions ? 255 : 1;
  bool is_rounded = false;
  for (std::size_t i = 0; i < colors_.size(); ++i) {
    const Triple& t = colors_[i];
    Color color{byte_of(t[0] * scale), byte_of(t[1] * scale), byte_of(t[2] * scale)};
    if (i < alphas_.size()) color.a = byte_of(alphas_[i] * scale);
    is_rounded = is_rounded || color.r / scale != t[0] || color.g / scale != t[1] || color.b / scale != t[2];
    file.colors.push_back(color);
  }
  if (is_rounded) file.report.warnings.emplace_back("colours given as fractions are rounded to 256 steps");
}

void PointColumns::warn_not_finite(PointReport& report) const {
  NotFinite all;
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    if (fields_[i] != PointField::other) all.add(not_finite_[i]);
  }
  all.warn("normals, colours or intensities", report);
}

void PointColumns::finish(PointFile& file) {
  tell_unnamed(file.report);
  file.dimension = dimension();
  file.points = std::move(points_);
  file.intensities = std::move(intensities_);
  file.weights = std::move(weights_);
  file.normals = std::move(normals_);
  if (!colors_.empty()) finish_colors(file);
  warn_not_finite(file.report);
}

}  // namespace quoin::io
