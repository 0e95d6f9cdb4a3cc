// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <vector>

#include "quoin/flow/flow_cells.h"
#include "quoin/flow/flow_complex.h"

/// Shared by tests of the flow.
namespace quoin::testing {

/// Faces of both descriptions, by vertices.
class FlowNames {
 public:
  FlowNames(const Delaunay3& triangulation, const FlowComplex& flow) : triangulation_(triangulation) {
    for (unsigned d = 1; d < 4; ++d) {
      for (std::uint32_t i = 0; i < flow.faces().count(d); ++i) {
        const std::span<const std::uint32_t> v = flow.faces().vertices({d, i});
        for (const std::uint32_t a : v) faces_of_[a].insert({d, i});
      }
    }
  }
  /// The face of the dimension with all these vertices.
  DeloneFace of(unsigned dimension, std::vector<std::uint32_t> vertices) const {
    DeloneFace found{0, 0};
    for (const DeloneFace& face : faces_of_.at(vertices[0])) {
      const bool has_all = std::all_of(vertices.begin(), vertices.end(),
                                       [&](std::uint32_t v) { return faces_of_.at(v).contains(face); });
      if (face.dimension == dimension && has_all) found = face;
    }
    return found;
  }
  DeloneFace of(CellFacet facet) const {
    std::vector<std::uint32_t> vertices;
    for (unsigned i = 0; i < 4; ++i) {
      if (i != facet.slot) vertices.push_back(triangulation_.cells()[facet.cell].vertices[i]);
    }
    return of(2, vertices);
  }
  DeloneFace of_cell(std::uint32_t cell) const {
    const auto& v = triangulation_.cells()[cell].vertices;
    return of(3, {v.begin(), v.end()});
  }

 private:
  const Delaunay3& triangulation_;
  std::map<std::uint32_t, std::set<DeloneFace>> faces_of_;
};

}  // namespace quoin::testing
