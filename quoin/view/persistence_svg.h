// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <ostream>
#include <span>
#include <string>

namespace quoin {

/// A class of homology as it is drawn, from its birth to its death.
struct PersistenceInterval {
  int degree = 0;
  double birth = 0;
  double death = std::numeric_limits<double>::infinity();  ///< infinite if it stays
};

/// Draws a point for each interval, births along x and deaths along y, over the diagonal; those that stay lie on a line
/// above. One SVG file, in colours by degree, with a scale and a legend, light or dark as the reader prefers.
///
/// Positions are rounded to a hundredth of a pixel. The same intervals give the same bytes. The caller checks the
/// stream for write errors. @throws InputError  a birth is not finite, or a death is NaN or before the birth
void write_persistence_diagram(std::ostream& out, std::span<const PersistenceInterval> intervals,
                               const std::string& title);

/// Draws a bar for each interval, by degree, then by birth; those that stay run on beyond the scale. As above.
void write_barcode(std::ostream& out, std::span<const PersistenceInterval> intervals, const std::string& title);

}  // namespace quoin
