// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "quoin/view/picture_path.h"

namespace quoin {

/// The sheet on which a box of the plane is drawn: pixels, y downward.
///
/// Renderers compute in single precision and know no circles that look straight. So curves are cut to what the sheet
/// and its surroundings show, and large arcs become chords that are off by at most 0.05 pixels.
class PictureFrame {
 public:
  /// The longer side of the box becomes `size` pixels. Curves are kept within `reach` sheets around the sheet.
  PictureFrame(const PictureBox& box, double size, double reach);

  double width() const { return width_; }
  double height() const { return height_; }
  /// Pixels for one unit of the picture.
  double scale() const { return scale_; }
  Point2 map(const Point2& p) const { return {(p.x - box_.low.x) * scale_, (box_.high.y - p.y) * scale_}; }
  bool is_near(const Point2& pixel) const { return region_.contains(pixel); }
  /// All that is drawn at all, in pixels.
  const PictureBox& region() const { return region_; }

  /// The parts of a curve that are seen, in pixels.
  std::vector<PicturePath> curve(const PicturePath& path) const;
  /// A closed curve that has the same interior near the sheet, in pixels; without steps if it has none.
  PicturePath ring(const PicturePath& path) const;
  /// The same sheet with nothing around it.
  PictureFrame without_surroundings() const;
  /// The border of what is drawn.
  PicturePath border() const;

 private:
  PicturePath mapped(const PicturePath& path) const;
  void add_chords(PicturePath& out, const Point2& from, const PathStep& step, double begin, double end) const;
  bool is_far(const Point2& pixel) const;

  PictureBox box_;
  double scale_ = 1;
  double width_ = 0;
  double height_ = 0;
  PictureBox region_;
};

}  // namespace quoin
