// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include "random.h"

/// Complexes whose simplices have values, for programs that compute their persistence. Faces come before cofaces.
namespace filtered_simplices {

struct List {
  std::vector<double> values;
  std::vector<std::size_t> begin{0};
  std::vector<std::uint32_t> vertices;

  std::size_t size() const { return values.size(); }
  void add(double value, const std::uint32_t* simplex, std::size_t count) {
    values.push_back(value);
    vertices.insert(vertices.end(), simplex, simplex + count);
    begin.push_back(vertices.size());
  }
};

/// n x n x n points with six tetrahedra in each cube; each simplex enters with its last vertex. Values of vertices are
/// random, and averaged over cubes of `smoothing` points a side.
inline List grid(std::uint32_t n, std::uint32_t smoothing) {
  Random random(1);
  std::vector<double> noise(std::size_t{n} * n * n);
  for (double& x : noise) x = static_cast<double>(random.between(0, 1 << 30));
  const auto at = [&](std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    return (std::size_t{x % n} * n + y % n) * n + z % n;
  };
  for (std::uint32_t axis = 0; axis < 3 && smoothing > 1; ++axis) {
    std::vector<double> mean(noise.size(), 0);
    for (std::uint32_t x = 0; x < n; ++x)
      for (std::uint32_t y = 0; y < n; ++y)
        for (std::uint32_t z = 0; z < n; ++z)
          for (std::uint32_t i = 0; i < smoothing; ++i)
            mean[at(x, y, z)] += noise[at(x + (axis == 0 ? i : 0), y + (axis == 1 ? i : 0), z + (axis == 2 ? i : 0))];
    noise = std::move(mean);
  }
  // Chains of 0 to 3 further steps, each along a nonempty set of the axes that are left.
  std::vector<std::vector<std::uint32_t>> chains{{}};
  for (std::size_t i = 0; i < chains.size(); ++i) {
    const std::vector<std::uint32_t> chain = chains[i];
    const std::uint32_t used = chain.empty() ? 0 : chain.back();
    for (std::uint32_t mask = used + 1; mask < 8; ++mask) {
      if ((mask & used) != used) continue;
      chains.push_back(chain);
      chains.back().push_back(mask);
    }
  }
  List list;
  for (std::size_t length = 0; length <= 3; ++length) {
    for (std::uint32_t x = 0; x < n; ++x)
      for (std::uint32_t y = 0; y < n; ++y)
        for (std::uint32_t z = 0; z < n; ++z)
          for (const std::vector<std::uint32_t>& chain : chains) {
            if (chain.size() != length) continue;
            std::array<std::uint32_t, 4> simplex{static_cast<std::uint32_t>(at(x, y, z))};
            double value = noise[simplex[0]];
            bool is_inside = true;
            for (std::size_t i = 0; i < length; ++i) {
              const std::uint32_t px = x + (chain[i] & 1), py = y + (chain[i] >> 1 & 1), pz = z + (chain[i] >> 2);
              is_inside = is_inside && px < n && py < n && pz < n;
              simplex[i + 1] = static_cast<std::uint32_t>(at(px, py, pz));
              value = std::max(value, noise[simplex[i + 1]]);
            }
            if (is_inside) list.add(value, simplex.data(), length + 1);
          }
  }
  return list;
}

/// Cliques of at most d + 1 of n random points of a sphere of dimension `of_sphere`, with edges up to a distance; each
/// enters with its longest edge, by the square of its length.
class Rips {
 public:
  Rips(std::uint32_t n, double distance, std::uint32_t d, std::size_t of_sphere) : limit_(distance * distance), d_(d) {
    Random random(2);
    for (std::uint32_t i = 0; i < n; ++i) {
      std::vector<double> p(of_sphere + 1);
      double square = 0;
      do {
        square = 0;
        for (double& x : p) {
          x = static_cast<double>(random.between(-(1 << 30), 1 << 30)) / (1 << 30);
          square += x * x;
        }
      } while (square > 1 || square < 0.01);
      for (double& x : p) x /= std::sqrt(square);
      points_.push_back(p);
    }
    by_size_.resize(d + 1);
    std::vector<std::uint32_t> all(n);
    for (std::uint32_t i = 0; i < n; ++i) all[i] = i;
    extend(all, 0);
  }

  List list() const {
    List result;
    for (const List& part : by_size_)
      for (std::size_t i = 0; i < part.size(); ++i)
        result.add(part.values[i], part.vertices.data() + part.begin[i], part.begin[i + 1] - part.begin[i]);
    return result;
  }

 private:
  double square(std::uint32_t i, std::uint32_t j) const {
    double sum = 0;
    for (std::size_t l = 0; l < points_[i].size(); ++l)
      sum += (points_[i][l] - points_[j][l]) * (points_[i][l] - points_[j][l]);
    return sum;
  }

  void extend(const std::vector<std::uint32_t>& candidates, double value) {
    for (std::size_t c = 0; c < candidates.size(); ++c) {
      double longest = value;
      for (const std::uint32_t v : clique_) longest = std::max(longest, square(v, candidates[c]));
      clique_.push_back(candidates[c]);
      by_size_[clique_.size() - 1].add(longest, clique_.data(), clique_.size());
      if (clique_.size() <= d_) {
        std::vector<std::uint32_t> next;
        for (std::size_t e = c + 1; e < candidates.size(); ++e)
          if (square(candidates[c], candidates[e]) <= limit_) next.push_back(candidates[e]);
        extend(next, longest);
      }
      clique_.pop_back();
    }
  }

  double limit_;
  std::uint32_t d_;
  std::vector<std::vector<double>> points_;
  std::vector<std::uint32_t> clique_;
  std::vector<List> by_size_;
};

/// Records of a double, the number of vertices and these, as bytes.
inline void write(const std::string& path, const List& list) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) throw std::runtime_error("cannot write " + path);
  for (std::size_t i = 0; i < list.size(); ++i) {
    const auto count = static_cast<std::uint32_t>(list.begin[i + 1] - list.begin[i]);
    std::fwrite(&list.values[i], sizeof(double), 1, file);
    std::fwrite(&count, sizeof count, 1, file);
    std::fwrite(list.vertices.data() + list.begin[i], sizeof(std::uint32_t), count, file);
  }
  if (std::fclose(file) != 0) throw std::runtime_error("cannot write " + path);
}

inline List read(const std::string& path) {
  std::FILE* file = std::fopen(path.c_str(), "rb");
  if (file == nullptr) throw std::runtime_error("cannot read " + path);
  List list;
  double value = 0;
  std::uint32_t count = 0;
  std::array<std::uint32_t, 20> simplex;
  while (std::fread(&value, sizeof value, 1, file) == 1) {
    if (std::fread(&count, sizeof count, 1, file) != 1 || count > simplex.size() ||
        std::fread(simplex.data(), sizeof(std::uint32_t), count, file) != count)
      throw std::runtime_error("bad record in " + path);
    list.add(value, simplex.data(), count);
  }
  std::fclose(file);
  return list;
}

/// grid N SMOOTHING | rips POINTS DISTANCE DIMENSION SPHERE | file PATH
inline List make(const std::vector<std::string>& words) {
  const auto number = [&](std::size_t i) {
    return static_cast<std::uint32_t>(std::strtoul(words[i].c_str(), nullptr, 10));
  };
  if (words.size() == 3 && words[0] == "grid") return grid(number(1), number(2));
  if (words.size() == 5 && words[0] == "rips")
    return Rips(number(1), std::strtod(words[2].c_str(), nullptr), number(3), number(4)).list();
  if (words.size() == 2 && words[0] == "file") return read(words[1]);
  throw std::invalid_argument("grid N SMOOTHING | rips POINTS DISTANCE DIMENSION SPHERE | file PATH");
}

}  // namespace filtered_simplices
