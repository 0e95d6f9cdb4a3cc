// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "quoin/arrangement/circular/circular_polygon_set.h"
#include "quoin/arrangement/geodesic/geodesic_polygon_set.h"
#include "quoin/arrangement/linear/linear_polygon_set.h"
#include "quoin/base/context.h"

namespace quoin {

/// Which cells of an arrangement belong to a set, by id; what is not real is ignored.
struct CellMembers {
  std::vector<bool> vertices;
  std::vector<bool> edges;
  std::vector<bool> faces;
};

/// Writes an arrangement exactly: supports in exact numbers, vertices by their definitions, edges with their curves.
/// Text, lines, described in docs/exact-text.md. Cells are numbered in lexicographic order whatever their ids are, dead
/// ones are left out, and so are supports that nothing refers to. `names` of the curves: none, or one each.
/// @throws InputError for another number of names
template <CurveFamily F>
void write_arrangement_text(std::ostream& out, const Arrangement<F>& arrangement,
                            std::span<const std::string> names = {});
/// The same of a set, with its members.
template <CurveFamily F>
void write_arrangement_text(std::ostream& out, const PolygonSet<F>& set, std::span<const std::string> names = {});

/// Into a file. @throws FileError
template <class ArrangementOrSet>
void write_arrangement_text(const std::filesystem::path& path, const ArrangementOrSet& what,
                            std::span<const std::string> names = {});

/// What an exact text holds.
template <CurveFamily F>
struct ArrangementText {
  Arrangement<F> arrangement;
  std::vector<std::string> names;  ///< of the curves, if it has them
  std::optional<CellMembers> members;

  /// The set, if it is one.
  std::optional<PolygonSet<F>> set() const {
    if (!members) return std::nullopt;
    return PolygonSet<F>(arrangement, members->vertices, members->edges, members->faces);
  }
};
using AnyArrangementText =
    std::variant<ArrangementText<LinearFamily>, ArrangementText<CircularFamily>, ArrangementText<GeodesicFamily>>;

/// Reads an exact text back without loss; written again it is the same, byte for byte. The cells are built anew by a
/// sweep, and what the text says is checked exactly on the way: ends lie on their edges, edges meet in their ends only,
/// vertices and edges are in order, the faces are as many. O(n log n).
/// @throws InputError with file and line; Cancelled
AnyArrangementText read_arrangement_text(std::string_view text, const std::string& name, const Context& context);

/// Whether a text begins like one of these.
bool is_arrangement_text(std::string_view text);

}  // namespace quoin
