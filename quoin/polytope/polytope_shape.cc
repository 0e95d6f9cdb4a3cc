// SPDX-License-Identifier: Apache-2.0
#include "quoin/polytope/polytope_shape.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace quoin {

namespace {

/// Halfedges in the order of facets.
struct Chains {
  std::vector<std::uint32_t> tail;
  std::vector<std::uint32_t> next;
  std::vector<std::uint32_t> facet;
  std::vector<std::uint32_t> twin;
};

/// By tail, then each looks for its twin among those that leave its head: few.
void find_twins(Chains& chains, std::size_t vertex_count) {
  std::vector<std::uint32_t> begin(vertex_count + 1, 0);
  for (const std::uint32_t v : chains.tail) ++begin[v + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<std::uint32_t> out(chains.tail.size());
  std::vector<std::uint32_t> end(begin);
  const auto head = [&](std::uint32_t h) { return chains.tail[chains.next[h]]; };
  for (std::uint32_t h = 0; h < chains.tail.size(); ++h) out[end[chains.tail[h]]++] = h;
  for (std::uint32_t v = 0; v < vertex_count; ++v) {
    std::sort(out.begin() + begin[v], out.begin() + begin[v + 1],
              [&](std::uint32_t a, std::uint32_t b) { return head(a) < head(b); });
  }
  chains.twin.resize(chains.tail.size());
  for (std::uint32_t h = 0; h < chains.tail.size(); ++h) {
    const std::uint32_t v = head(h);
    chains.twin[h] = *std::lower_bound(out.begin() + begin[v], out.begin() + begin[v + 1], chains.tail[h],
                                       [&](std::uint32_t a, std::uint32_t tail) { return head(a) < tail; });
  }
}

}  // namespace

void PolytopeShape::link(int dimension, std::size_t vertex_count, const Rings& rings) {
  dimension_ = dimension;
  if (dimension == 0) first_out_ = {0, 0};
  if (dimension == 1) link_segment();
  if (dimension == 3) link_rings(vertex_count, rings);
  if (dimension != 2) return;
  // A polygon gets its back.
  std::vector<std::uint32_t> corners(rings.corners.begin(), rings.corners.end());
  corners.insert(corners.end(), rings.corners.rbegin(), rings.corners.rend());
  const std::vector<std::size_t> facet_begin{0, rings.corners.size(), corners.size()};
  link_rings(vertex_count, {corners, facet_begin});
}

void PolytopeShape::link_segment() {
  first_out_ = {0, 1, 2};
  halfedges_ = {{{}, 0, 1, 1, none, 1}, {{}, 1, 0, 0, none, 0}};
}

/// Halfedges are numbered about the vertices: from one, through its predecessor in its facet, to that one's twin, which
/// is the next counterclockwise.
void PolytopeShape::link_rings(std::size_t vertex_count, const Rings& rings) {
  Chains chains;
  for (std::size_t f = 0; f < rings.facet_count(); ++f) {
    const auto first = static_cast<std::uint32_t>(rings.facet_begin[f]);
    const auto last = static_cast<std::uint32_t>(rings.facet_begin[f + 1]);
    for (std::uint32_t i = first; i < last; ++i) {
      chains.tail.push_back(rings.corners[i]);
      chains.next.push_back(i + 1 < last ? i + 1 : first);
      chains.facet.push_back(static_cast<std::uint32_t>(f));
    }
  }
  find_twins(chains, vertex_count);
  const auto count = static_cast<std::uint32_t>(chains.tail.size());
  std::vector<std::uint32_t> previous(count);
  std::vector<std::uint32_t> any_out(vertex_count);
  for (std::uint32_t h = 0; h < count; ++h) {
    previous[chains.next[h]] = h;
    any_out[chains.tail[h]] = h;
  }
  std::vector<std::uint32_t> number(count);
  std::uint32_t numbered = 0;
  first_out_.clear();
  for (const std::uint32_t first : any_out) {
    first_out_.push_back(numbered);
    std::uint32_t h = first;
    do {
      number[h] = numbered++;
      h = chains.twin[previous[h]];
    } while (h != first);
  }
  first_out_.push_back(count);
  halfedges_.resize(count);
  facet_halfedge_.resize(rings.facet_count());
  for (std::uint32_t h = 0; h < count; ++h) {
    halfedges_[number[h]] = {{},
                             chains.tail[h],
                             chains.tail[chains.next[h]],
                             number[chains.twin[h]],
                             chains.facet[h],
                             number[chains.next[h]]};
    facet_halfedge_[chains.facet[h]] = number[h];
  }
}

void PolytopeShape::set_vectors() {
  for (std::uint32_t h = 0; h < halfedges_.size(); ++h) halfedges_[h].vector = rounded(edge(h));
  normals_.clear();
  for (const std::uint32_t h : facet_halfedge_) {
    normals_.push_back(rounded_normal(halfedges_[h].vector, halfedges_[halfedges_[h].next].vector));
  }
}

/// A vertex keeps its number, and so does a facet. Around a facet all runs the other way, so a halfedge becomes what
/// its twin was on the other side; around a vertex the order turns around.
void PolytopeShape::reflect() {
  for (Point3& p : points_) p = {-p.x, -p.y, -p.z};
  if (dimension_ < 2) {
    if (dimension_ == 1 && !edges_.empty()) std::swap(edges_[0], edges_[1]);
    set_vectors();
    return;
  }
  const std::vector<Halfedge> old = std::move(halfedges_);
  const std::vector<EdgeVector> old_edges = std::move(edges_);
  std::vector<std::uint32_t> previous(old.size());
  for (std::uint32_t h = 0; h < old.size(); ++h) previous[old[h].next] = h;
  const auto number = [&](std::uint32_t h) { return first_out(old[h].tail) + end_out(old[h].tail) - 1 - h; };
  halfedges_.resize(old.size());
  edges_.resize(old_edges.size());
  for (std::uint32_t h = 0; h < old.size(); ++h) {
    const std::uint32_t twin = old[h].twin;
    halfedges_[number(h)] = {{},           old[h].tail,     old[h].head,
                             number(twin), old[twin].facet, number(old[previous[twin]].twin)};
    if (!old_edges.empty()) edges_[number(h)] = old_edges[twin];
  }
  for (std::uint32_t& h : facet_halfedge_) h = number(old[h].twin);
  set_vectors();
}

}  // namespace quoin
