// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/cell_texts.h"

#include <array>
#include <charconv>

namespace quoin {

namespace {

using dcel::BoundaryId;
using dcel::EdgeId;
using dcel::FaceId;
using dcel::HalfedgeId;
using dcel::VertexId;

constexpr std::size_t most_curves = 12;

std::string rounded(double value) {
  std::array<char, 32> text;
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value == 0 ? 0.0 : value, std::chars_format::general, 8)
          .ptr;
  return {text.data(), end};
}

std::string name(const char* kind, std::size_t index) {
  return std::string(kind) + ' ' + std::to_string(index);
}

}  // namespace

CellTexts::CellTexts(const dcel::Dcel& cells, const CurveHistory& history,
                     std::function<std::string(CurveId)> curve_name)
    : cells_(cells), history_(history), curve_name_(std::move(curve_name)) {}

std::vector<ViewFact> CellTexts::of_whole() const {
  const dcel::Counts counts = dcel::count_cells(cells_);
  return {{"Faces", std::to_string(counts.faces)},
          {"Edges", std::to_string(counts.edges)},
          {"Vertices", std::to_string(counts.vertices)}};
}

PictureText CellTexts::of(FaceId f) const {
  PictureText text{name("Face", f.index()), "", {}};
  std::size_t edges = 0;
  std::size_t holes = 0;
  std::size_t isolated = 0;
  std::set<CurveId> curves;
  for (BoundaryId b = cells_[f].first_boundary; !b.is_none(); b = cells_[b].next) {
    if (cells_[b].halfedge.is_none()) continue;
    if (!cells_[b].is_outer) ++holes;
    HalfedgeId h = cells_[b].halfedge;
    do {
      if (cells_.is_real(h.edge())) {
        ++edges;
        collect(h.edge(), curves);
      }
      h = cells_.next(h);
    } while (h != cells_[b].halfedge);
  }
  for (VertexId v = cells_[f].first_isolated; !v.is_none(); v = cells_[v].next_isolated) ++isolated;
  text.facts.emplace_back("Kind", cells_[f].is_unbounded ? "unbounded" : "bounded");
  text.facts.emplace_back("Edges around", std::to_string(edges));
  if (holes > 0) text.facts.emplace_back("Holes", std::to_string(holes));
  if (isolated > 0) text.facts.emplace_back("Lone points", std::to_string(isolated));
  if (!curves.empty()) text.facts.emplace_back("Curves", list(curves));
  return text;
}

PictureText CellTexts::of(EdgeId e) const {
  PictureText text{name("Edge", e.index()), "", {}};
  const HalfedgeId h(e, false);
  std::set<CurveId> curves;
  collect(e, curves);
  text.facts.emplace_back(curves.size() == 1 ? "Curve" : "Curves", list(curves));
  const auto end = [&](VertexId v) { return cells_.is_real(v) ? std::to_string(v.index()) : std::string("infinity"); };
  text.facts.emplace_back("Vertices", end(cells_.origin(h)) + ", " + end(cells_.target(h)));
  const FaceId above = cells_.face(h);
  const FaceId below = cells_.face(h.twin());
  text.facts.emplace_back(above == below ? "Inside face" : "Between faces",
                          above == below ? std::to_string(above.index())
                                         : std::to_string(above.index()) + ", " + std::to_string(below.index()));
  return text;
}

PictureText CellTexts::of(VertexId v, const Point2& at) const {
  PictureText text{name("Vertex", v.index()), "", {}};
  text.facts.emplace_back("Position", "≈ (" + rounded(at.x) + ", " + rounded(at.y) + ")");
  if (cells_.is_isolated(v)) {
    text.facts.emplace_back("Lone point of", name("face", cells_[v].face.index()));
    return text;
  }
  std::set<CurveId> curves;
  HalfedgeId h = cells_[v].out;
  std::size_t degree = 0;
  do {
    ++degree;
    if (cells_.is_real(h.edge())) collect(h.edge(), curves);
    h = cells_.clockwise(h);
  } while (h != cells_[v].out);
  text.facts.emplace_back("Edges", std::to_string(degree));
  text.facts.emplace_back("Curves", list(curves));
  return text;
}

std::string CellTexts::list(const std::set<CurveId>& curves) const {
  std::string names;
  std::size_t count = 0;
  for (const CurveId curve : curves) {
    if (count == most_curves) return names + " and " + std::to_string(curves.size() - count) + " more";
    if (count++ > 0) names += ", ";
    names += curve_name_ ? curve_name_(curve) : std::to_string(curve.index());
  }
  return names;
}

void CellTexts::collect(EdgeId e, std::set<CurveId>& curves) const {
  for (const CurveUse& use : history_.of(e)) curves.insert(use.curve());
}

}  // namespace quoin
