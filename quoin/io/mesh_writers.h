// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/io/block_writer.h"
#include "quoin/io/mesh_file.h"

namespace quoin::io {

/// The corners of a face with their number, and its colour if there are colours, as words of a line.
void write_face_line(BlockWriter& out, const Mesh& mesh, std::size_t f);

/// PLY of one of its three formats; of vertices with `nx ny nz`, `red green blue alpha`, `intensity` and `weight` as
/// far as they have them.
void write_ply(BlockWriter& out, MeshFormat format, const Mesh& mesh, const VertexData& data);

}  // namespace quoin::io
