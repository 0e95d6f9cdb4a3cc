// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace quoin::fuzz {

/// A target takes any bytes and returns; a promise that does not hold ends the program (std::abort) and says which.
using Target = void (*)(std::span<const std::uint8_t> bytes);

struct NamedTarget {
  std::string_view name;
  Target run;
};

void read_off(std::span<const std::uint8_t> bytes);
void read_obj(std::span<const std::uint8_t> bytes);
void read_stl(std::span<const std::uint8_t> bytes);
void read_ply(std::span<const std::uint8_t> bytes);
void read_3mf(std::span<const std::uint8_t> bytes);
void read_points(std::span<const std::uint8_t> bytes);
void read_exact(std::span<const std::uint8_t> bytes);
void read_arrangement(std::span<const std::uint8_t> bytes);
void read_cells(std::span<const std::uint8_t> bytes);
void read_wkt(std::span<const std::uint8_t> bytes);
void read_geojson(std::span<const std::uint8_t> bytes);
void read_svg(std::span<const std::uint8_t> bytes);
void read_dxf(std::span<const std::uint8_t> bytes);
void predicates(std::span<const std::uint8_t> bytes);
void booleans(std::span<const std::uint8_t> bytes);

inline constexpr NamedTarget targets[] = {{"read_off", read_off},       {"read_obj", read_obj},
                                          {"read_stl", read_stl},       {"read_ply", read_ply},
                                          {"read_3mf", read_3mf},       {"read_exact", read_exact},
                                          {"read_points", read_points}, {"read_arrangement", read_arrangement},
                                          {"read_wkt", read_wkt},       {"read_geojson", read_geojson},
                                          {"read_svg", read_svg},       {"read_dxf", read_dxf},
                                          {"predicates", predicates},   {"booleans", booleans},
                                          {"read_cells", read_cells}};

}  // namespace quoin::fuzz
