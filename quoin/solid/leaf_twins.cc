// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/leaf_twins.h"

#include <algorithm>
#include <span>

#include "quoin/solid/leaf_tiles.h"

namespace quoin {

namespace {

// A halfedge in the bucket of its smaller vertex.
struct Entry {
  std::uint32_t larger;
  std::uint32_t halfedge;
};

class TwinMatcher {
 public:
  TwinMatcher(Leaf& leaf, std::size_t max_listed, MeshDiagnosis& diagnosis, const Context& context)
      : leaf_(leaf), max_listed_(max_listed), diagnosis_(diagnosis), context_(context) {}

  void run() {
    fill_buckets();
    leaf_.twins.assign(3 * leaf_.tiles.size(), Leaf::no_twin);
    for (std::size_t v = 0; v + 1 < first_.size(); ++v) {
      if (v % 16384 == 0) context_.poll();
      const std::span<Entry> bucket(entries_.data() + first_[v], first_[v + 1] - first_[v]);
      std::sort(bucket.begin(), bucket.end(), [](const Entry& a, const Entry& b) {
        return a.larger != b.larger ? a.larger < b.larger : a.halfedge < b.halfedge;
      });
      for (std::size_t i = 0; i < bucket.size();) {
        std::size_t j = i + 1;
        while (j < bucket.size() && bucket[j].larger == bucket[i].larger) ++j;
        settle_edge(static_cast<std::uint32_t>(v), bucket.subspan(i, j - i));
        i = j;
      }
    }
  }

 private:
  std::uint32_t tail(std::uint32_t h) const { return leaf_.tiles[h / 3][h % 3]; }
  std::uint32_t head(std::uint32_t h) const { return leaf_.tiles[h / 3][(h % 3 + 1) % 3]; }

  void fill_buckets() {
    const auto count = static_cast<std::uint32_t>(3 * leaf_.tiles.size());
    first_.assign(leaf_.vertices.size() + 1, 0);
    for (std::uint32_t h = 0; h < count; ++h) ++first_[std::min(tail(h), head(h)) + 1];
    for (std::size_t v = 0; v < leaf_.vertices.size(); ++v) first_[v + 1] += first_[v];
    entries_.resize(count);
    std::vector<std::uint32_t> fill(first_.begin(), first_.end() - 1);
    for (std::uint32_t h = 0; h < count; ++h) {
      const std::uint32_t from = tail(h);
      const std::uint32_t to = head(h);
      entries_[fill[std::min(from, to)]++] = {std::max(from, to), h};
    }
  }

  void settle_edge(std::uint32_t smaller, std::span<const Entry> uses) {
    const auto is_forward = [&](const Entry& e) { return tail(e.halfedge) == smaller; };
    const auto forward = static_cast<std::size_t>(std::count_if(uses.begin(), uses.end(), is_forward));
    const std::size_t backward = uses.size() - forward;
    const MeshEdge edge{smaller, uses[0].larger};
    if (forward == 1 && backward == 1) {
      leaf_.twins[uses[0].halfedge] = uses[1].halfedge;
      leaf_.twins[uses[1].halfedge] = uses[0].halfedge;
    } else if (forward == backward) {
      note(diagnosis_.nonmanifold_edges, edge, max_listed_);
    } else {
      const MeshEdge excess = forward > backward ? edge : MeshEdge{edge.to, edge.from};
      note(uses.size() == 2 ? diagnosis_.misoriented_edges : diagnosis_.open_edges, excess, max_listed_);
    }
  }

  Leaf& leaf_;
  std::size_t max_listed_;
  MeshDiagnosis& diagnosis_;
  const Context& context_;
  std::vector<std::uint32_t> first_;
  std::vector<Entry> entries_;
};

}  // namespace

void match_twins(Leaf& leaf, std::size_t max_listed, MeshDiagnosis& diagnosis, const Context& context) {
  TwinMatcher(leaf, max_listed, diagnosis, context).run();
}

}  // namespace quoin
