// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "quoin/base/error.h"
#include "quoin/io/arrangement_text.h"
#include "quoin/io/strict_visitor.h"
#include "quoin/io/text_order.h"

namespace quoin {

namespace {

using io::ExactLines;
using io::FamilyText;
using io::is_at_pole;
using io::StrictVisitor;
using io::TextCells;

template <CurveFamily F>
class Reader {
 public:
  using Point = typename F::Point;
  Reader(ExactLines& lines, const Context& context) : lines_(lines), context_(context) {}

  ArrangementText<F> run() {
    ArrangementText<F> result;
    lines_.expect("curves", 2);
    cells_.list.curve_count = lines_.index(1, std::size_t{1} << 31);
    if (lines_.choice("names", "no", "yes")) read_names(result.names);
    const std::size_t supports = section("supports");
    for (std::size_t i = 0; i < supports; ++i) {
      lines_.need("support " + std::to_string(i));
      lines_.located([&] { FamilyText<F>::read_support(cells_.family, lines_); });
    }
    read_vertices();
    read_edges();
    close_vertices();
    result.arrangement = build();
    lines_.expect("faces", 2);
    if (lines_.count(1) != result.arrangement.counts().faces) {
      lines_.fail("the edges make " + std::to_string(result.arrangement.counts().faces) + " faces");
    }
    read_members(result);
    lines_.expect_end();
    return result;
  }

 private:
  std::size_t section(std::string_view keyword) {
    lines_.expect(keyword, 2);
    return lines_.count(1);
  }

  void read_names(std::vector<std::string>& names) {
    for (std::uint32_t i = 0; i < cells_.list.curve_count; ++i) {
      lines_.expect_at_least("name", 1);
      lines_.expect_size(2);
      names.push_back(lines_.words().size() > 1 ? io::decoded_name(lines_.words()[1]) : "");
    }
  }

  void read_vertices() {
    const std::size_t count = section("vertices");
    for (std::size_t i = 0; i < count; ++i) {
      lines_.need("vertex " + std::to_string(i));
      vertices_.push_back(lines_.located([&] { return FamilyText<F>::read_point(cells_.family, lines_); }));
      cells_.vertex_lines.push_back(lines_.line());
    }
    is_used_.assign(count, false);
    point_of_vertex_.assign(count, none);
  }

  void read_edges() {
    const std::size_t count = section("edges");
    for (std::size_t i = 0; i < count; ++i) {
      lines_.expect_at_least("edge", 4);
      const BranchId branch = FamilyText<F>::read_branch(cells_.family, lines_.words()[1], lines_);
      const std::uint32_t left = lines_.index(2, vertices_.size());
      const std::uint32_t right = lines_.index(3, vertices_.size());
      add_edge(branch, left, right);
      read_uses();
      cells_.edge_lines.push_back(lines_.line());
    }
  }

  void add_edge(BranchId branch, std::uint32_t left, std::uint32_t right) {
    F& family = cells_.family;
    const std::array<Point, 2> ends = FamilyText<F>::ends_on(family, branch, vertices_[left], vertices_[right]);
    for (const bool is_right : {false, true}) {
      if (FamilyText<F>::lies_on(family, ends[is_right ? 1 : 0], branch)) continue;
      lines_.fail("its " + std::string(is_right ? "right" : "left") + " end does not lie on it");
    }
    if (family.compare_xy(ends[0], ends[1]) != Sign::negative) lines_.fail("its left end is not before its right end");
    const std::uint32_t first = point_for(left, ends[0]);
    const std::uint32_t second = point_for(right, ends[1]);
    cells_.list.pieces.push_back({branch, first, second, CurveId(cells_.list.pieces.size()), false});
    cells_.left_vertices.push_back(left);
  }

  /// The vertex' own point, or another copy of it.
  std::uint32_t point_for(std::uint32_t vertex, const Point& end) {
    is_used_[vertex] = true;
    if (is_at_pole(end) || cells_.family.side(end) != cells_.family.side(vertices_[vertex])) {
      return add_point(vertex, end);
    }
    return own_point(vertex);
  }
  std::uint32_t own_point(std::uint32_t vertex) {
    std::uint32_t& point = point_of_vertex_[vertex];
    if (point == none) point = add_point(vertex, vertices_[vertex]);
    return point;
  }
  std::uint32_t add_point(std::uint32_t vertex, const Point& point) {
    cells_.vertex_of_point.push_back(vertex);
    return cells_.list.add_point(point);
  }

  /// Words +C and -C: curve C runs along the edge, or against it.
  void read_uses() {
    std::vector<CurveUse> uses;
    for (std::size_t i = 4; i < lines_.words().size(); ++i) {
      const std::string_view word = lines_.words()[i];
      const bool is_signed = word.size() > 1 && (word[0] == '+' || word[0] == '-') && word[1] >= '0' && word[1] <= '9';
      if (!is_signed) lines_.fail(io::quoted(word) + " is no curve with a sign");
      const std::uint32_t curve = lines_.index(word.substr(1), cells_.list.curve_count);
      uses.emplace_back(CurveId(std::size_t{curve}), word[0] == '-');
      if (uses.size() > 1 && uses[uses.size() - 2] >= uses.back()) lines_.fail("its curves are not in order");
    }
    cells_.uses.push_back(std::move(uses));
  }

  /// Vertices that no edge ends at are isolated; also, every point on the identification has its left copy.
  void close_vertices() {
    for (std::uint32_t v = 0; v < vertices_.size(); ++v) {
      if (is_used_[v]) {
        if (!is_at_pole(vertices_[v])) own_point(v);
        continue;
      }
      const Side side = cells_.family.side(vertices_[v]);
      if (!IdentifiedFamily<F> && side != Side::interior) {
        lines_.fail_at(cells_.vertex_lines[v], "no edge ends at this end of a line");
      }
      cells_.list.lone_points.push_back({own_point(v), CurveId(std::size_t{0})});
    }
  }

  Arrangement<F> build() {
    const std::uint32_t curve_count = cells_.list.curve_count;
    StrictVisitor<F> visitor(cells_, lines_);
    Sweep<F>(cells_.family, cells_.list, {}, {}, visitor, context_).run();
    Arrangement<F> made = visitor.finish(cells_.family);
    require_distinct_vertices(made, visitor.vertex_of_point());
    CurveHistory history;
    for (std::size_t e = 0; e < made.edge_count(); ++e) {
      history.append(e < cells_.uses.size() ? std::span<const CurveUse>(cells_.uses[e]) : std::span<const CurveUse>());
    }
    made.set_history(std::move(history), curve_count);
    return made;
  }

  /// The sweep tells no two ends at one pole as one vertex; the arrangement does.
  void require_distinct_vertices(const Arrangement<F>& made, const std::vector<dcel::VertexId>& vertex_of_point) const {
    std::vector<std::uint32_t> given(made.vertex_count(), std::uint32_t{none});
    for (std::size_t i = 0; i < cells_.vertex_of_point.size(); ++i) {
      const std::uint32_t vertex = cells_.vertex_of_point[i];
      std::uint32_t& other = given[vertex_of_point[i].index()];
      if (other != none && other != vertex) io::refuse_repeated(lines_, cells_.vertex_lines, other, vertex);
      other = vertex;
    }
  }

  enum class Kind : std::uint8_t { face, edge, vertex };
  struct MemberLine {
    Kind kind = Kind::face;
    std::uint32_t index = 0;
    bool is_in = false;
    std::size_t line = 0;
    auto place() const { return std::pair(kind, index); }
  };

  MemberLine read_member(const io::TextOrder<F>& order) {
    lines_.need("a member");
    MemberLine member;
    const std::string_view word = lines_.words()[0];
    member.kind = word == "face" ? Kind::face : word == "edge" ? Kind::edge : Kind::vertex;
    if (member.kind == Kind::vertex && word != "vertex") lines_.fail(io::quoted(word) + " is no face, edge or vertex");
    const std::size_t bound = member.kind == Kind::face   ? order.faces.size()
                              : member.kind == Kind::edge ? order.edges.size()
                                                          : order.vertices.size();
    member.index = lines_.index(1, bound);
    if (lines_.words().size() < 3) lines_.fail("the line is too short");
    lines_.expect_size(3);
    member.is_in = lines_.words()[2] == "in";
    if (!member.is_in && (member.kind == Kind::face || lines_.words()[2] != "out")) {
      lines_.fail(io::quoted(lines_.words()[2]) +
                  (member.kind == Kind::face ? " is not 'in'" : " is neither 'in' nor 'out'"));
    }
    member.line = lines_.line();
    return member;
  }

  void read_members(ArrangementText<F>& result) {
    const Arrangement<F>& a = result.arrangement;
    lines_.expect("members", 2);
    if (lines_.words()[1] == "none") return;
    const std::size_t count = lines_.count(1);
    const io::TextOrder<F> order = io::text_order(a);
    std::vector<bool> faces(a.face_count(), false);
    std::vector<MemberLine> exceptions;
    MemberLine last;
    for (std::size_t i = 0; i < count; ++i) {
      const MemberLine member = read_member(order);
      if (i > 0 && member.place() <= last.place()) lines_.fail("members are not in order");
      last = member;
      if (member.kind == Kind::face) {
        faces[order.faces[member.index].index()] = true;
      } else {
        exceptions.push_back(member);
      }
    }
    CellMembers members = io::closed_members(a, std::move(faces));
    for (const MemberLine& member : exceptions) {
      const bool is_edge = member.kind == Kind::edge;
      if (!is_edge && !a.cells().is_real(order.vertices[member.index])) {
        lines_.fail_at(member.line, "an end at infinity is no member");
      }
      std::vector<bool>& bits = is_edge ? members.edges : members.vertices;
      const std::size_t id = is_edge ? order.edges[member.index].index() : order.vertices[member.index].index();
      if (bits[id] == member.is_in) lines_.fail_at(member.line, "a member is named that follows from the faces");
      bits[id] = member.is_in;
    }
    result.members = std::move(members);
  }

  static constexpr std::uint32_t none = 0xFFFFFFFFU;
  ExactLines& lines_;
  const Context& context_;
  TextCells<F> cells_;
  std::vector<Point> vertices_;
  std::vector<bool> is_used_;
  std::vector<std::uint32_t> point_of_vertex_;
};

}  // namespace

bool is_arrangement_text(std::string_view text) {
  return io::first_word(text) == "quoin-arrangement";
}

AnyArrangementText read_arrangement_text(std::string_view text, const std::string& name, const Context& context) {
  ExactLines lines(text, name);
  lines.expect("quoin-arrangement", 3);
  if (lines.words()[1] != "1") lines.fail("this version of the format is not known");
  const std::string_view family = lines.words()[2];
  if (family == FamilyText<LinearFamily>::name) return Reader<LinearFamily>(lines, context).run();
  if (family == FamilyText<CircularFamily>::name) return Reader<CircularFamily>(lines, context).run();
  if (family == FamilyText<GeodesicFamily>::name) return Reader<GeodesicFamily>(lines, context).run();
  lines.fail(io::quoted(family) + " is no family of curves (linear, circular, geodesic)");
}

}  // namespace quoin
