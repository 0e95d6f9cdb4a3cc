// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "quoin/base/context.h"

struct zip;

namespace quoin::io {

/// What an archive may unpack to at most, all its parts that are read together.
inline constexpr std::uint64_t max_unpacked_bytes = std::uint64_t{4} << 30;

/// A part of an archive, unpacked.
struct UnpackedPart {
  std::string name;              ///< as the archive spells it
  std::unique_ptr<char[]> data;  ///< not filled before it is written to
  std::size_t size = 0;

  std::string_view text() const { return {data.get(), size}; }
};

/// A zip archive in memory, read only; stored and deflated parts.
///
/// Sizes that it declares are taken as bounds, never as truth: more bytes than declared, fewer, or other ones than the
/// checksum tells are refused.
class ZipArchive {
 public:
  /// The bytes must outlive the archive; `name` stands for it in messages. O(number of parts log of it).
  /// @throws InputError  the archive is damaged, cut short or empty
  ZipArchive(std::string_view bytes, std::string name);
  ~ZipArchive();
  ZipArchive(const ZipArchive&) = delete;
  ZipArchive& operator=(const ZipArchive&) = delete;

  /// A part by its path, without a slash in front, in letters of any case; nothing where there is none. O(size).
  /// @throws InputError  the part is there twice, encrypted, damaged, packed otherwise, or too large
  std::optional<UnpackedPart> read(const std::string& path, const Context& context);

 private:
  struct Place {
    std::uint64_t index = 0;
    bool is_twice = false;
  };
  [[noreturn]] void fail(const std::string& part, const std::string& what) const;

  std::string name_;
  std::size_t packed_bytes_ = 0;
  std::uint64_t unpacked_ = 0;
  struct zip* archive_ = nullptr;
  std::map<std::string, Place> places_;  // by the path in small letters
};

/// Whether a file begins as a zip archive does.
bool is_zip_archive(std::string_view bytes);

}  // namespace quoin::io
