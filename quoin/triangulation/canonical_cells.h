// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/triangulation/cell_array.h"

namespace quoin {

/// Brings cells into an order that their vertices alone determine: each begins with its smallest vertex, followed by
/// the smallest that its orientation allows (infinity stays last), and cells ascend by their vertices.
/// O(n) and a little sorting; another copy of the cells for the time being.
void sort_cells(CellArray& cells, int dimension);

}  // namespace quoin
