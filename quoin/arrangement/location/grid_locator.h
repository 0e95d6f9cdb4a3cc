// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "quoin/arrangement/location/naive_locator.h"
#include "quoin/arrangement/location/trapezoid_locator.h"
#include "quoin/kernel/point.h"

namespace quoin {

/// What a grid asks of a family of the plane besides the concept. To be specialized with two static functions:
///   - `point(Point2)`: the point of two doubles;
///   - `turning_point(family, branch)`: the place off the ends where the branch turns between rising and falling, if
///     there is one; each coordinate within `error()`.
template <class F>
struct GridTraits;

template <class F>
concept GridFamily = CurveFamily<F> && std::same_as<typename F::Position, Point2> &&
    requires(const F& f, BranchId b, const Point2& p) {
  { GridTraits<F>::point(p) } -> std::same_as<typename F::Point>;
  { GridTraits<F>::turning_point(f, b) } -> std::same_as<std::optional<Point2>>;
};

/// Point location by a grid fitted to the arrangement: columns with equally many vertices, each cut into rows with
/// equally many edges. The fastest for many queries in ordinary arrangements; plane only.
///
/// A cell lists the edges that touch it and the face it lies in if there are none. A query looks for the nearest edge
/// below it in its cell, and in the cells under it until an edge is found that leaves the column no lower. Exact: cells
/// are only filters, listed with room for the rounding of points. Left and right of all vertices edges do not change
/// their order: bisection. Cells of more than `heavy` edges, and then also searches of more than `long_walk` cells, are
/// left to a trapezoidal map, which is only built if there are such cells. O(n log n) to build.
template <GridFamily F>
class GridLocator {
 public:
  using Point = typename F::Point;
  static constexpr std::uint32_t heavy = 64;
  static constexpr std::uint32_t long_walk = 8;

  /// @throws Cancelled
  explicit GridLocator(const Arrangement<F>& arrangement, const Context& context = Context())
      : arrangement_(&arrangement), outer_(arrangement) {
    rebuild(context);
  }

  Location locate(const Point& p) const;

  bool is_stale() const { return is_stale_; }
  void mark_stale() { is_stale_ = true; }
  /// @throws Cancelled
  void rebuild(const Context& context);

  std::size_t column_count() const { return columns_.size(); }
  std::size_t cell_count() const { return faces_.size(); }
  std::size_t entry_count() const { return entries_.size(); }
  bool has_map() const { return map_.has_value(); }

 private:
  /// An edge in a cell, or an isolated vertex.
  struct Entry {
    double left;               ///< key of the left end
    double right;              ///< key of the right end
    BranchId branch;           ///< none: a vertex
    std::uint32_t cell_flags;  ///< twice the edge or the vertex; plus one: in this column it touches the row below too

    std::size_t cell() const { return cell_flags / 2; }
    bool continues() const { return (cell_flags & 1U) != 0; }
  };
  struct Column {
    std::uint32_t first_cell;  ///< the lowest
    std::uint32_t row_count;
    std::uint32_t first_bound;  ///< row_count - 1 heights between rows
  };
  struct Rows {
    std::uint32_t low;
    std::uint32_t high;
  };
  /// The search for what lies just below a point.
  struct Search {
    const Point& point;
    double key;
    double margin;
    dcel::EdgeId best;
    bool continues;
  };

  double margin_of(double x) const;
  void find_columns(std::vector<double> keys, std::size_t edge_count);
  void fill(const Context& context);
  std::size_t column_of(double x) const;
  void choose_rows(std::span<const std::uint32_t> edges, std::span<const std::uint32_t> vertices, std::size_t column);
  double height_in(dcel::EdgeId e, std::size_t column) const;
  Rows rows_of(dcel::EdgeId e, std::size_t column) const;
  Rows rows_of_point(const Point2& p) const;
  Rows rows_at(double x, BranchId b) const;
  void place(const std::vector<std::pair<Rows, Entry>>& listed, std::size_t column);
  void find_faces(std::size_t column);
  Location locate_in_slab(const Point& p, const std::vector<dcel::EdgeId>& edges) const;
  Location locate_in_column(const Point& p, const Column& column, std::uint32_t row) const;
  std::optional<Location> search_cell(Search& search, std::uint32_t cell) const;
  static Sign compare_keys(double a, double b, double margin);
  Sign compare_end(const Search& search, double key, const Point& end) const;

  const Arrangement<F>* arrangement_;
  OuterFaces<F> outer_;
  std::vector<dcel::EdgeId> left_;   // that come from the left side, bottom to top
  std::vector<dcel::EdgeId> right_;  // that reach the right side, bottom to top
  std::vector<double> walls_;        // x between columns, and before and after all
  std::vector<Column> columns_;
  std::vector<double> bounds_;              // heights between rows, by column
  std::vector<std::uint32_t> begin_;        // of the entries of cells
  std::vector<Entry> entries_;              // by cell
  std::vector<dcel::FaceId> faces_;         // of empty cells
  std::optional<TrapezoidLocator<F>> map_;  // for heavy cells
  bool is_stale_ = false;

  // While it is built: the rows of the current column.
  std::span<const double> heights_;
};

}  // namespace quoin
