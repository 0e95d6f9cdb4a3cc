// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/nearest_cells.h"

#include "quoin/cli/nearest_cell_parts.h"

namespace quoin::cli {

std::size_t NearestCells::bounded_count() const {
  std::size_t count = 0;
  for (std::uint32_t s = 0; s < site_count(); ++s) count += is_bounded(s) ? 1 : 0;
  return count;
}

std::unique_ptr<NearestCells> nearest_cells(const PointFile& file, bool of_plane, bool is_written,
                                            const Context& context) {
  return of_plane ? nearest_cells_of_plane(file, context) : nearest_cells_of_space(file, is_written, context);
}

std::uint64_t memory_of_nearest_cells(std::size_t points, bool of_plane, const MemoryUse& use) {
  // Measured at a million points, what the file says of them included.
  std::uint64_t per_point = of_plane ? 290 : 400;
  if (use.is_weighted) per_point += 100;
  if (use.is_listed) per_point += of_plane ? 2500 : 7500;
  if (use.is_written) per_point += of_plane ? 700 : 6000;
  if (use.is_exact) per_point += of_plane ? 2800 : 11000;
  return points * per_point;
}

}  // namespace quoin::cli
