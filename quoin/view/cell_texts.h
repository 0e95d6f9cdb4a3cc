// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "quoin/arrangement/cells/dcel.h"
#include "quoin/arrangement/cells/history.h"
#include "quoin/view/planar_picture.h"

namespace quoin {

/// What the links of an arrangement say of its cells, as people read it.
class CellTexts {
 public:
  /// Both must outlive this.
  CellTexts(const dcel::Dcel& cells, const CurveHistory& history, std::function<std::string(CurveId)> curve_name);

  std::vector<ViewFact> of_whole() const;
  PictureText of(dcel::FaceId f) const;
  PictureText of(dcel::EdgeId e) const;
  PictureText of(dcel::VertexId v, const Point2& at) const;

 private:
  std::string list(const std::set<CurveId>& curves) const;
  void collect(dcel::EdgeId e, std::set<CurveId>& curves) const;

  const dcel::Dcel& cells_;
  const CurveHistory& history_;
  std::function<std::string(CurveId)> curve_name_;
};

}  // namespace quoin
