// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/flow_page.h"

#include <algorithm>
#include <array>

namespace quoin::cli {

namespace {

constexpr std::size_t most_points_by_default = 100'000;
constexpr std::size_t most_points_with_tunnels = 100'000;

}  // namespace

FlowPage flow_page_of(const Options& options, std::size_t points) {
  const bool tunnels = points <= most_points_with_tunnels;
  if (options.reconstruct) {
    return {.tunnels = tunnels,
            .wall_name = "Surface of the solid",
            .chosen_name = "Maxima inside (index 3)",
            .other_name = "Maxima outside (index 3)"};
  }
  if (options.simplify) {
    return {.tunnels = tunnels,
            .wall_name = "Surfaces between regions",
            .chosen_name = "Maxima that stay (index 3)",
            .other_name = "Maxima that were joined (index 3)"};
  }
  if (options.stable == 3) return {.tunnels = tunnels, .wall_name = "Walls of regions (stable 3)"};
  if (options.shape)
    return {.edges = true, .surfaces = true, .tunnels = tunnels, .distance = *options.shape * *options.shape};
  FlowPage page{.edges = options.stable == 1,
                .surfaces = options.stable == 2,
                .ways = options.unstable == 2,
                .sheets = options.unstable == 1,
                .tunnels = tunnels};
  if (options.stable != 0 || options.unstable != 0) return page;
  const bool are_few = points <= most_points_by_default;
  page.edges = page.surfaces = page.ways = are_few;
  if (!are_few)
    page.left_out = "edges, surfaces and ways: there are more than " + std::to_string(most_points_by_default) +
                    " points (--stable 1, --stable 2, --unstable 2 ask for them)";
  return page;
}

FlowPage flat_page_of(const Options& options, std::size_t points) {
  if (options.shape) return {.edges = true, .surfaces = true, .distance = *options.shape * *options.shape};
  FlowPage page{.edges = options.stable == 1, .surfaces = options.stable == 2, .ways = options.unstable == 1};
  if (options.stable == 3 || options.simplify || options.reconstruct) {
    page.left_out = "solids and regions of space: points of one plane enclose nothing";
  } else if (options.unstable == 2) {
    page.left_out = "ways from index 2: straight across the plane to infinity";
  }
  if (options.stable != 0 || options.unstable != 0 || !page.left_out.empty()) return page;
  const bool are_few = points <= most_points_by_default;
  page.edges = page.surfaces = page.ways = are_few;
  if (!are_few)
    page.left_out = "edges, surfaces and ways: there are more than " + std::to_string(most_points_by_default) +
                    " points (--stable 1, --stable 2, --unstable 1 ask for them)";
  return page;
}

std::uint64_t memory_of_flow_page(const FlowPage& page, const FlowCells& flow) {
  const std::array<std::size_t, 4>& counts = flow.counts();
  std::uint64_t bytes = 110 * (counts[0] + counts[1] + counts[2] + counts[3]);
  if (page.tunnels) bytes += 330 * flow.cells().size();
  if (page.edges) bytes += 170 * std::min(counts[1], most_flow_segments);
  // Ten triangles a saddle in a cube, six on a surface.
  if (page.surfaces || !page.wall_name.empty()) bytes += 115 * std::min(10 * counts[2], most_flow_triangles);
  if (page.sheets) bytes += 30000 * counts[0] + std::min(60000 * counts[1], 150 * most_picked_triangles);
  if (page.ways) bytes += 300 * std::min(flow.cells().size(), most_flow_segments);
  return bytes;
}

std::uint64_t memory_of_flat_page(std::size_t points) {
  constexpr std::uint64_t bytes_per_point = 2000;
  return points * bytes_per_point;
}

}  // namespace quoin::cli
