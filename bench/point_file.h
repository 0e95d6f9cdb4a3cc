// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

/// Points of space, a line each, in decimals that read back as the same doubles.
namespace point_file {

using Point = std::array<double, 3>;

inline std::vector<Point> read(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("cannot read " + file);
  std::vector<Point> points;
  for (Point p{}; in >> p[0] >> p[1] >> p[2];) points.push_back(p);
  return points;
}

inline void write(const std::string& file, const std::vector<Point>& points) {
  std::ofstream out(file);
  for (const Point& p : points) {
    char line[100];
    std::snprintf(line, sizeof line, "%.17g %.17g %.17g\n", p[0], p[1], p[2]);
    out << line;
  }
  if (!out) throw std::runtime_error("cannot write " + file);
}

}  // namespace point_file
