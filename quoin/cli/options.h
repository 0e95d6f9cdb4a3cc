// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "quoin/number/rational.h"

namespace quoin::cli {

/// The name that stands for standard input or standard output.
inline constexpr const char* standard_stream = "-";

/// What all commands understand.
struct Options {
  std::string command;
  std::vector<std::string> inputs;    ///< files, or "-" for standard input; of `csg`: NAME=FILE
  std::vector<std::string> outputs;   ///< files with a known ending, "-" for standard output
  std::string format;                 ///< of "-" among the outputs: an ending without its dot; empty: OFF
  std::string expression;             ///< of `csg`
  std::vector<std::string> points;    ///< of `classify`: "x,y,z"
  std::vector<std::string> lines;     ///< of `classify`: "x,y,z,dx,dy,dz"
  std::string points_file;            ///< of `classify`: a point per line; of `constrained`: more points
  std::vector<std::string> primes;    ///< of `homology`, `persistence`, `alpha`: numbers of elements of fields
  std::string translation;            ///< of `distance`: "x,y,z"
  std::string direction;              ///< of `distance`: "x,y,z"
  std::string path;                   ///< of `distance`: a place per line, "-" for standard input
  std::string plane;                  ///< of `section`: "a,b,c,d"
  std::string operation;              ///< of `polygon`
  std::string fill;                   ///< of `polygon`: how rings that cross are read; empty: they are refused
  std::optional<Rational> distance;   ///< of `polygon offset`; below zero: an inset
  std::optional<Rational> precision;  ///< of `polygon offset`: how far the radius may be off; 2^-20 of it
  std::optional<double> ball;         ///< of `minkowski` and `erode`: a ball of this radius instead of a second solid
  std::optional<double> within;   ///< of the same: how far a polytope may be from the ball; a hundredth of its radius
  std::optional<double> flatten;  ///< chords instead of arcs, no further than this from them
  bool plain = false;             ///< of `polygon`: edges and points without area stay
  bool inner = false;             ///< of offsets: what lies within the exact one is written
  bool tight = false;             ///< of `polygon minkowski`: tight places too
  bool reflect = false;           ///< of `polygon minkowski`: the second set turned by half a turn
  bool labels = false;            ///< numbers in pictures
  bool sphere = false;            ///< of `arrange`: curves on the sphere
  bool barcode = false;           ///< of `persistence` and `alpha`: bars instead of points
  bool persistence = false;       ///< of `alpha`: when classes of homology come and go
  bool cube = false;              ///< of `gaussian-map`: on the surface of a cube
  bool upper = false;             ///< of `envelope`
  std::vector<std::string> directions;  ///< of `assembly`: "x,y,z"
  std::string base;                     ///< of `assembly`: the part that stays
  std::size_t limit = 10'000;           ///< of `assembly`: solutions listed
  bool sequence = false;                ///< of `assembly`
  bool sequence_only = false;           ///< of `assembly`: without all solutions
  bool infinitesimal = false;           ///< of `assembly`: only what can begin to move
  bool prune = false;                   ///< of `assembly`: first leave out where nothing moves
  bool one_part = false;                ///< of `assembly`: one part at a time
  std::string
      input_format;  ///< of `delaunay`, `voronoi`, `alpha`, `flow`: a name of PointFormat; empty: told by content
  bool onto_plane = false;            ///< of the same: x and y count
  bool weighted = false;              ///< of `delaunay`, `voronoi`, `alpha`: the last column is a weight
  bool check = false;                 ///< of `delaunay`: prove the result
  bool delone = false;                ///< of `delaunay`: outputs hold Delone cells
  bool inside = false;                ///< of `constrained`: outputs hold what is inside
  bool cells = false;                 ///< of `voronoi`: each cell in the report
  bool exact = false;                 ///< of `voronoi`: exact volumes at any length; of `alpha`: exact values
  std::optional<double> memory;       ///< of the same: megabytes
  std::optional<Rational> value;      ///< of `alpha`: a squared radius
  std::optional<Rational> radius;     ///< of `alpha`
  std::optional<std::size_t> pieces;  ///< of `alpha`: no more than these
  bool values = false;                ///< of `alpha`: all critical values in the report
  std::string graph;                  ///< of `alpha`: gabriel, relative-neighbours or spanning-tree
  int stable = 0;                     ///< of `flow`: an index, or 0
  int unstable = 0;                   ///< of `flow`
  std::optional<Rational> shape;      ///< of `flow`: a distance
  std::optional<Rational> simplify;   ///< of `flow`: a difference of distances
  bool reconstruct = false;           ///< of `flow`
  std::optional<Rational> ratio;      ///< of `flow`
  bool separate = false;              ///< of `flow`: points of the surface from medial ones
  bool json = false;
  bool quiet = false;
  bool verbose = false;
  bool accept_rounding = false;
  unsigned threads = 0;
  std::uint64_t seed = 0;
  std::optional<double> timeout;  ///< seconds
  std::optional<double> weld_tolerance;
};

}  // namespace quoin::cli
