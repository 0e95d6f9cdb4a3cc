// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/zip_archive.h"

#include <zip.h>

#include <algorithm>
#include <utility>

#include "quoin/base/error.h"
#include "quoin/io/text_lines.h"

namespace quoin::io {

namespace {

// A byte of deflated data stands for at most 1032 bytes; some more for the head of the data.
constexpr std::uint64_t max_ratio = 1032;
constexpr std::uint64_t chunk = std::uint64_t{1} << 18;
// Records at the end of an archive, and of a part in its directory.
constexpr std::size_t end_record_size = 22;
constexpr std::size_t large_end_size = 56;
constexpr std::size_t locator_size = 20;
constexpr std::size_t entry_size = 46;

std::string in_small_letters(std::string_view text) {
  std::string small(text);
  for (char& c : small) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return small;
}

std::uint64_t number_at(std::string_view bytes, std::size_t at, std::size_t count) {
  std::uint64_t value = 0;
  for (std::size_t k = count; k-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
  return value;
}

// Whether the end of a large archive promises more parts than the file has room for: memory for all of them would be
// taken before the first is read. Ends of other archives promise fewer than 65536.
bool promises_too_many_parts(std::string_view bytes) {
  const std::size_t begin = bytes.size() - std::min<std::size_t>(bytes.size(), 65535 + end_record_size + locator_size);
  const std::uint64_t room = bytes.size() / entry_size;
  for (std::size_t at = bytes.find("PK\6\7", begin); at != std::string_view::npos; at = bytes.find("PK\6\7", at + 1)) {
    if (at + locator_size > bytes.size()) break;
    const std::uint64_t end = number_at(bytes, at + 8, 8);
    if (end > bytes.size() - large_end_size || bytes.size() < large_end_size) continue;
    const auto record = static_cast<std::size_t>(end);
    if (number_at(bytes, record + 24, 8) > room || number_at(bytes, record + 32, 8) > room) return true;
  }
  return false;
}

struct CloseFile {
  void operator()(zip_file_t* file) const { zip_fclose(file); }
};

}  // namespace

bool is_zip_archive(std::string_view bytes) {
  return bytes.starts_with("PK\3\4") || bytes.starts_with("PK\5\6");
}

ZipArchive::ZipArchive(std::string_view bytes, std::string name) : name_(std::move(name)), packed_bytes_(bytes.size()) {
  if (bytes.starts_with("PK\5\6") && bytes.size() == end_record_size)
    throw InputError(name_ + ": the archive is empty");
  if (promises_too_many_parts(bytes))
    throw InputError(name_ + ": the archive promises more parts than it has room for");
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  if (source != nullptr) {
    archive_ = zip_open_from_source(source, ZIP_RDONLY, &error);
    if (archive_ == nullptr) zip_source_free(source);
  }
  const std::string why = zip_error_strerror(&error);
  zip_error_fini(&error);
  if (archive_ == nullptr) throw InputError(name_ + ": the archive is damaged or cut short: " + why);
  const zip_int64_t count = zip_get_num_entries(archive_, 0);
  for (zip_int64_t i = 0; i < count; ++i) {
    const auto index = static_cast<std::uint64_t>(i);
    const char* path = zip_get_name(archive_, index, 0);
    if (path == nullptr) continue;
    const auto [place, is_new] = places_.try_emplace(in_small_letters(path), Place{index, false});
    if (!is_new) place->second.is_twice = true;
  }
}

ZipArchive::~ZipArchive() {
  if (archive_ != nullptr) zip_discard(archive_);
}

void ZipArchive::fail(const std::string& part, const std::string& what) const {
  throw InputError(name_ + ": " + io::quoted(part) + ": " + what);
}

std::optional<UnpackedPart> ZipArchive::read(const std::string& path, const Context& context) {
  const auto found = places_.find(in_small_letters(path));
  if (found == places_.end()) return std::nullopt;
  if (found->second.is_twice) fail(path, "the part is there twice");
  zip_stat_t about;
  zip_stat_init(&about);
  if (zip_stat_index(archive_, found->second.index, 0, &about) != 0) fail(path, zip_strerror(archive_));
  if (about.encryption_method != ZIP_EM_NONE) fail(path, "the part is encrypted");
  if (about.comp_method != ZIP_CM_STORE && about.comp_method != ZIP_CM_DEFLATE)
    fail(path, "the part is packed by method " + std::to_string(about.comp_method) + ", not stored or deflated");
  if (about.size > max_unpacked_bytes - unpacked_) fail(path, "the archive unpacks to more than 4 GB");
  const bool is_possible = about.comp_size <= packed_bytes_ && about.size <= max_ratio * about.comp_size + chunk;
  if (!is_possible) fail(path, "the part declares a size that its data cannot have");
  const std::unique_ptr<zip_file_t, CloseFile> file(zip_fopen_index(archive_, found->second.index, 0));
  if (!file) fail(path, std::string("the part is damaged: ") + zip_strerror(archive_));
  const std::size_t capacity = static_cast<std::size_t>(about.size) + 1;  // one more, to meet the end
  UnpackedPart part{about.name, std::make_unique_for_overwrite<char[]>(capacity), 0};
  for (;;) {
    context.poll();
    const zip_int64_t got =
        zip_fread(file.get(), part.data.get() + part.size, std::min<std::uint64_t>(chunk, capacity - part.size));
    if (got < 0) fail(path, std::string("the part is damaged: ") + zip_file_strerror(file.get()));
    if (got == 0) break;
    part.size += static_cast<std::size_t>(got);
    if (part.size == capacity) fail(path, "the part holds more than it declares");
  }
  if (part.size != about.size) fail(path, "the part holds less than it declares");
  unpacked_ += part.size;
  return part;
}

}  // namespace quoin::io
