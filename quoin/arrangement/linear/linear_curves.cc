// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "quoin/arrangement/linear/linear_family.h"
#include "quoin/base/error.h"

namespace quoin {

void LinearFamily::add_piece(PieceList<LinearFamily>& list, BranchId line, const Point& source, const Point& target,
                             CurveId curve) const {
  const bool reversed = compare_xy(source, target) == Sign::positive;
  Piece piece{line, list.add_point(source), list.add_point(target), curve, reversed};
  if (reversed) std::swap(piece.left, piece.right);
  list.pieces.push_back(piece);
}

CurveId LinearFamily::add_segment(PieceList<LinearFamily>& list, const Point2& source, const Point2& target,
                                  std::string_view name) {
  const BranchId line = add_line(source, target, name);
  const CurveId curve(list.curve_count++);
  add_piece(list, line, point(source), point(target), curve);
  return curve;
}

CurveId LinearFamily::add_segment(PieceList<LinearFamily>& list, const RationalPoint2& source,
                                  const RationalPoint2& target, std::string_view name) {
  const BranchId line = add_line(source, target, name);
  const CurveId curve(list.curve_count++);
  const Point from = point(source);
  add_piece(list, line, from, point(target), curve);
  return curve;
}

CurveId LinearFamily::add_ray(PieceList<LinearFamily>& list, const Point2& source, const Point2& through,
                              std::string_view name) {
  const BranchId line = add_line(source, through, name);
  const CurveId curve(list.curve_count++);
  const bool backwards = lexicographically_less(through, source);
  add_piece(list, line, point(source), backwards ? first_end(line) : last_end(line), curve);
  return curve;
}

CurveId LinearFamily::add_line(PieceList<LinearFamily>& list, const Point2& a, const Point2& b, std::string_view name) {
  const BranchId line = add_line(a, b, name);
  const CurveId curve(list.curve_count++);
  const bool backwards = lexicographically_less(b, a);
  add_piece(list, line, backwards ? last_end(line) : first_end(line), backwards ? first_end(line) : last_end(line),
            curve);
  return curve;
}

CurveId LinearFamily::add_polyline(PieceList<LinearFamily>& list, const std::vector<Point2>& vertices, bool closed,
                                   std::string_view name) {
  if (vertices.size() < 2) throw InputError(std::string(name) + ": a polyline needs two vertices");
  const std::size_t edges = closed ? vertices.size() : vertices.size() - 1;
  for (std::size_t i = 0; i < edges; ++i) {
    if (vertices[i] == vertices[(i + 1) % vertices.size()]) {
      throw InputError(std::string(name) + ": vertices " + std::to_string(i) + " and " +
                       std::to_string((i + 1) % vertices.size()) + " are equal");
    }
  }
  const auto begin = static_cast<std::uint32_t>(list.points.size());
  for (const Point2& vertex : vertices) list.add_point(point(vertex, name));
  const CurveId curve(list.curve_count++);
  for (std::size_t i = 0; i < edges; ++i) {
    const std::size_t j = (i + 1) % vertices.size();
    const BranchId line = add_line(vertices[i], vertices[j], name);
    const bool reversed = lexicographically_less(vertices[j], vertices[i]);
    const std::uint32_t from = begin + static_cast<std::uint32_t>(reversed ? j : i);
    const std::uint32_t to = begin + static_cast<std::uint32_t>(reversed ? i : j);
    list.pieces.push_back({line, from, to, curve, reversed});
  }
  return curve;
}

CurveId LinearFamily::add_point(PieceList<LinearFamily>& list, const Point2& p, std::string_view name) {
  const CurveId curve(list.curve_count++);
  list.lone_points.push_back({list.add_point(point(p, name)), curve});
  return curve;
}

}  // namespace quoin
