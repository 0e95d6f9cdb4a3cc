// SPDX-License-Identifier: Apache-2.0
#include "quoin/flow/unstable_sheet.h"

#include <algorithm>
#include <map>

#include "quoin/base/error.h"
#include "quoin/flow/facet_formulas.h"

namespace quoin {

namespace {

using flow::FacetLine;
using flow::LineFromMidpoint;
using flow::Vector;

bool is_empty(const VoronoiInterval& part) {
  return part.low && part.high && *part.low >= *part.high;
}

/// constant + slope * t.
struct Linear {
  Rational constant;
  Rational slope;

  Linear operator-(const Linear& other) const { return {constant - other.constant, slope - other.slope}; }
  Rational at(const Rational& t) const { return constant + slope * t; }
};

/// Cuts off where the function is negative.
void cut_to_positive(VoronoiInterval& part, const Linear& f) {
  if (f.slope.sign() == Sign::zero) {
    if (f.constant.sign() == Sign::negative) part.low = part.high = Rational(0);
    return;
  }
  const Rational root = -f.constant / f.slope;
  std::optional<Rational>& end = f.slope.sign() == Sign::positive ? part.low : part.high;
  const bool is_inside = !end || (f.slope.sign() == Sign::positive ? root >= *end : root <= *end);
  if (is_inside) end = root;
}

/// What is left of a part outside disjoint others.
std::vector<VoronoiInterval> without(const VoronoiInterval& part, const std::vector<VoronoiInterval>& others) {
  std::vector<VoronoiInterval> left{part};
  for (const VoronoiInterval& other : others) {
    std::vector<VoronoiInterval> next;
    for (const VoronoiInterval& piece : left) {
      VoronoiInterval before = piece;
      if (other.low && (!before.high || *other.low < *before.high)) before.high = other.low;
      if (other.low && !is_empty(before)) next.push_back(before);
      VoronoiInterval behind = piece;
      if (other.high && (!behind.low || *other.high > *behind.low)) behind.low = other.high;
      if (other.high && !is_empty(behind)) next.push_back(behind);
    }
    left = std::move(next);
  }
  return left;
}

/// The lines of a facet as seen from a Voronoi edge on its boundary: 1 / lambda of each as a function of t. The largest
/// one that is positive is where the flow leaves.
struct FacetExits {
  struct Line {
    std::uint32_t polygon;
    Linear inverse;
    Linear along;  ///< y . normal over the normal's square
  };
  std::vector<Line> lines;

  FacetExits(const FlowComplex& flow, std::uint32_t edge, std::uint32_t polygon) {
    const DeloneFaces& faces = flow.faces();
    const LineFromMidpoint<Rational> from(flow, edge, polygon, faces.apex(polygon, faces.side_of(polygon, edge)));
    const Vector<Rational> start = from.at(Rational(0));
    const Vector<Rational> direction = flow::normal<Rational>(flow, polygon);
    for (const RingPolygon& g : faces.ring(edge)) {
      const FacetLine<Rational> line(flow, edge, g.apex);
      if (line.power.sign() != Sign::positive) continue;
      const Vector<Rational> normal = flow::normal<Rational>(flow, g.polygon);
      const Rational square = dot(normal, normal);
      lines.push_back({g.polygon,
                       {dot(start, line.direction) / line.power, dot(direction, line.direction) / line.power},
                       {dot(start, normal) / square, dot(direction, normal) / square}});
    }
  }
};

/// Where t goes on the line: along / inverse; at infinity the quotient of slopes; nothing where it goes to infinity.
std::optional<Rational> image(const FacetExits::Line& line, const std::optional<Rational>& t) {
  const Rational below = t ? line.inverse.at(*t) : line.inverse.slope;
  if (below.sign() == Sign::zero) return std::nullopt;
  return (t ? line.along.at(*t) : line.along.slope) / below;
}

class Sheet {
 public:
  Sheet(const FlowComplex& flow, std::uint32_t edge) : flow_(flow), faces_(flow.faces()), sheet_{} {
    sheet_.edge = edge;
  }

  UnstableSheet run(const Context& context) {
    start();
    while (!open_.empty()) {
      context.poll();
      const VoronoiInterval next = std::move(open_.back());
      open_.pop_back();
      for (const VoronoiInterval& part : without(next, done_[next.polygon])) {
        done_[part.polygon].push_back(part);
        follow(part);
      }
    }
    for (std::vector<std::uint32_t>* list : {&sheet_.cells, &sheet_.saddles}) {
      std::sort(list->begin(), list->end());
      list->erase(std::unique(list->begin(), list->end()), list->end());
    }
    return std::move(sheet_);
  }

 private:
  void start() {
    sheet_.pieces.push_back({sheet_.edge});
    sheet_.is_infinite = faces_.ring(sheet_.edge).empty();
    for (const RingPolygon& g : faces_.ring(sheet_.edge)) {
      VoronoiInterval whole{g.polygon};
      for (std::size_t side = 0; side < 2; ++side) {
        const std::uint32_t cell = faces_.cells_of_polygon(g.polygon)[side];
        sheet_.is_infinite |= cell == DeloneFaces::outside;
        if (cell == DeloneFaces::outside) continue;
        sheet_.cells.push_back(cell);
        (side == 0 ? whole.low : whole.high) = place_of(cell, g.polygon);
      }
      open_.push_back(whole);
    }
  }

  Rational place_of(std::uint32_t cell, std::uint32_t polygon) const {
    const std::span<const std::uint32_t> corners = faces_.polygon(polygon);
    for (const std::uint32_t v : faces_.cell(cell)) {
      if (std::find(corners.begin(), corners.end(), v) != corners.end()) continue;
      return flow::place_of_cell<Rational>(flow_, polygon, v);
    }
    return {};
  }

  void follow(const VoronoiInterval& part) {
    note_vertices(part);
    const DeloneFace crossed = flow_.crossed({2, part.polygon});
    if (crossed.dimension == 2) {
      follow_along(part);
    } else {
      follow_through(part, crossed.index);
    }
  }

  /// The Voronoi vertices at which a part ends.
  void note_vertices(const VoronoiInterval& part) {
    for (const std::uint32_t cell : faces_.cells_of_polygon(part.polygon)) {
      if (cell == DeloneFaces::outside) continue;
      const Rational t = place_of(cell, part.polygon);
      if (t == part.low || t == part.high) sheet_.cells.push_back(cell);
    }
  }

  void follow_along(const VoronoiInterval& part) {
    const Sign low = part.low ? part.low->sign() : Sign::negative;
    const Sign high = part.high ? part.high->sign() : Sign::positive;
    const bool is_at_end = low == Sign::zero || high == Sign::zero;
    const bool is_inside = low == Sign::negative && high == Sign::positive;
    if (is_inside && flow_.is_critical({2, part.polygon})) sheet_.saddles.push_back(part.polygon);
    if (is_at_end || (is_inside && flow_.kind({2, part.polygon}) == FlowKind::regular)) sheet_.is_ordinary = false;
    sheet_.along.push_back(part);
    if (low == Sign::negative) reach(faces_.cells_of_polygon(part.polygon)[0]);
    if (high == Sign::positive) reach(faces_.cells_of_polygon(part.polygon)[1]);
  }

  /// The flow along a Voronoi edge ends there.
  void reach(std::uint32_t cell) {
    sheet_.is_infinite |= cell == DeloneFaces::outside;
    if (cell != DeloneFaces::outside) sheet_.cells.push_back(cell);
  }

  void follow_through(const VoronoiInterval& part, std::uint32_t edge) {
    sheet_.pieces.push_back({edge, part});
    const FacetExits exits(flow_, edge, part.polygon);
    bool lands = false;
    for (const FacetExits::Line& line : exits.lines) {
      VoronoiInterval from = part;
      cut_to_positive(from, line.inverse);
      for (const FacetExits::Line& other : exits.lines) {
        if (other.polygon == line.polygon) continue;
        cut_to_positive(from, line.inverse - other.inverse);
      }
      if (is_empty(from)) continue;
      open_.push_back(landed(line, from));
      lands = true;
      sheet_.is_infinite |= !open_.back().low || !open_.back().high;
    }
    sheet_.is_infinite |= !lands;
  }

  static VoronoiInterval landed(const FacetExits::Line& line, const VoronoiInterval& from) {
    VoronoiInterval to{line.polygon, image(line, from.low), image(line, from.high)};
    // The derivative of the quotient has one sign.
    const Rational turn = line.along.slope * line.inverse.constant - line.along.constant * line.inverse.slope;
    if (turn.sign() == Sign::negative) std::swap(to.low, to.high);
    return to;
  }

  const FlowComplex& flow_;
  const DeloneFaces& faces_;
  UnstableSheet sheet_;
  std::vector<VoronoiInterval> open_;
  std::map<std::uint32_t, std::vector<VoronoiInterval>> done_;
};

}  // namespace

UnstableSheet unstable_sheet(const FlowComplex& flow, std::uint32_t edge, const Context& context) {
  if (edge >= flow.faces().count(1) || !flow.is_critical({1, edge})) {
    throw InputError("an unstable sheet of an edge that is not critical");
  }
  return Sheet(flow, edge).run(context);
}

}  // namespace quoin
