// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/usual_columns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace quoin::io {

namespace {

using Kind = ColumnPart::Kind;

bool is_byte(double value) {
  return value >= 0 && value <= 255 && value == std::floor(value);
}

/// Kinds of triples, by the column that they begin with.
class Triples {
 public:
  Triples(std::span<const double> values, std::size_t columns) : values_(values), columns_(columns) {}

  Kind kind_at(std::size_t first) {
    std::optional<Kind>& kind = kinds_[first];
    if (!kind) kind = tell(first);
    return *kind;
  }

 private:
  Kind tell(std::size_t first) const {
    bool are_bytes = true;
    bool has_color = false;  // zeros and ones may be normals
    bool are_normals = true;
    bool is_any_finite = false;
    for (std::size_t row = first; row < values_.size(); row += columns_) {
      const std::span<const double> t = values_.subspan(row, 3);
      if (!std::ranges::all_of(t, [](double v) { return std::isfinite(v); })) continue;
      is_any_finite = true;
      are_bytes = are_bytes && std::ranges::all_of(t, is_byte);
      has_color = has_color || std::ranges::any_of(t, [](double v) { return v > 1; });
      const double length = std::hypot(t[0], t[1], t[2]);
      are_normals = are_normals && (length == 0 || std::fabs(length - 1) < 0.01);
      if (!are_bytes && !are_normals) return Kind::unknown;
    }
    if (are_bytes && has_color) return Kind::colors;
    return are_normals && is_any_finite ? Kind::normals : Kind::unknown;
  }

  std::span<const double> values_;
  std::size_t columns_;
  std::array<std::optional<Kind>, 7> kinds_{};
};

/// Triples of the columns, and if their number asks for it an intensity behind the first `triples` of them.
std::vector<ColumnPart> parts_of(std::size_t columns, std::size_t triples, Triples& kinds) {
  std::vector<ColumnPart> parts;
  for (std::size_t at = 0; at < columns; at += parts.back().size()) {
    const bool is_intensity = columns % 3 == 1 && at == 3 * triples;
    Kind kind = is_intensity ? Kind::intensity : kinds.kind_at(at);
    if (std::ranges::any_of(parts, [&](const ColumnPart& p) { return p.kind == kind; })) kind = Kind::unknown;
    parts.push_back({kind, at});
  }
  return parts;
}

}  // namespace

bool are_usual(std::size_t columns) {
  return columns == 1 || columns == 3 || columns == 4 || columns == 6 || columns == 7;
}

UsualColumns usual_columns(std::span<const double> values, std::size_t columns) {
  Triples kinds(values, columns);
  UsualColumns result{parts_of(columns, 0, kinds), {}};
  const auto unknown = [](const std::vector<ColumnPart>& parts) {
    return std::ranges::count(parts, Kind::unknown, &ColumnPart::kind);
  };
  for (std::size_t triples = 1; columns % 3 == 1 && triples <= columns / 3; ++triples) {
    std::vector<ColumnPart> other = parts_of(columns, triples, kinds);
    if (unknown(other) < unknown(result.parts)) {
      result = {std::move(other), {}};
    } else if (unknown(other) == unknown(result.parts) && result.instead.empty()) {
      result.instead = std::move(other);
    }
  }
  return result;
}

std::string described(std::span<const ColumnPart> parts, std::size_t before) {
  std::string text;
  for (const ColumnPart& p : parts) {
    static constexpr const char* names[] = {"an intensity", "colours", "normals", "of no known kind"};
    const std::size_t first = before + p.first + 1;
    text += (text.empty() ? "" : ", ") + std::string(names[static_cast<std::size_t>(p.kind)]) + " (" +
            std::to_string(first) + (p.size() > 1 ? " to " + std::to_string(first + 2) : "") + ")";
  }
  return text;
}

}  // namespace quoin::io
