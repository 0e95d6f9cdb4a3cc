// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "quoin/base/context.h"
#include "quoin/io/mesh_file.h"

namespace quoin::io {

/// One reader per format. Each leaves vertices as the file has them, not welded, and `vertices_in_file` to its caller;
/// that of binary STL, where every triangle brings its own vertices, welds equal ones on the way if asked and fills the
/// report's counts. @throws InputError
MeshFile read_off(std::string_view bytes, const std::string& name, const Context& context);
MeshFile read_obj(std::string_view bytes, const std::string& name, const Context& context);
MeshFile read_stl_text(std::string_view bytes, const std::string& name, const Context& context);
MeshFile read_stl_binary(std::string_view bytes, const std::string& name, bool weld, const Context& context);
MeshFile read_ply(std::string_view bytes, const std::string& name, const Context& context);
MeshFile read_threemf(std::string_view bytes, const std::string& name, const Context& context);

/// Whether the file has just the size that its count of triangles asks for, as a binary STL.
bool fits_stl_binary(std::string_view bytes);
/// Of an STL file: begins with "solid" or "facet", in any case, and holds letters where a binary one has its count
/// (whose header may begin with "solid" too, and other data may follow the triangles).
bool is_stl_text(std::string_view bytes);

/// Whether OBJ has such a statement beside v, f, fo and those of free-form geometry; older versions count.
bool is_obj_statement(std::string_view keyword);

}  // namespace quoin::io
