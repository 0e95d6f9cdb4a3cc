// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>

#include "quoin/base/error.h"
#include "quoin/io/ply_layout.h"
#include "quoin/io/ply_values.h"
#include "quoin/io/readers.h"

namespace quoin::io {

namespace {

class PlyReader {
 public:
  PlyReader(std::string_view bytes, const std::string& name, const Context& context)
      : bytes_(bytes), name_(name), context_(context) {}

  MeshFile run() {
    layout_ = read_ply_layout(bytes_, name_);
    file_.report.format = layout_.format;
    PlyValues values(bytes_.substr(layout_.size), layout_, name_);
    for (const PlyElement& element : layout_.elements) {
      if (element.properties.empty()) continue;
      values.require_room(element);
      if (element.name == "vertex") {
        read_vertices(element, values);
      } else if (element.name == "face") {
        read_faces(element, values);
      } else {
        skip(element, values);
      }
    }
    if (const auto place = values.place_of_next())
      file_.report.warnings.push_back(*place + ": what follows the last element is not kept");
    if (!has_colors_) file_.mesh.face_colors.clear();
    return std::move(file_);
  }

 private:
  [[noreturn]] void fail_header(const std::string& what) const {
    throw InputError(name_ + ":" + std::to_string(layout_.lines) + ": " + what);
  }

  void read_vertices(const PlyElement& element, PlyValues& values) {
    std::array<std::size_t, 3> place{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::string axis(1, "xyz"[k]);
      const auto found = element.find(axis);
      if (!found) fail_header("the vertices have no " + axis);
      place[k] = *found;
    }
    file_.mesh.vertices.reserve(element.count);
    for (std::uint64_t i = 0; i < element.count; ++i) {
      if (i % 4096 == 0) context_.poll();
      Point3 point;
      read_ply_element(element, values, [&](std::size_t p, std::size_t, double value) {
        for (std::size_t k = 0; k < 3; ++k) {
          if (p != place[k]) continue;
          if (!std::isfinite(value))
            values.fail("vertex " + std::to_string(i) + " has a coordinate that is not finite");
          point[k] = value;
        }
      });
      file_.mesh.vertices.push_back(point);
    }
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      if (p != place[0] && p != place[1] && p != place[2]) warn("vertex", element.properties[p].name);
    }
  }

  void warn(const std::string& element, const std::string& property) {
    file_.report.warnings.push_back("the " + element + " property '" + property.substr(0, 60) + "' is not kept");
  }

  void read_faces(const PlyElement& element, PlyValues& values) {
    constexpr std::size_t absent = ~std::size_t{0};
    std::size_t indices = absent;
    std::array<std::size_t, 4> channels{absent, absent, absent, absent};
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      static constexpr std::string_view names[] = {"red", "green", "blue", "alpha"};
      const auto channel = std::find(std::begin(names), std::end(names), property.name);
      if (property.count_type && (property.name == "vertex_indices" || property.name == "vertex_index")) {
        indices = p;
      } else if (channel != std::end(names) && property.type == PlyType::uint8 && !property.count_type) {
        channels[static_cast<std::size_t>(channel - std::begin(names))] = p;
      } else {
        warn("face", property.name);
      }
    }
    if (indices == absent) fail_header("the faces have no vertex_indices");
    has_colors_ = channels[0] != absent && channels[1] != absent && channels[2] != absent;
    Mesh& mesh = file_.mesh;
    for (std::uint64_t f = 0; f < element.count; ++f) {
      if (f % 4096 == 0) context_.poll();
      Color color{200, 200, 200, 255};
      read_ply_element(element, values, [&](std::size_t p, std::size_t, double value) {
        if (p == indices) {
          if (!(value >= 0) || value >= static_cast<double>(mesh.vertices.size()) || value != std::floor(value)) {
            values.fail("face " + std::to_string(f) + " names a vertex that is not there");
          }
          mesh.corners.push_back(static_cast<std::uint32_t>(value));
        }
        for (std::size_t k = 0; k < 4; ++k) {
          if (p != channels[k]) continue;
          if (!(value >= 0 && value <= 255)) values.fail("face " + std::to_string(f) + " has a colour beyond 255");
          (k == 0 ? color.r : k == 1 ? color.g : k == 2 ? color.b : color.a) = static_cast<std::uint8_t>(value);
        }
      });
      mesh.face_begin.push_back(mesh.corners.size());
      mesh.face_colors.push_back(color);
    }
  }

  void skip(const PlyElement& element, PlyValues& values) {
    for (std::uint64_t i = 0; i < element.count; ++i) {
      if (i % 4096 == 0) context_.poll();
      read_ply_element(element, values, [](std::size_t, std::size_t, double) {});
    }
    file_.report.warnings.push_back("the elements '" + element.name.substr(0, 60) + "' are not kept");
  }

  std::string_view bytes_;
  std::string name_;
  const Context& context_;
  PlyLayout layout_;
  MeshFile file_;
  bool has_colors_ = false;
};

}  // namespace

MeshFile read_ply(std::string_view bytes, const std::string& name, const Context& context) {
  return PlyReader(bytes, name, context).run();
}

}  // namespace quoin::io
