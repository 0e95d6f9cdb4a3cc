// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/topology/simplex_list.h"

namespace quoin {

/// What keeps a list of simplices from being a complex, or its highest simplices from being coherently oriented.
struct SimplexListFindings {
  std::vector<std::uint32_t> invalid;  ///< no vertex, a vertex twice, or too many; the rest is about the others alone
  std::vector<std::array<std::uint32_t, 2>> duplicates;   ///< an earlier one with the same vertices, in any order
  std::vector<std::vector<std::uint32_t>> missing_faces;  ///< faces of listed simplices that are not listed
  std::vector<std::array<std::uint32_t, 2>> incoherent;   ///< of the highest dimension, the only two at a facet that
                                                          ///< both induce the same orientation on

  bool is_complex() const { return invalid.empty() && duplicates.empty() && missing_faces.empty(); }
};

/// Examines a list as it is given. O(m log m) for m faces of all simplices. @throws Cancelled
SimplexListFindings check_simplices(const SimplexList& simplices, const Context& context);

}  // namespace quoin
