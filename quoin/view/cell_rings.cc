// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/cell_rings.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace quoin {

namespace {

using dcel::Dcel;
using dcel::HalfedgeId;

/// The border of a box by length, counterclockwise from its lower left corner.
class Border {
 public:
  explicit Border(const PictureBox& box)
      : corners_{box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}},
        starts_{0, box.width(), box.width() + box.height(), 2 * box.width() + box.height()},
        perimeter_(2 * (box.width() + box.height())),
        box_(box) {}

  /// Of the point of the border nearest to p.
  double parameter(const Point2& p) const {
    const std::array<double, 4> distances{std::fabs(p.y - box_.low.y), std::fabs(p.x - box_.high.x),
                                          std::fabs(p.y - box_.high.y), std::fabs(p.x - box_.low.x)};
    const auto side = std::ranges::min_element(distances) - distances.begin();
    const double along = side == 0   ? p.x - box_.low.x
                         : side == 1 ? p.y - box_.low.y
                         : side == 2 ? box_.high.x - p.x
                                     : box_.high.y - p.y;
    return starts_[static_cast<std::size_t>(side)] + along;
  }

  /// Goes along the border to a point of it; all the way round from a point to itself. Ends that rounding swapped are
  /// taken for one.
  void walk(PicturePath& path, const Point2& to, bool is_whole_turn) const {
    const double begin = parameter(path.end());
    double length = parameter(to) - begin;
    if (length < 0) length += perimeter_;
    if (length > perimeter_ * (1 - 1e-6)) length = 0;
    if (is_whole_turn) length = perimeter_;
    for (std::size_t i = 0; i < 8; ++i) {
      const double at = starts_[i % 4] + (i < 4 ? 0 : perimeter_) - begin;
      if (at > 0 && at < length) path.steps.push_back(line_to(corners_[i % 4]));
    }
    path.steps.push_back(line_to(to));
  }

  PicturePath whole() const { return path_of({corners_[0], corners_[1], corners_[2], corners_[3], corners_[0]}); }

 private:
  std::array<Point2, 4> corners_;
  std::array<double, 4> starts_;
  double perimeter_;
  PictureBox box_;
};

PicturePath along(HalfedgeId h, const std::vector<PicturePath>& edges) {
  const PicturePath& path = edges[h.edge().index()];
  return h.is_forward() ? path : reversed(path);
}

PicturePath ring_from(const Dcel& cells, HalfedgeId first, const std::vector<PicturePath>& edges,
                      const Border& border) {
  HalfedgeId start = first;
  while (!cells.is_real(start.edge())) {
    start = cells.next(start);
    if (start == first) return border.whole();
  }
  PicturePath ring = along(start, edges);
  dcel::VertexId left_at = cells.target(start);
  bool is_at_infinity = false;
  const auto arrive = [&](HalfedgeId h, const Point2& at) {
    if (is_at_infinity) border.walk(ring, at, cells.origin(h) == left_at);
    is_at_infinity = false;
  };
  for (HalfedgeId h = cells.next(start); h != start; h = cells.next(h)) {
    if (!cells.is_real(h.edge())) {
      is_at_infinity = true;
      continue;
    }
    const PicturePath next = along(h, edges);
    arrive(h, next.start);
    append(ring, next);
    left_at = cells.target(h);
  }
  arrive(start, ring.start);
  return ring;
}

}  // namespace

std::vector<PicturePath> face_rings(const Dcel& cells, dcel::FaceId face, const std::vector<PicturePath>& edges,
                                    const PictureBox& reach) {
  const Border border(reach);
  std::vector<PicturePath> rings;
  for (dcel::BoundaryId b = cells[face].first_boundary; !b.is_none(); b = cells[b].next) {
    if (!cells[b].halfedge.is_none()) rings.push_back(ring_from(cells, cells[b].halfedge, edges, border));
  }
  return rings;
}

}  // namespace quoin
