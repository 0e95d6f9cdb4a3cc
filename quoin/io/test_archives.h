// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace quoin::io::test {

/// What an archive of the tests is made of: paths and contents.
using Parts = std::vector<std::pair<std::string, std::string>>;

/// What may be wrong with an archive.
struct ArchiveFaults {
  std::uint16_t flags = 0;            ///< 1: encrypted
  std::uint16_t method = 0;           ///< stored
  std::uint32_t checksum_change = 0;  ///< xor
  std::uint32_t declared_more = 0;    ///< bytes that the last part declares and does not have
  std::uint16_t declared_parts = 0;   ///< that are not there
};

/// CRC-32 as zip archives have it, bit by bit.
inline std::uint32_t checksum(std::string_view bytes) {
  std::uint32_t rest = ~std::uint32_t{0};
  for (const char c : bytes) {
    rest ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) rest = rest >> 1 ^ (0xEDB88320U & (~(rest & 1U) + 1U));
  }
  return ~rest;
}

/// A zip archive of stored parts, written without the library that reads it.
inline std::string archive(const Parts& parts, const ArchiveFaults& faults = {}) {
  std::string bytes;
  std::string directory;
  const auto put = [](std::string& to, std::uint64_t value, int count) {
    for (int k = 0; k < count; ++k, value >>= 8) to += static_cast<char>(value & 0xFF);
  };
  for (const auto& [path, text] : parts) {
    const std::size_t at = bytes.size();
    std::string head;
    put(head, 20, 2);  // version
    put(head, faults.flags, 2);
    put(head, faults.method, 2);
    put(head, 0x21 << 16, 4);  // the first day of 1980
    put(head, checksum(text) ^ faults.checksum_change, 4);
    put(head, text.size(), 4);
    put(head, text.size() + (&text == &parts.back().second ? faults.declared_more : 0), 4);
    put(head, path.size(), 2);
    put(head, 0, 2);  // extra fields
    bytes += "PK\3\4" + head + path + text;
    directory += std::string("PK\1\2") + std::string("\24\0", 2) + head;
    put(directory, 0, 10);  // comment, disk, attributes
    put(directory, at, 4);
    directory += path;
  }
  const std::size_t begin = bytes.size();
  bytes += directory + "PK\5\6";
  put(bytes, 0, 4);
  put(bytes, parts.size() + faults.declared_parts, 2);
  put(bytes, parts.size() + faults.declared_parts, 2);
  put(bytes, directory.size(), 4);
  put(bytes, begin, 4);
  put(bytes, 0, 2);
  return bytes;
}

inline const std::string relationships =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
    "<Relationship Id=\"r\" Target=\"/3D/3dmodel.model\" "
    "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>";

/// A model part; the resources begin in line 3, the build in the line behind them.
inline std::string model(const std::string& resources, const std::string& build, const std::string& attributes = "") {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<model xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\"" +
         attributes + "><resources>\n" + resources + "\n</resources><build>" + build + "</build></model>\n";
}

/// A file whose only model is this text.
inline std::string package(const std::string& text) {
  return archive({{"_rels/.rels", relationships}, {"3D/3dmodel.model", text}});
}

/// A tetrahedron with its right angle in the origin, its edges along the axes of this length.
inline std::string corner_mesh(const std::string& size = "1") {
  return "<mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"" + size +
         "\" y=\"0\" z=\"0\"/><vertex x=\"0\" y=\"" + size + "\" z=\"0\"/><vertex x=\"0\" y=\"0\" z=\"" + size +
         "\"/></vertices><triangles><triangle v1=\"0\" v2=\"2\" v3=\"1\"/><triangle v1=\"0\" v2=\"1\" v3=\"3\"/>"
         "<triangle v1=\"0\" v2=\"3\" v3=\"2\"/><triangle v1=\"1\" v2=\"2\" v3=\"3\"/></triangles></mesh>";
}

}  // namespace quoin::io::test
