// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "quoin/base/error.h"
#include "quoin/io/ply_values.h"
#include "quoin/io/point_columns.h"
#include "quoin/io/point_readers.h"

namespace quoin::io {

namespace {

class PlyPoints {
 public:
  PlyPoints(std::string_view bytes, const std::string& name, bool weights, const Context& context)
      : name_(name),
        layout_(read_ply_layout(bytes, name)),
        values_(bytes.substr(layout_.size), layout_, name),
        weights_(weights),
        context_(context) {
    file_.report.format = PointFormat::ply;
  }

  PointFile run() {
    bool has_vertices = false;
    for (const PlyElement& element : layout_.elements) {
      if (element.properties.empty()) continue;
      values_.require_room(element);
      if (element.name == "vertex" && !has_vertices) {
        has_vertices = true;
        read_vertices(element);
      } else {
        skip(element);
      }
    }
    if (!has_vertices) fail_header("there are no vertices");
    if (const auto place = values_.place_of_next())
      file_.report.warnings.push_back(*place + ": what follows the last element is not kept");
    return std::move(file_);
  }

 private:
  [[noreturn]] void fail_header(const std::string& what) const {
    throw InputError(name_ + ":" + std::to_string(layout_.lines) + ": " + what);
  }

  /// By property. Lists are not read.
  std::vector<PointField> fields_of(const PlyElement& element) const {
    std::vector<PointField> fields;
    for (const PlyProperty& p : element.properties)
      fields.push_back(p.count_type ? PointField::other : point_field_named(p.name));
    return fields;
  }

  static ColorScale scale_of(const PlyElement& element) {
    for (const PlyProperty& p : element.properties) {
      if (point_field_named(p.name) == PointField::red && p.type == PlyType::uint8) return ColorScale::bytes;
    }
    return ColorScale::unknown;
  }

  void read_vertices(const PlyElement& element) {
    PointColumns columns(fields_of(element), scale_of(element), weights_);
    if (!columns.has(PointField::x)) fail_header("the vertices have no x");
    if (!columns.has(PointField::y)) fail_header("the vertices have no y");
    if (weights_ && !columns.has(PointField::weight)) fail_header("the vertices have no w or weight");
    std::vector<double> row(element.properties.size());
    for (std::uint64_t i = 0; i < element.count; ++i) {
      if (i % 4096 == 0) context_.poll();
      read_ply_element(element, values_, [&](std::size_t p, std::size_t, double value) {
        row[p] = value;
        if (PointColumns::is_needed(columns.fields()[p]) && !std::isfinite(value))
          values_.fail("vertex " + std::to_string(i) + " has a '" + element.properties[p].name +
                       "' that is not finite");
      });
      columns.add(row, layout_.is_text() ? PointPlace{"line", values_.line()} : PointPlace{"vertex", i});
    }
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      if (columns.fields()[p] == PointField::other)
        file_.report.warnings.push_back("the vertex property " + quoted(std::string_view(element.properties[p].name)) +
                                        " is not kept");
    }
    columns.finish(file_);
  }

  void skip(const PlyElement& element) {
    for (std::uint64_t i = 0; i < element.count; ++i) {
      if (i % 4096 == 0) context_.poll();
      read_ply_element(element, values_, [](std::size_t, std::size_t, double) {});
    }
    if (element.name != "face")
      file_.report.warnings.push_back("the elements " + quoted(std::string_view(element.name)) + " are not kept");
  }

  std::string name_;
  PlyLayout layout_;
  PlyValues values_;
  bool weights_;
  const Context& context_;
  PointFile file_;
};

}  // namespace

PointFile read_point_ply(std::string_view bytes, const std::string& name, bool weights, const Context& context) {
  return PlyPoints(bytes, name, weights, context).run();
}

}  // namespace quoin::io
