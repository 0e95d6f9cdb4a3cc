// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iomanip>
#include <sstream>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace quoin::testing {

template <class T>
void append_bytes(std::string& bytes, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  bytes.append(raw, sizeof(T));
}

/// Packs with copies of the nearest earlier match, found by trying all.
inline std::string pack_lzf(std::string_view bytes) {
  std::string packed;
  std::string literals;
  const auto flush = [&] {
    for (std::size_t i = 0; i < literals.size(); i += 32) {
      const std::string_view run = std::string_view(literals).substr(i, 32);
      packed += static_cast<char>(run.size() - 1);
      packed += run;
    }
    literals.clear();
  };
  for (std::size_t at = 0; at < bytes.size();) {
    std::size_t best = 0;
    std::size_t back = 0;
    for (std::size_t b = 1; b <= at && b <= 8192 && best < 264; ++b) {
      std::size_t length = 0;
      while (length < 264 && at + length < bytes.size() && bytes[at + length] == bytes[at - b + length]) ++length;
      if (length > best) std::tie(best, back) = std::pair(length, b);
    }
    if (best < 3) {
      literals += bytes[at++];
      continue;
    }
    flush();
    const std::size_t length = best - 2;
    packed += static_cast<char>((length < 7 ? length << 5 : 7 << 5) | ((back - 1) >> 8));
    if (length >= 7) packed += static_cast<char>(length - 7);
    packed += static_cast<char>((back - 1) & 255);
    at += best;
  }
  flush();
  return packed;
}

/// A field of a PCD file with its values. Of a packed one the values are integers, and the file has their bits.
struct PcdColumn {
  std::string name;
  char type;
  std::size_t size;
  std::vector<double> values;
  bool is_packed = false;

  void append(std::size_t i, std::string& bytes) const {
    if (type == 'U' || is_packed) {
      append_bytes(bytes, static_cast<std::uint32_t>(values[i]));
    } else if (size == 4) {
      append_bytes(bytes, static_cast<float>(values[i]));
    } else {
      append_bytes(bytes, values[i]);
    }
  }

  std::string text(std::size_t i) const {
    const auto bits = static_cast<std::uint32_t>(is_packed ? values[i] : 0);
    std::ostringstream out;
    out << std::setprecision(17) << (is_packed && type == 'F' ? std::bit_cast<float>(bits) : values[i]);
    return out.str();
  }
};

inline std::string pcd_header(const std::vector<PcdColumn>& columns, std::size_t points, const std::string& data) {
  const auto line = [&](const std::string& keyword, const auto& word_of) {
    std::string words = keyword;
    for (const PcdColumn& c : columns) words += " " + word_of(c);
    return words + "\n";
  };
  const std::string count = std::to_string(points);
  return "# .PCD v.7 - Point Cloud Data file format\nVERSION .7\n" +
         line("FIELDS", [](const PcdColumn& c) { return c.name; }) +
         line("SIZE", [](const PcdColumn& c) { return std::to_string(c.size); }) +
         line("TYPE", [](const PcdColumn& c) { return std::string(1, c.type); }) +
         line("COUNT", [](const PcdColumn&) { return std::string("1"); }) + "WIDTH " + count +
         "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + count + "\nDATA " + data + "\n";
}

/// All columns have as many values; data as PCD names it.
inline std::string pcd_file(const std::vector<PcdColumn>& columns, const std::string& data) {
  const std::size_t points = columns[0].values.size();
  std::string bytes = pcd_header(columns, points, data);
  if (data == "binary_compressed") {
    std::string body;
    for (const PcdColumn& c : columns) {
      for (std::size_t i = 0; i < points; ++i) c.append(i, body);
    }
    const std::string packed = pack_lzf(body);
    append_bytes(bytes, static_cast<std::uint32_t>(packed.size()));
    append_bytes(bytes, static_cast<std::uint32_t>(body.size()));
    return bytes + packed;
  }
  for (std::size_t i = 0; i < points; ++i) {
    for (const PcdColumn& c : columns) {
      if (data == "binary") {
        c.append(i, bytes);
      } else {
        bytes += c.text(i) + (&c == &columns.back() ? "\n" : " ");
      }
    }
  }
  return bytes;
}

/// A cloud with x y z of floats, a packed colour and an intensity of doubles.
struct PcdRow {
  float x;
  float y;
  float z;
  std::uint32_t rgb;
  double intensity;
};

inline std::vector<PcdColumn> pcd_columns(const std::vector<PcdRow>& rows) {
  std::vector<PcdColumn> columns{
      {"x", 'F', 4, {}}, {"y", 'F', 4, {}}, {"z", 'F', 4, {}}, {"rgb", 'U', 4, {}}, {"intensity", 'F', 8, {}}};
  for (const PcdRow& r : rows) {
    const double values[] = {r.x, r.y, r.z, static_cast<double>(r.rgb), r.intensity};
    for (std::size_t k = 0; k < columns.size(); ++k) columns[k].values.push_back(values[k]);
  }
  return columns;
}

inline std::string pcd_header(std::size_t points, const std::string& data) {
  return pcd_header(pcd_columns({}), points, data);
}

inline std::string pcd_binary(const std::vector<PcdRow>& rows) {
  return pcd_file(pcd_columns(rows), "binary");
}

inline std::string pcd_compressed(const std::vector<PcdRow>& rows) {
  return pcd_file(pcd_columns(rows), "binary_compressed");
}

}  // namespace quoin::testing
