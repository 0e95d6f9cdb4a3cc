// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/targets.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <unordered_set>

#include "quoin/cli/failure.h"
#include "quoin/cli/inputs.h"
#include "quoin/view/page.h"

namespace quoin::cli {

namespace {

Target solid_target(const std::string& name, const std::string& ending) {
  if (ending == ".html" || ending == ".htm") return {name, Target::Kind::page};
  if (ending == ".qsolid") return {name, Target::Kind::exact};
  const auto format = format_from_path("x" + ending);
  if (!format) {
    throw UsageError((name == standard_stream ? "--format '" + ending.substr(1) + "'" : name + ": the ending") +
                     " tells no format that is written (off, obj, stl, ply, html, qsolid)");
  }
  if (!is_written(*format)) {
    throw UsageError((name == standard_stream ? "--format '" + ending.substr(1) + "'" : name) +
                     ": 3MF is read, not written (written are off, obj, stl, ply, html, qsolid)");
  }
  return {name, Target::Kind::mesh, *format};
}

Target trail_target(const std::string& name) {
  if (name != standard_stream && ending_of(name) != ".svg") throw UsageError(name + ": trails are written as .svg");
  return {name, Target::Kind::drawing};
}

Target diagram_target(const std::string& name) {
  if (name != standard_stream && ending_of(name) != ".svg")
    throw UsageError(name + ": diagrams and barcodes are written as .svg");
  return {name, Target::Kind::drawing};
}

Target drawing_target(const std::string& name) {
  if (name != standard_stream && ending_of(name) != ".svg")
    throw UsageError(name + ": sections are written as .svg; for a page or a mesh, cut the solid with a Boolean");
  return {name, Target::Kind::drawing};
}

Target planar_target(const std::string& name, const std::string& ending, const Options& options) {
  Target target{name, Target::Kind::planar};
  if (ending == ".html" || ending == ".htm") {
    target.kind = Target::Kind::planar_page;
  } else if (ending == ".svg") {
    target.kind = Target::Kind::picture;
  } else if (ending == ".qarr" && options.command != "envelope") {
    target.kind = Target::Kind::planar_exact;
  } else {
    const auto format = drawing_format_from_path("x" + ending);
    const bool writes_drawings = options.command == "polygon" || options.command == "envelope";
    if (!format || !writes_drawings) {
      throw UsageError((name == standard_stream ? "--format '" + ending.substr(1) + "'" : name + ": the ending") +
                       " tells no format that is written (" + (writes_drawings ? "wkt, geojson, dxf, " : "") +
                       "svg, html" + (options.command == "envelope" ? "" : ", qarr") + ")");
    }
    target.planar_format = *format;
  }
  return target;
}

Target cells_target(const std::string& name, const std::string& ending, bool has_text, bool has_page) {
  if (ending == ".vtk") return {name, Target::Kind::grid};
  if (has_page && (ending == ".html" || ending == ".htm")) return {name, Target::Kind::page};
  if (ending == ".txt" && has_text) return {name, Target::Kind::simplices};
  if (ending == ".qcells") return {name, Target::Kind::cells};
  const auto format = format_from_path("x" + ending);
  if (!format || is_triangles_only(*format)) {
    throw UsageError((name == standard_stream ? "--format '" + ending.substr(1) + "'" : name + ": the ending") +
                     " tells no format that is written (vtk, ply, obj, off, qcells" + (has_page ? ", html" : "") +
                     (has_text ? ", txt)" : ")"));
  }
  return {name, Target::Kind::mesh, *format};
}

Target constrained_target(const std::string& name, const std::string& ending) {
  if (ending == ".svg") return {name, Target::Kind::picture};
  if (ending == ".html" || ending == ".htm") return {name, Target::Kind::planar_page};
  try {
    return cells_target(name, ending, false, false);
  } catch (const UsageError&) {
    throw UsageError((name == standard_stream ? "--format '" + ending.substr(1) + "'" : name + ": the ending") +
                     " tells no format that is written (svg, html, vtk, ply, obj, off, qcells)");
  }
}

Target plan_target(const std::string& name, const std::string& ending) {
  if (ending == ".json") return {name, Target::Kind::report};
  if (ending == ".html" || ending == ".htm") return {name, Target::Kind::page};
  throw UsageError((name == standard_stream ? "--format '" + ending.substr(1) + "'" : name + ": the ending") +
                   " tells no format that is written (json, html)");
}

Target target_of(const std::string& name, const Options& options) {
  if (is_planar(options.command)) {
    const bool has_default = options.command == "polygon" || options.command == "envelope";
    if (name != standard_stream) return planar_target(name, ending_of(name), options);
    const std::string format = options.format.empty() ? (has_default ? "wkt" : "svg") : options.format;
    return planar_target(name, in_small_letters("." + format), options);
  }
  if (options.command == "constrained") {
    if (name != standard_stream) return constrained_target(name, ending_of(name));
    return constrained_target(name, in_small_letters("." + (options.format.empty() ? "svg" : options.format)));
  }
  if (options.command == "assembly") {
    if (name != standard_stream) return plan_target(name, ending_of(name));
    return plan_target(name, in_small_letters("." + (options.format.empty() ? "json" : options.format)));
  }
  if (options.persistence) {
    if (!options.format.empty() && in_small_letters(options.format) != "svg")
      throw UsageError("--format '" + options.format + "': diagrams and barcodes are written as .svg");
    return diagram_target(name);
  }
  if (options.command == "delaunay" || options.command == "voronoi" || options.command == "alpha" ||
      options.command == "flow") {
    const bool has_text = options.command == "alpha";
    const std::string ending = name != standard_stream ? ending_of(name) : in_small_letters("." + options.format);
    if (options.command == "flow" && ending == ".svg") return {name, Target::Kind::drawing};
    const bool has_page = options.command != "voronoi";
    if (name != standard_stream) return cells_target(name, ending_of(name), has_text, has_page);
    return cells_target(name, in_small_letters("." + (options.format.empty() ? "vtk" : options.format)), has_text,
                        has_page);
  }
  if (options.command == "section") return drawing_target(name);
  if (options.command == "distance") return trail_target(name);
  if (options.command == "persistence") return diagram_target(name);
  if (name != standard_stream) return solid_target(name, ending_of(name));
  return solid_target(name, in_small_letters("." + (options.format.empty() ? "off" : options.format)));
}

}  // namespace

bool is_planar(const std::string& command) {
  static const std::unordered_set<std::string> commands{"arrange", "overlay",  "polygon",
                                                        "locate",  "envelope", "gaussian-map"};
  return commands.contains(command);
}

std::vector<Target> targets_of(const Options& options) {
  std::vector<Target> targets;
  for (const std::string& name : options.outputs) targets.push_back(target_of(name, options));
  return targets;
}

bool writes(const Options& options, Target::Kind kind) {
  return std::ranges::count(targets_of(options), kind, &Target::kind) > 0;
}

void require_known_targets(const Options& options) {
  const std::vector<Target> targets = targets_of(options);
  if (!options.format.empty() && std::none_of(targets.begin(), targets.end(), std::mem_fn(&Target::is_stream)))
    throw UsageError("--format is that of standard output: it goes with '-o -'");
  for (const Target& target : targets) {
    const bool is_page = target.kind == Target::Kind::page || target.kind == Target::Kind::planar_page;
    if (is_page && !has_view())
      throw InputError(target.name + ": the view was not built into this quoin, so that it writes no pages");
  }
}

void require_single_use_of_streams(const Options& options) {
  std::size_t readers = (options.points_file == standard_stream ? 1 : 0) + (options.path == standard_stream ? 1 : 0);
  for (const std::string& input : options.inputs) {
    const bool is_named = options.command == "csg" && input.find('=') != std::string::npos;
    readers += (is_named ? input.substr(input.find('=') + 1) : input) == standard_stream ? 1 : 0;
  }
  if (readers > 1) throw UsageError("standard input ('-') is named twice, and can be read only once");
  if (std::count(options.outputs.begin(), options.outputs.end(), standard_stream) > 1)
    throw UsageError("standard output ('-') is named twice, and can hold only one file");
}

std::vector<NamedInput> named_inputs(const Options& options) {
  std::vector<NamedInput> inputs;
  std::unordered_set<std::string> names;
  for (const std::string& input : options.inputs) {
    const std::size_t equals = input.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == input.size())
      throw UsageError("'" + input + "': operands of csg are given as NAME=FILE");
    inputs.push_back({input.substr(0, equals), input.substr(equals + 1)});
    if (!names.insert(inputs.back().name).second) throw UsageError("'" + inputs.back().name + "=' is given twice");
  }
  return inputs;
}

}  // namespace quoin::cli
