// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "quoin/base/context.h"
#include "quoin/cli/options.h"

namespace quoin::cli {

/// Each command prints its report and returns the exit code: 0 done, 1 refused with a reason. The others are made from
/// exceptions.
int run_boolean(const Options& options, const Context& context);
int run_csg(const Options& options, const Context& context);
int run_info(const Options& options, const Context& context);
int run_check(const Options& options, const Context& context);
int run_repair(const Options& options, const Context& context);
int run_convert(const Options& options, const Context& context);
int run_classify(const Options& options, const Context& context);
int run_section(const Options& options, const Context& context);
int run_interfere(const Options& options, const Context& context);
int run_hull(const Options& options, const Context& context);
int run_distance(const Options& options, const Context& context);
int run_width(const Options& options, const Context& context);
int run_homology(const Options& options, const Context& context);
int run_persistence(const Options& options, const Context& context);
int run_delaunay(const Options& options, const Context& context);
int run_constrained(const Options& options, const Context& context);
int run_flow(const Options& options, const Context& context);
int run_voronoi(const Options& options, const Context& context);
int run_alpha(const Options& options, const Context& context);
int run_gaussian_map(const Options& options, const Context& context);
int run_minkowski_sum(const Options& options, const Context& context);
int run_erosion(const Options& options, const Context& context);
int run_decomposition(const Options& options, const Context& context);
int run_assembly(const Options& options, const Context& context);
int run_arrange(const Options& options, const Context& context);
int run_arrange_on_sphere(const Options& options, const Context& context);
int run_overlay(const Options& options, const Context& context);
int run_locate(const Options& options, const Context& context);
int run_envelope(const Options& options, const Context& context);
int run_polygon(const Options& options, const Context& context);
int run_view(const Options& options, const Context& context);

}  // namespace quoin::cli
