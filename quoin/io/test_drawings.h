// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/io/drawing.h"
#include "quoin/number/test_doubles.h"

/// Families of drawings for tests of readers and writers.
namespace quoin::testing {

inline const Context context;

/// The message of the Error that a call ends with; empty where it returns.
template <class Call>
std::string error_of(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

/// The text of a drawing, empty if it is refused.
inline std::string written(DrawingFormat format, const Drawing& drawing, std::vector<std::string>& notes,
                           const DrawingWriteOptions& options = {}) {
  std::ostringstream out;
  try {
    notes = write_drawing(out, format, drawing, options, context);
  } catch (const InputError&) {
    return "";
  }
  return out.str();
}

inline bool shapes_equal(const Drawing& a, const Drawing& b) {
  if (a.elements.size() != b.elements.size()) return false;
  for (std::size_t i = 0; i < a.elements.size(); ++i) {
    if (a.elements[i].shape != b.elements[i].shape || a.elements[i].layer != b.elements[i].layer) return false;
  }
  return true;
}

/// What a random drawing may hold.
struct DrawingFamily {
  bool has_arcs = true;
  bool has_points = true;
  bool has_circles = true;
  bool has_layers = true;
  bool has_closed_paths = true;
  bool has_holes = true;
};

/// Of each order of magnitude, but so that sums of a few are finite.
inline double random_coordinate(Random& random) {
  switch (random() % 4) {
    case 0:
      return small_integer(random, 4);
    case 1:
      return std::ldexp(small_integer(random, 9), -3);
    case 2:
      return with_exponent(random, -40, 40);
    default:
      return with_exponent(random, -990, 990);
  }
}

inline double random_bulge(Random& random) {
  static constexpr double likely[] = {0, 1, -1, 0.5, -0.5, 2, -0.25, 0.41421356237309503};
  return random() % 3 == 0 ? with_exponent(random, -20, 20) : likely[random() % 8];
}

inline DrawingPath random_path(Random& random, const DrawingFamily& family, bool is_closed) {
  DrawingPath path;
  path.is_closed = is_closed;
  const std::size_t size = (is_closed ? 3 : 2) + random() % 5;
  for (std::size_t i = 0; i < size; ++i) {
    if (i > 0 && random() % 12 == 0) {
      path.points.push_back(path.points[i - 1]);
    } else {
      path.points.push_back({random_coordinate(random), random_coordinate(random)});
    }
  }
  // The same ends would be a closed path in some formats.
  if (!is_closed && size > 2 && path.points.front() == path.points.back()) path.points.back().x += 1;
  if (family.has_arcs && random() % 2 == 0) {
    for (std::size_t e = 0; e < path.edge_count(); ++e) path.bulges.push_back(random_bulge(random));
    bool has_arc = false;
    for (const double bulge : path.bulges) has_arc |= bulge != 0;
    if (!has_arc) path.bulges.clear();
  }
  return path;
}

inline DrawingElement random_element(Random& random, const DrawingFamily& family) {
  for (;;) {
    switch (random() % 5) {
      case 0:
        if (family.has_points) return {Point2{random_coordinate(random), random_coordinate(random)}, "", ""};
        break;
      case 1:
        if (!family.has_circles) break;
        return {
            DrawingCircle{{random_coordinate(random), random_coordinate(random)}, std::fabs(random_coordinate(random))},
            "", ""};
      case 2:
        return {random_path(random, family, false), "", ""};
      case 3:
        if (family.has_closed_paths) return {random_path(random, family, true), "", ""};
        break;
      default: {
        DrawingPolygon polygon;
        do polygon.rings.push_back(random_path(random, family, true));
        while (family.has_holes && random() % 2 == 0);
        return {std::move(polygon), "", ""};
      }
    }
  }
}

inline Drawing random_drawing(Random& random, const DrawingFamily& family) {
  static constexpr const char* layers[] = {"WALLS", "a \"b\" <c> & d", "\xC3\xA4"};
  Drawing drawing;
  const std::size_t size = 1 + random() % 4;
  for (std::size_t i = 0; i < size; ++i) {
    drawing.elements.push_back(random_element(random, family));
    drawing.elements.back().name = "thing " + std::to_string(i);
    if (family.has_layers && random() % 3 == 0) drawing.elements.back().layer = layers[random() % 3];
  }
  return drawing;
}

}  // namespace quoin::testing
