// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "quoin/base/parallel.h"
#include "quoin/cli/cell_outputs.h"
#include "quoin/cli/commands.h"
#include "quoin/cli/failure.h"
#include "quoin/cli/inputs.h"
#include "quoin/cli/memory.h"
#include "quoin/cli/nearest_cells.h"
#include "quoin/cli/planar.h"
#include "quoin/cli/point_input.h"
#include "quoin/cli/summary.h"
#include "quoin/cli/targets.h"

namespace quoin::cli {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t grain = 64;
constexpr std::size_t short_number = 60;  // characters of an exact volume that is always told

/// For each site the sites next to it, one after the other.
class Neighbours {
 public:
  Neighbours(const NearestCells& cells, const Context& context) : begin_(cells.site_count() + 1) {
    const auto pairs = cells.neighbours(context);
    for (const auto& [a, b] : pairs) {
      ++begin_[a + 1];
      ++begin_[b + 1];
    }
    for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
    list_.resize(2 * pairs.size());
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    for (const auto& [a, b] : pairs) {
      list_[next[a]++] = b;
      list_[next[b]++] = a;
    }
  }
  std::span<const std::uint32_t> of(std::uint32_t site) const {
    return std::span(list_).subspan(begin_[site], begin_[site + 1] - begin_[site]);
  }

 private:
  std::vector<std::size_t> begin_;
  std::vector<std::uint32_t> list_;
};

/// Sites by their first points.
std::vector<std::uint32_t> in_order_of_inputs(const NearestCells& cells) {
  std::vector<std::uint32_t> sites(cells.site_count());
  for (std::uint32_t s = 0; s < sites.size(); ++s) sites[s] = s;
  std::ranges::sort(sites, {}, [&](std::uint32_t s) { return cells.inputs(s)[0]; });
  return sites;
}

Json as_json(const std::optional<double>& number) {
  return number && std::isfinite(*number) ? Json(*number) : Json();
}

/// Numbers of the points that have no cell: hidden by others, or nearest nowhere alone.
std::vector<std::uint32_t> hidden_points(const NearestCells& cells, std::size_t points) {
  std::vector<bool> has_cell(points, false);
  for (std::uint32_t s = 0; s < cells.site_count(); ++s) {
    for (const std::uint32_t i : cells.inputs(s)) has_cell[i] = true;
  }
  std::vector<std::uint32_t> hidden;
  for (std::uint32_t i = 0; i < points; ++i) {
    if (!has_cell[i]) hidden.push_back(i);
  }
  return hidden;
}

struct Sizes {
  std::vector<double> rounded;     // by site; NaN of an infinite cell
  std::vector<std::string> exact;  // if they are listed
};

Sizes sizes_of(const NearestCells& cells, const Options& options, const Context& context) {
  Sizes sizes;
  sizes.rounded.assign(cells.site_count(), std::numeric_limits<double>::quiet_NaN());
  if (options.cells) sizes.exact.resize(cells.site_count());
  context.progress("volumes", 0);
  for_each_chunk(context, cells.site_count(), grain, [&](const Chunk& chunk) {
    for (auto s = static_cast<std::uint32_t>(chunk.begin); s < chunk.end; ++s) {
      context.poll();
      if (!cells.is_bounded(s)) continue;
      const Rational size = cells.size(s);
      sizes.rounded[s] = size.to_double();
      if (!options.cells) continue;
      sizes.exact[s] = size.to_string();
      if (!options.exact && sizes.exact[s].size() > short_number) sizes.exact[s].clear();
    }
  });
  return sizes;
}

Json list_of(const NearestCells& cells, const Sizes& sizes, const PointFile& file, bool of_plane,
             const Context& context) {
  const char* const size_name = of_plane ? "area" : "volume";
  const Neighbours neighbours(cells, context);
  Json list = Json::array();
  for (const std::uint32_t s : in_order_of_inputs(cells)) {
    context.poll();
    const std::span<const std::uint32_t> inputs = cells.inputs(s);
    const Point3& p = file.points[inputs[0]];
    Json cell{{"input", inputs[0]}};
    if (inputs.size() > 1) cell["inputs"] = std::vector<std::uint32_t>(inputs.begin(), inputs.end());
    cell["point"] = of_plane ? Json{p.x, p.y} : Json{p.x, p.y, p.z};
    if (!file.weights.empty()) cell["weight"] = file.weights[inputs[0]];
    cell["bounded"] = cells.is_bounded(s);
    cell[size_name] = as_json(sizes.rounded[s]);
    cell[std::string("exact_") + size_name] = sizes.exact[s].empty() ? Json() : Json(sizes.exact[s]);
    std::vector<std::uint32_t> next;
    for (const std::uint32_t n : neighbours.of(s)) next.push_back(cells.inputs(n)[0]);
    std::ranges::sort(next);
    cell["neighbours"] = std::move(next);
    list.push_back(std::move(cell));
  }
  return list;
}

/// All bounded faces, with exact volumes of those that are cells.
ExactCells exact_cells_of(NearestCells& cells, bool of_plane, const Context& context) {
  const std::vector<std::uint32_t> order = in_order_of_inputs(cells);
  ExactCells made = cells.bounded_faces(order, context);
  std::vector<Rational> sizes(cells.site_count());
  for_each_chunk(context, cells.site_count(), grain, [&](const Chunk& chunk) {
    for (auto s = static_cast<std::uint32_t>(chunk.begin); s < chunk.end; ++s) {
      context.poll();
      if (cells.is_bounded(s)) sizes[s] = cells.size(s);
    }
  });
  ExactNumbers column;
  const std::size_t faces = made.cell_count() - cells.bounded_count();
  for (std::size_t c = 0; c < faces; ++c) column.add_none();
  for (const std::uint32_t s : order) {
    if (cells.is_bounded(s)) column.add(sizes[s]);
  }
  made.cell_data.numbers.emplace_back(of_plane ? "area" : "volume", std::move(column));
  return made;
}

VtkGrid grid_of(NearestCells& cells, const Sizes& sizes, const PointFile& file, bool of_plane, const Context& context) {
  VtkGrid grid;
  grid.cell_integers.push_back({"input", {}});
  grid.cell_doubles.push_back({of_plane ? "area" : "volume", {}});
  if (!file.weights.empty()) grid.cell_doubles.push_back({"weight", {}});
  for (const std::uint32_t s : in_order_of_inputs(cells)) {
    context.poll();
    if (!cells.is_bounded(s)) continue;
    cells.add_cell(s, grid);
    grid.cell_integers[0].second.push_back(cells.inputs(s)[0]);
    grid.cell_doubles[0].second.push_back(sizes.rounded[s]);
    if (!file.weights.empty()) grid.cell_doubles[1].second.push_back(file.weights[cells.inputs(s)[0]]);
  }
  return grid;
}

/// For people, a line per cell.
std::string text_of(const Json& cells, bool of_plane) {
  std::string text;
  for (const Json& cell : cells) {
    const Json& size = cell[of_plane ? "area" : "volume"];
    const Json& exact = cell[of_plane ? "exact_area" : "exact_volume"];
    text += "cell " + cell["input"].dump() + " of " + cell["point"].dump() + ": " +
            (cell["bounded"] == false ? "infinite" : size.dump()) +
            (exact.is_string() ? " = " + exact.get<std::string>() : "") + ", next to " + cell["neighbours"].dump() +
            "\n";
  }
  return text;
}

}  // namespace

int run_voronoi(const Options& options, const Context& context) {
  if (options.exact && !options.cells) throw UsageError("--exact goes with --cells");
  std::vector<std::string> warnings;
  const PointFile file = read_point_input(options, warnings, context);
  const bool of_plane = is_of_plane(file, options);
  const bool is_written = !options.outputs.empty();
  const MemoryUse use{.is_weighted = options.weighted,
                      .is_listed = options.cells,
                      .is_written = is_written,
                      .is_exact = writes(options, Target::Kind::cells)};
  announce_memory(memory_of_nearest_cells(file.points.size(), of_plane, use), file.points.size(), options);
  const std::unique_ptr<NearestCells> cells = nearest_cells(file, of_plane, is_written, context);
  const Sizes sizes = options.cells || is_written ? sizes_of(*cells, options, context) : Sizes();
  const std::size_t bounded = cells->bounded_count();
  Json report = describe(file, options);
  report["distinct"] = cells->place_count();
  std::vector<std::uint32_t> hidden;
  if (options.weighted) {
    hidden = hidden_points(*cells, file.points.size());
    report["hidden"] = hidden.size();
  }
  report.update(cells->counts());
  report["bounded_cells"] = bounded;
  report["infinite_cells"] = cells->site_count() - bounded;
  if (!options.outputs.empty() && bounded < cells->site_count())
    warnings.push_back(std::to_string(cells->site_count() - bounded) + " cells are infinite and are not written");
  write_cells({.grid = [&] { return grid_of(*cells, sizes, file, of_plane, context); },
               .mesh = [&] { return cells->mesh(context); },
               .cells = [&] { return exact_cells_of(*cells, of_plane, context); }},
              options, warnings, context);
  std::string text = as_text(report);
  if (options.cells) {
    if (options.weighted) report["hidden_points"] = hidden;
    report["cells"] = list_of(*cells, sizes, file, of_plane, context);
    if (!options.json && !options.quiet) text += text_of(report["cells"], of_plane);
  }
  print_report(std::move(report), text, warnings, options);
  return 0;
}

}  // namespace quoin::cli
