// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace quoin::io {

struct PcdField {
  std::string name;
  std::size_t size = 4;   ///< of a number, in bytes: 1, 2, 4 or 8
  char type = 'F';        ///< I signed, U unsigned, F floating
  std::size_t count = 1;  ///< numbers per point
  std::size_t bytes() const { return size * count; }
};

/// What the header of a PCD file says about what follows it.
struct PcdLayout {
  enum class Data { text, binary, compressed };
  std::vector<PcdField> fields;
  std::uint64_t points = 0;
  Data data = Data::text;
  bool has_viewpoint = false;  ///< one that is not the origin, looking as the axes lie
  std::size_t size = 0;        ///< of the header, in bytes
  std::size_t lines = 0;

  /// Of a point, in bytes; that of the header and the sizes of fields are known to be small.
  std::size_t point_size() const;
};

/// Versions .5 to .7. @throws InputError  with `name` and the line
PcdLayout read_pcd_layout(std::string_view bytes, const std::string& name);

}  // namespace quoin::io
