// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <charconv>

#include "quoin/base/error.h"
#include "quoin/io/point_columns.h"
#include "quoin/io/point_readers.h"
#include "quoin/io/table_lines.h"
#include "quoin/io/text_lines.h"

namespace quoin::io {

namespace {

using Fields = std::vector<std::string_view>;

bool name_columns(const Fields& names) {
  const auto is_named = [&](PointField field) {
    return std::ranges::any_of(names, [&](std::string_view n) { return point_field_named(n) == field; });
  };
  return is_named(PointField::x) && is_named(PointField::y);
}

/// A line that holds one whole number only, as PTS has before its points.
std::optional<std::uint64_t> lone_count(std::string_view line) {
  std::uint64_t count = 0;
  const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), count);
  if (end != line.data() + line.size() || error == std::errc::invalid_argument) return std::nullopt;
  return error == std::errc() ? count : ~std::uint64_t{0};
}

class TableReader {
 public:
  TableReader(std::string_view bytes, const std::string& name, PointFormat format, bool weights, const Context& context)
      : size_(bytes.size()), name_(name), lines_(bytes, name), weights_(weights), context_(context) {
    file_.report.format = format;
  }

  PointFile run() {
    if (!lines_.next()) throw InputError(name_ + ": there are no points");
    take_count(true);
    separator_ = separator_of(lines_.text());
    lines_.split(separator_, fields_);
    const bool has_header = name_columns(fields_);
    if (separator_ == Separator::tab && !has_header && file_.report.format != PointFormat::csv) {
      separator_ = Separator::blank;  // of numbers alone, two tabs have nothing between them
      lines_.split(separator_, fields_);
    }
    begin_columns(has_header);
    if (has_header && !lines_.next()) throw InputError(name_ + ": there are no points");
    do {
      if (columns_->size() % 4096 == 0) context_.poll();
      if (take_count(false)) continue;
      lines_.split(separator_, fields_);
      read_row();
    } while (lines_.next());
    if (left_ > 0 && is_counted_)
      lines_.fail("the file ends where " + std::to_string(left_) + " more points should follow");
    columns_->finish(file_);
    return std::move(file_);
  }

 private:
  /// Whether the line says how many points follow, as the first line and then the one behind so many points may. After
  /// the first count goes to the line behind it.
  bool take_count(bool is_first) {
    if (!is_first && (!is_counted_ || left_ > 0)) return false;
    const std::optional<std::uint64_t> count = lone_count(lines_.text());
    if (!is_first && !count) lines_.fail("there are more points than the " + std::to_string(count_) + " announced");
    if (!count) {
      if (file_.report.format == PointFormat::pts)
        file_.report.warnings.emplace_back("no number of points stands before them");
      return false;
    }
    if (*count > size_) lines_.fail("a count of " + quoted(lines_.text()) + " does not fit the file's size");
    file_.report.format = PointFormat::pts;
    is_counted_ = true;
    count_ = left_ = *count;
    if (is_first && !lines_.next()) {
      if (count_ == 0) throw InputError(name_ + ": there are no points");
      lines_.fail("the file ends where " + std::to_string(left_) + " points should follow");
    }
    return true;
  }

  void begin_columns(bool has_header) {
    std::vector<PointField> kinds;
    Fields names = fields_;
    bool has_names = has_header;
    if (!has_header) {  // names may stand in a comment
      const Separator separator = separator_of(lines_.comment());
      TableLines comment(lines_.comment(), name_);
      if (comment.next() && lines_.comment().find('"') == std::string_view::npos) comment.split(separator, names);
      has_names = name_columns(names) && names.size() == fields_.size();
    }
    if (has_names) {
      for (const std::string_view n : names) kinds.push_back(point_field_named(n));
    } else {
      kinds = usual_fields(fields_.size(), weights_);
      if (fields_.size() < (weights_ ? 3U : 2U)) fail_first();
    }
    columns_.emplace(std::move(kinds), ColorScale::unknown, weights_);
    if (weights_ && !columns_->has(PointField::weight)) lines_.fail("there is no column of weights (w or weight)");
    has_header_ = has_header;
    warn(names, has_names);
    row_.resize(columns_->fields().size());
  }

  /// Of a line with too few columns.
  [[noreturn]] void fail_first() const {
    double value = 0;
    if (!fields_.empty() && !parse_number(fields_[0], value))
      lines_.fail(quoted(fields_[0]) + " is not a finite number, nor are there columns named x and y");
    lines_.fail(weights_ ? "coordinates and a weight should stand here" : "two or three coordinates should stand here");
  }

  void warn(const Fields& names, bool has_names) {
    std::string lost;
    std::size_t count = 0;
    for (std::size_t i = 0; i < columns_->fields().size(); ++i) {
      if (columns_->fields()[i] != PointField::other) continue;
      if (++count <= 5 && has_names) lost += " " + quoted(names[i]);
    }
    if (count == 0) return;
    file_.report.warnings.push_back(std::to_string(count) + " columns are not kept" + (has_names ? ":" + lost : "") +
                                    (has_names && count > 5 ? " ..." : ""));
  }

  void read_row() {
    if (fields_.size() == row_.size() + 1 && fields_.back().empty()) fields_.pop_back();
    if (fields_.size() != row_.size()) {
      lines_.fail(std::to_string(fields_.size()) + " columns, where the first line has " + std::to_string(row_.size()));
    }
    for (std::size_t i = 0; i < row_.size(); ++i) {
      // Under names other columns may hold anything.
      if (has_header_ && columns_->fields()[i] == PointField::other) continue;
      const bool is_needed = PointColumns::is_needed(columns_->fields()[i]);
      if (!(is_needed ? parse_number : parse_any_number)(fields_[i], row_[i])) fail_number(i, is_needed);
    }
    columns_->add(row_, {"line", lines_.number()});
    if (is_counted_) --left_;
  }

  [[noreturn]] void fail_number(std::size_t column, bool is_needed) const {
    const std::string place = "column " + std::to_string(column + 1);
    if (fields_[column].empty()) lines_.fail(place + " is empty");
    const bool is_first = columns_->size() == 0 && !has_header_;
    lines_.fail(quoted(fields_[column]) + " in " + place +
                (is_needed ? " is not a finite number" : " is not a number") +
                (is_first ? ", nor are there columns named x and y" : ""));
  }

  std::size_t size_;
  std::string name_;
  TableLines lines_;
  bool weights_;
  const Context& context_;
  PointFile file_;
  std::optional<PointColumns> columns_;
  Separator separator_ = Separator::blank;
  Fields fields_;
  std::vector<double> row_;
  bool has_header_ = false;
  bool is_counted_ = false;
  std::uint64_t count_ = 0;
  std::uint64_t left_ = 0;
};

}  // namespace

PointFile read_point_table(std::string_view bytes, const std::string& name, PointFormat format, bool weights,
                           const Context& context) {
  return TableReader(bytes, name, format, weights, context).run();
}

std::optional<PointFormat> table_format(std::string_view bytes) {
  TableLines lines(bytes, "");
  try {
    if (!lines.next()) return std::nullopt;
    if (lone_count(lines.text())) return PointFormat::pts;
    const Separator separator = separator_of(lines.text());
    std::vector<std::string_view> fields;
    lines.split(separator, fields);
    double value = 0;
    const bool has_numbers = fields.size() > 1 && parse_number(fields[0], value) && parse_number(fields[1], value);
    if (!has_numbers && !name_columns(fields)) return std::nullopt;
    const bool has_blanks = separator == Separator::blank || separator == Separator::tab;
    return has_numbers && has_blanks ? PointFormat::xyz : PointFormat::csv;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace quoin::io
