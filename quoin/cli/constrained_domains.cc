// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/constrained_domains.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "quoin/kernel/predicates2.h"
#include "quoin/number/interval.h"

namespace quoin::cli {

namespace {

constexpr std::uint32_t none = 0xFFFFFFFFU;
constexpr std::size_t poll_step = 1024;
constexpr double crossing_size = 1.5;
constexpr Color crossing_color{214, 96, 64, 255};

double displacement(const Rational& exact, double rounded) {
  return Interval::around(abs(exact - Rational(rounded))).upper();
}

RationalPoint3 in_space(const RationalPoint2& p) {
  return {p.x, p.y, Rational(0)};
}

}  // namespace

ConstrainedDomains::ConstrainedDomains(const ConstrainedDelaunay2& triangulation, bool inside_only,
                                       const Context& context)
    : triangulation_(triangulation), regions_(triangulation) {
  choose(inside_only, context);
}

void ConstrainedDomains::choose(bool inside_only, const Context& context) {
  const Triangulation2& links = triangulation_.links();
  std::vector<Place> place_of_piece(triangulation_.pieces().size(), Place{inside_only ? none : 0, 0});
  for (std::uint32_t i = 0; i < links.triangle_count(); ++i) {
    if (i % poll_step == 0) context.poll();
    const Triangle2 t(i);
    if (links.is_infinite(t)) continue;
    ++triangle_count_;
    inside_count_ += is_inside(t) ? 1 : 0;
    if (inside_only && !is_inside(t)) continue;
    triangles_.push_back(t);
    for (unsigned slot = 0; slot < 3; ++slot) {
      const Edge2 e(t, slot);
      const auto piece = triangulation_.piece(e);
      if (piece) place_of_piece[*piece] = std::min(place_of(t), place_of(links.twin(e).triangle()));
    }
  }
  for (std::size_t piece = 0; piece < place_of_piece.size(); ++piece) {
    if (place_of_piece[piece].depth != none) pieces_.push_back({piece, place_of_piece[piece]});
  }
  std::vector<bool> is_used(triangulation_.vertex_count(), !inside_only);
  for (const Triangle2 t : triangles_) {
    for (const Vertex2 v : links.corners(t)) is_used[v.index()] = true;
  }
  number_.assign(triangulation_.vertex_count(), none);
  for (std::size_t v = 0; v < is_used.size(); ++v) {
    if (!is_used[v]) continue;
    number_[v] = static_cast<std::uint32_t>(vertices_.size());
    vertices_.emplace_back(v);
  }
}

std::uint32_t ConstrainedDomains::largest_depth() const {
  std::uint32_t largest = 0;
  for (std::uint32_t r = 0; r < regions_.count(); ++r) largest = std::max(largest, regions_.depth(r));
  return largest;
}

std::array<std::uint32_t, 3> ConstrainedDomains::corners(Triangle2 t) const {
  const std::array<Vertex2, 3> v = triangulation_.links().corners(t);
  return {number_[v[0].index()], number_[v[1].index()], number_[v[2].index()]};
}

std::array<std::uint32_t, 2> ConstrainedDomains::ends(std::size_t piece) const {
  const SegmentPieces2::Piece& at = triangulation_.pieces()[piece];
  return {number_[at.source.index()], number_[at.target.index()]};
}

RoundedCrossings ConstrainedDomains::rounding(const Context& context) const {
  RoundedCrossings found;
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    if (i % poll_step == 0) context.poll();
    if (!is_constructed(vertices_[i])) continue;
    const RationalPoint2 exact = triangulation_.exact(vertices_[i]);
    const Point2 rounded = triangulation_.rounded(vertices_[i]);
    const double moved = std::max(displacement(exact.x, rounded.x), displacement(exact.y, rounded.y));
    found.points += moved > 0 ? 1 : 0;
    found.max_displacement = std::max(found.max_displacement, moved);
  }
  if (found.points == 0) return found;
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    if (i % poll_step == 0) context.poll();
    const std::array<Vertex2, 3> v = triangulation_.links().corners(triangles_[i]);
    if (std::ranges::none_of(v, [this](Vertex2 corner) { return is_constructed(corner); })) continue;
    const Sign turn =
        orientation(triangulation_.rounded(v[0]), triangulation_.rounded(v[1]), triangulation_.rounded(v[2]));
    found.turned_triangles += turn == Sign::positive ? 0 : 1;
  }
  return found;
}

VtkGrid ConstrainedDomains::grid() const {
  VtkGrid grid;
  std::vector<std::uint32_t> constructed;
  for (const Vertex2 v : vertices_) {
    const Point2 p = triangulation_.rounded(v);
    grid.points.push_back({p.x, p.y, 0});
    constructed.push_back(is_constructed(v) ? 1 : 0);
  }
  grid.point_integers = {{"constructed", std::move(constructed)}};
  grid.cell_integers = {{"domain", {}}, {"depth", {}}, {"piece", {}}};
  const auto add = [&grid](VtkCell type, std::span<const std::uint32_t> numbers, const Place& place) {
    grid.add_cell(type, numbers);
    grid.cell_integers[0].second.push_back(place.domain);
    grid.cell_integers[1].second.push_back(place.depth);
    grid.cell_integers[2].second.push_back(type == VtkCell::line ? 1 : 0);
  };
  for (const Triangle2 t : triangles_) add(VtkCell::triangle, corners(t), place_of(t));
  for (const auto& [piece, place] : pieces_) add(VtkCell::line, ends(piece), place);
  return grid;
}

ExactCells ConstrainedDomains::exact_cells(const Context& context) const {
  ExactCells cells;
  cells.dimension = 2;
  std::vector<std::uint32_t> constructed;
  for (const Vertex2 v : vertices_) {
    if (constructed.size() % poll_step == 0) context.poll();
    cells.add_point(in_space(triangulation_.exact(v)));
    constructed.push_back(is_constructed(v) ? 1 : 0);
  }
  cells.point_data.integers = {{"constructed", std::move(constructed)}};
  cells.cell_data.integers = {{"domain", {}}, {"depth", {}}, {"segment", {}}};
  const auto add = [&cells](std::span<const std::uint32_t> numbers, const Place& place, std::uint32_t segment) {
    cells.add_cell(ExactCellKind::simplex, numbers);
    cells.cell_data.integers[0].second.push_back(place.domain);
    cells.cell_data.integers[1].second.push_back(place.depth);
    cells.cell_data.integers[2].second.push_back(segment);
  };
  for (const Triangle2 t : triangles_) add(corners(t), place_of(t), ExactColumns::none);
  for (const auto& [piece, place] : pieces_) add(ends(piece), place, triangulation_.uses(piece)[0].segment);
  return cells;
}

Mesh ConstrainedDomains::mesh() const {
  Mesh mesh;
  for (const Vertex2 v : vertices_) {
    const Point2 p = triangulation_.rounded(v);
    mesh.vertices.push_back({p.x, p.y, 0});
  }
  for (const Triangle2 t : triangles_) mesh.add_face(corners(t));
  return mesh;
}

PlanarPicture ConstrainedDomains::picture(bool has_labels) const {
  PlanarPicture picture;
  add_faces(picture);
  add_edges(picture);
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    const bool is_crossing = is_constructed(vertices_[i]);
    PicturePoint point{.at = triangulation_.rounded(vertices_[i]), .text = {.name = "Point " + std::to_string(i)}};
    if (is_crossing) {
      point.size = crossing_size;
      point.fill.color = crossing_color;
      point.text.facts.emplace_back("Constructed", "yes");
    }
    if (has_labels) point.text.label = std::to_string(i);
    picture.points.push_back(std::move(point));
  }
  return picture;
}

void ConstrainedDomains::add_faces(PlanarPicture& picture) const {
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    const std::array<Vertex2, 3> v = triangulation_.links().corners(triangles_[i]);
    const Place place = place_of(triangles_[i]);
    PictureFace face{
        .rings = {path_of({triangulation_.rounded(v[0]), triangulation_.rounded(v[1]), triangulation_.rounded(v[2])})},
        .text = {.name = "Triangle " + std::to_string(i)}};
    face.text.facts = {{"Domain", std::to_string(place.domain)}, {"Depth", std::to_string(place.depth)}};
    if (place.depth > 0) face.fill.category = place.depth % 2 == 1 ? 0 : 1;
    picture.faces.push_back(std::move(face));
  }
  const auto has = [&picture](std::uint32_t category) {
    return std::ranges::any_of(picture.faces, [&](const PictureFace& face) { return face.fill.category == category; });
  };
  if (has(0)) picture.categories = {"Inside"};
  if (has(1)) picture.categories.emplace_back("Between domains inside");
}

void ConstrainedDomains::add_edges(PlanarPicture& picture) const {
  const Triangulation2& links = triangulation_.links();
  const auto between = [this](Vertex2 a, Vertex2 b) {
    return path_of({triangulation_.rounded(a), triangulation_.rounded(b)});
  };
  for (const Triangle2 t : triangles_) {
    for (unsigned slot = 0; slot < 3; ++slot) {
      const Edge2 e(t, slot);
      // Each once: from the triangle of the smaller number, or the finite one.
      const bool is_first = links.is_infinite(links.twin(e).triangle()) || e.code < links.twin(e).code;
      if (triangulation_.is_constrained(e) || !is_first) continue;
      picture.edges.push_back({.path = between(links.source(e), links.target(e)), .style = EdgeStyle::faint});
    }
  }
  for (const auto& [piece, place] : pieces_) {
    const SegmentPieces2::Piece& at = triangulation_.pieces()[piece];
    PictureEdge edge{.path = between(at.source, at.target),
                     .style = EdgeStyle::strong,
                     .text = {.name = "Piece " + std::to_string(piece)}};
    edge.text.facts.emplace_back("Segment", std::to_string(triangulation_.uses(piece)[0].segment));
    picture.edges.push_back(std::move(edge));
  }
}

}  // namespace quoin::cli
