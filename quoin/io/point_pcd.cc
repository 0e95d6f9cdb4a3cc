// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "quoin/base/error.h"
#include "quoin/io/lzf.h"
#include "quoin/io/pcd_layout.h"
#include "quoin/io/point_columns.h"
#include "quoin/io/point_readers.h"
#include "quoin/io/text_lines.h"

namespace quoin::io {

namespace {

template <class T>
double decode_as(const char* at) {  // the format has the least byte first
  std::array<char, sizeof(T)> bytes;
  std::memcpy(bytes.data(), at, sizeof(T));
  if constexpr (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
  return static_cast<double>(std::bit_cast<T>(bytes));
}

double decode(const PcdField& field, const char* at) {
  if (field.type == 'F') return field.size == 4 ? decode_as<float>(at) : decode_as<double>(at);
  const bool is_signed = field.type == 'I';
  if (field.size == 1) return is_signed ? decode_as<std::int8_t>(at) : decode_as<std::uint8_t>(at);
  if (field.size == 2) return is_signed ? decode_as<std::int16_t>(at) : decode_as<std::uint16_t>(at);
  if (field.size == 4) return is_signed ? decode_as<std::int32_t>(at) : decode_as<std::uint32_t>(at);
  return is_signed ? decode_as<std::int64_t>(at) : decode_as<std::uint64_t>(at);
}

class PcdReader {
 public:
  PcdReader(std::string_view bytes, const std::string& name, bool weights, const Context& context)
      : bytes_(bytes), name_(name), context_(context), layout_(read_pcd_layout(bytes, name)) {
    file_.report.format = PointFormat::pcd;
    make_columns(weights);
    if (layout_.has_viewpoint) file_.report.warnings.emplace_back("the viewpoint is not kept; points stay as they are");
  }

  PointFile run() {
    if (layout_.data == PcdLayout::Data::text) {
      read_text();
    } else if (layout_.data == PcdLayout::Data::binary) {
      read_binary();
    } else {
      read_compressed();
    }
    columns_->finish(file_);
    if (file_.report.missing > 0) {
      file_.report.warnings.push_back(std::to_string(file_.report.missing) +
                                      " points are missing (a coordinate is NaN) and left out");
    }
    return std::move(file_);
  }

 private:
  [[noreturn]] void fail_header(const std::string& what) const {
    throw InputError(name_ + ":" + std::to_string(layout_.lines) + ": " + what);
  }
  [[noreturn]] void fail_byte(std::size_t byte, const std::string& what) const {
    throw InputError(name_ + ": byte " + std::to_string(byte) + ": " + what);
  }

  void make_columns(bool weights) {
    std::vector<PointField> kinds;
    for (const PcdField& f : layout_.fields) {
      PointField kind = f.count == 1 ? point_field_named(f.name) : PointField::other;
      if (f.size == 4 && f.count == 1 && (f.name == "rgb" || f.name == "rgba")) kind = PointField::packed;
      kinds.push_back(kind);
    }
    columns_.emplace(kinds, ColorScale::bytes, weights);
    if (!columns_->has(PointField::x)) fail_header("the points have no x");
    if (!columns_->has(PointField::y)) fail_header("the points have no y");
    if (weights && !columns_->has(PointField::weight)) fail_header("the points have no w or weight");
    for (std::size_t i = 0; i < kinds.size(); ++i) {
      if (columns_->fields()[i] == PointField::other && layout_.fields[i].name != "_")
        file_.report.warnings.push_back("the field " + quoted(std::string_view(layout_.fields[i].name)) +
                                        " is not kept");
    }
    row_.resize(kinds.size());
  }

  bool is_packed_float(std::size_t i) const {
    return columns_->fields()[i] == PointField::packed && layout_.fields[i].type == 'F';
  }

  /// Of a number that carries a colour in its bits. One that is no float carries none.
  static double bits_of(double value) {
    if (!(std::fabs(value) <= std::numeric_limits<float>::max())) return std::numeric_limits<double>::quiet_NaN();
    return static_cast<double>(std::bit_cast<std::uint32_t>(static_cast<float>(value)));
  }

  template <class Fail>
  void add_row(const PointPlace& place, const Fail& fail) {
    bool is_missing = false;
    for (std::size_t i = 0; i < row_.size(); ++i) {
      if (!PointColumns::is_needed(columns_->fields()[i]) || std::isfinite(row_[i])) continue;
      if (!std::isnan(row_[i])) fail("'" + layout_.fields[i].name + "' is infinite");
      is_missing = true;
    }
    if (is_missing) {
      ++file_.report.missing;
    } else {
      columns_->add(row_, place);
    }
  }

  /// A coordinate may be NaN, where a point is missing.
  double text_value(const TextLines& lines, std::size_t f, std::size_t word) const {
    const double value = lines.any_number(lines.words()[word]);
    if (PointColumns::is_needed(columns_->fields()[f]) && std::isinf(value)) {
      lines.fail(quoted(lines.words()[word]) + " in column " + std::to_string(word + 1) + " is not finite");
    }
    return is_packed_float(f) ? bits_of(value) : value;
  }

  void read_text() {
    TextLines lines(bytes_.substr(layout_.size), name_, '#', layout_.lines);
    std::size_t words_of_point = 0;
    for (const PcdField& f : layout_.fields) words_of_point += f.count;
    for (std::uint64_t i = 0; i < layout_.points; ++i) {
      if (i % 4096 == 0) context_.poll();
      lines.need("point " + std::to_string(i) + " of " + std::to_string(layout_.points));
      const auto& words = lines.words();
      if (words.size() != words_of_point) {
        lines.fail(std::to_string(words.size()) + " numbers, where the fields are " + std::to_string(words_of_point));
      }
      std::size_t at = 0;
      for (std::size_t f = 0; f < row_.size(); ++f) {
        row_[f] = text_value(lines, f, at);
        at += layout_.fields[f].count;
      }
      add_row({"line", lines.line()}, [&](const std::string& what) { lines.fail(what); });
    }
    if (lines.next())
      file_.report.warnings.push_back("line " + std::to_string(lines.line()) +
                                      ": what follows the last point is not kept");
  }

  /// A number of a field. The bits of a colour may look like a NaN.
  double value_at(std::size_t f, const char* at) const {
    if (columns_->fields()[f] == PointField::packed) return decode_as<std::uint32_t>(at);
    return decode(layout_.fields[f], at);
  }

  void read_binary() {
    const std::string_view body = bytes_.substr(layout_.size);
    const std::size_t stride = layout_.point_size();
    if (layout_.points > body.size() / stride) {
      fail_byte(bytes_.size(), "the file ends within its points: " + std::to_string(layout_.points) + " of " +
                                   std::to_string(stride) + " bytes are announced");
    }
    for (std::uint64_t i = 0; i < layout_.points; ++i) {
      if (i % 4096 == 0) context_.poll();
      const std::size_t begin = i * stride;
      std::size_t at = begin;
      for (std::size_t f = 0; f < row_.size(); ++f) {
        row_[f] = value_at(f, body.data() + at);
        at += layout_.fields[f].bytes();
      }
      add_row({"point", i}, [&](const std::string& what) {
        fail_byte(layout_.size + begin, "point " + std::to_string(i) + ": " + what);
      });
    }
    warn_behind(layout_.size + layout_.points * stride);
  }

  void warn_behind(std::size_t end) {
    if (end < bytes_.size())
      file_.report.warnings.push_back("byte " + std::to_string(end) + ": what follows the last point is not kept");
  }

  std::uint32_t size_at(std::size_t byte) const {
    if (bytes_.size() < byte + 4) fail_byte(bytes_.size(), "the file ends before the sizes of its packed points");
    return static_cast<std::uint32_t>(decode_as<std::uint32_t>(bytes_.data() + byte));
  }

  /// Two sizes, then all numbers of the first field, all of the second ..., packed.
  void read_compressed() {
    const std::size_t packed_size = size_at(layout_.size);
    const std::size_t size = size_at(layout_.size + 4);
    const std::size_t begin = layout_.size + 8;
    if (packed_size > bytes_.size() - begin) fail_byte(bytes_.size(), "the file ends within its packed points");
    const std::size_t stride = layout_.point_size();
    if (layout_.points != size / stride || size % stride != 0) {
      fail_byte(layout_.size + 4, std::to_string(size) + " bytes of " + std::to_string(layout_.points) + " points of " +
                                      std::to_string(stride) + " bytes are announced");
    }
    const auto body = unpack_lzf(bytes_.substr(begin, packed_size), size, context_);
    if (!body) fail_byte(begin, "the packed points do not unpack to " + std::to_string(size) + " bytes");
    for (std::uint64_t i = 0; i < layout_.points; ++i) {
      if (i % 4096 == 0) context_.poll();
      std::size_t column = 0;
      for (std::size_t f = 0; f < row_.size(); ++f) {
        row_[f] = value_at(f, body->data() + column + i * layout_.fields[f].bytes());
        column += layout_.points * layout_.fields[f].bytes();
      }
      add_row({"point", i},
              [&](const std::string& what) { fail_byte(begin, "point " + std::to_string(i) + ": " + what); });
    }
    warn_behind(begin + packed_size);
  }

  std::string_view bytes_;
  std::string name_;
  const Context& context_;
  PcdLayout layout_;
  PointFile file_;
  std::optional<PointColumns> columns_;
  std::vector<double> row_;
};

}  // namespace

PointFile read_point_pcd(std::string_view bytes, const std::string& name, bool weights, const Context& context) {
  return PcdReader(bytes, name, weights, context).run();
}

bool begins_like_pcd(std::string_view bytes) {
  if (bytes.starts_with("# .PCD")) return true;
  while (bytes.starts_with('#')) bytes.remove_prefix(std::min(bytes.find('\n'), bytes.size() - 1) + 1);
  const std::string_view word = first_word(bytes);
  return word == "VERSION" || word == "FIELDS" || word == "COLUMNS";
}

}  // namespace quoin::io
