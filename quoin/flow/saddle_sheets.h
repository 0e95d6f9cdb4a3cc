// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/flow/cell_crossing.h"

namespace quoin {

/// An end of a part of a Voronoi edge.
struct SheetEnd {
  /// Where the Voronoi edge itself ends, in a Voronoi vertex or at infinity: -1 below, 1 above; 0 at a point of the
  /// chain. Above is where the simplex of the facet is that names the polygon.
  int side = 0;
  std::uint32_t point = CrossingChain::none;
  bool is_up = true;  ///< the normal of the point's triangle points above
};

/// A part of the Voronoi edge of a polygon.
struct SheetPart {
  CellFacet polygon{};  ///< that names it
  SheetEnd low{.side = -1};
  SheetEnd high{.side = 1};
};

/// A corner of a piece of a sheet.
struct SheetCorner {
  bool is_constructed = false;  ///< a point of the chain; else a Delone cell, by its first simplex: its centre
  std::uint32_t place = 0;
  friend bool operator==(const SheetCorner&, const SheetCorner&) = default;
};

/// A part of the Voronoi facet of an edge: a convex polygon.
struct CellSheetPiece {
  std::array<std::uint32_t, 2> edge{};  ///< vertices of the triangulation
  SheetPart entry{};                    ///< of no meaning for the first piece, which is the whole facet
  std::size_t first_corner = 0;         ///< among the corners of the sheet; the last one is before that of the next
  bool is_bounded = true;               ///< else corners at infinity are missing
};

/// What UnstableSheet has, on simplices.
struct CellSheet {
  std::vector<CellSheetPiece> pieces;
  std::vector<SheetCorner> corners;
  std::vector<SheetPart> along;      ///< parts of Voronoi edges that the flow follows, where the surface ends
  std::vector<std::uint32_t> cells;  ///< Voronoi vertices on the boundaries of both, ascending; their ways belong to it
  std::vector<CellFacet> saddles;    ///< critical polygons whose centres are inside those parts, ascending
  std::size_t parts = 0;  ///< of Voronoi edges, joined where they touch: does not depend on the order of following
  bool is_infinite = false;
  bool has_regular_point = false;   ///< a stationary point that is not critical is inside a part
  bool has_stationary_end = false;  ///< an end of a part is a stationary point: neighbours end elsewhere

  bool is_ordinary() const { return !has_regular_point && !has_stationary_end; }
};

/// Which parts of a sheet are followed.
enum class SheetParts : std::uint8_t {
  all,   ///< each sheet is told as a whole
  fresh  ///< those that no sheet before it had: all sheets together, each part once
};

/// Unstable sheets of critical points of index 1, one after another, for surveys of all of them: what unstable_sheet
/// tells. A convex facet is left between the exits of the ends of the interval in which it is entered, so that a part
/// costs two crossings; doubles with bounds decide, and exact numbers where they cannot.
///
/// Sheets run as far as ways do, and several ones run on together where ways have met: k parts of a sheet are O(k)
/// crossings, and all sheets together are more than linear in the points (bench/flow_bench.cc).
class SaddleSheets {
 public:
  /// The cells must outlive it.
  explicit SaddleSheets(const FlowCells& flow, SheetParts parts = SheetParts::all)
      : flow_(flow), crosser_(flow), parts_(parts) {}

  /// Of a critical edge, by its number in a simplex. The sheet is valid until the next call, and so is what the chain
  /// says of its points; of fresh parts all points stay, and `parts` counts those of all sheets so far.
  /// @throws Cancelled
  const CellSheet& follow(std::uint32_t cell, unsigned edge, const Context& context);

  CrossingChain& chain() { return crosser_.chain(); }
  const CellCrosser& crosser() const { return crosser_; }

 private:
  /// Of the ring around a facet's edge: on a spoke, or where the last of the facet before the next spoke ends.
  struct Exit {
    std::size_t spoke = 0;
    SheetEnd end{.side = 1};  ///< the point on the spoke's Voronoi edge; of another side if it is none
    bool is_point() const { return end.side == 0; }
  };
  void gather(const CellSide& side);
  bool is_gap(std::size_t spoke) const { return !ring_[spoke].is_joined; }
  std::size_t place_of_cell(std::uint32_t first) const;

  void start(const CellSide& side);
  void add(const SheetPart& part);
  void follow(const SheetPart& part);
  void follow_along(const SheetPart& part);
  void follow_through(const SheetPart& part, const CellSide& side);
  Exit exit(const SheetEnd& end, bool is_high, const CellSide& side);
  Exit exit_of_vertex(bool is_high, const CellSide& side);
  Exit exit_of(const CellExit& found) const;
  SheetPart part_of_spoke(std::size_t spoke, const SheetEnd* from, const SheetEnd* to) const;
  void leave_open();
  void add_corner(const SheetCorner& corner);
  void add_vertex(std::size_t spoke);
  void add_exit(const Exit& exit);
  void add_end(CellFacet polygon, const SheetEnd& end);
  Sign sign_of(CellFacet polygon, const SheetEnd& end);
  int compare(const SheetEnd& a, const SheetEnd& b);

  const FlowCells& flow_;
  CellCrosser crosser_;
  SheetParts parts_;
  CellSheet sheet_;
  std::vector<FacetSpoke> ring_;
  std::vector<SheetPart> open_;
  /// By the number of the polygon: disjoint parts that were followed, ascending.
  std::unordered_map<std::uint32_t, std::vector<SheetPart>> done_;
  std::size_t joined_ = 0;  ///< how many those are
  // Neighbouring parts have ends in common, which go to the same points: those are constructed once, so that nobody has
  // to find out by exact numbers that they are equal.
  std::unordered_map<std::uint32_t, CellExit> exit_of_vertex_;  ///< by Delone cell
  std::unordered_map<std::uint32_t, CellExit> exit_of_point_;
};

}  // namespace quoin
