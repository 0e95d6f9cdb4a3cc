// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/leaf_twins.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "quoin/solid/leaf_tiles.h"

namespace quoin {

namespace {

// A halfedge in the bucket of its smaller vertex.
struct Entry {
  std::uint32_t larger;
  std::uint32_t halfedge;
};

// The common case, every edge used once in each direction and vertices of few edges, in one pass over the halfedges:
// those that run to a larger vertex wait in the bucket of their smaller one for those that come back. Buckets are
// searched from end to end, so long ones, as at the apex of a cone, are left to sorting. O(n) for that reason.
class PlainTwinMatcher {
 public:
  explicit PlainTwinMatcher(Leaf& leaf) : leaf_(leaf) {}

  // False, and nothing said, where some edge is used in any other way or a bucket is long.
  bool run(const Context& context) {
    const auto count = static_cast<std::uint32_t>(3 * leaf_.tiles.size());
    if (!fill_buckets(count)) return false;
    context.poll();
    leaf_.twins.resize(count);
    for (std::uint32_t t = 0; t < leaf_.tiles.size(); ++t) {
      if (t % 16384 == 0) context.poll();
      const Tile& tile = leaf_.tiles[t];
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t from = tile[k];
        const std::uint32_t to = tile[k == 2 ? 0 : k + 1];
        if (from > to && !match(to, from, 3 * t + k)) return false;
      }
    }
    return true;  // as many came back as waited, no two to one
  }

 private:
  static constexpr std::uint32_t longest_bucket = 32;

  bool fill_buckets(std::uint32_t count) {
    first_.assign(leaf_.vertices.size() + 1, 0);
    for (const Tile& tile : leaf_.tiles) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (tile[k] < tile[k == 2 ? 0 : k + 1]) ++first_[tile[k] + 1];
      }
    }
    if (*std::max_element(first_.begin(), first_.end()) > longest_bucket) return false;
    for (std::size_t v = 0; v < leaf_.vertices.size(); ++v) first_[v + 1] += first_[v];
    if (2 * std::size_t{first_.back()} != count) return false;
    waiting_.resize(first_.back());
    std::vector<std::uint32_t> fill(first_.begin(), first_.end() - 1);
    for (std::uint32_t t = 0; t < leaf_.tiles.size(); ++t) {
      const Tile& tile = leaf_.tiles[t];
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t to = tile[k == 2 ? 0 : k + 1];
        if (tile[k] >= to) continue;
        for (std::uint32_t i = first_[tile[k]]; i < fill[tile[k]]; ++i) {
          if (waiting_[i].larger == to) return false;
        }
        waiting_[fill[tile[k]]++] = {to, 3 * t + k};
      }
    }
    return true;
  }

  bool match(std::uint32_t smaller, std::uint32_t larger, std::uint32_t halfedge) {
    for (std::uint32_t i = first_[smaller]; i < first_[smaller + 1]; ++i) {
      if (waiting_[i].larger != larger) continue;
      leaf_.twins[halfedge] = waiting_[i].halfedge;
      leaf_.twins[waiting_[i].halfedge] = halfedge;
      waiting_[i].larger = Leaf::no_twin;  // taken
      return true;
    }
    return false;
  }

  Leaf& leaf_;
  std::vector<std::uint32_t> first_;
  std::vector<Entry> waiting_;
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
      if (!is_inside_faces(uses, smaller)) note(diagnosis_.nonmanifold_edges, edge, max_listed_);
    } else {
      const MeshEdge excess = forward > backward ? edge : MeshEdge{edge.to, edge.from};
      note(uses.size() == 2 ? diagnosis_.misoriented_edges : diagnosis_.open_edges, excess, max_listed_);
    }
  }

  // Whether each face that uses the edge does so in both directions: a diagonal of polygons that lie on each other.
  bool is_inside_faces(std::span<const Entry> uses, std::uint32_t smaller) const {
    std::vector<std::pair<std::uint32_t, int>> turns;  // face, direction
    for (const Entry& e : uses)
      turns.push_back({leaf_.tile_face[e.halfedge / 3], tail(e.halfedge) == smaller ? 1 : -1});
    std::sort(turns.begin(), turns.end());
    int balance = 0;
    for (std::size_t i = 0; i < turns.size(); ++i) {
      balance += turns[i].second;
      const bool is_last = i + 1 == turns.size() || turns[i + 1].first != turns[i].first;
      if (is_last && balance != 0) return false;
    }
    return true;
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
  leaf.has_all_twins = PlainTwinMatcher(leaf).run(context);
  if (!leaf.has_all_twins) TwinMatcher(leaf, max_listed, diagnosis, context).run();
}

}  // namespace quoin
