// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/alpha_outputs.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>

#include "quoin/base/error.h"
#include "quoin/cli/point_origins.h"
#include "quoin/kernel/predicates2.h"
#include "quoin/kernel/predicates3.h"

namespace quoin::cli {

namespace {

constexpr std::uint32_t none = 0xFFFFFFFF;
constexpr std::size_t poll_step = 4096;
using Triangle = std::array<std::uint32_t, 3>;

VtkGrid vertices_of(const AlphaPoints& points, const PointFile& file) {
  VtkGrid grid;
  for (const std::uint32_t i : points.first_input) grid.points.push_back(file.points[i]);
  grid.point_integers.emplace_back("input", points.first_input);
  grid.point_integers.emplace_back("multiplicity", points.multiplicity);
  add_data(grid, data_of(file, points.first_input));
  return grid;
}

/// The x and y of points of a plane, or of their images in a plane of coordinates in which not all triangles vanish.
class FlatTurns {
 public:
  explicit FlatTurns(const AlphaComplex& alpha) : spheres_(alpha.spheres()) {
    if (alpha.complex().count(2) == 0) return;
    const auto v = alpha.complex().vertices({2, 0});
    for (const auto& axes : {std::array{0, 1}, std::array{1, 2}, std::array{2, 0}}) {
      axes_ = axes;
      if (of({v[0], v[1], v[2]}) != Sign::zero) return;
    }
  }
  Sign of(const Triangle& t) const { return orientation(flat(t[0]), flat(t[1]), flat(t[2])); }

 private:
  Point2 flat(std::uint32_t v) const {
    const Point3& p = spheres_.point(v);
    return {p[static_cast<std::size_t>(axes_[0])], p[static_cast<std::size_t>(axes_[1])]};
  }

  const SmallestSpheres& spheres_;
  std::array<int, 2> axes_{};
};

std::vector<Triangle> triangles_of_plane(const AlphaComplex& alpha, std::uint32_t grades, const Context& context) {
  const FlatTurns turns(alpha);
  std::vector<Triangle> triangles;
  for (std::uint32_t i = 0; i < alpha.complex().count(2); ++i) {
    if (i % poll_step == 0) context.poll();
    if (alpha.grade_of({2, i}) >= grades) continue;
    const auto v = alpha.complex().vertices({2, i});
    Triangle t{v[0], v[1], v[2]};
    if (turns.of(t) == Sign::negative) std::swap(t[1], t[2]);
    triangles.push_back(t);
  }
  return triangles;
}

/// For each triangle that bounds one tetrahedron of the complex, the corner of that which it lacks.
std::vector<std::uint32_t> inner_corners(const AlphaComplex& alpha, std::uint32_t grades, const Context& context) {
  std::vector<std::uint32_t> corners(alpha.complex().count(2), none);
  for (std::uint32_t i = 0; i < alpha.complex().count(3); ++i) {
    if (i % poll_step == 0) context.poll();
    if (alpha.grade_of({3, i}) >= grades) continue;
    const auto v = alpha.complex().vertices({3, i});
    const auto facets = alpha.complex().facets({3, i});
    for (std::size_t j = 0; j < 4; ++j) corners[facets[j]] = v[j];
  }
  return corners;
}

std::vector<Triangle> triangles_of_space(const AlphaComplex& alpha, const AlphaIntervals& intervals,
                                         std::uint32_t grades, const Context& context) {
  const std::vector<std::uint32_t> inner = inner_corners(alpha, grades, context);
  const auto point = [&](std::uint32_t v) { return alpha.spheres().point(v); };
  std::vector<Triangle> triangles;
  for (std::uint32_t i = 0; i < alpha.complex().count(2); ++i) {
    if (i % poll_step == 0) context.poll();
    const AlphaPlace place = intervals.of({2, i}).place(grades);
    if (place != AlphaPlace::singular && place != AlphaPlace::regular) continue;
    const auto v = alpha.complex().vertices({2, i});
    Triangle t{v[0], v[1], v[2]};
    if (inner[i] != none && orientation(point(t[0]), point(t[1]), point(t[2]), point(inner[i])) == Sign::positive)
      std::swap(t[1], t[2]);
    triangles.push_back(t);
  }
  return triangles;
}

class TextLines {
 public:
  TextLines(std::ostream& out, const Context& context) : out_(out), context_(context) {}

  TextLines& text(std::string_view s) {
    block_.append(s);
    return *this;
  }
  TextLines& number(std::uint32_t n) {
    std::array<char, 16> digits;
    block_.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), n).ptr);
    return *this;
  }
  void end() {
    block_ += '\n';
    if (block_.size() < 65536) return;
    context_.poll();
    flush();
  }
  void flush() {
    out_ << block_;
    block_.clear();
  }

 private:
  std::ostream& out_;
  const Context& context_;
  std::string block_;
};

std::string decimal_of(double value) {
  if (!std::isfinite(value))
    throw InputError("a value is beyond the largest double; '--exact' writes all of them as fractions");
  std::array<char, 32> digits;
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
}

}  // namespace

VtkGrid grid_of_shape(const AlphaPoints& points, const AlphaIntervals& intervals, std::uint32_t grades,
                      const PointFile& file, const Context& context) {
  const AlphaComplex& alpha = points.alpha;
  VtkGrid grid = vertices_of(points, file);
  grid.cell_doubles.emplace_back("value", std::vector<double>());
  static constexpr std::array<VtkCell, 4> types{VtkCell::vertex, VtkCell::line, VtkCell::triangle,
                                                VtkCell::tetrahedron};
  for (int k = alpha.dimension(); k >= 0; --k) {
    for (std::uint32_t i = 0; i < alpha.complex().count(k); ++i) {
      if (i % poll_step == 0) context.poll();
      const AlphaPlace place = intervals.of({k, i}).place(grades);
      if (place == AlphaPlace::outside || (k < alpha.dimension() && place != AlphaPlace::singular)) continue;
      grid.add_cell(types[static_cast<std::size_t>(k)], alpha.complex().vertices({k, i}));
      grid.cell_doubles[0].second.push_back(alpha.value(alpha.grade_of({k, i})));
    }
  }
  return grid;
}

CellMesh mesh_of_shape(const AlphaPoints& points, const AlphaIntervals& intervals, std::uint32_t grades,
                       const PointFile& file, const Context& context) {
  const std::vector<Triangle> triangles = points.alpha.dimension() == 3
                                              ? triangles_of_space(points.alpha, intervals, grades, context)
                                              : triangles_of_plane(points.alpha, grades, context);
  CellMesh made;
  Mesh& mesh = made.mesh;
  std::vector<std::uint32_t> number(points.first_input.size(), none);
  for (const Triangle& t : triangles) {
    for (const std::uint32_t v : t) {
      if (number[v] == none) {
        number[v] = static_cast<std::uint32_t>(mesh.vertices.size());
        made.add_vertex(file, points.first_input[v]);
      }
      mesh.corners.push_back(number[v]);
    }
    mesh.face_begin.push_back(mesh.corners.size());
  }
  return made;
}

std::size_t write_filtration(std::ostream& out, const AlphaPoints& points, std::uint32_t grades, bool is_exact,
                             const Context& context) {
  const AlphaComplex& alpha = points.alpha;
  TextLines lines(out, context);
  lines.text("# value, then the numbers of points, from 0").end();
  std::string value;
  std::uint32_t last = none;
  std::size_t merged = 0;
  for (const SimplexId s : alpha.order(context)) {
    const std::uint32_t grade = alpha.grade_of(s);
    if (grade >= grades) break;
    if (grade != last) {
      std::string next = is_exact ? alpha.exact_value(grade).to_string() : decimal_of(alpha.value(grade));
      merged += next == value ? 1 : 0;
      value = std::move(next);
    }
    last = grade;
    lines.text(value);
    for (const std::uint32_t v : alpha.complex().vertices(s)) lines.text(" ").number(points.first_input[v]);
    lines.end();
  }
  lines.flush();
  return merged;
}

std::vector<double> lengths_of(const AlphaPoints& points, const VertexPairs& edges) {
  std::vector<double> lengths;
  lengths.reserve(edges.size());
  for (const auto& [a, b] : edges) {
    const Point3& p = points.alpha.spheres().point(a);
    const Point3& q = points.alpha.spheres().point(b);
    lengths.push_back(std::hypot(p.x - q.x, p.y - q.y, p.z - q.z));
  }
  return lengths;
}

VtkGrid grid_of_graph(const AlphaPoints& points, const VertexPairs& edges, const PointFile& file) {
  VtkGrid grid = vertices_of(points, file);
  for (const auto& edge : edges) grid.add_cell(VtkCell::line, edge);
  grid.cell_doubles.emplace_back("length", lengths_of(points, edges));
  return grid;
}

void write_graph(std::ostream& out, const AlphaPoints& points, const VertexPairs& edges, const Context& context) {
  TextLines lines(out, context);
  for (const auto& [a, b] : edges) lines.number(points.first_input[a]).text(" ").number(points.first_input[b]).end();
  lines.flush();
}

}  // namespace quoin::cli
