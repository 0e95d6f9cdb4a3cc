// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/arguments.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <limits>
#include <string_view>

#include "quoin/cli/command_options.h"
#include "quoin/cli/failure.h"
#include "quoin/cli/number_options.h"
#include "quoin/cli/point_arguments.h"

namespace quoin::cli {

namespace {

void add_makers_options(CLI::App& command, Options& options) {
  add_repeatable(command, "-o,--output", options.outputs,
                 "file to write, format by its ending: off obj stl ply (rounded, certified), html (a page to look at), "
                 "qsolid (exact); '-' for standard output; may be repeated");
  command.add_option("--format", options.format, "format of standard output: an ending without its dot (default: off)");
  command.add_flag("--accept-rounding", options.accept_rounding,
                   "write a mesh even where rounding makes faces cross, or parts vanish or fuse");
}

CLI::App* add_maker(CLI::App& app, Options& options, const char* name, const char* text) {
  CLI::App* command = add_command(app, options, name, text);
  add_makers_options(*command, options);
  return command;
}

void add_one_file(CLI::App& command, Options& options) {
  command.add_option("file", options.inputs, "a mesh or .qsolid; '-' for standard input")->required()->expected(1);
}

void add_files(CLI::App& command, Options& options) {
  command.add_option("files", options.inputs, "meshes or .qsolid; '-' for standard input")->required();
}

void add_booleans(CLI::App& app, Options& options) {
  for (const auto& [name, text] : {std::pair{"union", "the points in any of the solids"},
                                   {"intersection", "the points in all of the solids"},
                                   {"difference", "the points of the first solid in none of the others"},
                                   {"xor", "the points in an odd number of the solids"}}) {
    add_files(*add_maker(app, options, name, text), options);
  }
  CLI::App* csg =
      add_maker(app, options, "csg", "any expression: quoin csg 'a - (b | c)' a=x.stl b=y.off c=z.ply -o result.stl");
  csg->add_option("expression", options.expression, "| union, - difference, & intersection, ^ xor, ! complement, ( )")
      ->required();
  csg->add_option("operands", options.inputs, "NAME=FILE for each name")->required();
}

void add_assembly(CLI::App& app, Options& options) {
  CLI::App* assembly =
      add_command(app, options, "assembly", "how an assembly comes apart: which parts can move away, and where to");
  assembly
      ->add_option("files", options.inputs,
                   "parts that do not overlap: meshes or .qsolid, a part each, or OBJ or 3MF with several objects; of "
                   "convex pieces, which may be groups of an object")
      ->required();
  add_repeatable(*assembly, "-o,--output", options.outputs,
                 "file to write, format by its ending: json (the report), html (a page to look at); '-' for standard "
                 "output; may be repeated");
  assembly->add_option("--format", options.format, "format of standard output: an ending without its dot");
  assembly->add_flag("--sequence", options.sequence, "take it apart altogether, with alternatives");
  assembly->add_flag("--sequence-only", options.sequence_only, "the same without the list of all solutions");
  assembly->add_flag("--infinitesimal", options.infinitesimal, "only what can begin to move, which costs less");
  assembly->add_flag("--prune", options.prune,
                     "first leave out directions in which everything holds, triangle by triangle");
  add_repeatable(*assembly, "--direction", options.directions, "x,y,z: only this way (may be repeated)");
  assembly->add_flag("--one-part", options.one_part, "move one part at a time");
  assembly->add_option("--base", options.base, "name of a part that stays where it is");
  const auto set_limit = [&options](std::uint64_t number) { options.limit = number; };
  add_whole_number(*assembly, "--limit", set_limit, 0, std::numeric_limits<std::size_t>::max(),
                   "solutions listed (default: 10000)");
}

void add_queries(CLI::App& app, Options& options) {
  CLI::App* classify =
      add_command(app, options, "classify", "where points and lines lie: in, out, on a face, edge or vertex");
  add_one_file(*classify, options);
  add_repeatable(*classify, "--point", options.points, "x,y,z (may be repeated)");
  classify->add_option("--points", options.points_file, "file with a point per line; '-' for standard input");
  add_repeatable(*classify, "--line", options.lines,
                 "x,y,z,dx,dy,dz: a point of it and its direction (may be repeated)");
  CLI::App* section = add_command(app, options, "section", "what a plane cuts out of a solid, exactly");
  add_one_file(*section, options);
  section
      ->add_option("--plane", options.plane,
                   "a,b,c,d: the points with a x + b y + c z = d; seen from where (a,b,c) points")
      ->required();
  add_repeatable(*section, "-o,--output", options.outputs,
                 "SVG drawing to write; '-' for standard output; may be repeated");
  CLI::App* interfere =
      add_command(app, options, "interfere", "whether solids overlap, touch or stay apart, pair by pair");
  interfere->add_option("files", options.inputs, "two or more meshes or .qsolid")->required()->expected(2, 1 << 20);
}

void add_topology(CLI::App& app, Options& options) {
  CLI::App* homology =
      add_command(app, options, "homology", "components, tunnels and voids: Betti numbers over fields, torsion");
  homology
      ->add_option(
          "file", options.inputs,
          "a mesh, cells (qcells), or a text with the vertex numbers of a simplex in each line; '-' for standard input")
      ->required()
      ->expected(1);
  add_repeatable(*homology, "--prime", options.primes, "Betti numbers over this many elements too (may be repeated)");
  CLI::App* persistence =
      add_command(app, options, "persistence", "when components, tunnels and voids come and go in a growing complex");
  persistence
      ->add_option("file", options.inputs,
                   "cells with values (qcells), or a text with the value and vertex numbers of a simplex in each line; "
                   "'-' for standard input")
      ->required()
      ->expected(1);
  add_repeatable(*persistence, "--prime", options.primes, "over a field of this many elements (default: 2)");
  add_repeatable(*persistence, "-o,--output", options.outputs,
                 "SVG diagram to write; '-' for standard output; may be repeated");
  persistence->add_flag("--barcode", options.barcode, "draw bars instead of points");
}

void add_constrained(CLI::App& app, Options& options) {
  CLI::App* constrained = add_command(app, options, "constrained",
                                      "triangles of the plane with given edges: points and segments that may cross");
  constrained
      ->add_option("files", options.inputs,
                   "drawings: wkt, geojson, svg paths, dxf; '-' for standard input; or WKT itself")
      ->required();
  constrained->add_option("--points", options.points_file,
                          "file of more points: xyz txt pts csv ply obj off pcd; '-' for standard input");
  add_repeatable(*constrained, "-o,--output", options.outputs,
                 "file to write, format by its ending: svg (a picture), html (a page to look into it), vtk (triangles "
                 "and edges), ply obj off (triangles), qcells (exact); '-' for standard output; may be repeated");
  constrained->add_option("--format", options.format,
                          "format of standard output: an ending without its dot (default: svg)");
  constrained->add_flag("--inside", options.inside,
                        "outputs hold triangles inside alone: behind an odd number of edges");
  constrained->add_flag("--labels", options.labels, "numbers of points in pictures");
  add_number(*constrained, "--flatten", options.flatten, above_zero,
             "chords no further than this from arcs, which triangles cannot have");
}

void add_pictures(CLI::App& command, Options& options, const std::string& formats) {
  add_repeatable(
      command, "-o,--output", options.outputs,
      "file to write, format by its ending: " + formats +
          "svg (a picture), html (a page to look into it), qarr (exact); '-' for standard output; may be repeated");
  command.add_option("--format", options.format, "format of standard output: an ending without its dot");
  command.add_flag("--labels", options.labels, "numbers of cells in pictures");
}

void add_drawings(CLI::App& command, Options& options) {
  command
      .add_option("files", options.inputs,
                  "drawings: wkt, geojson, svg paths, dxf; qarr; '-' for standard input; or WKT itself")
      ->required();
}

void add_planar(CLI::App& app, Options& options) {
  CLI::App* arrange =
      add_command(app, options, "arrange", "what curves of the plane divide it into: vertices, edges, faces");
  add_drawings(*arrange, options);
  add_pictures(*arrange, options, "");
  arrange->add_flag("--sphere", options.sphere,
                    "curves on the sphere: a text with lines 'arc' and two directions, 'circle' and a normal, 'point'");
  CLI::App* overlay = add_command(app, options, "overlay", "several arrangements over one another, a file each");
  add_drawings(*overlay, options);
  add_pictures(*overlay, options, "");
  CLI::App* locate = add_command(app, options, "locate", "which vertex, edge or face of an arrangement holds a point");
  add_drawings(*locate, options);
  add_repeatable(*locate, "--point", options.points, "x,y (may be repeated)");
  locate->add_option("--points", options.points_file, "file with a point per line; '-' for standard input");
  add_pictures(*locate, options, "");
  CLI::App* polygon = add_command(app, options, "polygon", "sets of points bounded by segments and arcs, a file each");
  polygon
      ->add_option("operation", options.operation,
                   "union, intersection, difference, xor; minkowski: the sum of two sets; offset: what is within a "
                   "distance of a set")
      ->required()
      ->check(CLI::IsMember({"union", "intersection", "difference", "xor", "minkowski", "offset"}));
  add_drawings(*polygon, options);
  add_pictures(*polygon, options, "wkt geojson dxf (certified), ");
  polygon->add_option("--fill", options.fill,
                      "read rings that cross by a rule: even-odd, nonzero, positive (default: they are refused)");
  add_number(*polygon, "--flatten", options.flatten, above_zero,
             "chords no further than this from arcs, where a format has no arcs");
  polygon->add_flag("--plain", options.plain, "without regularization: edges and points without area stay");
  add_exact_number(*polygon, "--distance", options.distance, any_number, "of offset; below zero: an inset");
  add_exact_number(*polygon, "--precision", options.precision, above_zero,
                   "of offset: how far the radius may be off, where it cannot be exact (default: 2^-20 of it)");
  polygon->add_flag("--inner", options.inner,
                    "of offset: write what lies within the exact one (default: what holds it)");
  polygon->add_flag("--tight", options.tight, "of minkowski: also slits and points that only the open sets leave free");
  polygon->add_flag("--reflect", options.reflect,
                    "of minkowski: of the first set and the second turned by half a turn");
  CLI::App* envelope = add_command(app, options, "envelope", "the lowest, or highest, of curves over every x");
  add_drawings(*envelope, options);
  add_pictures(*envelope, options, "wkt geojson dxf, ");
  envelope->add_flag("--upper", options.upper, "the highest points instead of the lowest");
  add_number(*envelope, "--flatten", options.flatten, above_zero,
             "chords no further than this from arcs, where a format has no arcs");
}

void add_ball(CLI::App& command, Options& options, const std::string& inner) {
  add_number(command, "--ball", options.ball, above_zero, "a ball of this radius instead of a second solid");
  add_number(command, "--within", options.within, above_zero,
             "how far off the polytope that stands for the ball may be (default: a hundredth of the radius)");
  command.add_flag("--inner", options.inner, inner);
}

void add_solid_sums(CLI::App& app, Options& options) {
  CLI::App* minkowski = add_maker(app, options, "minkowski", "the sum of solids, exactly: all sums of a point of each");
  minkowski
      ->add_option("files", options.inputs, "two or more meshes, .qsolid, or files of points, which mean their hull")
      ->required()
      ->expected(1, 1 << 20);
  add_ball(*minkowski, options, "of --ball: what lies within the exact sum (default: what holds it)");
  CLI::App* erode = add_maker(app, options, "erode", "where the second solid fits into the first, exactly");
  erode->add_option("files", options.inputs, "two meshes, .qsolid, or files of points, which mean their hull")
      ->required()
      ->expected(1, 2);
  add_ball(*erode, options, "of --ball: what lies within the exact erosion (default: what holds it)");
  add_one_file(*add_maker(app, options, "decompose", "a solid as few convex pieces, a file for each"), options);
}

void add_distance(CLI::App& app, Options& options) {
  CLI::App* distance =
      add_command(app, options, "distance", "whether two solids are apart, touch or overlap, and how far");
  distance->add_option("files", options.inputs, "two meshes, .qsolid, or files of points, which mean their hull")
      ->required()
      ->expected(2);
  distance->add_option("--translate", options.translation, "x,y,z: the first solid is moved by that");
  distance->add_option("--direction", options.direction,
                       "x,y,z: how far the first goes that way to leave the second, of convex solids");
  distance->add_option("--path", options.path,
                       "file with a place per line that the first is moved to, in turn; '-' for standard input");
  add_repeatable(*distance, "-o,--output", options.outputs,
                 "with --path: SVG drawing of the trail, from above; '-' for standard output; may be repeated");
}

void add_commands(CLI::App& app, Options& options) {
  add_booleans(app, options);
  add_files(*add_command(app, options, "info", "what a solid is: volume, area, counts, bounds, centroid"), options);
  add_files(*add_command(app, options, "check", "whether files bound valid solids, and what is wrong if not"), options);
  add_one_file(*add_maker(app, options, "repair", "orientation, duplicate and degenerate faces, self-crossings"),
               options);
  add_one_file(*add_maker(app, options, "convert", "one format to another, faces merged where coplanar"), options);
  add_one_file(*add_maker(app, options, "view", "a page to look at a solid in the browser"), options);
  add_files(*add_maker(app, options, "hull", "the convex hull of the vertices of all files, exactly"), options);
  add_solid_sums(app, options);
  CLI::App* map =
      add_command(app, options, "gaussian-map", "the directions in which each vertex of a convex solid is extreme");
  add_one_file(*map, options);
  add_pictures(*map, options, "");
  map->add_flag("--cube", options.cube, "on the six squares of a cube instead of the sphere");
  add_distance(app, options);
  add_one_file(*add_command(app, options, "width",
                            "of a convex solid: least distance of parallel planes about it, diameter, smallest ball"),
               options);
  add_topology(app, options);
  add_point_commands(app, options);
  add_constrained(app, options);
  add_queries(app, options);
  add_assembly(app, options);
  add_planar(app, options);
}

}  // namespace

std::optional<int> parse_arguments(int argc, char** argv, Options& options) {
  CLI::App app(
      "Quoin: exact Booleans of solids, arrangements and polygons of the plane.\n\nExit codes: 0 done, 1 refused with "
      "a reason, 2 usage, 3 file trouble, 4 "
      "cancelled or out of time.");
  app.name("quoin");
  app.set_version_flag("--version", "quoin " QUOIN_VERSION);
  app.require_subcommand(1);
  add_commands(app, options);
  try {
    app.parse(argc, argv);
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    const bool wants_json =
        std::any_of(argv + 1, argv + argc, [](const char* word) { return std::string_view(word) == "--json"; });
    if (error.get_exit_code() == 0) return app.exit(error);
    if (wants_json) std::cout << as_json(Failure{error.what(), exit_usage}).dump(2) << "\n";
    app.exit(error);
    return exit_usage;
  }
}

}  // namespace quoin::cli
