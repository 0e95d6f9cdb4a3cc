// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "quoin/number/rational.h"
#include "quoin/topology/homology.h"
#include "quoin/topology/simplicial_complex.h"

/// Complexes for tests, and slow linear algebra that shares nothing with the library's.
namespace quoin::test_complexes {

using Betti = std::vector<std::size_t>;
using Row = std::vector<std::uint32_t>;

inline Betti over(const SimplicialComplex& complex, std::uint32_t p) {
  return betti_numbers(complex, p, Context());
}
inline IntegerHomology integers(const SimplicialComplex& complex) {
  return integer_homology(complex, Context());
}

inline SimplicialComplex closure(const SimplexList& list) {
  return SimplicialComplex::closure_of(list, Context());
}

/// Triangles whose vertices are digits.
inline SimplexList triangles(const std::vector<int>& numbers) {
  SimplexList list;
  for (const int n : numbers) {
    const std::array<std::uint32_t, 3> t{static_cast<std::uint32_t>(n / 100), static_cast<std::uint32_t>(n / 10 % 10),
                                         static_cast<std::uint32_t>(n % 10)};
    list.add(t);
  }
  return list;
}

inline SimplexList seven_vertex_torus() {
  return triangles({142, 245, 253, 356, 165, 126, 276, 237, 173, 157, 475, 467, 134, 364});
}
inline SimplexList six_vertex_projective_plane() {
  return triangles({412, 423, 531, 512, 623, 631, 453, 562, 641, 456});
}
inline SimplexList annulus() {
  return triangles({142, 245, 253, 356, 136, 164});
}

/// An m by n grid of squares whose sides are glued: a torus, or a Klein bottle where one side is turned.
inline SimplexList glued_grid(std::uint32_t m, std::uint32_t n, bool is_turned, bool has_diagonals_turned = false) {
  const auto vertex = [&](std::uint32_t i, std::uint32_t j) {
    if (i == m && is_turned) j = (2 * n - j) % n;
    return (i % m) * n + j % n;
  };
  SimplexList list;
  for (std::uint32_t i = 0; i < m; ++i) {
    for (std::uint32_t j = 0; j < n; ++j) {
      const std::array<std::uint32_t, 4> v{vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)};
      const std::size_t s = has_diagonals_turned ? 1 : 0;
      list.add(std::array{v[s], v[s + 1], v[s + 2]});
      list.add(std::array{v[s], v[s + 2], v[(s + 3) % 4]});
    }
  }
  return list;
}

/// All proper faces of a simplex of dimension d + 1.
inline SimplexList sphere(std::uint32_t d) {
  SimplexList list;
  for (std::uint32_t left_out = 0; left_out < d + 2; ++left_out) {
    Row facet;
    for (std::uint32_t v = 0; v < d + 2; ++v)
      if (v != left_out) facet.push_back(v);
    list.add(facet);
  }
  return list;
}

inline SimplexList full_simplex(std::uint32_t d) {
  Row all(d + 1);
  std::iota(all.begin(), all.end(), 0U);
  SimplexList list;
  list.add(all);
  return list;
}

inline std::uint32_t vertices_of(const SimplexList& list) {
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < list.size(); ++i)
    for (const std::uint32_t v : list[i]) count = std::max(count, v + 1);
  return count;
}

/// Every simplex of one with every simplex of the other, and each by itself.
inline SimplexList join(const SimplexList& a, const SimplexList& b) {
  const std::uint32_t shift = vertices_of(a);
  SimplexList list;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      Row row(a[i].begin(), a[i].end());
      for (const std::uint32_t v : b[j]) row.push_back(v + shift);
      list.add(row);
    }
  }
  return list;
}

/// A disk whose boundary goes n times around a circle of three edges: first homology of n elements.
inline SimplexList moore_space(std::uint32_t n) {
  const std::uint32_t k = 3 * n;
  const std::uint32_t center = 3 + k;
  SimplexList list;
  for (std::uint32_t i = 0; i < k; ++i) {
    const std::uint32_t ring = 3 + i;
    const std::uint32_t next = 3 + (i + 1) % k;
    list.add(std::array{i % 3, (i + 1) % 3, ring});
    list.add(std::array{ring, (i + 1) % 3, next});
    list.add(std::array{ring, next, center});
  }
  return list;
}

/// The six tetrahedra around a diagonal of each cube of a grid.
inline SimplexList cubes(std::uint32_t nx, std::uint32_t ny, std::uint32_t nz) {
  const auto vertex = [&](std::array<std::uint32_t, 3> p) { return (p[0] * (ny + 1) + p[1]) * (nz + 1) + p[2]; };
  SimplexList list;
  for (std::uint32_t x = 0; x < nx; ++x)
    for (std::uint32_t y = 0; y < ny; ++y)
      for (std::uint32_t z = 0; z < nz; ++z) {
        std::array<std::size_t, 3> axes{0, 1, 2};
        do {
          std::array<std::uint32_t, 3> p{x, y, z};
          Row row{vertex(p)};
          for (const std::size_t axis : axes) {
            ++p[axis];
            row.push_back(vertex(p));
          }
          list.add(row);
        } while (std::next_permutation(axes.begin(), axes.end()));
      }
  return list;
}

/// Simplices of random vertices, of at most d + 1 each.
inline SimplexList random_simplices(std::mt19937_64& random, std::uint32_t vertices, std::uint32_t d, int count) {
  SimplexList list;
  Row all(vertices);
  std::iota(all.begin(), all.end(), 0U);
  for (int i = 0; i < count; ++i) {
    std::shuffle(all.begin(), all.end(), random);
    list.add({all.data(), 1 + random() % (d + 1)});
  }
  return list;
}

/// All edges between some vertices, and random triangles of these: often with torsion.
inline SimplexList random_triangles(std::mt19937_64& random, std::uint32_t vertices, std::size_t count) {
  std::vector<std::array<std::uint32_t, 3>> all;
  SimplexList list;
  for (std::uint32_t a = 0; a < vertices; ++a)
    for (std::uint32_t b = a + 1; b < vertices; ++b) {
      list.add(std::array{a, b});
      for (std::uint32_t c = b + 1; c < vertices; ++c) all.push_back({a, b, c});
    }
  std::shuffle(all.begin(), all.end(), random);
  for (std::size_t i = 0; i < std::min(count, all.size()); ++i) list.add(all[i]);
  return list;
}

/// Simplices of a complex in a random order in which faces come before cofaces.
inline std::vector<SimplexId> random_order(const SimplicialComplex& complex, std::mt19937_64& random) {
  std::vector<std::pair<double, SimplexId>> keys;
  std::vector<std::vector<double>> key(complex.dimension() + 1);
  std::uniform_real_distribution<double> step(0, 1);
  for (int k = 0; k <= complex.dimension(); ++k) {
    for (std::uint32_t i = 0; i < complex.count(k); ++i) {
      double least = 0;
      if (k > 0)
        for (const std::uint32_t facet : complex.facets({k, i})) least = std::max(least, key[k - 1][facet]);
      key[k].push_back(least + step(random));
      keys.emplace_back(key[k].back(), SimplexId{k, i});
    }
  }
  std::sort(keys.begin(), keys.end());
  std::vector<SimplexId> order;
  for (const auto& entry : keys) order.push_back(entry.second);
  return order;
}

/// A dense matrix over the integers modulo p.
using Dense = std::vector<std::vector<std::int64_t>>;

inline std::int64_t inverse_modulo(std::int64_t a, std::int64_t p) {
  for (std::int64_t x = 1; x < p; ++x)
    if (a * x % p == 1) return x;
  return 0;
}

inline std::size_t rank_modulo(Dense rows, std::int64_t p) {
  std::size_t rank = 0;
  const std::size_t columns = rows.empty() ? 0 : rows[0].size();
  for (auto& row : rows)
    for (std::int64_t& x : row) x = (x % p + p) % p;
  for (std::size_t j = 0; j < columns; ++j) {
    std::size_t pivot = rank;
    while (pivot < rows.size() && rows[pivot][j] == 0) ++pivot;
    if (pivot == rows.size()) continue;
    std::swap(rows[rank], rows[pivot]);
    const std::int64_t inverse = inverse_modulo(rows[rank][j], p);
    for (std::size_t i = rank + 1; i < rows.size(); ++i) {
      const std::int64_t f = rows[i][j] * inverse % p;
      if (f == 0) continue;
      for (std::size_t l = j; l < columns; ++l) rows[i][l] = ((rows[i][l] - f * rows[rank][l]) % p + p) % p;
    }
    ++rank;
  }
  return rank;
}

inline std::size_t rational_rank(const Dense& dense) {
  std::vector<std::vector<Rational>> rows;
  for (const auto& row : dense) rows.emplace_back(row.begin(), row.end());
  std::size_t rank = 0;
  const std::size_t columns = rows.empty() ? 0 : rows[0].size();
  for (std::size_t j = 0; j < columns; ++j) {
    std::size_t pivot = rank;
    while (pivot < rows.size() && rows[pivot][j].sign() == Sign::zero) ++pivot;
    if (pivot == rows.size()) continue;
    std::swap(rows[rank], rows[pivot]);
    for (std::size_t i = rank + 1; i < rows.size(); ++i) {
      if (rows[i][j].sign() == Sign::zero) continue;
      const Rational f = rows[i][j] / rows[rank][j];
      for (std::size_t l = j; l < columns; ++l) rows[i][l] -= f * rows[rank][l];
    }
    ++rank;
  }
  return rank;
}

/// The boundary of dimension k by the definition: rows are simplices, columns their facets, found by their vertices.
inline Dense dense_boundary(const SimplicialComplex& complex, int k) {
  std::map<Row, std::size_t> place;
  for (std::uint32_t i = 0; i < complex.count(k - 1); ++i) {
    const auto v = complex.vertices({k - 1, i});
    place.emplace(Row(v.begin(), v.end()), i);
  }
  Dense rows(complex.count(k), std::vector<std::int64_t>(complex.count(k - 1), 0));
  for (std::uint32_t i = 0; i < complex.count(k) && k > 0; ++i) {
    const auto v = complex.vertices({k, i});
    for (std::size_t j = 0; j < v.size(); ++j) {
      Row facet(v.begin(), v.end());
      facet.erase(facet.begin() + static_cast<std::ptrdiff_t>(j));
      rows[i][place.at(facet)] = j % 2 == 0 ? 1 : -1;
    }
  }
  return rows;
}

/// Betti numbers as numbers of simplices less ranks.
template <class Rank>
Betti betti_by_ranks(const SimplicialComplex& complex, const Rank& rank) {
  std::vector<std::size_t> ranks{0};
  for (int k = 1; k <= complex.dimension(); ++k) ranks.push_back(rank(dense_boundary(complex, k)));
  ranks.push_back(0);
  Betti betti;
  for (int k = 0; k <= complex.dimension(); ++k) betti.push_back(complex.count(k) - ranks[k] - ranks[k + 1]);
  return betti;
}

}  // namespace quoin::test_complexes
