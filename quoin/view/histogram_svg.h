// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <span>
#include <string>

#include "quoin/flow/histogram.h"

namespace quoin {

struct NamedHistogram {
  std::string name;
  const Histogram* histogram = nullptr;
};

/// Draws histograms under one another: bars of how often each value occurs, in a logarithmic scale; several values
/// share a bar where there are too many. With their numbers, means, deviations, modes and medians. One SVG file, light
/// or dark as the reader prefers.
///
/// Positions are rounded to a hundredth of a pixel. The same histograms give the same bytes. The caller checks the
/// stream for write errors.
void write_histograms(std::ostream& out, std::span<const NamedHistogram> histograms, const std::string& title);

}  // namespace quoin
