// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <string>

#include "quoin/arrangement/envelope.h"
#include "quoin/view/picture_traits.h"
#include "quoin/view/planar_picture.h"

namespace quoin {

/// How an envelope becomes a picture.
struct EnvelopePictureOptions {
  std::string title{};
  std::function<std::string(CurveId)> curve_name{};  ///< by default "3" is the name of curve 3
  bool has_numbers = false;                          ///< of intervals and breakpoints
};

/// Draws curves faintly and over them their envelope, in a colour for each curve.
template <class F>
class EnvelopePicture {
 public:
  EnvelopePicture(const F& family, const PieceList<F>& list, const Envelope<F>& envelope,
                  const EnvelopePictureOptions& options)
      : family_(family), list_(list), envelope_(envelope), options_(options) {}

  PlanarPicture take_picture() {
    picture_.title = options_.title;
    picture_.facts = {{"Intervals", std::to_string(envelope_.arc_count())},
                      {"Breakpoints", std::to_string(envelope_.breakpoint_count())}};
    choose_box();
    add_curves();
    for (std::size_t i = 0; i < envelope_.interval_count(); ++i) {
      if (!envelope_.is_gap(i)) add_interval(i);
    }
    for (std::size_t i = 0; i < envelope_.breakpoint_count(); ++i) add_breakpoint(i);
    return std::move(picture_);
  }

 private:
  bool is_finite(const typename F::Point& p) const { return family_.side(p) == Side::interior; }

  void choose_box() {
    PictureBox box;
    bool is_bounded = true;
    for (const auto& p : list_.points) {
      if (is_finite(p)) box.add(family_.position(p));
    }
    for (std::size_t i = 0; i < envelope_.breakpoint_count(); ++i) {
      if (is_finite(envelope_.point(i))) box.add(family_.position(envelope_.point(i)));
    }
    if constexpr (F::Surface::sides.left == SideKind::infinite) {
      for (const Piece& piece : list_.pieces) {
        if (is_finite(list_.points[piece.left]) && is_finite(list_.points[piece.right])) continue;
        is_bounded = false;
        for (const Point2& p : PictureTraits<F>::anchors(family_, piece.branch)) box.add(p);
      }
    }
    if (!is_bounded) picture_.box = box.enlarged(0.1);
    reach_ = box.enlarged(4);
  }

  PicturePath path_of_piece(const Piece& piece) const {
    return PictureTraits<F>::piece(family_, piece.branch, list_.points[piece.left], list_.points[piece.right], reach_);
  }

  std::string name_of(std::uint32_t member) const {
    const CurveId curve = curve_of_member(list_, member);
    return options_.curve_name ? options_.curve_name(curve) : std::to_string(curve.index());
  }

  PictureFill color_of(std::uint32_t member) const {
    PictureFill fill;
    fill.category = static_cast<std::uint32_t>(curve_of_member(list_, member).index() % colors);
    return fill;
  }

  void add_curves() {
    for (std::size_t i = 0; i < list_.pieces.size(); ++i) {
      PictureEdge edge{path_of_piece(list_.pieces[i]), EdgeStyle::faint, {}, {}};
      edge.text.name = name_of(static_cast<std::uint32_t>(i));
      picture_.edges.push_back(std::move(edge));
    }
    for (const LonePoint& lone : list_.lone_points) {
      PicturePoint point{family_.position(list_.points[lone.point]), 0.6, {}, {}};
      point.text.name = name_of(static_cast<std::uint32_t>(list_.pieces.size() + (&lone - list_.lone_points.data())));
      picture_.points.push_back(std::move(point));
    }
  }

  void add_interval(std::size_t i) {
    const std::uint32_t member = envelope_.over(i).front();
    const PicturePath whole = path_of_piece(list_.pieces[member]);
    const double low = i == 0 ? whole.start.x : family_.position(envelope_.point(i - 1)).x;
    const double high = i == envelope_.breakpoint_count() ? whole.end().x : family_.position(envelope_.point(i)).x;
    PictureEdge edge{between_x(whole, low, high), EdgeStyle::strong, color_of(member), {}};
    edge.text.name = "Interval " + std::to_string(i);
    if (options_.has_numbers) edge.text.label = std::to_string(i);
    edge.text.facts = facts_of(envelope_.over(i));
    picture_.edges.push_back(std::move(edge));
  }

  void add_breakpoint(std::size_t i) {
    if (!is_finite(envelope_.point(i))) return;
    PicturePoint point{family_.position(envelope_.point(i)), 1, color_of(envelope_.at(i).front()), {}};
    point.text.name = "Breakpoint " + std::to_string(i);
    if (options_.has_numbers) point.text.label = std::to_string(i);
    point.text.facts = facts_of(envelope_.at(i));
    picture_.points.push_back(std::move(point));
  }

  std::vector<ViewFact> facts_of(typename Envelope<F>::Members members) const {
    constexpr std::size_t most = 12;
    std::string text;
    for (std::size_t k = 0; k < std::min(members.size(), most); ++k) text += (k > 0 ? ", " : "") + name_of(members[k]);
    if (members.size() > most) text += ", ...";
    return {{members.size() == 1 ? "Curve" : "Curves", text}};
  }

  static constexpr std::size_t colors = 5;

  const F& family_;
  const PieceList<F>& list_;
  const Envelope<F>& envelope_;
  const EnvelopePictureOptions& options_;
  PictureBox reach_;
  PlanarPicture picture_;
};

/// The picture of an envelope of the list. Positions are rounded to the family's error; unbounded curves go as far as
/// the picture does. O(size).
template <class F>
PlanarPicture picture_of(const F& family, const PieceList<F>& list, const Envelope<F>& envelope,
                         const EnvelopePictureOptions& options = {}) {
  return EnvelopePicture<F>(family, list, envelope, options).take_picture();
}

}  // namespace quoin
