// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "quoin/cli/nearest_cells.h"

/// What the two kinds of nearest_cells.h have in common.
namespace quoin::cli {

/// Of the plane.
std::unique_ptr<NearestCells> nearest_cells_of_plane(const PointFile& file, const Context& context);
/// Of space.
std::unique_ptr<NearestCells> nearest_cells_of_space(const PointFile& file, bool is_written, const Context& context);

constexpr std::uint32_t no_number = ExactColumns::none;

/// Corners of the diagram by the number of their Delone cell; each is rounded once.
class Corners {
 public:
  explicit Corners(std::size_t count) : number_(count, no_number) {}

  /// The place among `points`, where `make()` goes if the corner is not there. Begins anew where there are none.
  template <class Make>
  std::uint32_t place(std::uint32_t corner, std::vector<Point3>& points, const Make& make) {
    if (points.empty()) std::ranges::fill(number_, no_number);
    if (number_[corner] == no_number) {
      number_[corner] = static_cast<std::uint32_t>(points.size());
      points.push_back(make());
    }
    return number_[corner];
  }

 private:
  std::vector<std::uint32_t> number_;
};

/// Faces of a diagram with the sites that they are of.
class FaceList {
 public:
  explicit FaceList(unsigned dimension) { cells_.dimension = dimension; }

  void add_corner(const RationalPoint3& p) {
    cells_.add_point(p);
    add(ExactCellKind::simplex, std::array{static_cast<std::uint32_t>(inputs_.size())});
  }
  std::uint32_t add(ExactCellKind kind, std::span<const std::uint32_t> numbers, std::uint32_t input = no_number,
                    std::uint32_t neighbour = no_number) {
    cells_.add_cell(kind, numbers);
    inputs_.push_back(input);
    neighbours_.push_back(neighbour);
    return static_cast<std::uint32_t>(inputs_.size() - 1);
  }
  ExactCells take() {
    cells_.cell_data.integers = {{"input", std::move(inputs_)}, {"neighbour", std::move(neighbours_)}};
    return std::move(cells_);
  }

 private:
  ExactCells cells_;
  std::vector<std::uint32_t> inputs_;
  std::vector<std::uint32_t> neighbours_;
};

/// The vertices that have cells, by numbers of their own where some have none.
class Sites {
 public:
  template <class Labels>
  Sites(std::size_t vertices, const Labels& has_cell) : count_(vertices) {
    std::vector<std::uint32_t> sites(vertices, no_number);
    for (std::uint32_t v = 0; v < vertices; ++v) {
      if (!has_cell(v)) continue;
      sites[v] = static_cast<std::uint32_t>(vertex_.size());
      vertex_.push_back(v);
    }
    count_ = vertex_.size();
    if (count_ == vertices) {
      vertex_.clear();
    } else {
      site_ = std::move(sites);
    }
  }

  std::size_t count() const { return count_; }
  std::uint32_t vertex(std::uint32_t site) const { return vertex_.empty() ? site : vertex_[site]; }
  std::uint32_t site(std::uint32_t vertex) const { return site_.empty() ? vertex : site_[vertex]; }

 private:
  std::size_t count_;
  std::vector<std::uint32_t> vertex_;
  std::vector<std::uint32_t> site_;
};

}  // namespace quoin::cli
