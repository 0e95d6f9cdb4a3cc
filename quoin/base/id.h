// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>

namespace quoin {

/// Index of an element in the array of its kind; `Tag` keeps kinds apart. The default value names nothing.
template <class Tag>
struct Id {
  std::uint32_t value = none_value;

  static constexpr std::uint32_t none_value = 0xFFFFFFFFU;

  constexpr Id() = default;
  constexpr explicit Id(std::size_t index) : value(static_cast<std::uint32_t>(index)) {}
  constexpr bool is_none() const { return value == none_value; }
  constexpr std::size_t index() const { return value; }
  friend constexpr bool operator==(Id, Id) = default;
  friend constexpr auto operator<=>(Id, Id) = default;
};

}  // namespace quoin

template <class Tag>
struct std::hash<quoin::Id<Tag>> {
  std::size_t operator()(quoin::Id<Tag> id) const noexcept { return std::hash<std::uint32_t>{}(id.value); }
};
