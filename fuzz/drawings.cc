// SPDX-License-Identifier: Apache-2.0
//
// Readers of drawings return one that every format either refuses or holds, in text that can be read again, or refuse
// with an InputError; nothing else. What is written without notes comes back the same.
#include <array>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>

#include "fuzz/promise.h"
#include "fuzz/targets.h"
#include "quoin/base/error.h"
#include "quoin/io/drawing.h"

namespace quoin::fuzz {

namespace {

constexpr std::array formats = {DrawingFormat::wkt, DrawingFormat::geojson, DrawingFormat::svg, DrawingFormat::dxf};

DrawingReadOptions as(DrawingFormat format) {
  DrawingReadOptions options;
  options.format = format;
  return options;
}

bool same_shapes(const Drawing& a, const Drawing& b) {
  if (a.elements.size() != b.elements.size()) return false;
  for (std::size_t i = 0; i < a.elements.size(); ++i) {
    if (a.elements[i].shape != b.elements[i].shape || a.elements[i].layer != b.elements[i].layer) return false;
  }
  return true;
}

void write_and_read(const Drawing& drawing, DrawingFormat format, const Context& context) {
  std::ostringstream out;
  std::vector<std::string> notes;
  try {
    notes = write_drawing(out, format, drawing, {}, context);
  } catch (const InputError&) {
    return;
  }
  // A file without elements is no WKT.
  if (format == DrawingFormat::wkt && drawing.elements.empty()) return;
  std::optional<Drawing> again;
  try {
    again = read_drawing(out.str(), "again", as(format), context);
  } catch (const InputError& error) {
    require(false, "what is written can be read: " + std::string(error.what()) + "\n" + out.str());
  }
  require(!notes.empty() || same_shapes(drawing, *again), "what is written without notes comes back:\n" + out.str());
}

void read(std::span<const std::uint8_t> bytes, DrawingFormat format, bool closed_paths_are_polygons) {
  const Context context({.threads = 1});
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  DrawingReadOptions options = as(format);
  options.closed_paths_are_polygons = closed_paths_are_polygons;
  std::optional<Drawing> drawing;
  try {
    drawing = read_drawing(text, "input", options, context);
  } catch (const InputError&) {
    return;
  }
  for (const DrawingFormat other : formats) write_and_read(*drawing, other, context);
  try {
    check_drawing(*drawing);
  } catch (const InputError&) {
  }
}

}  // namespace

void read_wkt(std::span<const std::uint8_t> bytes) {
  read(bytes, DrawingFormat::wkt, true);
}
void read_geojson(std::span<const std::uint8_t> bytes) {
  read(bytes, DrawingFormat::geojson, true);
}
void read_svg(std::span<const std::uint8_t> bytes) {
  read(bytes, DrawingFormat::svg, true);
  read(bytes, DrawingFormat::svg, false);
}
void read_dxf(std::span<const std::uint8_t> bytes) {
  read(bytes, DrawingFormat::dxf, true);
  read(bytes, DrawingFormat::dxf, false);
}

}  // namespace quoin::fuzz
