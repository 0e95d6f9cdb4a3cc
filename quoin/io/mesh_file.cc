// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/mesh_file.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "quoin/base/error.h"
#include "quoin/io/readers.h"
#include "quoin/io/text_lines.h"
#include "quoin/io/weld.h"
#include "quoin/io/zip_archive.h"

namespace quoin {

namespace {

std::string ending_of(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

// A buffer that is not filled before it is read into.
struct FileBytes {
  std::unique_ptr<char[]> data;
  std::size_t size = 0;
  std::string_view view() const { return {data.get(), size}; }
};

FileBytes read_bytes(const std::filesystem::path& path, const Context& context) {
  constexpr std::size_t most_at_once = std::size_t{1} << 20;
  const std::string name = path.string();
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) throw FileError(name + ": is a directory");
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(name.c_str(), "rb"), &std::fclose);
  if (!file) throw FileError(name + ": cannot be opened: " + std::strerror(errno));
  const auto expected = std::filesystem::file_size(path, error);
  std::size_t capacity = error ? 65536 : static_cast<std::size_t>(expected) + 1;  // one more, to meet the end
  FileBytes bytes{std::make_unique_for_overwrite<char[]>(capacity)};
  for (;;) {
    context.poll();
    const std::size_t wanted = std::min(most_at_once, capacity - bytes.size);
    const std::size_t read = std::fread(bytes.data.get() + bytes.size, 1, wanted, file.get());
    bytes.size += read;
    if (read < wanted) break;
    if (bytes.size < capacity) continue;
    auto larger = std::make_unique_for_overwrite<char[]>(2 * capacity);
    std::memcpy(larger.get(), bytes.data.get(), bytes.size);
    bytes.data = std::move(larger);
    capacity *= 2;
  }
  if (std::ferror(file.get()) != 0) throw FileError(name + ": cannot be read: " + std::strerror(errno));
  return bytes;
}

MeshFile read_by_content(std::string_view bytes, const std::string& name, bool weld, const Context& context) {
  if (bytes.empty()) throw InputError(name + ": the file is empty");
  if (io::is_zip_archive(bytes)) return io::read_threemf(bytes, name, context);
  const std::string ending = ending_of(name);
  const std::string_view word = io::first_word(bytes);
  if (word == "ply") return io::read_ply(bytes, name, context);
  if (io::fits_stl_binary(bytes)) return io::read_stl_binary(bytes, name, weld, context);
  if (word.ends_with("OFF") && word.size() <= 7) return io::read_off(bytes, name, context);
  if (ending == ".stl") {
    return io::is_stl_text(bytes) ? io::read_stl_text(bytes, name, context)
                                  : io::read_stl_binary(bytes, name, weld, context);
  }
  if (ending == ".ply") throw InputError(name + ":1: 'ply' should stand here");
  if (ending == ".3mf") throw InputError(name + ": a zip archive should begin here, as 3MF files do");
  if (ending == ".off") return io::read_off(bytes, name, context);
  if (ending == ".obj") return io::read_obj(bytes, name, context);
  if (io::is_word(word, "solid")) {
    return io::is_stl_text(bytes) ? io::read_stl_text(bytes, name, context)
                                  : io::read_stl_binary(bytes, name, weld, context);
  }
  if (word == "v" || word == "#" || word == "o" || word == "g" || word == "mtllib")
    return io::read_obj(bytes, name, context);
  throw InputError(name + ": neither the content nor the ending tells a format that is read (OFF, OBJ, STL, PLY, 3MF)");
}

// Arrays that grew by doubling hold up to twice what they need, for as long as the mesh lives.
void release_spare_room(Mesh& mesh) {
  mesh.vertices.shrink_to_fit();
  mesh.corners.shrink_to_fit();
  mesh.face_begin.shrink_to_fit();
  mesh.face_colors.shrink_to_fit();
}

}  // namespace

std::optional<MeshFormat> format_from_path(const std::filesystem::path& path) {
  const std::string ending = ending_of(path);
  if (ending == ".off") return MeshFormat::off;
  if (ending == ".obj") return MeshFormat::obj;
  if (ending == ".stl") return MeshFormat::stl_binary;
  if (ending == ".ply") return MeshFormat::ply_binary_little;
  if (ending == ".3mf") return MeshFormat::threemf;
  return std::nullopt;
}

std::string read_file(const std::filesystem::path& path) {
  const FileBytes bytes = read_bytes(path, Context({.threads = 1}));
  return std::string(bytes.view());
}

MeshFile read_mesh(std::string_view bytes, const std::string& name, const ReadOptions& options,
                   const Context& context) {
  context.progress("reading", 0);
  ReadOptions open = options;
  MeshFile file = read_by_content(bytes, name, options.weld || options.weld_tolerance, context);
  if (file.report.format == MeshFormat::stl_binary) {
    open.weld = false;  // done
  } else {
    file.report.vertices_in_file = file.mesh.vertices.size();
  }
  if (file.mesh.face_count() == 0) {
    file.report.warnings.push_back("no faces; vertices in the file: " + std::to_string(file.report.vertices_in_file));
  }
  if (file.mesh.name.empty()) file.mesh.name = std::filesystem::path(name).stem().string();
  io::weld(file.mesh, open, file.report, context);
  release_spare_room(file.mesh);
  return file;
}

MeshFile read_mesh(const std::filesystem::path& path, const ReadOptions& options, const Context& context) {
  const FileBytes bytes = read_bytes(path, context);
  return read_mesh(bytes.view(), path.string(), options, context);
}

}  // namespace quoin
