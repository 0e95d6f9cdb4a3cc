// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/overlay/crossings.h"

#include <algorithm>
#include <numeric>

#include "quoin/base/error.h"
#include "quoin/base/parallel.h"

namespace quoin::overlay {

namespace {

// Three planes, ascending.
using PlaneTriple = std::array<std::uint32_t, 3>;

struct Found {
  std::vector<PlaneTriple> keys;
  std::vector<std::pair<std::uint32_t, PointRef>> on_curves;
};

struct Box {
  std::array<double, 3> lo;
  std::array<double, 3> hi;
};

bool meet(const Box& a, const Box& b) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (a.lo[k] > b.hi[k] || b.lo[k] > a.hi[k]) return false;
  }
  return true;
}

class FacetCrossings {
 public:
  FacetCrossings(const Scene& scene, const Network& network, const Context& context, Found& out)
      : table_(scene.table), network_(network), context_(context), out_(out) {}

  void run(std::uint32_t facet) {
    facet_ = facet;
    curves_ = network_.curves_in(facet);
    if (curves_.empty()) return;
    first_ = static_cast<std::uint32_t>(curves_.data() - network_.curves.data());
    make_boxes();
    if (curves_.size() > 1) meet_curves();
    meet_isolated_points();
  }

 private:
  // Rounding is monotone, so boxes of rounded ends contain the rounded points of the curve.
  void make_boxes() {
    boxes_.resize(curves_.size());
    order_.resize(curves_.size());
    std::iota(order_.begin(), order_.end(), 0U);
    Box all{{1e308, 1e308, 1e308}, {-1e308, -1e308, -1e308}};
    for (std::size_t i = 0; i < curves_.size(); ++i) {
      const Point3& p = table_.rounded(curves_[i].from);
      const Point3& q = table_.rounded(curves_[i].to);
      for (std::size_t k = 0; k < 3; ++k) {
        boxes_[i].lo[k] = std::min(p[k], q[k]);
        boxes_[i].hi[k] = std::max(p[k], q[k]);
        all.lo[k] = std::min(all.lo[k], boxes_[i].lo[k]);
        all.hi[k] = std::max(all.hi[k], boxes_[i].hi[k]);
      }
    }
    axis_ = 0;
    for (std::size_t k = 1; k < 3; ++k) {
      if (all.hi[k] / 2 - all.lo[k] / 2 > all.hi[axis_] / 2 - all.lo[axis_] / 2) axis_ = k;
    }
    std::sort(order_.begin(), order_.end(), [&](std::uint32_t i, std::uint32_t j) {
      return boxes_[i].lo[axis_] != boxes_[j].lo[axis_] ? boxes_[i].lo[axis_] < boxes_[j].lo[axis_] : i < j;
    });
  }

  void meet_curves() {
    for (std::size_t i = 0; i < order_.size(); ++i) {
      if (i % 64 == 63) context_.poll();
      const Box& box = boxes_[order_[i]];
      for (std::size_t j = i + 1; j < order_.size() && boxes_[order_[j]].lo[axis_] <= box.hi[axis_]; ++j) {
        if (meet(box, boxes_[order_[j]])) meet_pair(std::min(order_[i], order_[j]), std::max(order_[i], order_[j]));
      }
    }
  }

  Sign side(PointId p, const Curve& curve) const {
    return p == curve.from || p == curve.to ? Sign::zero : table_.side(p, curve.cut);
  }

  void split(std::size_t curve, PointId point) {
    out_.on_curves.push_back({first_ + static_cast<std::uint32_t>(curve), PointRef::point(point)});
  }

  void meet_pair(std::size_t i, std::size_t j) {
    const Curve& a = curves_[i];
    const Curve& b = curves_[j];
    if (a.is_along_edge() && b.is_along_edge()) return;  // where edges meet was found when their facets were
    const Sign b_from = side(b.from, a);
    const Sign b_to = side(b.to, a);
    if (b_from == Sign::zero && b_to == Sign::zero) {
      meet_collinear(i, j);
      return;
    }
    if (b_from * b_to == Sign::positive) return;
    const Sign a_from = side(a.from, b);
    const Sign a_to = side(a.to, b);
    if (a_from * a_to == Sign::positive) return;
    const bool inside_a = b_from * b_to == Sign::negative;
    const bool inside_b = a_from * a_to == Sign::negative;
    if (inside_a && inside_b) {
      cross(i, j);
    } else if (inside_b) {  // an end of b lies inside a
      split(i, b_from == Sign::zero ? b.from : b.to);
    } else if (inside_a) {
      split(j, a_from == Sign::zero ? a.from : a.to);
    }
  }

  void cross(std::size_t i, std::size_t j) {
    PlaneTriple key{facet_, curves_[i].cut.value, curves_[j].cut.value};
    std::sort(key.begin(), key.end());
    const PointRef ref = PointRef::contact(out_.keys.size());
    out_.keys.push_back(key);
    out_.on_curves.push_back({first_ + static_cast<std::uint32_t>(i), ref});
    out_.on_curves.push_back({first_ + static_cast<std::uint32_t>(j), ref});
  }

  void meet_collinear(std::size_t i, std::size_t j) {
    for (const PointId p : {curves_[j].from, curves_[j].to}) split_if_between(i, p);
    for (const PointId p : {curves_[i].from, curves_[i].to}) split_if_between(j, p);
  }

  // For a point known to lie on the curve's line.
  void split_if_between(std::size_t curve, PointId p) {
    const Curve& c = curves_[curve];
    if (p == c.from || p == c.to) return;
    for (unsigned axis = 0; axis < 3; ++axis) {
      const Sign direction = table_.compare(c.to, c.from, axis);
      if (direction == Sign::zero) continue;
      const Sign after = table_.compare(p, c.from, axis) * direction;
      const Sign before = table_.compare(c.to, p, axis) * direction;
      if (after == Sign::positive && before == Sign::positive) split(curve, p);
      return;
    }
  }

  // Vertices that touch the facet from one side, where no curve ends.
  void meet_isolated_points() {
    ends_.clear();
    for (const PointInFacet& p : network_.points_in(facet_)) {
      if (ends_.empty()) gather_ends();
      if (std::binary_search(ends_.begin(), ends_.end(), p.point)) continue;
      const Point3& at = table_.rounded(p.point);
      const Box box{{at.x, at.y, at.z}, {at.x, at.y, at.z}};
      for (std::size_t i = 0; i < curves_.size(); ++i) {
        if (meet(box, boxes_[i]) && side(p.point, curves_[i]) == Sign::zero) split_if_between(i, p.point);
      }
    }
  }

  void gather_ends() {
    for (const Curve& c : curves_) {
      ends_.push_back(c.from);
      ends_.push_back(c.to);
    }
    std::sort(ends_.begin(), ends_.end());
  }

  const Constructions& table_;
  const Network& network_;
  const Context& context_;
  Found& out_;
  std::uint32_t facet_ = 0;
  std::uint32_t first_ = 0;
  std::size_t axis_ = 0;
  std::span<const Curve> curves_;
  std::vector<Box> boxes_;
  std::vector<std::uint32_t> order_;
  std::vector<PointId> ends_;
};

std::vector<std::uint32_t> facets_with_curves(const Network& network) {
  std::vector<std::uint32_t> facets;
  for (const Curve& c : network.curves) {
    if (facets.empty() || facets.back() != c.facet) facets.push_back(c.facet);
  }
  return facets;
}

// Sets the new points and returns the id that stands for each key.
std::vector<PointId> construct(Scene& scene, Network& network, const std::vector<PlaneTriple>& keys,
                               const Context& context) {
  Constructions& table = scene.table;
  const std::size_t first = table.point_count();
  if (first + keys.size() >= PointRef::contact_bit) throw InputError("too many intersections");
  table.resize_points(first + keys.size());
  for_each_chunk(context, keys.size(), 256, [&](const Chunk& chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      table.set_point(PointId{first + i}, PlaneId{keys[i][0]}, PlaneId{keys[i][1]}, PlaneId{keys[i][2]});
    }
  });
  std::vector<PointId> canonical(keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (i % 4096 == 0) context.poll();
    canonical[i] = network.merger.insert(PointId{first + i});
  }
  return canonical;
}

}  // namespace

std::vector<PointOnCurve> find_crossings(Scene& scene, Network& network, const Context& context) {
  constexpr std::size_t grain = 64;
  const std::vector<std::uint32_t> facets = facets_with_curves(network);
  std::vector<Found> found(chunk_count(facets.size(), grain));
  context.progress("crossings", 0);
  for_each_chunk(context, facets.size(), grain, [&](const Chunk& chunk) {
    FacetCrossings crossings(scene, network, context, found[chunk.index]);
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) crossings.run(facets[i]);
  });
  std::vector<PlaneTriple> keys;
  for (const Found& part : found) keys.insert(keys.end(), part.keys.begin(), part.keys.end());
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  const std::vector<PointId> canonical = construct(scene, network, keys, context);

  std::vector<PointOnCurve> result;
  for (const Found& part : found) {
    for (const auto& [curve, ref] : part.on_curves) {
      PointId point{ref.value};
      if (ref.is_contact()) {
        const auto key = std::lower_bound(keys.begin(), keys.end(), part.keys[ref.contact_index()]);
        point = canonical[static_cast<std::size_t>(key - keys.begin())];
      }
      result.push_back({curve, point});
    }
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

}  // namespace quoin::overlay
