// SPDX-License-Identifier: Apache-2.0
//
// Readers of points return some that are finite, with as many normals, colours and so on or none, or refuse with an
// InputError; nothing else. What they return is the same when it is read from the plainest text.
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>

#include "fuzz/promise.h"
#include "fuzz/targets.h"
#include "quoin/base/error.h"
#include "quoin/io/point_file.h"

namespace quoin::fuzz {

namespace {

void append(std::string& text, double value) {
  std::array<char, 32> digits;
  text.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
}

std::string plain_text(const PointFile& file) {
  std::string text;
  for (const Point3& p : file.points) {
    append(text, p.x);
    append(text += ' ', p.y);
    if (file.dimension == 3) append(text += ' ', p.z);
    text += '\n';
  }
  return text;
}

bool fits(const PointFile& file, std::size_t size) {
  return size == 0 || size == file.points.size();
}

void check(const PointFile& file, const Context& context) {
  require(!file.points.empty(), "there are points");
  for (const Point3& p : file.points)
    require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z), "points are finite");
  for (const Vector3& n : file.normals)
    require(std::isfinite(n.x) && std::isfinite(n.y) && std::isfinite(n.z), "normals are finite");
  for (const double i : file.intensities) require(std::isfinite(i), "intensities are finite");
  require(fits(file, file.normals.size()) && fits(file, file.colors.size()) && fits(file, file.intensities.size()) &&
              fits(file, file.weights.size()),
          "each point has its normal, colour, intensity and weight, or none has");
  const PointFile again = quoin::read_points(plain_text(file), "again.xyz", {.format = PointFormat::xyz}, context);
  require(again.points == file.points && again.dimension == file.dimension, "points survive writing and reading");
}

}  // namespace

void read_points(std::span<const std::uint8_t> bytes) {
  const Context context({.threads = 1});
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  for (const bool weights : {false, true}) {
    for (const char* name : {"input", "input.csv"}) {
      std::optional<PointFile> file;
      try {
        file = quoin::read_points(text, name, {.format = {}, .weights = weights}, context);
      } catch (const InputError&) {
        continue;
      }
      check(*file, context);
    }
  }
}

}  // namespace quoin::fuzz
