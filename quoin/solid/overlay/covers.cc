// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/overlay/covers.h"

#include <algorithm>

namespace quoin::overlay {

namespace {

class CoverWalk {
 public:
  CoverWalk(std::uint32_t region_count, std::span<const RegionNeighbours> neighbours)
      : neighbours_(neighbours), covers_(region_count), seen_(region_count, false), first_(region_count + 1, 0) {
    for (const RegionNeighbours& n : neighbours) {
      ++first_[n.a + 1];
      ++first_[n.b + 1];
    }
    for (std::size_t r = 0; r < region_count; ++r) first_[r + 1] += first_[r];
    around_.resize(first_.back());
    std::vector<std::uint32_t> fill(first_.begin(), first_.end() - 1);
    for (std::uint32_t i = 0; i < neighbours.size(); ++i) {
      around_[fill[neighbours[i].a]++] = i;
      around_[fill[neighbours[i].b]++] = i;
    }
  }

  Covers run(std::uint32_t outside) {
    seen_[outside] = true;
    std::vector<std::uint32_t> stack{outside};
    while (!stack.empty()) {
      const std::uint32_t region = stack.back();
      stack.pop_back();
      for (std::uint32_t i = first_[region]; i < first_[region + 1]; ++i) {
        const RegionNeighbours& n = neighbours_[around_[i]];
        const std::uint32_t other = n.a == region ? n.b : n.a;
        if (seen_[other]) continue;
        seen_[other] = true;
        covers_[other] = covers_[region];
        for (const std::uint32_t unit : n.toggled) toggle(covers_[other], unit);
        stack.push_back(other);
      }
    }
    Covers result;
    for (const auto& cover : covers_) {
      result.units.insert(result.units.end(), cover.begin(), cover.end());
      result.first.push_back(static_cast<std::uint32_t>(result.units.size()));
    }
    return result;
  }

 private:
  static void toggle(std::vector<std::uint32_t>& cover, std::uint32_t unit) {
    const auto place = std::lower_bound(cover.begin(), cover.end(), unit);
    if (place != cover.end() && *place == unit) {
      cover.erase(place);
    } else {
      cover.insert(place, unit);
    }
  }

  std::span<const RegionNeighbours> neighbours_;
  std::vector<std::vector<std::uint32_t>> covers_;
  std::vector<bool> seen_;
  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> around_;
};

}  // namespace

Covers find_covers(std::uint32_t region_count, std::uint32_t outside, std::span<const RegionNeighbours> neighbours) {
  return CoverWalk(region_count, neighbours).run(outside);
}

}  // namespace quoin::overlay
