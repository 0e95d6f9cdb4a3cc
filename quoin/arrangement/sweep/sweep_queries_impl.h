// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <unordered_map>
#include <utility>
#include <vector>

#include "quoin/arrangement/sweep/sweep_impl.h"
#include "quoin/arrangement/sweep/sweep_queries.h"

/// Bodies of the queries by sweep, for the one source file per family that instantiates them.
namespace quoin {

/// What starts, ends and passes at an event.
template <CurveFamily F>
class QueryVisitor : public SweepVisitor<typename F::Point> {
 public:
  using Event = SweepEvent<typename F::Point>;

  explicit QueryVisitor(const PieceList<F>& list)
      : list_(list), incidences_(list.points.size(), list.pieces), lone_(list.points.size(), none) {
    next_lone_.resize(list.lone_points.size(), none);
    for (std::size_t i = list.lone_points.size(); i-- > 0;) {
      next_lone_[i] = std::exchange(lone_[list.lone_points[i].point], static_cast<std::uint32_t>(i));
    }
  }

 protected:
  static constexpr std::uint32_t none = 0xFFFFFFFFU;
  /// Numbers of pieces that end and start there, and of lone points.
  struct Ends {
    std::size_t ending = 0;
    std::size_t starting = 0;
    std::vector<std::uint32_t> lone_points;
  };
  Ends ends(const Event& event) const {
    Ends result;
    for (const std::uint32_t index : event.known) {
      if (index >= list_.points.size()) continue;
      for (const std::uint32_t entry : incidences_.at(index)) ++(entry % 2 == 0 ? result.starting : result.ending);
      for (std::uint32_t i = lone_[index]; i != none; i = next_lone_[i]) result.lone_points.push_back(i);
    }
    std::sort(result.lone_points.begin(), result.lone_points.end());
    return result;
  }
  static std::vector<std::uint32_t> bundle(const Event& event, std::uint32_t head) {
    std::vector<std::uint32_t> pieces;
    for (std::uint32_t piece = head; piece != none; piece = event.next_in_bundle[piece]) pieces.push_back(piece);
    std::sort(pieces.begin(), pieces.end());
    return pieces;
  }

 private:
  const PieceList<F>& list_;
  PointIncidences incidences_;
  std::vector<std::uint32_t> lone_;  // by point: the first lone point there
  std::vector<std::uint32_t> next_lone_;
};

template <CurveFamily F>
bool crosses_anything(const F& family, const PieceList<F>& list, const Context& context) {
  class Visitor : public QueryVisitor<F> {
   public:
    using QueryVisitor<F>::QueryVisitor;
    bool at_event(const typename QueryVisitor<F>::Event& event) override {
      for (const std::uint32_t head : event.bundles) found = found || event.next_in_bundle[head] != event.none;
      const auto ends = this->ends(event);
      // Nothing overlaps so far: every edge on the left is one piece.
      const std::size_t passing = event.left.size() - std::min(event.left.size(), ends.ending);
      const std::size_t others = ends.ending + ends.starting + ends.lone_points.size();
      found = found || passing > 1 || (passing == 1 && others > 0);
      return !found;
    }
    bool found = false;
  } visitor(list);
  Sweep<F>(family, list, {}, {}, visitor, context).run();
  return visitor.found;
}

template <CurveFamily F>
std::vector<SubCurve<typename F::Point>> sub_curves(const F& family, const PieceList<F>& list, const Context& context) {
  class Visitor : public QueryVisitor<F> {
   public:
    explicit Visitor(const PieceList<F>& pieces) : QueryVisitor<F>(pieces), list_(pieces) {}
    bool at_event(const typename QueryVisitor<F>::Event& event) override {
      for (const std::uint32_t edge : event.left) curves[edge].right = event.point;
      for (const std::uint32_t head : event.bundles) {
        curves.push_back({list_.pieces[head].branch, event.point, event.point, this->bundle(event, head)});
      }
      return true;
    }
    std::vector<SubCurve<typename F::Point>> curves;

   private:
    const PieceList<F>& list_;
  } visitor(list);
  Sweep<F>(family, list, {}, {}, visitor, context).run();
  return std::move(visitor.curves);
}

template <CurveFamily F>
std::vector<Intersection<typename F::Point>> report_intersections(const F& family, const PieceList<F>& list,
                                                                  const Context& context,
                                                                  const IntersectionOptions& options) {
  using Report = Intersection<typename F::Point>;
  class Visitor : public QueryVisitor<F> {
   public:
    Visitor(const PieceList<F>& pieces, bool includes_common_ends)
        : QueryVisitor<F>(pieces), includes_common_ends_(includes_common_ends) {}
    bool at_event(const typename QueryVisitor<F>::Event& event) override {
      const auto ends = this->ends(event);
      Report report{event.point, {}, ends.lone_points};
      std::size_t before = 0;
      bool overlaps = false;
      for (const std::uint32_t edge : event.left) {
        const auto open = open_.extract(edge);
        before += open.mapped().size();
        overlaps = overlaps || open.mapped().size() > 1;
        report.pieces.insert(report.pieces.end(), open.mapped().begin(), open.mapped().end());
      }
      for (std::size_t i = 0; i < event.right.size(); ++i) {
        std::vector<std::uint32_t> pieces = this->bundle(event, event.bundles[i]);
        report.pieces.insert(report.pieces.end(), pieces.begin(), pieces.end());
        overlaps = overlaps || pieces.size() > 1;
        open_.emplace(event.right[i], std::move(pieces));
      }
      std::sort(report.pieces.begin(), report.pieces.end());
      report.pieces.erase(std::unique(report.pieces.begin(), report.pieces.end()), report.pieces.end());
      const bool is_inside = before > ends.ending || overlaps || !report.lone_points.empty();
      const std::size_t count = report.pieces.size() + (report.pieces.empty() ? 0 : report.lone_points.size());
      if (count > 1 && (is_inside || includes_common_ends_)) {
        reports.push_back(std::move(report));
      }
      return true;
    }
    std::vector<Report> reports;

   private:
    bool includes_common_ends_;
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> open_;  // pieces of the edges that are open
  } visitor(list, options.includes_common_ends);
  Sweep<F>(family, list, {}, {}, visitor, context).run();
  return std::move(visitor.reports);
}

}  // namespace quoin
