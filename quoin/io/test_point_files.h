// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstring>
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

/// A cloud with x y z of floats, a packed colour and an intensity of doubles; data as PCD names it.
struct PcdRow {
  float x;
  float y;
  float z;
  std::uint32_t rgb;
  double intensity;
};

inline std::string pcd_header(std::size_t points, const std::string& data) {
  const std::string count = std::to_string(points);
  return "# .PCD v.7 - Point Cloud Data file format\nVERSION .7\nFIELDS x y z rgb intensity\nSIZE 4 4 4 4 8\nTYPE F F "
         "F U "
         "F\nCOUNT 1 1 1 1 1\nWIDTH " +
         count + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + count + "\nDATA " + data + "\n";
}

inline std::string pcd_binary(const std::vector<PcdRow>& rows) {
  std::string bytes = pcd_header(rows.size(), "binary");
  for (const PcdRow& r : rows) {
    append_bytes(bytes, r.x);
    append_bytes(bytes, r.y);
    append_bytes(bytes, r.z);
    append_bytes(bytes, r.rgb);
    append_bytes(bytes, r.intensity);
  }
  return bytes;
}

inline std::string pcd_compressed(const std::vector<PcdRow>& rows) {
  std::string body;
  for (const PcdRow& r : rows) append_bytes(body, r.x);
  for (const PcdRow& r : rows) append_bytes(body, r.y);
  for (const PcdRow& r : rows) append_bytes(body, r.z);
  for (const PcdRow& r : rows) append_bytes(body, r.rgb);
  for (const PcdRow& r : rows) append_bytes(body, r.intensity);
  const std::string packed = pack_lzf(body);
  std::string bytes = pcd_header(rows.size(), "binary_compressed");
  append_bytes(bytes, static_cast<std::uint32_t>(packed.size()));
  append_bytes(bytes, static_cast<std::uint32_t>(body.size()));
  return bytes + packed;
}

}  // namespace quoin::testing
