// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/point_arguments.h"

#include <cstdint>
#include <limits>
#include <string>

#include "quoin/cli/command_options.h"
#include "quoin/cli/number_options.h"

namespace quoin::cli {

namespace {

CLI::App* add_points_command(CLI::App& app, Options& options, const char* name, const char* text,
                             const std::string& formats) {
  CLI::App* command = add_command(app, options, name, text);
  command
      ->add_option("file", options.inputs,
                   "points of the plane or of space: xyz txt pts csv ply obj off pcd; '-' for standard input")
      ->required()
      ->expected(1);
  add_repeatable(*command, "-o,--output", options.outputs,
                 "file to write, format by its ending: " + formats + "; '-' for standard output; may be repeated");
  command->add_option("--format", options.format,
                      "format of standard output: an ending without its dot (default: vtk)");
  command
      ->add_option("--input-format", options.input_format,
                   "xyz, pts, csv, ply, obj, off or pcd (default: told by content and ending)")
      ->check(CLI::IsMember({"xyz", "pts", "csv", "ply", "obj", "off", "pcd"}, CLI::ignore_case));
  command->add_flag("--plane", options.onto_plane, "x and y count, whatever the third coordinate is");
  add_number(*command, "--memory", options.memory, above_zero,
             "refuse what needs more than this many megabytes (default: what is free)");
  return command;
}

void add_alpha(CLI::App& app, Options& options) {
  CLI::App* alpha = add_points_command(
      app, options, "alpha", "alpha complexes of points, exactly: their values, shapes, and graphs of neighbours",
      "vtk (simplices with values, or edges of a graph), ply obj off (the boundary, or triangles of the plane), html "
      "(a page of all values), qcells (exact: the filtration, or edges), txt (the same in numbers of points)");
  alpha->add_flag("--weighted", options.weighted, "the last column is a weight: of the regular triangulation");
  add_exact_number(*alpha, "--value", options.value, any_number,
                   "the complex of this value, a squared radius: a decimal or p/q");
  add_exact_number(*alpha, "--radius", options.radius, from_zero, "the complex of the square of this");
  const auto set_pieces = [&options](std::uint64_t number) { options.pieces = number; };
  add_whole_number(*alpha, "--pieces", set_pieces, 1, std::numeric_limits<std::uint32_t>::max(),
                   "the least complex with no more pieces of full dimension, all points at them");
  alpha->add_flag("--values", options.values, "all critical values");
  alpha->add_flag("--persistence", options.persistence,
                  "when components, tunnels and voids come and go, instead of a complex; svg draws it");
  add_repeatable(*alpha, "--prime", options.primes,
                 "of --persistence: over a field of this many elements (default: 2)");
  alpha->add_flag("--barcode", options.barcode, "of --persistence: draw bars instead of points");
  alpha->add_flag("--exact", options.exact, "values as fractions, in the report and in txt");
  alpha
      ->add_option("--graph", options.graph,
                   "gabriel, relative-neighbours or spanning-tree: that graph of all points instead of a complex")
      ->check(CLI::IsMember({"gabriel", "relative-neighbours", "spanning-tree"}));
}

void add_triangulations(CLI::App& app, Options& options) {
  CLI::App* delaunay = add_points_command(app, options, "delaunay", "the Delaunay triangulation of points, exactly",
                                          "vtk (all cells), ply obj off (the hull, or all triangles of the plane), "
                                          "html (a page to look at), qcells (exact)");
  delaunay->add_flag("--delone", options.delone,
                     "files hold Delone cells, which do not depend on the choice of diagonals, not simplices");
  delaunay->add_flag("--weighted", options.weighted, "the last column is a weight: the regular triangulation");
  delaunay->add_flag("--check", options.check,
                     "prove that every sphere is empty, by other means than those that made it");
  CLI::App* voronoi =
      add_points_command(app, options, "voronoi", "what is nearest to each of many points, exactly",
                         "vtk (all cells), ply obj off (bounded facets, or cells of the plane), qcells (exact)");
  voronoi->add_flag("--weighted", options.weighted, "the last column is a weight: the power diagram");
  voronoi->add_flag("--cells", options.cells, "each cell: its volume or area, and its neighbours");
  voronoi->add_flag("--exact", options.exact, "of --cells: exact volumes at any length, not only short ones");
}

void add_flow(CLI::App& app, Options& options) {
  CLI::App* flow = add_points_command(
      app, options, "flow", "critical points of the distance to points, and what flows to them, exactly",
      "vtk (what is asked for), ply obj off (its surfaces), svg (histograms), html (a page to look at), "
      "qcells (exact)");
  const auto set_stable = [&options](std::uint64_t index) { options.stable = static_cast<int>(index); };
  add_whole_number(*flow, "--stable", set_stable, 1, 3,
                   "what flows to critical points of this index: 1 (edges), 2 (surfaces) or 3 (regions)");
  const auto set_unstable = [&options](std::uint64_t index) { options.unstable = static_cast<int>(index); };
  add_whole_number(*flow, "--unstable", set_unstable, 1, 2,
                   "what flows from critical points of this index: 1 (sheets) or 2 (ways to maxima)");
  add_exact_number(*flow, "--shape", options.shape, from_zero,
                   "what is found up to this distance, with its Betti numbers");
  add_exact_number(
      *flow, "--simplify", options.simplify, from_zero,
      "leave out maxima that are at most this much farther from the points than a saddle that cuts them off");
  flow->add_flag("--reconstruct", options.reconstruct, "the solid whose surface the points are on");
  add_exact_number(*flow, "--ratio", options.ratio, zero_to_one,
                   "of --reconstruct: how near to the points a wall is, of the distance behind it (default: 0.5)");
  flow->add_flag("--separate", options.separate,
                 "critical points near the surface that the points are on from those near its medial axis; "
                 "--reconstruct goes by that then");
}

}  // namespace

void add_point_commands(CLI::App& app, Options& options) {
  add_triangulations(app, options);
  add_alpha(app, options);
  add_flow(app, options);
}

}  // namespace quoin::cli
