// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/cells/history.h"

namespace quoin {

CurveUse CurveHistory::stored_bundle(std::span<const CurveUse> curves) {
  table_.insert(table_.end(), curves.begin(), curves.end());
  bundle_begin_.push_back(static_cast<std::uint32_t>(table_.size()));
  return CurveUse::bundle_number(bundle_begin_.size() - 2);
}

void CurveHistory::assign(dcel::EdgeId edge, std::span<const CurveUse> curves) {
  // The span may lie in the table itself, which grows.
  const std::vector<CurveUse> copy(curves.begin(), curves.end());
  uses_[edge.index()] = stored(copy);
}

std::vector<std::vector<dcel::EdgeId>> CurveHistory::edges_by_curve(std::size_t curve_count) const {
  std::vector<std::vector<dcel::EdgeId>> edges(curve_count);
  for (std::size_t e = 0; e < uses_.size(); ++e) {
    for (const CurveUse use : of(dcel::EdgeId(e))) {
      if (use.curve().index() < curve_count) edges[use.curve().index()].push_back(dcel::EdgeId(e));
    }
  }
  return edges;
}

}  // namespace quoin
