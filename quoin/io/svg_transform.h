// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "quoin/io/drawing.h"
#include "quoin/io/xml_tags.h"
#include "quoin/number/rational.h"

namespace quoin::io {

/// x' = sx x + tx, y' = sy y + ty with |sx| = |sy| a power of two: keeps circles and, but for the shift, doubles.
class SvgTransform {
 public:
  /// This after another one that is written behind it.
  SvgTransform after(const SvgTransform& inner) const;
  /// Whether its numbers have far more digits than transforms of drawings; limits what nested groups can make of them.
  bool is_excessive() const;

  /// Applies it, to nearest doubles; notes what is rounded. @throws InputError  beyond the largest double
  void apply(DrawingPath& path, const TextCursor& cursor, const std::string& element, DrawingNotes& notes) const;
  void apply(DrawingCircle& circle, const TextCursor& cursor, const std::string& element, DrawingNotes& notes) const;

  /// From the value of a transform attribute. @throws InputError  naming a function that is not supported
  static SvgTransform read(TextCursor cursor, const std::string& element);

 private:
  static SvgTransform one(TextCursor& cursor, std::string_view function, const std::string& element);
  Point2 image(const Point2& p, const TextCursor& cursor, const std::string& element, DrawingNotes& notes) const;

  bool is_identity_ = true;
  Rational sx_{1};
  Rational sy_{1};
  Rational tx_;
  Rational ty_;
};

}  // namespace quoin::io
