// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "quoin/arrangement/linear/linear_family.h"
#include "quoin/view/picture_path.h"

namespace quoin {

/// How pieces of a family's branches are drawn; all that pictures of arrangements ask of a family. A specialisation has
///
///   static PicturePath piece(const F&, BranchId, const Point& left, const Point& right, const PictureBox& reach);
///
/// the path of a branch from left to right between two of its points, as steps: straight, or arcs of circles with
/// centre and sweep (`arc_to`), or chords. An end at infinity is put where the branch leaves `reach`, which holds every
/// vertex; families of bounded curves need not look at it. Where curves can be unbounded, also
///
///   static std::array<Point2, 2> anchors(const F&, BranchId);
///
/// two points of a branch near which it was given: what to look at where there are few vertices.
///
/// circular_picture.h is one with arcs.
template <class F>
struct PictureTraits;

template <>
struct PictureTraits<LinearFamily> {
  static PicturePath piece(const LinearFamily& family, BranchId line, const LinearPoint& left, const LinearPoint& right,
                           const PictureBox& reach);
  static std::array<Point2, 2> anchors(const LinearFamily& family, BranchId line);
};

}  // namespace quoin
