// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <optional>
#include <utility>

#include "quoin/arrangement/sets/polygon_set_combine_impl.h"

/// Body of `find_ring_problem`, for the one source file per family that instantiates it.
namespace quoin {

namespace polygon_set_detail {

/// Winding numbers of every ring and counts of every element at the current face of a walk.
template <CurveFamily F>
class RingWalk {
 public:
  RingWalk(const Arrangement<F>& drawn, std::span<const std::uint32_t> element_of_curve,
           const std::vector<bool>& is_hole)
      : drawn_(drawn), element_of_curve_(element_of_curve), is_hole_(is_hole), winding_(element_of_curve.size(), 0) {
    std::uint32_t elements = 0;
    for (const std::uint32_t element : element_of_curve) {
      if (element != no_element) elements = std::max(elements, element + 1);
    }
    elements_.resize(elements);
    direction_.assign(element_of_curve.size(), 0);
  }

  std::optional<RingProblem> run() {
    problem_ = find_overlap();
    if (problem_) return problem_;
    dcel::walk_faces(
        drawn_.cells(), [&](HalfedgeId h) { cross(h); }, [](FaceId) {});
    return problem_;
  }

 private:
  struct Element {
    bool in_outer = false;
    std::uint32_t holes = 0;  // rings that are holes around the place
  };

  std::optional<RingProblem> find_overlap() const {
    for (std::size_t e = 0; e < drawn_.edge_count(); ++e) {
      if (!drawn_.cells().is_real(EdgeId(e))) continue;
      const auto uses = drawn_.curves(EdgeId(e));
      if (uses.size() < 2) continue;
      std::vector<std::pair<std::uint32_t, std::uint32_t>> by_element;
      for (const CurveUse use : uses) {
        const std::uint32_t element = element_of_curve_[use.curve().index()];
        if (element != no_element) by_element.emplace_back(element, use.curve().value);
      }
      std::sort(by_element.begin(), by_element.end());
      for (std::size_t i = 1; i < by_element.size(); ++i) {
        if (by_element[i].first != by_element[i - 1].first) continue;
        return RingProblem{RingProblem::Kind::overlap, by_element[i - 1].second, by_element[i].second, EdgeId(e)};
      }
    }
    return std::nullopt;
  }

  void cross(HalfedgeId h) {
    for (const CurveUse use : drawn_.curves(h.edge())) {
      const std::uint32_t curve = use.curve().value;
      if (element_of_curve_[curve] == no_element) continue;
      std::int32_t& winding = winding_[curve];
      const bool before = winding != 0;
      winding += winding_step(h, use);
      const bool now = winding != 0;
      Element& element = elements_[element_of_curve_[curve]];
      if (now != before) {
        if (is_hole_[curve]) {
          element.holes += now ? 1U : 0xFFFFFFFFU;
        } else {
          element.in_outer = now;
        }
      }
      if (!now) continue;
      if (direction_[curve] == 0) direction_[curve] = winding;
      if (winding != direction_[curve] || (winding != 1 && winding != -1)) {
        report(RingProblem::Kind::crosses_itself, curve, curve, h);
      }
    }
    for (const CurveUse use : drawn_.curves(h.edge())) judge(use.curve().value, h);
  }
  /// The face just entered, for the element of a ring on its boundary.
  void judge(std::uint32_t curve, HalfedgeId h) {
    if (element_of_curve_[curve] == no_element) return;
    const Element& element = elements_[element_of_curve_[curve]];
    if (element.holes == 0) return;
    if (element.holes > 1) report(RingProblem::Kind::holes_overlap, curve, other_hole(curve), h);
    if (!element.in_outer) report(RingProblem::Kind::hole_outside, any_hole(curve), curve, h);
  }
  std::uint32_t other_hole(std::uint32_t curve) const {
    for (std::uint32_t c = 0; c < winding_.size(); ++c) {
      if (c != curve && is_hole_[c] && winding_[c] != 0 && element_of_curve_[c] == element_of_curve_[curve]) return c;
    }
    return curve;
  }
  std::uint32_t any_hole(std::uint32_t curve) const {
    return is_hole_[curve] && winding_[curve] != 0 ? curve : other_hole(curve);
  }
  void report(RingProblem::Kind kind, std::uint32_t first, std::uint32_t second, HalfedgeId h) {
    if (!problem_) problem_ = RingProblem{kind, first, second, h.edge()};
  }

  const Arrangement<F>& drawn_;
  std::span<const std::uint32_t> element_of_curve_;
  const std::vector<bool>& is_hole_;
  std::vector<std::int32_t> winding_;    // by curve
  std::vector<std::int32_t> direction_;  // by curve: the winding number inside, once seen
  std::vector<Element> elements_;
  std::optional<RingProblem> problem_;
};

}  // namespace polygon_set_detail

template <CurveFamily F>
std::optional<RingProblem> find_ring_problem(const Arrangement<F>& drawn,
                                             std::span<const std::uint32_t> element_of_curve,
                                             const std::vector<bool>& is_hole) {
  return polygon_set_detail::RingWalk<F>(drawn, element_of_curve, is_hole).run();
}

}  // namespace quoin
