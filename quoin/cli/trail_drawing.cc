// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/trail_drawing.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <ostream>

#include "quoin/base/error.h"
#include "quoin/cli/proximity_report.h"
#include "quoin/polytope/planar_hull.h"

namespace quoin::cli {

namespace {

constexpr double longer_side = 900;
constexpr double margin = 24;
constexpr double legend_height = 40;
constexpr std::size_t most_places = 60;

constexpr const char* style = R"(<style>
svg { background: #fbfbf9; font: 14px sans-serif; color: #333 }
.fixed { fill: #8a94a3; fill-opacity: .55; stroke: #4b5563; stroke-width: 1.2 }
.way { fill: none; stroke: #64748b; stroke-width: 1.5; stroke-linejoin: round }
.apart { color: #0f766e } .touching { color: #b45309 } .overlapping { color: #b91c1c }
.place { fill: currentColor; fill-opacity: .07; stroke: currentColor; stroke-opacity: .7; stroke-width: 1 }
.end { fill-opacity: .25; stroke-opacity: 1; stroke-width: 2 }
.contact { fill: none; stroke: currentColor; stroke-width: 4; stroke-linecap: round }
.dot { fill: currentColor }
.nearest { fill: none; stroke: currentColor; stroke-width: 1.5; stroke-dasharray: 5 3 }
text { fill: #333 }
@media (prefers-color-scheme: dark) {
  svg { background: #16191d; color: #ddd }
  .fixed { stroke: #aab4c3 } .way { stroke: #94a3b8 } text { fill: #ddd }
  .apart { color: #2dd4bf } .touching { color: #fbbf24 } .overlapping { color: #f87171 }
}
</style>
)";

std::string decimals(double value) {
  std::array<char, 400> digits;
  const double rounded = std::round(value * 100) / 100;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), rounded == 0 ? 0.0 : rounded).ptr;
  return {digits.data(), end};
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '<') {
      result += "&lt;";
    } else if (c == '&') {
      result += "&amp;";
    } else if (static_cast<unsigned char>(c) >= ' ') {
      result += c;
    }
  }
  return result;
}

class Drawing {
 public:
  Drawing(std::ostream& out, const Trail& trail) : out_(out), trail_(trail) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    low_ = {infinity, infinity};
    high_ = {-infinity, -infinity};
    for (const auto& ring : trail.fixed) {
      for (const Point2& p : ring) extend(p);
    }
    for (const Trail::Step& step : trail.steps) {
      extend(step.at);  // the way itself, which the solid may be far from
      for (const auto& ring : trail.moving) {
        for (const Point2& p : ring) extend({p.x + step.at.x, p.y + step.at.y});
      }
    }
    const double extent = std::max(high_.x - low_.x, high_.y - low_.y);
    if (!std::isfinite(extent)) throw InputError("a coordinate is too large for a drawing");
    scale_ = extent > 0 ? longer_side / extent : 1;
    if (!std::isfinite(scale_)) throw InputError("the trail is too small for a drawing");
  }

  void write() {
    const double width = std::max((high_.x - low_.x) * scale_ + 2 * margin, 560.0);
    const double height = (high_.y - low_.y) * scale_ + 2 * margin + legend_height;
    out_ << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << decimals(width) << "\" height=\""
         << decimals(height) << "\" viewBox=\"0 0 " << decimals(width) << " " << decimals(height) << "\">\n<title>"
         << escaped(trail_.title) << "</title>\n"
         << style << "<path class=\"fixed\" fill-rule=\"nonzero\" d=\"" << path_of(trail_.fixed, {0, 0}) << "\"/>\n";
    write_places();
    write_way();
    if (trail_.nearest) {
      out_ << "<path class=\"nearest apart\" d=\"M" << text_of((*trail_.nearest)[0]) << "L"
           << text_of((*trail_.nearest)[1]) << "\"><title>nearest points</title></path>\n";
    }
    write_legend(height);
    out_ << "</svg>\n";
  }

 private:
  void extend(const Point2& p) {
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
    high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
  }
  std::string text_of(const Point2& p) const {
    return decimals((p.x - low_.x) * scale_ + margin) + " " + decimals((high_.y - p.y) * scale_ + margin);
  }
  std::string path_of(const Shadow& shadow, const Point2& at) const {
    std::string path;
    for (const auto& ring : shadow) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        path += (i == 0 ? "M" : "L") + text_of({ring[i].x + at.x, ring[i].y + at.y});
      }
      path += "Z";
    }
    return path;
  }

  /// The ends and places at equal steps between.
  void write_places() {
    const std::size_t count = trail_.steps.size();
    const std::size_t stride = count / most_places + 1;
    for (std::size_t i = 0; i < count; ++i) {
      const bool is_end = i == 0 || i + 1 == count;
      if (!is_end && i % stride != 0) continue;
      const Trail::Step& step = trail_.steps[i];
      out_ << "<path class=\"place " << name_of(step.relation) << (is_end ? " end" : "")
           << "\" fill-rule=\"nonzero\" d=\"" << path_of(trail_.moving, step.at) << "\"><title>" << i << ": "
           << name_of(step.relation) << "</title></path>\n";
    }
  }

  void write_way() {
    out_ << "<path class=\"way\" d=\"";
    for (std::size_t i = 0; i < trail_.steps.size(); ++i) out_ << (i == 0 ? "M" : "L") << text_of(trail_.steps[i].at);
    out_ << "\"/>\n";
    for (const Trail::Contact& contact : trail_.contacts) {
      out_ << "<path class=\"contact " << name_of(contact.relation) << "\" d=\"M" << text_of(contact.from) << "L"
           << text_of(contact.to) << "\"><title>" << name_of(contact.relation) << "</title></path>\n";
    }
    if (trail_.steps.size() > 4 * most_places) return;
    for (const Trail::Step& step : trail_.steps) {
      const std::string at = text_of(step.at);
      const std::size_t space = at.find(' ');
      out_ << "<circle class=\"dot " << name_of(step.relation) << "\" cx=\"" << at.substr(0, space) << "\" cy=\""
           << at.substr(space + 1) << "\" r=\"3\"/>\n";
    }
  }

  void write_legend(double height) {
    double x = margin;
    const double y = height - legend_height / 2 + 4;
    const auto entry = [&](Proximity relation) {
      const auto count = std::ranges::count(trail_.steps, relation, &Trail::Step::relation);
      const std::string text = std::string(name_of(relation)) + ": " + std::to_string(count);
      out_ << "<circle class=\"dot " << name_of(relation) << "\" cx=\"" << decimals(x) << "\" cy=\"" << decimals(y - 5)
           << "\" r=\"5\"/><text x=\"" << decimals(x + 12) << "\" y=\"" << decimals(y) << "\">" << text << "</text>\n";
      x += 150;
    };
    for (const Proximity relation : {Proximity::apart, Proximity::touching, Proximity::overlapping}) entry(relation);
  }

  std::ostream& out_;
  const Trail& trail_;
  Point2 low_;
  Point2 high_;
  double scale_ = 1;
};

}  // namespace

Shadow shadow_of(const ProximityOperand& operand, const Context& context) {
  Shadow shadow;
  if (operand.pieces) {
    for (const Polytope& piece : *operand.pieces) {
      std::vector<Point2> points;
      for (std::uint32_t v = 0; v < piece.vertex_count(); ++v) {
        points.push_back({piece.vertex(v).x, piece.vertex(v).y});
      }
      auto& ring = shadow.emplace_back();
      for (const std::uint32_t v : planar_hull(points, context)) ring.push_back(points[v]);
    }
    return shadow;
  }
  const Brep& boundary = *operand.boundary;
  for (std::uint32_t f = 0; f < boundary.face_count(); ++f) {
    const auto& plane = boundary.face_planes[f];
    if (boundary.points.turn(plane[0], plane[1], plane[2], 2) != Sign::positive) continue;
    for (std::uint32_t l = boundary.face_first_loop[f]; l < boundary.face_first_loop[f + 1]; ++l) {
      auto& ring = shadow.emplace_back();
      for (const PointId p : boundary.loop(l)) {
        ring.push_back({boundary.points.rounded(p).x, boundary.points.rounded(p).y});
      }
    }
  }
  return shadow;
}

void draw_trail(std::ostream& out, const Trail& trail) {
  Drawing(out, trail).write();
}

}  // namespace quoin::cli
