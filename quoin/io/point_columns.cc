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

bool are_normals(std::span<const Triple> triples) {
  return std::ranges::all_of(triples, [](const Triple& t) {
    const double length = std::hypot(t[0], t[1], t[2]);
    return length == 0 || std::fabs(length - 1) < 0.01;
  });
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
  switch (others) {
    case 0:
    case 1:
    case 2:
      fields.resize(others);
      break;
    case 4:
      fields.push_back(intensity);
      break;
    case 6:
      fields.insert(fields.end(), 3, triple);
      break;
    case 7:
      fields.push_back(intensity);
      fields.insert(fields.end(), 3, triple);
      break;
    case 9:
      fields.insert(fields.end(), 3, triple);
      fields.insert(fields.end(), 3, triple2);
      break;
    default:
      fields.resize(others, other);
  }
  if (weights) fields.push_back(weight);
  return fields;
}

PointColumns::PointColumns(std::vector<PointField> fields, ColorScale scale)
    : fields_(std::move(fields)), scale_(scale) {
  // Parts of triples say nothing; of columns of one name the first counts.
  const auto drop = [&](std::initializer_list<PointField> list) {
    for (PointField& f : fields_) {
      if (std::ranges::find(list, f) != list.end()) f = PointField::other;
    }
  };
  using enum PointField;
  if (!has(nx) || !has(ny) || !has(nz)) drop({nx, ny, nz});
  if (!has(red) || !has(green) || !has(blue)) drop({red, green, blue, alpha});
  if (has(red)) drop({packed});
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    if (fields_[i] == triple || fields_[i] == triple2) continue;
    if (std::find(fields_.begin(), fields_.begin() + static_cast<std::ptrdiff_t>(i), fields_[i]) !=
        fields_.begin() + static_cast<std::ptrdiff_t>(i))
      fields_[i] = other;
  }
}

bool PointColumns::has(PointField field) const {
  return std::ranges::find(fields_, field) != fields_.end();
}

void PointColumns::add(std::span<const double> row) {
  using enum PointField;
  Point3 point;
  Triple normal{};
  Triple color{};
  std::array<Triple, 2> triples{};
  std::array<std::size_t, 2> filled{};
  double opacity = 255;
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    double value = row[i];
    const PointField field = fields_[i];
    if (field == other) continue;
    if (!std::isfinite(value)) {
      ++not_finite_;
      value = 0;
    }
    if (field <= z) {
      point[static_cast<std::size_t>(field)] = value;
    } else if (field <= nz) {
      normal[static_cast<std::size_t>(field) - static_cast<std::size_t>(nx)] = value;
    } else if (field <= blue) {
      color[static_cast<std::size_t>(field) - static_cast<std::size_t>(red)] = value;
    } else if (field == alpha) {
      opacity = value;
    } else if (field == packed) {
      const bool fits = value >= 0 && value <= 0xFFFFFFFFU;
      if (!fits) ++not_finite_;
      const auto bits = fits ? static_cast<std::uint32_t>(value) : 0U;
      color = {static_cast<double>(bits >> 16 & 255), static_cast<double>(bits >> 8 & 255),
               static_cast<double>(bits & 255)};
    } else if (field == intensity) {
      intensities_.push_back(value);
    } else if (field == weight) {
      weights_.push_back(value);
    } else {
      const std::size_t which = field == triple ? 0 : 1;
      triples[which][filled[which]++] = value;
    }
  }
  points_.push_back(point);
  if (has(nx)) normals_.push_back(normal);
  if (has(red) || has(packed)) colors_.push_back(color);
  if (has(alpha)) alphas_.push_back(opacity);
  for (std::size_t which = 0; which < 2; ++which) {
    if (filled[which] == 3) triples_[which].push_back(triples[which]);
  }
}

void PointColumns::finish_normals(const std::vector<Triple>& triples, PointFile& file) {
  for (const Triple& t : triples) file.normals.push_back({t[0], t[1], t[2]});
}

void PointColumns::finish_colors(const std::vector<Triple>& triples, PointFile& file) {
  const bool bytes = are_bytes(triples);
  const bool fractions = !(bytes && scale_ == ColorScale::bytes) && are_fractions(triples);
  if (!bytes && !fractions) {
    file.report.warnings.emplace_back("colours beyond 0 to 255 are not kept");
    return;
  }
  const double scale = fractions ? 255 : 1;
  bool is_rounded = false;
  for (std::size_t i = 0; i < triples.size(); ++i) {
    const Triple& t = triples[i];
    Color color{byte_of(t[0] * scale), byte_of(t[1] * scale), byte_of(t[2] * scale)};
    if (i < alphas_.size()) color.a = byte_of(alphas_[i] * scale);
    is_rounded = is_rounded || color.r / scale != t[0] || color.g / scale != t[1] || color.b / scale != t[2];
    file.colors.push_back(color);
  }
  if (is_rounded) file.report.warnings.emplace_back("colours given as fractions are rounded to 256 steps");
}

void PointColumns::finish_triples(std::vector<Triple>& triples, const char* where, PointFile& file) {
  if (triples.empty()) return;
  const bool has_color = std::ranges::any_of(
      triples, [](const Triple& t) { return std::ranges::any_of(t, [](double v) { return v > 1; }); });
  if (are_bytes(triples) && has_color && file.colors.empty()) {
    finish_colors(triples, file);
  } else if (are_normals(triples) && file.normals.empty()) {
    finish_normals(triples, file);
  } else {
    file.report.warnings.push_back(std::string("three columns ") + where +
                                   " are neither colours from 0 to 255 nor normals of length 1: not kept");
  }
  triples.clear();
}

void PointColumns::finish(PointFile& file) {
  file.dimension = dimension();
  file.points = std::move(points_);
  file.intensities = std::move(intensities_);
  file.weights = std::move(weights_);
  finish_normals(normals_, file);
  if (!colors_.empty()) finish_colors(colors_, file);
  finish_triples(triples_[0], "behind the coordinates", file);
  finish_triples(triples_[1], "at the end", file);
  if (not_finite_ > 0) {
    file.report.warnings.push_back(
        std::to_string(not_finite_) +
        " numbers of normals, colours or intensities are not finite or too large: taken for 0");
  }
}

}  // namespace quoin::io
