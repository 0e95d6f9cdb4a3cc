// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/history.h"

namespace quoin {

CurveHistory::Use CurveHistory::stored(std::span<const CurveUse> curves) {
  if (curves.size() == 1) return {curves[0], single, 1};
  const Use use{CurveUse(), static_cast<std::uint32_t>(table_.size()), static_cast<std::uint32_t>(curves.size())};
  table_.insert(table_.end(), curves.begin(), curves.end());
  return use;
}

void CurveHistory::append(std::span<const CurveUse> curves) {
  uses_.push_back(stored(curves));
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
