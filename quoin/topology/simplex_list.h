// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <vector>

namespace quoin {

/// Simplices as they are given: each a sequence of vertex numbers of its own length, whose order is an orientation.
///
/// No promise about anything: `check_simplices` tells what is wrong with a list, `SimplicialComplex` makes a complex.
class SimplexList {
 public:
  SimplexList() = default;
  SimplexList(std::initializer_list<std::initializer_list<std::uint32_t>> simplices) {
    for (const auto& simplex : simplices) add({simplex.begin(), simplex.size()});
  }

  std::size_t size() const { return begin_.size() - 1; }
  std::span<const std::uint32_t> operator[](std::size_t i) const {
    return {vertices_.data() + begin_[i], begin_[i + 1] - begin_[i]};
  }
  void add(std::span<const std::uint32_t> simplex) {
    vertices_.insert(vertices_.end(), simplex.begin(), simplex.end());
    begin_.push_back(vertices_.size());
  }

 private:
  std::vector<std::uint32_t> vertices_;
  std::vector<std::size_t> begin_{0};
};

}  // namespace quoin
