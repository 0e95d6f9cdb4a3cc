// SPDX-License-Identifier: Apache-2.0
//
// Vertices of OBJ and OFF; what joins them to faces is passed over.
#include <algorithm>
#include <cmath>
#include <span>

#include "quoin/base/error.h"
#include "quoin/io/point_columns.h"
#include "quoin/io/point_readers.h"
#include "quoin/io/readers.h"
#include "quoin/io/text_lines.h"

namespace quoin::io {

namespace {

std::vector<PointField> with_colors(std::vector<PointField> fields, std::size_t channels) {
  using enum PointField;
  for (const PointField channel : {red, green, blue, alpha}) {
    if (channels-- == 0) break;
    fields.push_back(channel);
  }
  return fields;
}

/// x y z, then a weight, or three or four parts of a colour.
std::vector<PointField> fields_of_obj(std::size_t numbers, bool weights) {
  using enum PointField;
  std::vector<PointField> fields{x, y, z};
  if (numbers == 4) {
    fields.push_back(weights ? weight : other);
    return fields;
  }
  return with_colors(std::move(fields), numbers - 3);
}

/// Takes a point from the words of the line behind the first `before`.
void read_row(const TextLines& lines, std::size_t before, PointColumns& columns, std::span<double> row) {
  for (std::size_t k = 0; k < row.size(); ++k) {
    const std::string_view word = lines.words()[before + k];
    row[k] = PointColumns::is_needed(columns.fields()[k]) ? lines.number(word) : lines.any_number(word);
  }
  columns.add(row, {"line", lines.line()});
}

/// Normals of OBJ, which belong to the vertices in the same places where faces do not say otherwise.
class ObjNormals {
 public:
  void add(const TextLines& lines) {
    const auto& words = lines.words();
    if (words.size() != 4) lines.fail("a normal should have three coordinates");
    const auto part = [&](std::size_t k) {
      const double value = lines.any_number(words[k]);
      if (std::isfinite(value)) return value;
      not_finite_.note({"line", lines.line()});
      return 0.0;
    };
    normals_.push_back({part(1), part(2), part(3)});
  }
  /// A corner of a face, as 7/2/7.
  void meet(std::string_view corner) {
    const std::size_t second = corner.find('/');
    if (second == std::string_view::npos) return;
    const std::size_t third = corner.find('/', second + 1);
    if (third == std::string_view::npos || third + 1 == corner.size()) return;
    are_in_order_ = are_in_order_ && corner.substr(0, second) == corner.substr(third + 1);
  }
  void finish(PointFile& file) {
    if (normals_.empty()) return;
    if (are_in_order_ && normals_.size() == file.points.size()) {
      file.normals = std::move(normals_);
      not_finite_.warn("normals", file.report);
    } else {
      file.report.warnings.emplace_back("normals are not kept: they are not those of the vertices in the same places");
    }
  }

 private:
  std::vector<Vector3> normals_;
  NotFinite not_finite_;
  bool are_in_order_ = true;
};

}  // namespace

PointFile read_point_obj(std::string_view bytes, const std::string& name, bool weights, const Context& context) {
  TextLines lines(bytes, name, '#');
  lines.join_continued_lines();
  PointFile file;
  file.report.format = PointFormat::obj;
  std::optional<PointColumns> columns;
  std::vector<double> row;
  ObjNormals normals;
  bool has_weights = false;
  std::size_t statements = 0;
  while (lines.next()) {
    if (++statements % 4096 == 0) context.poll();
    const auto& words = lines.words();
    if (words[0] == "vn") {
      normals.add(lines);
      continue;
    }
    if (words[0] != "v") {
      for (std::size_t k = 1; words[0] == "f" && k < words.size(); ++k) normals.meet(words[k]);
      if (words[0] != "f" && words[0] != "fo" && !is_obj_statement(words[0]))
        lines.fail(quoted(words[0]) + " is no statement of an OBJ file");
      continue;
    }
    const std::size_t numbers = words.size() - 1;
    if (numbers < 3) lines.fail("a vertex has fewer than three coordinates");
    if (numbers == 5 || numbers > 7) lines.fail("a vertex of " + std::to_string(numbers) + " words");
    if (!columns) {
      if (weights && numbers != 4) lines.fail("the vertex has no weight");
      columns.emplace(fields_of_obj(numbers, weights), ColorScale::unknown, weights);
      row.resize(numbers);
    }
    if (numbers != row.size()) {
      lines.fail("a vertex of " + std::to_string(numbers) + " numbers, where the first has " +
                 std::to_string(row.size()));
    }
    read_row(lines, 1, *columns, row);
    has_weights = has_weights || (numbers == 4 && row[3] != 1);
  }
  if (columns) columns->finish(file);
  normals.finish(file);
  if (has_weights && !weights) file.report.warnings.emplace_back("weights of vertices are not kept");
  return file;
}

namespace {

class OffPoints {
 public:
  OffPoints(std::string_view bytes, const std::string& name, bool weights, const Context& context)
      : size_(bytes.size()), lines_(bytes, name, '#'), weights_(weights), context_(context) {
    file_.report.format = PointFormat::off;
  }

  PointFile run() {
    read_header();
    for (std::size_t i = 0; i < vertex_count_; ++i) read_vertex(i);
    if (columns_) columns_->finish(file_);
    for (std::size_t f = 0; f < face_count_; ++f) {
      if (f % 4096 == 0) context_.poll();
      lines_.need("face " + std::to_string(f));
    }
    if (lines_.next())
      file_.report.warnings.push_back("line " + std::to_string(lines_.line()) +
                                      ": what follows the last face is not kept");
    if (has_extra_) file_.report.warnings.emplace_back("what the vertex lines hold beyond what is known is not kept");
    return std::move(file_);
  }

 private:
  void read_header() {
    lines_.need("OFF and the counts");
    std::vector<std::string_view> counts = lines_.words();
    if (counts[0].ends_with("OFF")) {
      const std::string_view kind = counts[0].substr(0, counts[0].size() - 3);
      if (kind.find_first_not_of("STCN") != std::string_view::npos)
        lines_.fail(quoted(counts[0]) + " is not a kind of OFF with three coordinates");
      has_normals_ = kind.find('N') != std::string_view::npos;
      has_colors_ = kind.find('C') != std::string_view::npos;
      counts.erase(counts.begin());
      if (!counts.empty() && counts[0] == "BINARY") lines_.fail("binary OFF is not read");
      if (counts.empty()) {
        lines_.need("the counts of vertices, faces and edges");
        counts = lines_.words();
      }
    }
    if (counts.size() < 2) lines_.fail("the counts of vertices and faces should stand here");
    vertex_count_ = count(counts[0]);
    face_count_ = count(counts[1]);
  }

  std::size_t count(std::string_view word) const {
    const std::int64_t value = lines_.integer(word);
    if (value < 0 || static_cast<std::uint64_t>(value) > size_)
      lines_.fail("a count of " + std::string(word.substr(0, 30)) + " does not fit the file's size");
    return static_cast<std::size_t>(value);
  }

  void begin(std::size_t numbers) {
    using enum PointField;
    std::vector<PointField> fields{x, y, z};
    if (has_normals_) fields.insert(fields.end(), {nx, ny, nz});
    const std::size_t others = numbers - std::min(numbers, fields.size());
    if (has_colors_ && (others == 3 || others == 4)) fields = with_colors(std::move(fields), others);
    if (!has_colors_ && !has_normals_ && weights_ && others == 1) fields.push_back(weight);
    if (weights_ && fields.back() != weight) lines_.fail("a vertex should have three coordinates and a weight");
    has_extra_ = fields.size() < numbers;
    if (fields.size() > numbers) lines_.fail("the vertex has fewer numbers than its kind of OFF asks for");
    fields.resize(numbers, other);
    columns_.emplace(std::move(fields), ColorScale::unknown, weights_);
    row_.resize(numbers);
  }

  void read_vertex(std::size_t i) {
    if (i % 4096 == 0) context_.poll();
    lines_.need("vertex " + std::to_string(i));
    const auto& words = lines_.words();
    if (words.size() < 3) lines_.fail("vertex " + std::to_string(i) + " has fewer than three coordinates");
    if (!columns_) begin(words.size());
    if (words.size() != row_.size()) {
      lines_.fail("vertex " + std::to_string(i) + " has " + std::to_string(words.size()) +
                  " numbers, where the first has " + std::to_string(row_.size()));
    }
    read_row(lines_, 0, *columns_, row_);
  }

  std::size_t size_;
  TextLines lines_;
  bool weights_;
  const Context& context_;
  PointFile file_;
  std::optional<PointColumns> columns_;
  std::vector<double> row_;
  std::size_t vertex_count_ = 0;
  std::size_t face_count_ = 0;
  bool has_normals_ = false;
  bool has_colors_ = false;
  bool has_extra_ = false;
};

}  // namespace

PointFile read_point_off(std::string_view bytes, const std::string& name, bool weights, const Context& context) {
  return OffPoints(bytes, name, weights, context).run();
}

}  // namespace quoin::io
