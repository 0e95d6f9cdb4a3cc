// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "quoin/kernel/point.h"
#include "quoin/solid/mesh.h"
#include "quoin/view/scene.h"

namespace quoin {

/// No such value: of what stays for ever.
inline constexpr std::uint32_t never_in_scene = 0xFFFFFFFFU;

/// Points, segments or triangles of one kind, which can be hidden and shown by their name.
///
/// Element i is there at the values from `begin[i]` up to, not including, `end[i]`: indices into LayeredScene::values.
/// Elements may have owners, numbers that the scene chooses: a point that is picked selects its owner, and what else
/// that one owns, in any layer, is then seen alone.
struct SceneLayer {
  enum class Kind { points, segments, triangles };
  std::string name{};
  Kind kind = Kind::points;
  std::vector<std::uint32_t> vertices{};  ///< LayeredScene::point_count() is above each: one, two or three an element
  std::vector<std::uint32_t> begin{};     ///< empty: there from the first value on
  std::vector<std::uint32_t> end{};       ///< empty: there for ever, as one with never_in_scene
  Color color{};                          ///< of those without one of their own; see through if its opacity is less
  std::vector<Color> colors{};            ///< empty, or one for each element
  std::vector<std::uint32_t> owners{};    ///< empty, or one for each element
  std::string element_name{};             ///< of a point that is picked: "Saddle"; empty: "Point"
  double size = 0;                        ///< pixels: diameter of points, width of segments; 0 for a usual one
  bool is_shown = true;                   ///< when the page is opened
};

/// Some number that changes with the value, as how many edges there are.
struct SceneCount {
  std::string name{};
  std::vector<std::uint32_t> at{};  ///< by value
};

/// Numbers under a heading, as "Betti numbers".
struct SceneCounts {
  std::string name{};
  std::vector<SceneCount> rows{};
};

/// A point of the persistence diagram: a class of homology that is there from one value up to another.
struct ScenePair {
  std::uint32_t degree = 0;
  std::uint32_t birth = 0;                     ///< index into LayeredScene::values
  std::uint32_t death = never_in_scene;        ///< the same, later than `birth`
  std::uint32_t birth_point = never_in_scene;  ///< the point at which it is born, if it is one
  std::uint32_t death_point = never_in_scene;  ///< the same of its death
};

/// Where one owner is seen, another one is too.
struct SceneLink {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
};

/// Points and what stands on them, by a value that whoever looks chooses: alpha complexes, flow complexes,
/// triangulations. Without values, all of it is there.
struct LayeredScene {
  std::string title{};
  std::vector<ViewFact> facts{};
  std::vector<Point3> points{};                ///< finite
  std::vector<Point3> near_points{};           ///< more of them, numbered on from those, told in single precision
  std::vector<std::uint32_t> point_numbers{};  ///< empty, or by which number the page names points, the first ones
  std::vector<SceneLayer> layers{};
  std::vector<SceneLink> links{};  ///< followed from owner to owner; of one without any, against their direction
  std::vector<double> values{};    ///< ascending, equal ones allowed; infinite ones are beyond the largest double
  bool has_all_values = true;  ///< what begins at a value has that value; else it may have one after the value before
  std::string value_name{};    ///< "Value"
  std::string root_name{};     ///< of the square root of the value, for people: "Radius"; empty where it has no sense
  std::optional<std::uint32_t> value{};  ///< that is shown first, an index into `values`; else the page chooses
  std::vector<SceneCounts> counts{};
  std::vector<ScenePair> pairs{};
  std::uint64_t pairs_left_out = 0;  ///< how many more there are

  std::size_t point_count() const { return points.size() + near_points.size(); }
};

}  // namespace quoin
