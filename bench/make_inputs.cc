// SPDX-License-Identifier: Apache-2.0
//
// Writes the inputs of the benchmarks as OFF files: two overlapping geodesic spheres.
//
//   make_inputs FREQUENCY DIRECTORY     (20 FREQUENCY^2 triangles each)
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "quoin/io/mesh_file.h"
#include "quoin/solid/shapes.h"

int main(int argc, char** argv) {
  using namespace quoin;
  if (argc != 3) {
    std::fprintf(stderr, "make_inputs FREQUENCY DIRECTORY\n");
    return 2;
  }
  const Context context;
  const std::filesystem::path directory(argv[2]);
  const Mesh sphere = shapes::geodesic_sphere(static_cast<std::size_t>(std::atol(argv[1])));
  const Mesh moved = shapes::translated(sphere, {0.9, 0.17, 0.31});
  write_mesh(directory / (std::string("sphere") + argv[1] + "_a.off"), MeshFormat::off, sphere, context);
  write_mesh(directory / (std::string("sphere") + argv[1] + "_b.off"), MeshFormat::off, moved, context);
  return 0;
}
