// SPDX-License-Identifier: Apache-2.0
//
// Reading a binary STL against the least that welding needs: fread of the whole file and one hash insertion per vertex.
//
//   stl_bench [SEGMENTS] [RUNS]
//
// writes a sphere of 4 SEGMENTS^2 triangles (default 500: a million) to a temporary file, reads it both ways in turn,
// and prints medians and their ratio.
#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "quoin/io/mesh_file.h"

namespace {

using Single = std::array<float, 3>;

constexpr double pi = 3.14159265358979323846;

Single on_sphere(std::size_t i, std::size_t j, std::size_t rings, std::size_t sectors) {
  if (i == 0) return {0, 0, 1};
  if (i == rings) return {0, 0, -1};
  const double polar = pi * static_cast<double>(i) / static_cast<double>(rings);
  const double turn = 2 * pi * static_cast<double>(j % sectors) / static_cast<double>(sectors);
  return {static_cast<float>(std::sin(polar) * std::cos(turn)), static_cast<float>(std::sin(polar) * std::sin(turn)),
          static_cast<float>(std::cos(polar))};
}

void put(std::vector<char>& out, const Single& a, const Single& b, const Single& c) {
  std::array<char, 50> record{};
  std::memcpy(record.data() + 12, a.data(), 12);
  std::memcpy(record.data() + 24, b.data(), 12);
  std::memcpy(record.data() + 36, c.data(), 12);
  out.insert(out.end(), record.begin(), record.end());
}

std::vector<char> sphere_stl(std::size_t segments) {
  const std::size_t rings = segments + 1;
  const std::size_t sectors = 2 * segments;
  std::vector<char> out(84);
  for (std::size_t i = 0; i < rings; ++i) {
    for (std::size_t j = 0; j < sectors; ++j) {
      const Single a = on_sphere(i, j, rings, sectors);
      const Single b = on_sphere(i + 1, j, rings, sectors);
      const Single c = on_sphere(i + 1, j + 1, rings, sectors);
      const Single d = on_sphere(i, j + 1, rings, sectors);
      if (i + 1 < rings) put(out, a, b, c);
      if (i > 0) put(out, a, c, d);
    }
  }
  const auto count = static_cast<std::uint32_t>((out.size() - 84) / 50);
  std::memcpy(out.data() + 80, &count, 4);
  return out;
}

// The least that a weld needs, written plainly: the whole file in memory, a linear probing table of 16-byte slots that
// starts at the number of vertices a closed mesh of that many triangles has.
std::size_t bare_read(const std::string& path) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) std::abort();
  const std::size_t size = std::filesystem::file_size(path);
  const auto bytes = std::make_unique_for_overwrite<char[]>(size);
  if (std::fread(bytes.get(), 1, size, file.get()) != size) std::abort();
  struct Slot {
    Single point;
    std::uint32_t number;
  };
  const std::size_t triangles = (size - 84) / 50;
  std::vector<Slot> slots(std::bit_ceil(triangles), Slot{{}, 0xFFFFFFFFU});
  const std::size_t mask = slots.size() - 1;
  std::uint32_t distinct = 0;
  for (std::size_t t = 0; t < triangles; ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      Single p;
      std::memcpy(p.data(), bytes.get() + 84 + 50 * t + 12 + 12 * k, 12);
      std::array<std::uint32_t, 3> bits{};
      std::memcpy(bits.data(), p.data(), 12);
      std::uint64_t h =
          (bits[0] * 0x9E3779B97F4A7C15U) ^ (bits[1] * 0xC2B2AE3D27D4EB4FU) ^ (bits[2] * 0x165667B19E3779F9U);
      h ^= h >> 32;
      std::size_t slot = h & mask;
      while (slots[slot].number != 0xFFFFFFFFU && slots[slot].point != p) slot = (slot + 1) & mask;
      if (slots[slot].number == 0xFFFFFFFFU) slots[slot] = {p, distinct++};
    }
  }
  return distinct;
}

std::size_t quoin_read(const std::string& path, const quoin::Context& context) {
  return quoin::read_mesh(path, {}, context).mesh.vertices.size();
}

double seconds_of(const std::function<std::size_t()>& work, std::size_t& result) {
  const auto start = std::chrono::steady_clock::now();
  result = work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t segments = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 500;
  const std::size_t runs = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 15;
  const std::string path = (std::filesystem::temp_directory_path() / "quoin_stl_bench.stl").string();
  const std::vector<char> bytes = sphere_stl(segments);
  {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "wb"), &std::fclose);
    if (!file || std::fwrite(bytes.data(), 1, bytes.size(), file.get()) != bytes.size()) return 3;
  }
  const quoin::Context one({.threads = 1});
  const quoin::Context two({.threads = 2});
  std::vector<double> bare;
  std::vector<double> single;
  std::vector<double> pair;
  std::size_t expected = 0;
  std::size_t got_one = 0;
  std::size_t got_two = 0;
  for (std::size_t run = 0; run <= runs; ++run) {
    const double a = seconds_of([&] { return bare_read(path); }, expected);
    const double b = seconds_of([&] { return quoin_read(path, one); }, got_one);
    const double c = seconds_of([&] { return quoin_read(path, two); }, got_two);
    if (run == 0) continue;  // warms the file cache
    bare.push_back(a);
    single.push_back(b);
    pair.push_back(c);
  }
  std::filesystem::remove(path);
  if (got_one != expected || got_two != expected) {
    std::fprintf(stderr, "the readers disagree: %zu %zu %zu vertices\n", expected, got_one, got_two);
    return 1;
  }
  std::printf("%zu triangles, %zu vertices, medians of %zu runs\n", (bytes.size() - 84) / 50, expected, runs);
  std::printf("fread and a hash     %8.2f ms\n", 1e3 * median(bare));
  std::printf("read_mesh, 1 thread  %8.2f ms  %.2fx\n", 1e3 * median(single), median(single) / median(bare));
  std::printf("read_mesh, 2 threads %8.2f ms  %.2fx\n", 1e3 * median(pair), median(pair) / median(bare));
}
