// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "quoin/io/mesh_file.h"

namespace quoin::io {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// In bytes.
std::size_t size_of(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type;
  std::optional<PlyType> count_type;  ///< of a list
};

struct PlyElement {
  std::string name;
  std::uint64_t count;
  std::vector<PlyProperty> properties;

  /// Place of a property that is no list, if there is one.
  std::optional<std::size_t> find(std::string_view property) const;
};

/// What the header of a PLY file says about the bytes behind it.
struct PlyLayout {
  MeshFormat format = MeshFormat::ply_text;
  std::vector<PlyElement> elements;
  std::size_t size = 0;   ///< of the header, in bytes
  std::size_t lines = 0;  ///< of the header

  bool is_text() const { return format == MeshFormat::ply_text; }
};

/// @throws InputError  with `name` and the line
PlyLayout read_ply_layout(std::string_view bytes, const std::string& name);

}  // namespace quoin::io
