// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/cli/options.h"
#include "quoin/triangulation/segment_pieces2.h"

namespace quoin::cli {

/// Points and segments between them, as drawings and a file of points have them.
struct SegmentInput {
  std::vector<Point2> points;
  std::vector<Segment2> segments;
};

/// All vertices of the drawings and the points of --points; a segment for each edge of a path or ring. Arcs and circles
/// become chords with --flatten. Notes go to `warnings`.
/// @throws InputError  an arc without --flatten, an element without extent (see check_drawing), an exact arrangement,
///                     and what readers refuse
SegmentInput read_segments(const Options& options, std::vector<std::string>& warnings, const Context& context);

}  // namespace quoin::cli
