// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/repair_duplicates.h"

#include <algorithm>
#include <span>
#include <unordered_map>
#include <utility>

#include "quoin/base/disjoint_sets.h"

namespace quoin {

namespace {

using Corners = std::vector<std::uint32_t>;

// A face's outline from its smallest corner towards the smaller neighbour of that, and which way the face runs.
struct Outline {
  Corners corners;
  std::uint32_t face;
  bool forward;
};

Outline outline_of(const Corners& face, std::uint32_t index) {
  Outline result{face, index, true};
  std::rotate(result.corners.begin(), std::min_element(result.corners.begin(), result.corners.end()),
              result.corners.end());
  if (result.corners.back() < result.corners[1]) {
    std::reverse(result.corners.begin() + 1, result.corners.end());
    result.forward = false;
  }
  return result;
}

std::uint64_t edge_key(std::uint32_t a, std::uint32_t b) {
  return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
}

template <class Visitor>
void for_each_edge(const Corners& face, const Visitor& visit) {
  for (std::size_t i = 0; i < face.size(); ++i) visit(edge_key(face[i], face[i + 1 == face.size() ? 0 : i + 1]));
}

class DuplicateFinder {
 public:
  DuplicateFinder(const std::vector<Corners>& faces, const Context& context) : faces_(faces), context_(context) {}

  SuperfluousFaces run() {
    find_groups();
    if (!balanced_.empty()) {
      count_uses_of_others();
      settle_balanced();
    }
    std::sort(out_.duplicates.begin(), out_.duplicates.end());
    std::sort(out_.balanced.begin(), out_.balanced.end());
    return std::move(out_);
  }

 private:
  using Group = std::vector<std::uint32_t>;  // faces of one outline, ascending

  void find_groups() {
    std::vector<Outline> outlines;
    outlines.reserve(faces_.size());
    for (std::uint32_t f = 0; f < faces_.size(); ++f) {
      if (f % 4096 == 0) context_.poll();
      outlines.push_back(outline_of(faces_[f], f));
    }
    std::sort(outlines.begin(), outlines.end(), [](const Outline& a, const Outline& b) {
      return a.corners != b.corners ? a.corners < b.corners : a.face < b.face;
    });
    context_.poll();
    for (std::size_t begin = 0, end = 0; begin < outlines.size(); begin = end) {
      while (end < outlines.size() && outlines[end].corners == outlines[begin].corners) ++end;
      if (end - begin > 1) settle_group(std::span(outlines).subspan(begin, end - begin));
    }
  }

  void settle_group(std::span<const Outline> group) {
    const auto forward =
        static_cast<std::size_t>(std::count_if(group.begin(), group.end(), [](const Outline& o) { return o.forward; }));
    if (2 * forward == group.size()) {
      Group faces;
      for (const Outline& o : group) faces.push_back(o.face);
      balanced_.push_back(std::move(faces));
      return;
    }
    const bool kept_way = 2 * forward > group.size();
    bool is_kept = false;
    for (const Outline& o : group) {
      if (!is_kept && o.forward == kept_way) {
        is_kept = true;
      } else {
        out_.duplicates.push_back(o.face);
      }
    }
  }

  void count_uses_of_others() {
    std::vector<bool> counts(faces_.size(), true);
    for (const std::uint32_t f : out_.duplicates) counts[f] = false;
    for (const Group& group : balanced_) {
      for (const std::uint32_t f : group) counts[f] = false;
      for_each_edge(faces_[group[0]], [&](std::uint64_t edge) { uses_.try_emplace(edge, 0); });
    }
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      if (!counts[f]) continue;
      for_each_edge(faces_[f], [&](std::uint64_t edge) {
        const auto at = uses_.find(edge);
        if (at != uses_.end()) ++at->second;
      });
    }
  }

  void settle_balanced() {
    std::vector<bool> stays(balanced_.size(), false);
    for (std::size_t g = 0; g < balanced_.size(); ++g) stays[g] = closes_a_gap(faces_[balanced_[g][0]]);
    keep_surfaces(stays);
    for (std::size_t g = 0; g < balanced_.size(); ++g) {
      const Group& group = balanced_[g];
      auto& list = stays[g] ? out_.duplicates : out_.balanced;
      list.insert(list.end(), group.begin() + (stays[g] ? 1 : 0), group.end());
    }
  }

  // Most of its edges are used by an odd number of other faces.
  bool closes_a_gap(const Corners& face) const {
    std::size_t odd = 0;
    for_each_edge(face, [&](std::uint64_t edge) { odd += uses_.at(edge) % 2; });
    return 2 * odd > face.size();
  }

  // Balanced faces that hang together, touch no others, and close if each stays once.
  void keep_surfaces(std::vector<bool>& stays) {
    DisjointSets sets(balanced_.size());
    std::unordered_map<std::uint64_t, std::pair<std::uint32_t, std::size_t>> first_and_count;
    for (std::uint32_t g = 0; g < balanced_.size(); ++g) {
      for_each_edge(faces_[balanced_[g][0]], [&](std::uint64_t edge) {
        auto& [first, count] = first_and_count.try_emplace(edge, g, std::size_t{0}).first->second;
        ++count;
        sets.unite(first, g);
      });
    }
    std::vector<bool> is_surface(balanced_.size(), true);
    for (std::uint32_t g = 0; g < balanced_.size(); ++g) {
      for_each_edge(faces_[balanced_[g][0]], [&](std::uint64_t edge) {
        if (uses_.at(edge) != 0 || first_and_count.at(edge).second % 2 != 0) is_surface[sets.find(g)] = false;
      });
    }
    for (std::uint32_t g = 0; g < balanced_.size(); ++g) stays[g] = stays[g] || is_surface[sets.find(g)];
  }

  const std::vector<Corners>& faces_;
  const Context& context_;
  SuperfluousFaces out_;
  std::vector<Group> balanced_;
  std::unordered_map<std::uint64_t, std::size_t> uses_;  // of edges of balanced faces, by the other faces that stay
};

}  // namespace

SuperfluousFaces find_superfluous_faces(const std::vector<Corners>& faces, const Context& context) {
  return DuplicateFinder(faces, context).run();
}

}  // namespace quoin
