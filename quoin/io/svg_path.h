// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "quoin/io/drawing.h"
#include "quoin/io/drawing_text.h"

namespace quoin::io {

/// Draws the subpaths of one SVG element from moves, lines and arcs.
class SvgPen {
 public:
  /// Errors are at `cursor` and, like the notes, about `element`; all must outlive the pen.
  SvgPen(const TextCursor& cursor, const std::string& element, DrawingNotes& notes)
      : cursor_(cursor), element_(element), notes_(notes) {}

  /// Where relative coordinates begin; draws nothing.
  void stand(double x, double y) { go(x, y, false); }
  /// Begins a subpath; the one before stays open.
  void move(double x, double y, bool is_relative);
  void line(double x, double y, bool is_relative);
  void horizontal(double x, bool is_relative);
  void vertical(double y, bool is_relative);
  /// A circular arc to (x, y); `is_positive`: counterclockwise where y points up.
  void arc(double radius, bool is_large, bool is_positive, double x, double y, bool is_relative);
  /// A line to the begin, if it is elsewhere; what follows begins there.
  void close();
  std::vector<DrawingPath> take();

 private:
  Point2 here() const { return {x_.value(), y_.value()}; }
  void go(double x, double y, bool is_relative);
  void note_rounding();
  void begin_subpath();
  void end_open();

  const TextCursor& cursor_;
  const std::string& element_;
  DrawingNotes& notes_;
  RunningSum x_;
  RunningSum y_;
  RunningSum first_x_;
  RunningSum first_y_;
  DrawingPath path_;  // no points: the next edge begins a subpath
  std::vector<DrawingPath> paths_;
};

/// The subpaths of path data from the cursor to its end: M L H V Z A in both cases.
/// @throws InputError  curves (C S Q T), arcs that are not circular, anything else
std::vector<DrawingPath> read_path_data(TextCursor& cursor, const std::string& element, DrawingNotes& notes,
                                        const Context& context);

}  // namespace quoin::io
