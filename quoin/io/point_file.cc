// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/point_file.h"

#include <algorithm>
#include <array>
#include <utility>

#include "quoin/base/error.h"
#include "quoin/io/mesh_file.h"
#include "quoin/io/point_readers.h"
#include "quoin/io/text_lines.h"

namespace quoin {

namespace {

using enum PointFormat;
constexpr std::array<std::pair<std::string_view, PointFormat>, 7> names{
    {{"xyz", xyz}, {"pts", pts}, {"csv", csv}, {"ply", ply}, {"obj", obj}, {"off", off}, {"pcd", pcd}}};

std::optional<PointFormat> format_of_ending(const std::string& name) {
  const std::string ending = std::filesystem::path(name).extension().string();
  if (ending.empty()) return std::nullopt;
  for (const std::string_view other : {".txt", ".asc", ".xyzn", ".xyzrgb", ".xyzc"}) {
    if (io::is_word(ending, other)) return xyz;
  }
  if (io::is_word(ending, ".tsv")) return csv;
  return point_format_named(std::string_view(ending).substr(1));
}

/// Formats that begin with something of their own.
std::optional<PointFormat> format_of_beginning(std::string_view bytes, const std::string& name) {
  const std::string_view word = io::first_word(bytes);
  if (word == "ply") return ply;
  if (word.ends_with("OFF") && word.size() <= 7) return off;
  if (io::begins_like_pcd(bytes)) return pcd;
  static constexpr std::pair<std::string_view, const char*> others[] = {
      {"LASF", "LAS"}, {"ASTM-E57", "E57"}, {"PK\x03\x04", "a ZIP archive"}, {"\x1F\x8B", "a packed file (gzip)"}};
  for (const auto& [begin, what] : others) {
    if (bytes.starts_with(begin))
      throw InputError(name + ": " + what + " is not read (points: XYZ, PTS, CSV, PLY, OBJ, OFF, PCD)");
  }
  return std::nullopt;
}

bool begins_like_obj(std::string_view bytes) {
  io::TextLines lines(bytes, "", '#');
  if (!lines.next()) return false;
  const std::string_view word = lines.words()[0];
  return std::ranges::any_of(std::array<std::string_view, 7>{"v", "vn", "vt", "o", "g", "mtllib", "usemtl"},
                             [&](std::string_view statement) { return word == statement; });
}

PointFormat format_of(std::string_view bytes, const std::string& name, const PointReadOptions& options) {
  if (options.format) return *options.format;
  if (const auto format = format_of_beginning(bytes, name)) return *format;
  const auto ending = format_of_ending(name);
  const bool is_table = ending == xyz || ending == csv || ending == pts;
  if (ending && !is_table) return *ending;
  if (!ending && begins_like_obj(bytes)) return obj;
  if (const auto table = io::table_format(bytes)) return is_table && *table != pts ? *ending : *table;
  if (ending) return *ending;
  throw InputError(name +
                   ": neither the content nor the ending tells a format that is read (XYZ, PTS, CSV, PLY, OBJ, OFF, "
                   "PCD)");
}

PointFile read_as(PointFormat format, std::string_view bytes, const std::string& name, bool weights,
                  const Context& context) {
  switch (format) {
    case ply:
      return io::read_point_ply(bytes, name, weights, context);
    case obj:
      return io::read_point_obj(bytes, name, weights, context);
    case off:
      return io::read_point_off(bytes, name, weights, context);
    case pcd:
      return io::read_point_pcd(bytes, name, weights, context);
    default:
      return io::read_point_table(bytes, name, format, weights, context);
  }
}

}  // namespace

std::optional<PointFormat> point_format_named(std::string_view name) {
  const auto found = std::ranges::find_if(names, [&](const auto& entry) { return io::is_word(name, entry.first); });
  return found == names.end() ? std::nullopt : std::optional(found->second);
}

std::string_view name_of(PointFormat format) {
  return names[static_cast<std::size_t>(format)].first;
}

PointFile read_points(std::string_view bytes, const std::string& name, const PointReadOptions& options,
                      const Context& context) {
  context.progress("reading", 0);
  if (bytes.empty()) throw InputError(name + ": the file is empty");
  PointFile file = read_as(format_of(bytes, name, options), bytes, name, options.weights, context);
  file.report.points_in_file = file.points.size() + file.report.missing;
  if (file.points.empty()) {
    throw InputError(name + ": there are no points" +
                     (file.report.missing > 0
                          ? " but " + std::to_string(file.report.missing) + " that are missing (a coordinate is NaN)"
                          : ""));
  }
  return file;
}

PointFile read_points(const std::filesystem::path& path, const PointReadOptions& options, const Context& context) {
  return read_points(read_file(path), path.string(), options, context);
}

}  // namespace quoin
