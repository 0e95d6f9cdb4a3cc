// SPDX-License-Identifier: Apache-2.0
//
// Writes an input of the benchmarks of arrangements, in the format of arrangement_input.h.
//
//   make_arrangement_inputs KIND SIZE FILE [SEED]
//
// KIND                                                    SIZE
//   long_segments short_segments lattice pencil band      segments
//   perturbed_grid_a perturbed_grid_b                     cells on a side; two subdivisions to overlay
//   coverage coverage_noisy                               cells on a side, 18 segments each
//   circles discs great_circles geodesics polygons        curves or polygons
//   comb_a comb_b fork_a fork_b                           vertices of one polygon of a pair, for Minkowski sums
//   queries                                               points
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "arrangement_families.h"

namespace {

using families::Int;

void append(std::string& out, Int value, char separator) {
  char digits[24];
  const auto [end, error] = std::to_chars(digits, digits + sizeof digits, value);
  out.append(digits, end);
  out.push_back(separator);
}

template <std::size_t n>
void append(std::string& out, const std::array<Int, n>& element) {
  for (const Int value : element) append(out, value, ' ');
  out.back() = '\n';
}

void append(std::string& out, const families::Polygon& polygon) {
  append(out, static_cast<Int>(polygon.size()), ' ');
  for (const families::Point& p : polygon) {
    append(out, p[0], ' ');
    append(out, p[1], ' ');
  }
  out.back() = '\n';
}

template <class Element>
std::string text(const char* kind, const std::vector<Element>& elements) {
  std::string out = kind;
  out.push_back(' ');
  append(out, static_cast<Int>(elements.size()), '\n');
  for (const Element& element : elements) append(out, element);
  return out;
}

std::string segments(std::string_view kind, Int size, Random& random) {
  const auto written = [](const std::vector<families::Segment>& all) { return text("segments", all); };
  if (kind == "long_segments") return written(families::long_segments(size, random));
  if (kind == "short_segments") return written(families::short_segments(size, random));
  if (kind == "perturbed_grid_a") return written(families::perturbed_grid(size, false, random));
  if (kind == "perturbed_grid_b") return written(families::perturbed_grid(size, true, random));
  if (kind == "coverage") return written(families::coverage(size, 0, random));
  if (kind == "coverage_noisy") return written(families::coverage(size, 2, random));
  if (kind == "lattice") return written(families::lattice(size, random));
  if (kind == "pencil") return written(families::pencil(size, random));
  if (kind == "band") return written(families::band(size, random));
  return {};
}

std::string others(std::string_view kind, Int size, Random& random) {
  using Polygons = std::vector<families::Polygon>;
  if (kind == "circles") return text("circles", families::circles(size, random));
  if (kind == "discs") return text("circles", families::discs(size, random));
  if (kind == "great_circles") return text("great_circles", families::great_circles(size, random));
  if (kind == "geodesics") return text("geodesics", families::geodesics(size, random));
  if (kind == "polygons") return text("polygons", families::star_polygons(size, random));
  if (kind == "comb_a") return text("polygons", Polygons{families::comb(size, false, random)});
  if (kind == "comb_b") return text("polygons", Polygons{families::comb(size, true, random)});
  if (kind == "fork_a") return text("polygons", Polygons{families::fork(size, false)});
  if (kind == "fork_b") return text("polygons", Polygons{families::fork(size, true)});
  if (kind == "queries") return text("points", families::queries(size, random));
  return {};
}

// Different for every kind (FNV-1a), but the same for a map and its noisy twin.
std::uint64_t seed_of(std::string_view kind, std::uint64_t seed) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : kind.substr(0, kind.find("_noisy"))) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  }
  return hash + seed;
}

}  // namespace

int main(int argc, char** argv) {
  const Int size = argc > 2 ? std::atoll(argv[2]) : 0;
  if (argc < 4 || argc > 5 || size < 1) {
    std::fprintf(stderr, "make_arrangement_inputs KIND SIZE FILE [SEED]\n");
    return 2;
  }
  Random random(seed_of(argv[1], argc > 4 ? std::strtoull(argv[4], nullptr, 10) : 1));
  std::string written = segments(argv[1], size, random);
  if (written.empty()) written = others(argv[1], size, random);
  if (written.empty()) {
    std::fprintf(stderr, "make_arrangement_inputs: no inputs are called %s\n", argv[1]);
    return 2;
  }
  std::ofstream file(argv[3], std::ios::binary);
  file << written;
  file.close();
  if (!file) {
    std::fprintf(stderr, "make_arrangement_inputs: cannot write %s\n", argv[3]);
    return 1;
  }
  return 0;
}
