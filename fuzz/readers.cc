// SPDX-License-Identifier: Apache-2.0
//
// Readers return a mesh that can be written and read again, or refuse with an InputError; nothing else.
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>

#include "fuzz/promise.h"
#include "fuzz/targets.h"
#include "quoin/base/error.h"
#include "quoin/io/arrangement_text.h"
#include "quoin/io/cells_complex.h"
#include "quoin/io/cells_text.h"
#include "quoin/io/exact_text.h"
#include "quoin/io/mesh_file.h"
#include "quoin/io/test_archives.h"
#include "quoin/solid/check.h"
#include "quoin/solid/leaf.h"

namespace quoin::fuzz {

namespace {

std::string_view text_of(std::span<const std::uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

void read(std::string_view text, const char* name) {
  const Context context({.threads = 1});
  try {
    const MeshFile file = read_mesh(text, name, {}, context);
    for (const std::uint32_t corner : file.mesh.corners) {
      require(corner < file.mesh.vertices.size(), "a face names a vertex that is there");
    }
    std::ostringstream out;
    write_mesh(out, MeshFormat::off, file.mesh, context);
    const MeshFile again = read_mesh(out.str(), "again.off", {.weld = false, .weld_tolerance = {}}, context);
    require(again.mesh.corners == file.mesh.corners, "faces survive writing and reading");
    require(again.mesh.vertices == file.mesh.vertices, "vertices survive writing and reading");
    if (file.mesh.face_count() < 200) (void)make_leaf(file.mesh, {}, context);
  } catch (const InputError&) {
  }
}

}  // namespace

void read_off(std::span<const std::uint8_t> bytes) {
  read(text_of(bytes), "input.off");
}
void read_obj(std::span<const std::uint8_t> bytes) {
  read(text_of(bytes), "input.obj");
}
void read_stl(std::span<const std::uint8_t> bytes) {
  read(text_of(bytes), "input.stl");
}
void read_ply(std::span<const std::uint8_t> bytes) {
  read(text_of(bytes), "input.ply");
}

// Few changes of an archive pass its checksum: what is none is the model of a package without relationships.
void read_3mf(std::span<const std::uint8_t> bytes) {
  const std::string_view text = text_of(bytes);
  if (text.starts_with("PK")) return read(text, "input.3mf");
  read(io::test::archive({{"3D/3dmodel.model", std::string(text)}}), "input.3mf");
}

void read_exact(std::span<const std::uint8_t> bytes) {
  const Context context({.threads = 1});
  try {
    const Brep boundary = read_exact_text(text_of(bytes), "input.qsolid");
    std::ostringstream first;
    write_exact_text(first, boundary);
    std::ostringstream second;
    write_exact_text(second, read_exact_text(first.str(), "again.qsolid"));
    require(first.str() == second.str(), "exact text is the same after another round");
    if (boundary.face_count() < 50) (void)check_boundary(boundary, 10, context);
  } catch (const InputError&) {
  }
}

void read_arrangement(std::span<const std::uint8_t> bytes) {
  const Context context({.threads = 1});
  try {
    const auto written = [](const auto& read) {
      std::ostringstream out;
      if (read.members) {
        write_arrangement_text(out, *read.set(), read.names);
      } else {
        write_arrangement_text(out, read.arrangement, read.names);
      }
      return out.str();
    };
    const AnyArrangementText any = read_arrangement_text(text_of(bytes), "input.qarr", context);
    std::visit([](const auto& read) { dcel::check_links(read.arrangement.cells()); }, any);
    const std::string first = std::visit(written, any);
    const std::string second = std::visit(written, read_arrangement_text(first, "again.qarr", context));
    require(first == second, "exact text of an arrangement is the same after another round");
  } catch (const InputError&) {
  }
}

void read_cells(std::span<const std::uint8_t> bytes) {
  const Context context({.threads = 1});
  try {
    const ExactCells cells = read_cells_text(text_of(bytes), "input.qcells", context);
    std::ostringstream first;
    write_cells_text(first, cells, context);
    const ExactCells again = read_cells_text(first.str(), "again.qcells", context);
    require(again == cells, "exact cells survive writing and reading");
    std::ostringstream second;
    write_cells_text(second, again, context);
    require(first.str() == second.str(), "exact text of cells is the same after another round");
    (void)simplices_of_cells(cells, context);
    (void)filtration_of_cells(cells, "input.qcells", context);
  } catch (const InputError&) {
  }
}

}  // namespace quoin::fuzz
