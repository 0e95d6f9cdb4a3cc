// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/cli/clipped_segments.h"
#include "quoin/cli/flow_grades.h"
#include "quoin/cli/page_values.h"
#include "quoin/flow/flow_reconstruction.h"
#include "quoin/flow/saddle_surfaces.h"
#include "quoin/view/layered_scene.h"

namespace quoin::cli {

/// Where things are in the scene of a flow, among its points and owners.
struct FlowPlaces {
  std::uint32_t first_edge = 0;  ///< point of the first critical edge; saddles and maxima follow
  std::uint32_t first_saddle = 0;
  std::uint32_t first_maximum = 0;

  // Owners are numbered as the critical points are; what has none of its own follows.
  std::uint32_t owner_of_edge(std::uint32_t i) const { return i; }
  std::uint32_t owner_of_saddle(std::uint32_t i) const { return first_saddle - first_edge + i; }
  std::uint32_t owner_of_maximum(std::uint32_t i) const { return first_maximum - first_edge + i; }
};

/// Adds the triangles of stable surfaces to layers of a scene, with their corners.
class SurfaceLayers {
 public:
  /// All must outlive it. Points of the scene are the vertices of the triangulation, then the critical points.
  SurfaceLayers(const FlowGraph& graph, const FlowGrades& grades, const FlowPlaces& places, LayeredScene& scene);

  /// The surface of a saddle of the graph, there from a stop on. @throws Cancelled
  void add(std::uint32_t saddle, std::uint32_t stop, SceneLayer& layer, const Context& context);

  /// Surfaces that are not what they are in general position.
  std::size_t not_ordinary() const { return not_ordinary_; }

 private:
  std::uint32_t midpoint(const std::array<std::uint32_t, 2>& edge);
  std::uint32_t constructed(std::uint32_t node);

  const FlowGraph& graph_;
  FlowPlaces places_;
  LayeredScene& scene_;
  SaddleSurfaces surfaces_;
  double unscale_;
  double precision_;
  std::unordered_map<std::uint64_t, std::uint32_t> midpoints_;
  std::vector<std::uint32_t> constructed_;
  std::size_t not_ordinary_ = 0;
};

/// Adds the ways of saddles to a layer of a scene. Ways join: each step from a Voronoi vertex is an owner, linked to
/// the next. What leads to infinity ends a little outside of the points.
class WayLayer {
 public:
  /// All must outlive it.
  WayLayer(const FlowGraph& graph, const FlowPlaces& places, LayeredScene& scene);

  /// The two ways of a saddle of the graph, there from a stop on; what other ways have drawn stays as it is. Saddles
  /// come by ascending stops. @throws Cancelled
  void add(std::uint32_t saddle, std::uint32_t stop, SceneLayer& layer, const Context& context);

 private:
  void follow(std::uint32_t from, std::uint32_t cell, std::uint32_t stop, SceneLayer& layer, const Context& context);
  std::uint32_t centre(std::uint32_t cell);

  const FlowGraph& graph_;
  FlowPlaces places_;
  LayeredScene& scene_;
  CriticalValues values_;
  SaddleArcs arcs_;
  ClippedSegments segments_;
  std::vector<std::uint32_t> owner_;   // by cell
  std::vector<std::uint32_t> centre_;  // by cell, among the spots
  std::vector<SceneSpot> spots_;
  double precision_;
  std::uint32_t next_owner_;
};

/// Adds unstable sheets of saddles of index 1: as a layer all together, each part once and at every distance, as sheets
/// run together and no part is of one saddle alone; and as another one, hidden until a midpoint is picked, each sheet
/// by itself from its distance on. What goes far beyond the points is left out; the scene's facts say how much. Layers
/// that have owners, and links, come before. @throws Cancelled
void add_sheet_layers(const FlowGraph& graph, const FlowGrades& grades, const FlowPlaces& places,
                      const PageValues& stops, LayeredScene& scene, const Context& context);

}  // namespace quoin::cli
