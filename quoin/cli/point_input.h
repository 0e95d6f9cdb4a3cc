// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "quoin/base/context.h"
#include "quoin/cli/options.h"
#include "quoin/io/point_file.h"
#include "quoin/triangulation/regular_predicates2.h"

namespace quoin::cli {

/// Reads the points of the command's file, or of standard input. Warnings go to `warnings`.
PointFile read_point_input(const Options& options, std::vector<std::string>& warnings, const Context& context);

/// Whether points are those of the plane: the file has two coordinates, or --plane asks for it.
bool is_of_plane(const PointFile& file, const Options& options);

/// x and y of all points.
std::vector<Point2> plane_points(const PointFile& file);

/// The same with their weights.
std::vector<WeightedPoint2> weighted_plane_points(const PointFile& file);

/// How many different places points of the plane have.
std::size_t distinct_places(const PointFile& file);

/// What is to be said of points of the plane whose third coordinate is not kept, and of points that span less than they
/// have coordinates.
void warn_of_points(std::size_t heights_lost, int dimension, const Options& options, bool of_plane,
                    std::vector<std::string>& warnings);

/// The first keys of a report: format, points, coordinates, missing where some are.
nlohmann::ordered_json describe(const PointFile& file, const Options& options);

}  // namespace quoin::cli
