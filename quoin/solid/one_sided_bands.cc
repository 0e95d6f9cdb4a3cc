// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/one_sided_bands.h"

#include <algorithm>

namespace quoin {

namespace {

constexpr std::uint32_t none = 0xFFFFFFFFU;

class Flood {
 public:
  Flood(std::size_t face_count, std::span<const FaceLink> links, const Context& context)
      : links_(links), context_(context), first_(face_count + 1, 0), parent_(face_count, none), depth_(face_count, 0) {
    out_.component.assign(face_count, none);
    out_.is_reversed.assign(face_count, 0);
  }

  Orientation run() {
    gather_neighbours();
    for (std::uint32_t seed = 0; seed < out_.component.size(); ++seed) {
      if (out_.component[seed] == none) fill(seed);
    }
    return std::move(out_);
  }

 private:
  struct Neighbour {
    std::uint32_t face;
    bool agrees;
  };

  void gather_neighbours() {
    for (const FaceLink& link : links_) {
      ++first_[link.a + 1];
      ++first_[link.b + 1];
    }
    for (std::size_t f = 1; f < first_.size(); ++f) first_[f] += first_[f - 1];
    neighbours_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (const FaceLink& link : links_) {
      neighbours_[next[link.a]++] = {link.b, link.agrees};
      neighbours_[next[link.b]++] = {link.a, link.agrees};
    }
  }

  // Breadth first, so that bands are short.
  void fill(std::uint32_t seed) {
    const std::uint32_t number = out_.component_count++;
    bool is_one_sided = false;
    out_.component[seed] = number;
    members_.assign(1, seed);
    for (std::size_t i = 0; i < members_.size(); ++i) {
      const std::uint32_t f = members_[i];
      if (i % 4096 == 0) context_.poll();
      for (std::size_t n = first_[f]; n < first_[f + 1]; ++n) {
        const auto [face, agrees] = neighbours_[n];
        const std::uint8_t reversed = out_.is_reversed[f] ^ (agrees ? 0 : 1);
        if (out_.component[face] == none) {
          out_.component[face] = number;
          out_.is_reversed[face] = reversed;
          parent_[face] = f;
          depth_[face] = depth_[f] + 1;
          members_.push_back(face);
        } else if (out_.is_reversed[face] != reversed && !is_one_sided) {
          is_one_sided = true;
          out_.one_sided_bands.push_back(band(f, face));
        }
      }
    }
    out_.is_one_sided.push_back(is_one_sided ? 1 : 0);
  }

  // The ways from two faces that disagree to the first face that both have on theirs.
  std::vector<std::uint32_t> band(std::uint32_t a, std::uint32_t b) const {
    std::vector<std::uint32_t> left{a};
    std::vector<std::uint32_t> right;
    while (a != b) {
      if (depth_[a] >= depth_[b]) {
        a = parent_[a];
        left.push_back(a);
      } else {
        right.push_back(b);
        b = parent_[b];
      }
    }
    left.insert(left.end(), right.rbegin(), right.rend());
    return left;
  }

  std::span<const FaceLink> links_;
  const Context& context_;
  Orientation out_;
  std::vector<std::size_t> first_;  // per face, into neighbours_
  std::vector<Neighbour> neighbours_;
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint32_t> depth_;
  std::vector<std::uint32_t> members_;
};

}  // namespace

Orientation orient_faces(std::size_t face_count, std::span<const FaceLink> links, const Context& context) {
  return Flood(face_count, links, context).run();
}

}  // namespace quoin
