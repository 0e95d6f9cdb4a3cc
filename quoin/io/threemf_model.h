// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/io/drawing_text.h"
#include "quoin/kernel/transformation.h"

namespace quoin::io {

struct ThreemfObject;

/// An object in a place: a component of an object, or an item of the build.
struct ThreemfUse {
  const ThreemfObject* object = nullptr;
  std::optional<Transformation> place;  ///< where one is written
  std::size_t line = 0;
};

/// Triangles, or components; of objects that are left out, neither.
struct ThreemfObject {
  std::uint32_t id = 0;
  std::string name;                      ///< may be empty
  bool is_left_out = false;              ///< of the types support, solidsupport and other
  std::vector<Point3> vertices;          ///< finite
  std::vector<std::uint32_t> triangles;  ///< three indices each
  std::vector<ThreemfUse> components;
  std::size_t depth = 1;      ///< of the tree of components that it is the root of
  std::uint64_t uses = 1;     ///< nodes of that tree, saturated, as what follows
  std::uint64_t corners = 0;  ///< vertices and triangles in all of them
};

/// What a model part says.
struct ThreemfModel {
  std::string part;
  std::string unit = "millimeter";
  std::deque<ThreemfObject> objects;  ///< in the order of the part; uses point to them
  std::unordered_map<std::uint32_t, ThreemfObject*> by_id;
  std::vector<ThreemfUse> items;
};

/// Gives the model of another part of the archive, whose objects a part names by path (production extension).
using OtherModel = std::function<const ThreemfModel&(const std::string& path)>;

/// Reads a model part (3MF core specification, 1.3). Coordinates and entries of transforms are the nearest doubles of
/// their decimals. What is left out goes to `notes`. Nothing of other extensions than that for production is read; of
/// those that the part requires, the one for materials is let pass, since it changes no geometry. O(size).
/// @param name   file and part, for messages
/// @param other  nothing in parts that other parts name, which may name none themselves
/// @throws InputError  what is not well formed, or not as the specification wants it; names the line
ThreemfModel read_threemf_model(std::string_view text, const std::string& part, const std::string& name,
                                const OtherModel& other, DrawingNotes& notes, const Context& context);

}  // namespace quoin::io
